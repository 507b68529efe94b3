/*  What pair terms do with a case's numbers, found by their own formulas: for whoever says what a
    case does not need.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/sphModels.hpp"

namespace riprap
{

struct TermEffect
{
    bool idle = false;              // it adds nothing to any pair, to the bit
    bool seesViscosity = false;     // what it adds depends on the fluid's viscosity
    bool atWalls = false;           // it acts at walls that do not slip, and at solids
};

//- In the order of pairTerms(), whether they are chosen or not
std::vector<TermEffect> termEffects(const SphConfig&);

} // namespace riprap
