// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "bodyShapes.H"
#include "scratchCase.hpp"
#include "geometryWalls.H"
#include "laidWalls.hpp"
#include "testTime.H"
#include "StringStream.H"
#include "wallEdges.H"
#include <cmath>
#include <gtest/gtest.h>
#include <set>
namespace bodyShapesTests
{
#include "bodyShapes.C"
}
namespace geometryWallsTests
{
#include "geometryWalls.C"
}
namespace patchElementsTests
{
#include "patchElements.C"
}
namespace wallCurvesTests
{
#include "wallCurves.C"
}
namespace wallLatticeTests
{
#include "wallLattice.C"
}
namespace wallNormalsTests
{
#include "wallNormals.C"
}
namespace wallSheetsTests
{
#include "wallSheets.C"
}
namespace wallSurfaceTests
{
#include "wallSurface.C"
}
