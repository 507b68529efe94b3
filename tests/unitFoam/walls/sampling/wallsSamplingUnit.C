// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "pointGrid.H"
#include "polylines.H"
#include "sheetSampling.H"
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>
namespace polylinesTests
{
#include "polylines.C"
}
namespace sheetSamplingTests
{
#include "sheetSampling.C"
}
