// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "demSettings.C"
#include "readConstraints.C"
#include "readSolidBonds.C"
#include "readSolidGroups.C"
#include "readSolidMaterials.C"
#include "readSolidProperties.C"
#include "readSolidWalls.C"
