// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "coupledSolids.C"
#include "coupledSolidsLog.C"
#include "coupledSolidsSpeed.C"
