// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "rigidEntries.C"
#include "rigidRegion.C"
#include "rigidSurface.C"
#include "solidBonding.C"
#include "solidChecks.C"
#include "solidClumps.C"
#include "solidList.C"
#include "solidPacking.C"
#include "solidPlacing.C"
#include "solidRegionBodies.C"
#include "solidRegions.C"
