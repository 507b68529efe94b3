// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "brokenBonds.C"
#include "contactChains.C"
#include "forceParts.C"
#include "gaugeBody.C"
#include "groupMotion.C"
#include "particleDisplacement.C"
#include "particleForces.C"
#include "particleForcesInTime.C"
#include "solidEnergies.C"
#include "solidWallForce.C"
#include "springForces.C"
