/*  Pressure gradient (paper Eq. 34, sign as corrected in docs/theory.md): dv_i/dt = - sum m_j
    (p_i/rho_i^2 + p_j/rho_j^2) grad_i W

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/term.hpp"

namespace riprap
{

struct Pressure : TermTraits
{
    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G&, Channels<T>& c) const
    {
        c.radial -= i.pressureTerm + j.pressureTerm;
    }
};

} // namespace riprap
