// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "runningFluid.hpp"
#include "riprapFoam/functionObjects/fluid/gaugeLine.H"
#include "riprapFoam/functionObjects/probes/sensorDisc.H"
#include "runningSolids.hpp"
#include <cmath>
#include <gtest/gtest.h>
namespace particleProbesTests
{
#include "particleProbes.C"
}
namespace regionMassTests
{
#include "regionMass.C"
}
namespace sensorDiscTests
{
#include "sensorDisc.C"
}
namespace solidMassTests
{
#include "solidMass.C"
}
