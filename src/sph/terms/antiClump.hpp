/*  Anti-clump term against tensile instability (paper Eq. 38 as corrected in docs/theory.md; Monaghan 2000):
        dv_i/dt -= sum m_j epsilon (|p_i|/rho_i^2 + |p_j|/rho_j^2) (W/W(dp))^4 grad_i W,   epsilon = 1/100
    Between fluid particles only.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/term.hpp"

namespace riprap
{

template<class R>
struct AntiClump : TermTraits
{
    static constexpr bool needsW = true;
    R epsilon;

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        c.radial -= T(epsilon)*(absolute(i.pressureTerm) + absolute(j.pressureTerm))*power<4>(g.wRatio);
    }
};

} // namespace riprap
