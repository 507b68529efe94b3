// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "bondLines.C"
#include "demInput.C"
#include "demMotion.C"
#include "demRestart.C"
#include "demSceneObject.C"
#include "demWallInput.C"
#include "matchesCloud.C"
#include "solidCloud.C"
#include "solidFiles.C"
#include "solidFilesRead.C"
#include "solidNeeds.C"
#include "touchingStart.C"
