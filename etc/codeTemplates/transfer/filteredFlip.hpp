/*  A template: copy it to src/pic/transfer/schemes, rename FilteredFlip and its word, replace the
    formula.

    FLIP whose particles keep of what the grid does not see only what lasts (replace by the scheme's
    source):

        d = v + sum W du - sum W u,     s += (d - s) dt/tau,        v = sum W u + s

    tau [s]. At dt = tau this is FLIP, for dt << tau PIC; longer steps would overshoot. s is what
    the particle remembers. Linear splines, whose gradient jumps between cells, would put these
    jumps into d.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/schemes/card.hpp"

namespace riprap
{

struct FilteredFlip : SchemeCard
{
    static constexpr const char* word = "filteredFlip";
    static constexpr const char* text =
        "velocity of the grid, and what of the particles' own lasts";

    // a number that only this scheme has is kept by name
    static constexpr TransferEntry filterTime =
        TransferEntry("filterTime", "s", "time that a velocity of its own must last").like(0.05);
    static constexpr TransferEntry entries[] = {filterTime, transferEntry::affine};

    template<int Order> static constexpr bool goesWith = Order > 1;

    static double timeStep(const TransferProperties& p) { return filterTime.value(p); }

    template<class R>
    struct Formula : FormulaCard
    {
        static constexpr int memory = 1;
        R part;                 // dt/tau

        template<class T>
        HD T velocity(T own, T change, T grid, T* s) const
        {
            s[0] += T(part)*(own + change - grid - s[0]);
            return grid + s[0];
        }
    };

    template<class R>
    static Formula<R> make(const TransferProperties& p, double dt)
    {
        Formula<R> f{};
        f.part = R(dt/filterTime.value(p));
        return f;
    }
};

} // namespace riprap
