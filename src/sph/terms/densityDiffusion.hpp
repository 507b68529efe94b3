/*  Density diffusion (delta-SPH):
        drho_i/dt += delta h c0 sum psi_ij . grad_i W m_j/rho_j, psi_ij = 2 (rho_j - rho_i -
        rhoH_ij) x_ji/r^2
    molteni  : rhoH = 0 (Molteni & Colagrossi 2009)
    fourtakas: rhoH_ij = rho0 g . (x_j - x_i)/c0^2, the hydrostatic difference, so that a tank at
    rest stays at rest
               (Fourtakas et al. 2019, linearised equation of state)
    Between fluid particles only.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/terms/card.hpp"

namespace riprap
{

//- Which part of rhoH a diffusion leaves alone
struct MolteniDiffusion
{
    static constexpr const char* word = "molteni";
    static constexpr double hydrostatic = 0;
};

struct FourtakasDiffusion
{
    static constexpr const char* word = "fourtakas";
    static constexpr double hydrostatic = 1;
};

using Diffusions = Models<MolteniDiffusion, FourtakasDiffusion>;

template<int D, class R>
struct DensityDiffusion : TermCard
{
    static constexpr const char* word = "densityDiffusion";
    static constexpr const char* text = "Molteni & Colagrossi 2009, Fourtakas et al. 2019";
    static constexpr TermSwitch chosenBy = termSwitch::densityDiffusion;
    static constexpr std::array words{MolteniDiffusion::word, FourtakasDiffusion::word};
    static constexpr const char* coeffs = "densityDiffusionCoeffs";
    static constexpr TermEntry entries[] =
    {
        TermEntry("delta", "", "delta", &TermProperties::diffusionDelta)
            .in(Range::zeroOrPositive).atMost(10).byDefault(0.1)
    };
    static constexpr Part part = Part::density;
    static constexpr bool frequent = true;

    R factor;                   // 2 delta c0 [m/s]
    Vec<D, R> hydrostatic;      // rho0 g/c0^2 [kg/m4]; zero for molteni

    static DensityDiffusion make(const TermProperties& p, const TermFluid& f)
    {
        DensityDiffusion t;
        t.factor = R(2*p.diffusionDelta*f.soundSpeed);
        t.hydrostatic = filled<D>(R(0));
        const int chosen = Diffusions::find(p.diffusion);
        if (chosen < 0) return t;               // none
        Diffusions::at(chosen, [&](auto diffusion)
        {
            const double part = decltype(diffusion)::type::hydrostatic;
            const double c02 = f.soundSpeed*f.soundSpeed;
            for (int d = 0; d < D; ++d)
                t.hydrostatic.c[d] = R(part*(f.density*f.gravity[d]/c02));
        });
        return t;
    }

    template<class Q, class G, class T>
    HD void operator()(const Q& i, const Q& j, const G& g, Channels<T>& c) const
    {
        T difference = j.density - i.density;
        for (int d = 0; d < D; ++d) difference = difference + T(hydrostatic.c[d])*g.dx.c[d];
        c.rate -= T(factor)*g.h*difference/j.density;
    }
};

} // namespace riprap
