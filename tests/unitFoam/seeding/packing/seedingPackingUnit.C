// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "bodyGrading.H"
#include "boxMesh.hpp"
#include "particlePacking.H"
#include "randomPacking.H"
#include "scratchCase.hpp"
#include "fittedPacking.H"
#include "regionShapes.H"
#include "latticeRows.H"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
namespace bodiesTests
{
#include "bodies.C"
}
namespace fittedPackingTests
{
#include "fittedPacking.C"
}
namespace latticeRowsTests
{
#include "latticeRows.C"
}
namespace particlePackingTests
{
#include "particlePacking.C"
}
