// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "deviceChoice.C"
#include "fluidCloud.C"
#include "readSphProperties.C"
#include "sphDictionaries.C"
#include "sphNames.C"
#include "sphRestart.C"
#include "sphSceneObject.C"
#include "sphSettings.C"
