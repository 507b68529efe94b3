/*  DemSolver for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/demInstances.hpp"
#include "solvers/dem/driver/demSolver.hpp"
