/*  What a fluid particle F and a solid particle S do to each other, written once: the pass over the
    fluid and the pass over the solids evaluate the same functors on the same arguments (fluid
    first), so that action and reaction differ by round-off.

    The solid particle is a boundary point of the volume V_S = m_S/rho0 and acts by paper 1, Eqs.
    32, 34 and 36 with
        stationary              p_S = 0, rho_S = rho0
        pressureGradient        F_FS = - V_F V_S p_F grad W          (Eq. 40) in place of Eq. 34
        pressureApproximation   p_S = sum p_F W m_F/rho_F (Eq. 41), rho_S by the equation of state
        extrapolated            p_S by Adami, Hu & Adams 2012, Eq. 27, with the solid's own
                                acceleration
    Viscosity and the anti-clump term (Eq. 38) are switched by the case; XSPH (Eq. 39) too, where
    the fluid has it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/passes/fluidPass.hpp"
#include "sph/terms/antiClump.hpp"
#include "sph/terms/continuity.hpp"

namespace riprap
{

//- Pressure between a fluid particle (first) and a solid one
struct SolidPressure : TermTraits
{
    bool gradient;              // Eq. 40

    template<class Q, class G, class T>
    HD void operator()(const Q& fluid, const Q& solid, const G&, Channels<T>& c) const
    {
        // m_S p_F/(rho_F rho0): Eq. 34 with p_S = 0 but for one density
        if (gradient) c.radial -= fluid.pressureTerm*fluid.density/solid.density;
        else c.radial -= fluid.pressureTerm + solid.pressureTerm;
    }
};

template<class Viscous, class R>
struct SolidTerms
{
    SolidPressure pressure;
    Continuity continuity;
    Viscous viscous;            // Terms<...>
    Switchable<AntiClump<R>> antiClump;
    R smoothing;                // 2 epsilon of XSPH, 0: off

    template<Part part, class Q, class G, class T>
    HD Channels<T> evaluate(const Q& fluid, const Q& solid, const G& g) const
    {
        Channels<T> c{T(R(0)), T(R(0)), T(R(0)), T(R(0))};
        if constexpr (part != Part::density)
        {
            pressure(fluid, solid, g, c);
            viscous(fluid, solid, g, c);
            antiClump(fluid, solid, g, c);
        }
        if constexpr (part != Part::momentum)
        {
            continuity(fluid, solid, g, c);
            c.smooth += T(smoothing)/(fluid.density + solid.density);
        }
        return c;
    }
};

//- Geometry of a pair, x_F - x_S = dx. `own` is the solid's velocity; that of its record is what
//  laminar viscosity sees
template<class Kernel, bool VariableH, int D, class T, class R>
HD PairGeometry<D, T> solidGeometry(const KernelConstants<D, R>& kernel, R h0,
    const PairParticle<D, T>& fluid, const PairParticle<D, T>& solid, const Vec<D, T>& own,
    const Vec<D, T>& dx, T r2)
{
    PairGeometry<D, T> g = pairGeometry<Kernel, VariableH, true>(kernel, h0, fluid, solid, dx, r2);
    g.approach = dot(fluid.velocity - own, dx);
    return g;
}

} // namespace riprap
