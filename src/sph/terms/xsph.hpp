/*  XSPH (paper Eq. 39 with W as corrected in docs/theory.md; Monaghan 1989): dx_i/dt = v_i -
    epsilon sum m_j/rho_ij (v_i - v_j) W

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/card.hpp"

namespace riprap
{

template<class R>
struct Xsph : TermCard
{
    static constexpr const char* word = "XSPH";
    static constexpr const char* text = "drift with the neighbours (Monaghan 1989)";
    static constexpr TermEntry entries[] = {TermEntry("XSPH", "", "XSPH", &TermProperties::xsph)
                                                .in(Range::zeroOrPositive)
                                                .atMost(2)
                                                .byDefault(0)};
    static constexpr Part part = Part::density;
    static constexpr bool needsW = true, smooths = true, frequent = true;

    R epsilon;

    static Xsph make(const TermProperties& p, const TermFluid&)
    {
        Xsph t;
        t.epsilon = R(p.xsph);
        return t;
    }

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G&, Channels<T>& c) const
    {
        c.smooth += T(R(2)*epsilon)/(i.density + j.density);
    }
};

} // namespace riprap
