// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "logPrecision.H"
#include "moduleLog.H"
#include "progressClock.H"
#include "sceneNeeds.H"
#include "scratchCase.hpp"
#include "StringStream.H"
#include <cstdio>
#include <gtest/gtest.h>
namespace sceneNeedsTests
{
#include "sceneNeeds.C"
}
