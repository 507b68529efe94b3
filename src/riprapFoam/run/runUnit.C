// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "checkControlDict.C"
#include "documentation.C"
#include "editedFiles.C"
#include "particleModule.C"
#include "postProcessTimes.C"
#include "runForecast.C"
#include "runProgram.C"
#include "solverModule.C"
#include "stopSignals.C"
#include "timePlan.C"
