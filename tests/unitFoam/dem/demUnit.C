// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "runningSolids.hpp"
#include "sceneState.H"
#include "touchingStart.H"
#include "readSolidProperties.H"
#include "scratchCase.hpp"
#include "particleCase.hpp"
#include "dem/bond/bondRadius.hpp"
#include "dem/motion/integrators.hpp"
#include "modelFamily.hpp"
#include "timeWriter.H"
#include "writtenSolids.hpp"
#include "solidRegionCase.hpp"
#include "solidNeeds.H"
#include "StringStream.H"
#include "lineFile.hpp"
#include "pictures.H"
#include <gtest/gtest.h>
#include <limits>
namespace demInputTests
{
#include "demInput.C"
}
namespace demRestartTests
{
#include "demRestart.C"
}
namespace demWallsTests
{
#include "demWalls.C"
}
namespace readConstraintsTests
{
#include "readConstraints.C"
}
namespace readSolidLawsTests
{
#include "readSolidLaws.C"
}
namespace readSolidPropertiesTests
{
#include "readSolidProperties.C"
}
namespace solidCloudTests
{
#include "solidCloud.C"
}
namespace solidFilesTests
{
#include "solidFiles.C"
}
namespace solidNeedsTests
{
#include "solidNeeds.C"
}
namespace writtenBondsTests
{
#include "writtenBonds.C"
}
