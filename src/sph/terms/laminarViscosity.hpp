/*  Laminar viscosity (paper Eq. 36; Morris et al. 1997), mu [Pa s] the same for both particles:
        dv_i/dt = sum m_j 2 mu (v_i - v_j) (x_ij . grad_i W)/(rho_i rho_j (r^2 + eta h^2))
    eta, `softening`, is 0.01 in the paper. Nothing needs it for stability, since grad W vanishes with r, and it takes 1.4 % of the viscosity away.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/term.hpp"

namespace riprap
{

template<class R>
struct LaminarViscosity : TermTraits
{
    R mu;
    R softening = R(0.01);

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        c.cross += T(R(2)*mu)*g.r2/(i.density*j.density*(g.r2 + T(softening)*g.h*g.h));
    }
};

} // namespace riprap
