// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "coupledPCG.C"
#include "pressureSolver.C"
#include "processRanks.C"
#include "solverEntries.C"
#include "wetMesh.C"
