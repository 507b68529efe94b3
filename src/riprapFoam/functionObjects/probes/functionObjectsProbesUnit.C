// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "particleProbeMeans.C"
#include "particleProbeSensors.C"
#include "particleProbes.C"
#include "regionMass.C"
