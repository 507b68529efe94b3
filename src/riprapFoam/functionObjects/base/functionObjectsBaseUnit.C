// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "checkFunctionObjects.C"
#include "demFunctionObject.C"
#include "fluidFunctionObject.C"
#include "runningScenes.C"
#include "sceneFunctionObject.C"
#include "trailingMean.C"
