// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "advance.C"
#include "dem.C"
#include "dryRun.C"
#include "guards.C"
#include "initialise.C"
#include "logModels.C"
#include "logStep.C"
#include "needs.C"
#include "ranks.C"
#include "restart.C"
#include "softContacts.C"
