// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "fluidRegionCase.hpp"
#include "closedSurface.H"
#include "scratchCase.hpp"
#include "setParticlesRecord.H"
#include "IOdictionary.H"
#include "boxMesh.hpp"
#include "particleRegions.H"
#include "wallPoints.H"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
namespace fluidClipTests
{
#include "fluidClip.C"
}
namespace fluidSourcesTests
{
#include "fluidSources.C"
}
namespace manyDifferencesTests
{
#include "manyDifferences.C"
}
namespace particleRegionsTests
{
#include "particleRegions.C"
}
namespace setParticlesRecordTests
{
#include "setParticlesRecord.C"
}
