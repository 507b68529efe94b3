// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "runningFluid.hpp"
#include "riprapFoam/functionObjects/fluid/fluidFront.hpp"
#include "riprapFoam/functionObjects/fluid/levelCrossing.hpp"
#include "particleCloudIO.H"
#include "volFields.H"
#include "wallCorrection.H"
#include "riprapFoam/functionObjects/fluid/wallCoverage.hpp"
#include <functional>
#include <gtest/gtest.h>
namespace energyBalanceTests
{
#include "energyBalance.C"
}
namespace fluidEntriesTests
{
#include "fluidEntries.C"
}
namespace fluidLevelTests
{
#include "fluidLevel.C"
}
namespace frontPositionTests
{
#include "frontPosition.C"
}
namespace momentumBalanceTests
{
#include "momentumBalance.C"
}
namespace particlesToMeshTests
{
#include "particlesToMesh.C"
}
namespace wallCorrectionTests
{
#include "wallCorrection.C"
}
namespace wallCoverageTests
{
#include "wallCoverage.C"
}
namespace wallForceTests
{
#include "wallForce.C"
}
namespace waterLevelTests
{
#include "waterLevel.C"
}
