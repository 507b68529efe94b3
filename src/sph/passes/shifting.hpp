/*  Whether particles are shifted (ShiftingModel in fluidPass.hpp has the formula).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

namespace riprap
{

struct NoShifting
{
    static constexpr const char* word = "none";
    static constexpr const char* text = "particles move by their velocity";
    static constexpr bool shifts = false;
};

struct FickianShifting
{
    static constexpr const char* word = "fickian";
    static constexpr const char* text = "from dense to sparse places (Skillen et al. 2013)";
    static constexpr bool shifts = true;
};

} // namespace riprap
