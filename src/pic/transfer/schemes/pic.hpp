/*  PIC: particles take the grid's velocity (Harlow 1964, Methods in Computational Physics 3):

        v = sum W u

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/schemes/card.hpp"

namespace riprap
{

//- The velocity of the grid
struct TakeGrid : FormulaCard
{
    static constexpr bool own = false;
    HD static constexpr bool keepsOwn() { return false; }

    template<class T>
    HD T velocity(T, T, T grid, T*) const { return grid; }
};

struct Pic : SchemeCard
{
    static constexpr const char* word = "pic";
    static constexpr const char* text = "velocity of the grid";
    static constexpr TransferEntry entries[] = {transferEntry::affine};

    template<class> using Formula = TakeGrid;
    template<class R> static Formula<R> make(const TransferProperties&, double) { return {}; }
};

} // namespace riprap
