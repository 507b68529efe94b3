/*  Anti-clump term against tensile instability (paper Eq. 38 as corrected in docs/theory.md;
    Monaghan 2000):
        dv_i/dt -= sum m_j epsilon (|p_i|/rho_i^2 + |p_j|/rho_j^2) (W/W(dp))^4 grad_i W, epsilon =
        1/100
    Between fluid particles only.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/card.hpp"

namespace riprap
{

template<class R>
struct AntiClump : TermCard
{
    static constexpr const char* word = "antiClump";
    static constexpr const char* text = "term against tensile instability (Monaghan 2000)";
    static constexpr TermEntry entries[] =
    {
        TermEntry("antiClump", "", "antiClump", &TermProperties::antiClump)
            .in(Range::zeroOrPositive).atMost(2).byDefault(0.01)
    };
    static constexpr bool needsW = true, frequent = true;

    R epsilon;

    static AntiClump make(const TermProperties& p, const TermFluid&)
    {
        AntiClump t;
        t.epsilon = R(p.antiClump);
        return t;
    }

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        c.radial -= T(epsilon)*(absolute(i.pressureTerm) + absolute(j.pressureTerm))
            *power<4>(g.wRatio);
    }
};

} // namespace riprap
