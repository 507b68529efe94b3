// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "escapeCount.C"
#include "fluidProperties.C"
#include "nearestPatch.C"
#include "particleDomain.C"
#include "readMesh.C"
