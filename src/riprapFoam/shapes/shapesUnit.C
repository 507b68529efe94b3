// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "bodyFaces.C"
#include "bodyLog.C"
#include "closedSurface.C"
#include "clumpOutline.C"
#include "clumpShape.C"
#include "csvFile.C"
#include "exactShapes.C"
