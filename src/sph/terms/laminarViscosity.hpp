/*  Laminar viscosity (paper Eq. 36; Morris et al. 1997), mu [Pa s] the same for both particles:
        dv_i/dt = sum m_j 2 mu (v_i - v_j) (x_ij . grad_i W)/(rho_i rho_j (r^2 + eta h^2))
    eta, `softening`, is 0.01 in the paper. Nothing needs it for stability, since grad W vanishes
    with r, and it takes 1.4 % of the viscosity away.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/card.hpp"

namespace riprap
{

template<class R>
struct LaminarViscosity : TermCard
{
    static constexpr const char* word = "laminarViscosity";
    static constexpr const char* text = "laminar viscosity (Morris et al. 1997)";
    static constexpr TermSwitch chosenBy = termSwitch::viscosity;
    static constexpr std::array words{"laminar", "laminarAndArtificial"};
    static constexpr const char* coeffs = "laminarViscosity";
    static constexpr TermEntry entries[] =
    {
        TermEntry("softening", "", "softening", &TermProperties::viscositySoftening).byDefault(0.01)
    };
    static constexpr bool atWalls = true, frequent = true;

    R mu;
    R softening = R(0.01);

    static LaminarViscosity make(const TermProperties& p, const TermFluid& f)
    {
        LaminarViscosity t;
        t.mu = R(f.viscosity);
        t.softening = R(p.viscositySoftening);
        return t;
    }

    static double viscosity(const TermProperties&, const TermFluid& f)
    { return f.viscosity/f.density; }

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        c.cross += T(R(2)*mu)*g.r2/(i.density*j.density*(g.r2 + T(softening)*g.h*g.h));
    }
};

} // namespace riprap
