// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "boxSource.C"
#include "csvSource.C"
#include "dividedRegion.C"
#include "fluidClip.C"
#include "numberRanks.C"
#include "particleRegionChecks.C"
#include "particleRegions.C"
#include "particleSource.C"
#include "roundSources.C"
#include "setParticlesRecord.C"
#include "surfaceSection.C"
#include "surfaceSource.C"
