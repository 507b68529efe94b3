// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "checkWalls.C"
#include "setFluid.C"
#include "setParticles.C"
#include "setSolids.C"
