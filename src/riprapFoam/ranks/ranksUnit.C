// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "allRanks.C"
#include "logRanks.C"
#include "pstreamTransport.C"
#include "rankBalance.C"
#include "wholeBoundary.C"
