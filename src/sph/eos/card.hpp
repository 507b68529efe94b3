/*  What equations of state say about themselves besides word, text and the formulas: defaults of
    their cards.

    d = rho/rho0 - 1 is the deviation of the density, so that single precision keeps small changes.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/equationProperties.hpp"
#include "core/simd/math.hpp"

namespace riprap
{

struct EquationCard
{
    static constexpr NoEntries<EquationEntry> entries{};

    //- The least deviation that a pressure is given: the fluid cannot be emptier than half its
    //  rest density
    static constexpr double emptiest = -0.5;
};

} // namespace riprap
