// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "checkFunctionObjects.H"
#include "runningSolids.hpp"
#include "sceneFunctionObject.H"
#include "sceneState.H"
#include "riprapFoam/functionObjects/base/runningMean.hpp"
#include "functionTable.hpp"
#include "particleCase.hpp"
#include "fvMesh.H"
#include "runningScenes.H"
#include "timeWriter.H"
#include "scratchCase.hpp"
#include "trailingMean.H"
#include "runningFluid.hpp"
#include "riprapFoam/functionObjects/fluid/fluidFront.hpp"
#include "riprapFoam/functionObjects/fluid/levelCrossing.hpp"
#include "particleCloudIO.H"
#include "volFields.H"
#include "wallCorrection.H"
#include "riprapFoam/functionObjects/fluid/wallCoverage.hpp"
#include "riprapFoam/functionObjects/fluid/gaugeLine.H"
#include "riprapFoam/functionObjects/probes/sensorDisc.H"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
namespace functionObjects_base_checkFunctionObjectsTests
{
#include "functionObjects/base/checkFunctionObjects.C"
}
namespace functionObjects_base_keptNumbersTests
{
#include "functionObjects/base/keptNumbers.C"
}
namespace functionObjects_base_runningMeanTests
{
#include "functionObjects/base/runningMean.C"
}
namespace functionObjects_base_sceneFunctionObjectTests
{
#include "functionObjects/base/sceneFunctionObject.C"
}
namespace functionObjects_base_trailingMeanTests
{
#include "functionObjects/base/trailingMean.C"
}
namespace functionObjects_fluid_energyBalanceTests
{
#include "functionObjects/fluid/energyBalance.C"
}
namespace functionObjects_fluid_fluidEntriesTests
{
#include "functionObjects/fluid/fluidEntries.C"
}
namespace functionObjects_fluid_fluidLevelTests
{
#include "functionObjects/fluid/fluidLevel.C"
}
namespace functionObjects_fluid_frontPositionTests
{
#include "functionObjects/fluid/frontPosition.C"
}
namespace functionObjects_fluid_momentumBalanceTests
{
#include "functionObjects/fluid/momentumBalance.C"
}
namespace functionObjects_fluid_particlesToMeshTests
{
#include "functionObjects/fluid/particlesToMesh.C"
}
namespace functionObjects_fluid_wallCorrectionTests
{
#include "functionObjects/fluid/wallCorrection.C"
}
namespace functionObjects_fluid_wallCoverageTests
{
#include "functionObjects/fluid/wallCoverage.C"
}
namespace functionObjects_fluid_wallForceTests
{
#include "functionObjects/fluid/wallForce.C"
}
namespace functionObjects_fluid_waterLevelTests
{
#include "functionObjects/fluid/waterLevel.C"
}
namespace functionObjects_probes_particleProbesTests
{
#include "functionObjects/probes/particleProbes.C"
}
namespace functionObjects_probes_regionMassTests
{
#include "functionObjects/probes/regionMass.C"
}
namespace functionObjects_probes_sensorDiscTests
{
#include "functionObjects/probes/sensorDisc.C"
}
namespace functionObjects_probes_solidMassTests
{
#include "functionObjects/probes/solidMass.C"
}
