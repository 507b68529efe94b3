// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "demMotion.H"
#include "demSceneObject.H"
#include "functionTable.hpp"
#include "gaugeBody.H"
#include "runningFluid.hpp"
#include "runningScenes.H"
#include "runningSolids.hpp"
#include "lineFile.hpp"
#include "riprapFoam/functionObjects/fluid/wallNeighbours.hpp"
#include "riprapFoam/functionObjects/solids/rigidFit.hpp"
#include <gtest/gtest.h>
namespace besideFluidTests
{
#include "besideFluid.C"
}
namespace bondTablesTests
{
#include "bondTables.C"
}
namespace contactTablesTests
{
#include "contactTables.C"
}
namespace groupMotionTests
{
#include "groupMotion.C"
}
namespace particleDisplacementTests
{
#include "particleDisplacement.C"
}
namespace particleForcesTests
{
#include "particleForces.C"
}
namespace periodicEndsTests
{
#include "periodicEnds.C"
}
namespace rigidFitTests
{
#include "rigidFit.C"
}
namespace solidEnergiesTests
{
#include "solidEnergies.C"
}
