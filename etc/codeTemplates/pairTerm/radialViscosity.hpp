/*  A template: copy it to src/sph/terms, rename RadialViscosity and its words, replace the formula.

    Viscosity along the line of centres (Monaghan 2005, with nu for alpha c0 h/(2 (D + 2))), which
    keeps angular momentum:

        dv_i/dt = sum m_j 2 (D + 2) mu (v_ij . x_ij)/(rho_i rho_j (r^2 + eta h^2)) grad_i W

    mu [Pa s], eta [].

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/card.hpp"

namespace riprap
{

template<class R>
struct RadialViscosity : TermCard
{
    static constexpr const char* word = "radialViscosity";
    static constexpr const char* text = "viscosity along the line of centres (Monaghan 2005)";

    // chosen by `viscosity radial;`, its numbers in radialViscosity {}
    static constexpr TermSwitch chosenBy = termSwitch::viscosity;
    static constexpr std::array words{"radial"};
    static constexpr const char* coeffs = "radialViscosity";

    // a number that only this term has is kept by name
    static constexpr TermEntry eta = TermEntry("eta", "", "eta").byDefault(0.01);
    static constexpr TermEntry entries[] = {eta};

    // between fluid and walls or solids too
    static constexpr bool atWalls = true;

    R factor;                   // 2 (D + 2) mu [Pa s]
    R softening;

    static RadialViscosity make(const TermProperties& p, const TermFluid& f)
    {
        RadialViscosity t;
        t.factor = R(2*(f.dimensions + 2)*f.viscosity);
        t.softening = R(eta.value(p));
        return t;
    }

    static double viscosity(const TermProperties&, const TermFluid& f)
    { return f.viscosity/f.density; }

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        c.radial += T(factor)*g.approach/(i.density*j.density*(g.r2 + T(softening)*g.h*g.h));
    }
};

} // namespace riprap
