// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "bodyGrading.C"
#include "fittedPacking.C"
#include "latticeRows.C"
#include "particlePacking.C"
#include "randomPacking.C"
#include "regionShapes.C"
