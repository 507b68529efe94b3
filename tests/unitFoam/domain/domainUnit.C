// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "boxMesh.hpp"
#include "escapeCount.H"
#include "scratchCase.hpp"
#include "api/sphScene.hpp"
#include "particleDomain.H"
#include <gtest/gtest.h>
namespace escapeCountTests
{
#include "escapeCount.C"
}
namespace particleDomainTests
{
#include "particleDomain.C"
}
