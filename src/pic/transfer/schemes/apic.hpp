/*  APIC, affine particles in cells (Jiang, Schroeder, Selle, Teran & Stomakhin 2015, ACM Trans.
    Graph. 34): PIC whose particles always keep the gradient,

        v = sum W u,    C = (sum W u (x_f - x_p)^T) D^-1

    with D the second moment of the splines (window.hpp); linear ones, which have no such moment,
    take the derivative.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/schemes/pic.hpp"

namespace riprap
{

struct Apic : SchemeCard
{
    static constexpr const char* word = "apic";
    static constexpr const char* text = "velocity of the grid and its gradient";
    static constexpr NoEntries<TransferEntry> entries{};
    static constexpr bool gradient = true;

    template<class> using Formula = TakeGrid;
    template<class R> static Formula<R> make(const TransferProperties&, double) { return {}; }
};

} // namespace riprap
