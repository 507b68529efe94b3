/*  Continuity (paper Eq. 32): drho_i/dt = rho_i sum m_j/rho_j (v_i - v_j) . grad_i W

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/term.hpp"

namespace riprap
{

struct Continuity : TermTraits
{
    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        c.rate += g.approach*i.density/j.density;
    }
};

} // namespace riprap
