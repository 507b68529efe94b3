/*  PicSolver, and what the instantiating units offer.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/driver/picSolver.hpp"
#include "solvers/pic/picInstances.hpp"
