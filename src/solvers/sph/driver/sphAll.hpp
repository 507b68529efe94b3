/*  SphSolver for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/driver/sphSolver.hpp"
#include "solvers/sph/sphInstances.hpp"
