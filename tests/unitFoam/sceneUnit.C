// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "boxMesh.hpp"
#include "caseTime.H"
#include "commandLine.hpp"
#include "pictures.H"
#include "scratchCase.hpp"
#include "sceneCloud.H"
#include "timeManifest.H"
#include "timeWriter.H"
#include "particleCloudIO.H"
#include "fluidCloud.H"
#include "picCloud.H"
#include "picRestart.H"
#include "runningFluid.hpp"
#include "sphRestart.H"
#include "idIndex.H"
#include "toStdVector.H"
#include "cellLattice.H"
#include "testTime.H"
#include "lineSeries.H"
#include "escapeCount.H"
#include "api/sphScene.hpp"
#include "particleDomain.H"
#include "bodyFaces.H"
#include "closedSurface.H"
#include "clumpShape.H"
#include "csvFile.H"
#include "exactShapes.H"
#include "principalAxes.H"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>
namespace clouds_caseTimeTests
{
#include "clouds/caseTime.C"
}
namespace clouds_coordinatesTests
{
#include "clouds/coordinates.C"
}
namespace clouds_fluidCloudsTests
{
#include "clouds/fluidClouds.C"
}
namespace clouds_idIndexTests
{
#include "clouds/idIndex.C"
}
namespace clouds_locateParticlesTests
{
#include "clouds/locateParticles.C"
}
namespace clouds_particleCloudIOTests
{
#include "clouds/particleCloudIO.C"
}
namespace clouds_polyDataTests
{
#include "clouds/polyData.C"
}
namespace clouds_sceneCloudTests
{
#include "clouds/sceneCloud.C"
}
namespace domain_escapeCountTests
{
#include "domain/escapeCount.C"
}
namespace domain_particleDomainTests
{
#include "domain/particleDomain.C"
}
namespace shapes_bodyFacesTests
{
#include "shapes/bodyFaces.C"
}
namespace shapes_closedSurfaceTests
{
#include "shapes/closedSurface.C"
}
namespace shapes_exactShapesTests
{
#include "shapes/exactShapes.C"
}
