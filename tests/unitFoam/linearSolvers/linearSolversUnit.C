// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "ballsInWater.hpp"
#include "pressureSolver.H"
#include "testTime.H"
#include "pic/projection/pressureStep.hpp"
#include <gtest/gtest.h>
#include <sstream>
namespace freeBodyTests
{
#include "freeBody.C"
}
namespace pressureSolverTests
{
#include "pressureSolver.C"
}
