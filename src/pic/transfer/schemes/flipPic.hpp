/*  FLIP with a share b of PIC, which takes away what of the particles' velocities the grid cannot
    see (Zhu & Bridson 2005, ACM Trans. Graph. 24):

        v = (1 - b)(v + sum W du) + b sum W u

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/schemes/card.hpp"

namespace riprap
{

template<class R>
struct Blend : FormulaCard
{
    R b;                        // 0 FLIP .. 1 PIC

    HD bool keepsOwn() const { return b < 1; }
    HD bool readsGrid() const { return b > 0; }

    template<class T>
    HD T velocity(T own, T change, T grid, T*) const
    {
        T v(R(0));
        if (b < 1) v += T(1 - b)*(own + change);
        if (b > 0) v += T(b)*grid;
        return v;
    }
};

struct FlipPic : SchemeCard
{
    static constexpr const char* word = "flipPic";
    static constexpr const char* text =
        "change of the grid's velocity, with a share of that velocity";
    static constexpr TransferEntry entries[] = {
        TransferEntry("picPart", "", "share of PIC", &TransferProperties::picPart)
            .in(Range::zeroOrPositive)
            .atMost(1)
            .byDefault(0.05)
            .like(0.3),
        transferEntry::affine};

    template<class R> using Formula = Blend<R>;
    template<class R> static Formula<R> make(const TransferProperties& p, double)
    {
        return of(R(p.picPart));
    }
    template<class R> static Formula<R> of(R b) { Formula<R> f{}; f.b = b; return f; }
};

} // namespace riprap
