// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "bodyShapes.H"
#include "scratchCase.hpp"
#include "geometryWalls.H"
#include "walls/laidWalls.hpp"
#include "boxMesh.hpp"
#include "slidingWalls.H"
#include "wallTimes.H"
#include "sweptDomain.H"
#include "wallBodies.H"
#include "testTime.H"
#include "pointGrid.H"
#include "polylines.H"
#include "sheetSampling.H"
#include "StringStream.H"
#include "wallEdges.H"
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>
namespace walls_bodyShapesTests
{
#include "walls/bodyShapes.C"
}
namespace walls_geometryWallsTests
{
#include "walls/geometryWalls.C"
}
namespace walls_motion_slidingWallsTests
{
#include "walls/motion/slidingWalls.C"
}
namespace walls_motion_wallBodiesTests
{
#include "walls/motion/wallBodies.C"
}
namespace walls_patchElementsTests
{
#include "walls/patchElements.C"
}
namespace walls_sampling_polylinesTests
{
#include "walls/sampling/polylines.C"
}
namespace walls_sampling_sheetSamplingTests
{
#include "walls/sampling/sheetSampling.C"
}
namespace walls_wallCurvesTests
{
#include "walls/wallCurves.C"
}
namespace walls_wallLatticeTests
{
#include "walls/wallLattice.C"
}
namespace walls_wallNormalsTests
{
#include "walls/wallNormals.C"
}
namespace walls_wallSheetsTests
{
#include "walls/wallSheets.C"
}
namespace walls_wallSurfaceTests
{
#include "walls/wallSurface.C"
}
