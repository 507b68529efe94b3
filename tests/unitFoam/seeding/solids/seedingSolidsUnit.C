// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "solidRegionCase.hpp"
#include <algorithm>
#include <set>
namespace rigidRegionTests
{
#include "rigidRegion.C"
}
namespace solidBondingTests
{
#include "solidBonding.C"
}
namespace solidChecksTests
{
#include "solidChecks.C"
}
namespace solidClumpsTests
{
#include "solidClumps.C"
}
namespace solidListTests
{
#include "solidList.C"
}
namespace solidPlacingTests
{
#include "solidPlacing.C"
}
