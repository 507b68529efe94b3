/*  XSPH (paper Eq. 39 with W as corrected in docs/theory.md; Monaghan 1989): dx_i/dt = v_i - epsilon sum m_j/rho_ij (v_i - v_j) W

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/term.hpp"

namespace riprap
{

template<class R>
struct Xsph : TermTraits
{
    static constexpr bool needsW = true;
    static constexpr bool smooths = true;
    R epsilon;

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G&, Channels<T>& c) const
    {
        c.smooth += T(R(2)*epsilon)/(i.density + j.density);
    }
};

} // namespace riprap
