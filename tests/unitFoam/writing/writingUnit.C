// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "scratchCase.hpp"
#include "timeManifest.H"
#include "foamVersions/foamVersions.H"
#include "IOField.H"
#include "labelField.H"
#include "labelIOList.H"
#include "OSspecific.H"
#include "sceneState.H"
#include "timeWriter.H"
#include "vectorField.H"
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <sstream>
#include <thread>
namespace manifestTests
{
#include "manifest.C"
}
namespace writingTests
{
#include "writing.C"
}
