// SPDX-License-Identifier: GPL-3.0-or-later
// Written by etc/unitSources: the sources of this folder, compiled together
#include "deviceChoice.H"
#include "scratchCase.hpp"
#include "timeWriter.H"
#include "core/backend/gpus.hpp"
#include "coupling/couplings.hpp"
#include "coupling/fluidForces.hpp"
#include "modelFamily.hpp"
#include "particleCase.hpp"
#include "solvers/sph/sphModels.hpp"
#include "sphDictionaries.H"
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <omp.h>
namespace deviceChoiceTests
{
#include "deviceChoice.C"
}
namespace sphSettingsTests
{
#include "sphSettings.C"
}
