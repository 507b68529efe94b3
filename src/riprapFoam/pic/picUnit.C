// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "picCloud.C"
#include "picDictionaries.C"
#include "picGrid.C"
#include "picNames.C"
#include "picObstacles.C"
#include "picOpenings.C"
#include "picRestart.C"
#include "picSceneObject.C"
#include "picShapes.C"
