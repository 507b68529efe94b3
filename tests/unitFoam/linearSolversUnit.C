// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "ballsInWater.hpp"
#include "pressureSolver.H"
#include "testTime.H"
#include "pic/projection/pressureStep.hpp"
#include <gtest/gtest.h>
#include <sstream>
namespace linearSolvers_freeBodyTests
{
#include "linearSolvers/freeBody.C"
}
namespace linearSolvers_pressureSolverTests
{
#include "linearSolvers/pressureSolver.C"
}
