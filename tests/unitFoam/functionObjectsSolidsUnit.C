// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
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
namespace functionObjects_solids_besideFluidTests
{
#include "functionObjects/solids/besideFluid.C"
}
namespace functionObjects_solids_bondTablesTests
{
#include "functionObjects/solids/bondTables.C"
}
namespace functionObjects_solids_contactTablesTests
{
#include "functionObjects/solids/contactTables.C"
}
namespace functionObjects_solids_groupMotionTests
{
#include "functionObjects/solids/groupMotion.C"
}
namespace functionObjects_solids_particleDisplacementTests
{
#include "functionObjects/solids/particleDisplacement.C"
}
namespace functionObjects_solids_particleForcesTests
{
#include "functionObjects/solids/particleForces.C"
}
namespace functionObjects_solids_periodicEndsTests
{
#include "functionObjects/solids/periodicEnds.C"
}
namespace functionObjects_solids_rigidFitTests
{
#include "functionObjects/solids/rigidFit.C"
}
namespace functionObjects_solids_solidEnergiesTests
{
#include "functionObjects/solids/solidEnergies.C"
}
