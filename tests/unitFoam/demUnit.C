// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
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
namespace dem_demInputTests
{
#include "dem/demInput.C"
}
namespace dem_demRestartTests
{
#include "dem/demRestart.C"
}
namespace dem_demWallsTests
{
#include "dem/demWalls.C"
}
namespace dem_readConstraintsTests
{
#include "dem/readConstraints.C"
}
namespace dem_readSolidLawsTests
{
#include "dem/readSolidLaws.C"
}
namespace dem_readSolidPropertiesTests
{
#include "dem/readSolidProperties.C"
}
namespace dem_solidCloudTests
{
#include "dem/solidCloud.C"
}
namespace dem_solidFilesTests
{
#include "dem/solidFiles.C"
}
namespace dem_solidNeedsTests
{
#include "dem/solidNeeds.C"
}
namespace dem_writtenBondsTests
{
#include "dem/writtenBonds.C"
}
