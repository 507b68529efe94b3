// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "functionObjects/solids/brokenBonds.C"
#include "functionObjects/solids/contactChains.C"
#include "functionObjects/solids/forceParts.C"
#include "functionObjects/solids/gaugeBody.C"
#include "functionObjects/solids/groupMotion.C"
#include "functionObjects/solids/particleDisplacement.C"
#include "functionObjects/solids/particleForces.C"
#include "functionObjects/solids/particleForcesInTime.C"
#include "functionObjects/solids/solidEnergies.C"
#include "functionObjects/solids/solidWallForce.C"
#include "functionObjects/solids/springForces.C"
