// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: these sources are compiled together
#include "coupledSolids.H"
#include "particleCase.hpp"
#include "boxMesh.hpp"
#include "picObstacles.H"
#include "picShapes.H"
#include "scratchCase.hpp"
#include "wallPoints.H"
#include "picGrid.H"
#include "modelFamily.hpp"
#include "pic/openings/kinds.hpp"
#include "pic/terms/viscousSchemes.hpp"
#include "picDictionaries.H"
#include "deviceChoice.H"
#include "timeWriter.H"
#include "core/backend/gpus.hpp"
#include "coupling/couplings.hpp"
#include "coupling/fluidForces.hpp"
#include "solvers/sph/sphModels.hpp"
#include "sphDictionaries.H"
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <omp.h>
namespace coupled_coupledSolidsTests
{
#include "coupled/coupledSolids.C"
}
namespace pic_obstaclesTests
{
#include "pic/obstacles.C"
}
namespace pic_picGridTests
{
#include "pic/picGrid.C"
}
namespace pic_picSettingsTests
{
#include "pic/picSettings.C"
}
namespace sph_deviceChoiceTests
{
#include "sph/deviceChoice.C"
}
namespace sph_sphSettingsTests
{
#include "sph/sphSettings.C"
}
