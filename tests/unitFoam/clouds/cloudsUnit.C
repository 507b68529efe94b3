// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
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
#include <cmath>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>
namespace caseTimeTests
{
#include "caseTime.C"
}
namespace coordinatesTests
{
#include "coordinates.C"
}
namespace fluidCloudsTests
{
#include "fluidClouds.C"
}
namespace idIndexTests
{
#include "idIndex.C"
}
namespace locateParticlesTests
{
#include "locateParticles.C"
}
namespace particleCloudIOTests
{
#include "particleCloudIO.C"
}
namespace polyDataTests
{
#include "polyData.C"
}
namespace sceneCloudTests
{
#include "sceneCloud.C"
}
