// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
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
#include <cmath>
#include <gtest/gtest.h>
namespace checkFunctionObjectsTests
{
#include "checkFunctionObjects.C"
}
namespace keptNumbersTests
{
#include "keptNumbers.C"
}
namespace runningMeanTests
{
#include "runningMean.C"
}
namespace sceneFunctionObjectTests
{
#include "sceneFunctionObject.C"
}
namespace trailingMeanTests
{
#include "trailingMean.C"
}
