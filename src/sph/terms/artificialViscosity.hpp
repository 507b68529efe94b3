/*  Artificial viscosity (Monaghan 1992), acting on approaching pairs only:
        dv_i/dt = - sum m_j Pi_ij grad_i W,  Pi_ij = - alpha c0 mu_ij/rho_ij, mu_ij = h min(v_ij .
                                             x_ij, 0)/(r^2 + 0.01 h^2)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/card.hpp"

namespace riprap
{

template<class R>
struct ArtificialViscosity : TermCard
{
    static constexpr const char* word = "artificialViscosity";
    static constexpr const char* text = "artificial viscosity (Monaghan 1992)";
    static constexpr TermSwitch chosenBy = termSwitch::viscosity;
    static constexpr std::array words{"artificial", "laminarAndArtificial"};
    static constexpr const char* coeffs = "artificialViscosity";
    static constexpr TermEntry entries[] =
    {
        TermEntry("alpha", "", "alpha", &TermProperties::artificialAlpha)
            .in(Range::zeroOrPositive).atMost(100).byDefault(0.02),
        TermEntry("walls", "also at walls", &TermProperties::artificialAtWalls, false)
            .show(Shown::never)
    };
    static constexpr bool atWalls = true, frequent = true;

    R alphaC0;                  // alpha c0 [m/s]

    static ArtificialViscosity make(const TermProperties& p, const TermFluid& f)
    {
        ArtificialViscosity t;
        t.alphaC0 = R(p.artificialAlpha*f.soundSpeed);
        return t;
    }

    static bool actsAtWalls(const TermProperties& p) { return p.artificialAtWalls; }

    //- Monaghan 2005: nu = alpha c0 h/(2 (D + 2))
    static double viscosity(const TermProperties& p, const TermFluid& f)
    { return p.artificialAlpha*f.soundSpeed*f.h/(2*(f.dimensions + 2)); }

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        const T mu = g.h*minimum(g.approach, T(R(0)));
        c.radial += T(R(2)*alphaC0)*mu/((g.r2 + T(R(0.01))*g.h*g.h)*(i.density + j.density));
    }
};

} // namespace riprap
