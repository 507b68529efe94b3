// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "bodyGrading.H"
#include "boxMesh.hpp"
#include "particlePacking.H"
#include "randomPacking.H"
#include "scratchCase.hpp"
#include "fittedPacking.H"
#include "regionShapes.H"
#include "latticeRows.H"
#include "fluidRegionCase.hpp"
#include "closedSurface.H"
#include "setParticlesRecord.H"
#include "IOdictionary.H"
#include "particleRegions.H"
#include "wallPoints.H"
#include "solidRegionCase.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
namespace seeding_packing_bodiesTests
{
#include "seeding/packing/bodies.C"
}
namespace seeding_packing_fittedPackingTests
{
#include "seeding/packing/fittedPacking.C"
}
namespace seeding_packing_latticeRowsTests
{
#include "seeding/packing/latticeRows.C"
}
namespace seeding_packing_particlePackingTests
{
#include "seeding/packing/particlePacking.C"
}
namespace seeding_regions_fluidClipTests
{
#include "seeding/regions/fluidClip.C"
}
namespace seeding_regions_fluidSourcesTests
{
#include "seeding/regions/fluidSources.C"
}
namespace seeding_regions_manyDifferencesTests
{
#include "seeding/regions/manyDifferences.C"
}
namespace seeding_regions_particleRegionsTests
{
#include "seeding/regions/particleRegions.C"
}
namespace seeding_regions_setParticlesRecordTests
{
#include "seeding/regions/setParticlesRecord.C"
}
namespace seeding_solids_rigidRegionTests
{
#include "seeding/solids/rigidRegion.C"
}
namespace seeding_solids_solidBondingTests
{
#include "seeding/solids/solidBonding.C"
}
namespace seeding_solids_solidChecksTests
{
#include "seeding/solids/solidChecks.C"
}
namespace seeding_solids_solidClumpsTests
{
#include "seeding/solids/solidClumps.C"
}
namespace seeding_solids_solidListTests
{
#include "seeding/solids/solidList.C"
}
namespace seeding_solids_solidPlacingTests
{
#include "seeding/solids/solidPlacing.C"
}
