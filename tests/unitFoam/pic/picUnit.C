// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "boxMesh.hpp"
#include "picObstacles.H"
#include "picShapes.H"
#include "scratchCase.hpp"
#include "wallPoints.H"
#include "picGrid.H"
#include "modelFamily.hpp"
#include "particleCase.hpp"
#include "pic/openings/kinds.hpp"
#include "pic/terms/viscousSchemes.hpp"
#include "picDictionaries.H"
#include <cmath>
#include <gtest/gtest.h>
namespace obstaclesTests
{
#include "obstacles.C"
}
namespace picGridTests
{
#include "picGrid.C"
}
namespace picSettingsTests
{
#include "picSettings.C"
}
