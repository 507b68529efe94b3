/*  What integrators of the fluid say about themselves besides

        word, text
        passes              over the pairs, a step
        acousticCourant     default of the entry, and highestCourant, above which it is refused
        run(step)           the passes of a step, by what SphStepper::Step has

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

namespace riprap
{

struct IntegratorCard
{
    // its first pass needs the pressures of walls before the step has moved anything
    static constexpr bool seesWallsFirst = false;
};

} // namespace riprap
