// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "restartRecord.H"
#include "scratchCase.hpp"
#include "StringStream.H"
#include "sceneState.H"
#include "timeWriter.H"
#include <cmath>
#include <gtest/gtest.h>
namespace restartRecordTests
{
#include "restartRecord.C"
}
namespace sceneStateTests
{
#include "sceneState.C"
}
