// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "boxMesh.hpp"
#include "scratchCase.hpp"
#include "slidingWalls.H"
#include "wallTimes.H"
#include "sweptDomain.H"
#include "wallBodies.H"
#include <cmath>
#include <gtest/gtest.h>
namespace slidingWallsTests
{
#include "slidingWalls.C"
}
namespace wallBodiesTests
{
#include "wallBodies.C"
}
