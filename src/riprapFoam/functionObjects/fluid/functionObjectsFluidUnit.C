// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "energyBalance.C"
#include "frontPosition.C"
#include "momentumBalance.C"
#include "particlesToMesh.C"
#include "wallCorrection.C"
#include "wallForce.C"
#include "waterLevel.C"
