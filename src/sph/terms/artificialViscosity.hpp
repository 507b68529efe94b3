/*  Artificial viscosity (Monaghan 1992), acting on approaching pairs only:
        dv_i/dt = - sum m_j Pi_ij grad_i W,  Pi_ij = - alpha c0 mu_ij/rho_ij,  mu_ij = h min(v_ij . x_ij, 0)/(r^2 + 0.01 h^2)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/term.hpp"

namespace riprap
{

template<class R>
struct ArtificialViscosity : TermTraits
{
    R alphaC0;                  // alpha c0 [m/s]

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        const T mu = g.h*minimum(g.approach, T(R(0)));
        c.radial += T(R(2)*alphaC0)*mu/((g.r2 + T(R(0.01))*g.h*g.h)*(i.density + j.density));
    }
};

} // namespace riprap
