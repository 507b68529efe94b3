// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "coupledSolids.H"
#include "particleCase.hpp"
#include <cmath>
#include <gtest/gtest.h>
namespace coupledSolidsTests
{
#include "coupledSolids.C"
}
