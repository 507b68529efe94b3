// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "bodyFaces.H"
#include "testTime.H"
#include "closedSurface.H"
#include "clumpShape.H"
#include "csvFile.H"
#include "scratchCase.hpp"
#include "exactShapes.H"
#include "principalAxes.H"
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
namespace bodyFacesTests
{
#include "bodyFaces.C"
}
namespace closedSurfaceTests
{
#include "closedSurface.C"
}
namespace exactShapesTests
{
#include "exactShapes.C"
}
