// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "allRanks.H"
#include "boxMesh.hpp"
#include "dividedCloud.H"
#include "pstreamTransport.H"
#include "scratchCase.hpp"
#include "wholeBoundary.H"
#include <gtest/gtest.h>
namespace allRanksTests
{
#include "allRanks.C"
}
