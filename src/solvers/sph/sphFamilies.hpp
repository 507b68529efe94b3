/*  From the words of a case to compiled passes: kernel, smoothing and terms become types here, once, outside the loops.

    The combinations that scenes usually take are compiled exactly; all others run a general one in which each term is
    switched by a flag that is the same for all pairs. Adding a term: its header, a line in `general`.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphScene.hpp"
#include "sph/boundary/extrapolatedWall.hpp"
#include "sph/boundary/wallForcePass.hpp"
#include "sph/passes/fluidPass.hpp"
#include "sph/kernels/cubicSpline.hpp"
#include "sph/kernels/wendlandC2.hpp"
#include "sph/passes/samplePass.hpp"
#include "sph/terms/antiClump.hpp"
#include "sph/terms/artificialViscosity.hpp"
#include "sph/terms/continuity.hpp"
#include "sph/terms/densityDiffusion.hpp"
#include "sph/terms/laminarViscosity.hpp"
#include "sph/terms/pressure.hpp"
#include "sph/terms/xsph.hpp"

namespace riprap
{

//- Which terms a case uses
struct TermChoice
{
    bool laminar, artificial, antiClump, xsph, diffusion, shifting;

    explicit TermChoice(const SphConfig& c)
    :
        laminar(c.viscosityModel == ViscosityKind::laminar || c.viscosityModel == ViscosityKind::laminarAndArtificial),
        artificial(c.viscosityModel == ViscosityKind::artificial || c.viscosityModel == ViscosityKind::laminarAndArtificial),
        antiClump(c.antiClump > 0), xsph(c.xsph > 0), diffusion(c.diffusion != DiffusionKind::none),
        shifting(c.shifting != ShiftingKind::none)
    {}

    bool exactly(bool l, bool a, bool ac, bool x, bool d) const
    {
        return laminar == l && artificial == a && antiClump == ac && xsph == x && diffusion == d && !shifting;
    }
};

//- The parameters of every term of a case, in the precision R
template<int D, class R>
struct TermParameters
{
    LaminarViscosity<R> laminar;
    ArtificialViscosity<R> artificial;
    AntiClump<R> antiClump;
    Xsph<R> xsph;
    DensityDiffusion<D, R> diffusion;
    ShiftingModel<R> shifting;
    TermChoice on;
    bool wallViscosity, wallArtificial, solidArtificial;

    explicit TermParameters(const SphConfig& c)
      : on(c), wallViscosity(c.noSlip), wallArtificial(c.noSlip && c.artificialAtWalls), solidArtificial(c.artificialAtWalls)
    {
        laminar.mu = R(c.viscosity);
        laminar.softening = R(c.viscositySoftening);
        artificial.alphaC0 = R(c.artificialAlpha*c.soundSpeed);
        antiClump.epsilon = R(c.antiClump);
        xsph.epsilon = R(c.xsph);
        diffusion.factor = R(2*c.diffusionDelta*c.soundSpeed);
        for (int d = 0; d < D; ++d)
            diffusion.hydrostatic.c[d] = c.diffusion == DiffusionKind::fourtakas
              ? R(c.density*c.gravity[c.axes[d]]/(c.soundSpeed*c.soundSpeed)) : R(0);
        const double surface = c.shiftingSurfaceThreshold >= 0 ? c.shiftingSurfaceThreshold : (D == 2 ? 1.5 : 2.75);
        shifting = ShiftingModel<R>{R(c.shiftingCoefficient), R(surface), R(D)};
    }

    //- viscous: else the pressure alone
    template<Part part>
    auto wallTerms(bool viscous = true) const
    {
        if constexpr (part == Part::density) return Terms{Continuity{}};
        else return Terms{Pressure{}, Continuity{}, Switchable<LaminarViscosity<R>>(laminar, viscous && on.laminar && wallViscosity),
            Switchable<ArtificialViscosity<R>>(artificial, viscous && on.artificial && wallArtificial)};
    }

    //- Call f(fluid terms, shifts?) with the types that fit the case: all terms in one pass
    template<bool Specialised, class F>
    void withAllTerms(const F& f) const
    {
        const Pressure p{};
        const Continuity c{};
        if constexpr (Specialised)
        {
            if (on.exactly(true, false, false, false, false)) return f(Terms{p, c, laminar}, std::false_type());
            if (on.exactly(true, false, true, true, false)) return f(Terms{p, c, laminar, antiClump, xsph}, std::false_type());
            if (on.exactly(false, true, false, false, true)) return f(Terms{p, c, artificial, diffusion}, std::false_type());
        }
        const Switchable<LaminarViscosity<R>> l(laminar, on.laminar);
        const Switchable<ArtificialViscosity<R>> a(artificial, on.artificial);
        const Switchable<AntiClump<R>> ac(antiClump, on.antiClump);
        const Switchable<DensityDiffusion<D, R>> d(diffusion, on.diffusion);
        const Switchable<Xsph<R>> x(xsph, on.xsph);
        if (on.shifting) f(Terms{p, c, l, a, ac, d, x}, std::true_type());
        else if (on.xsph) f(Terms{p, c, l, a, ac, d, x}, std::false_type());
        else f(Terms{p, c, l, a, ac, d}, std::false_type());
    }

    //- The terms of the momentum equation
    template<bool Specialised, class F>
    void withMomentumTerms(const F& f) const
    {
        const Pressure p{};
        if constexpr (Specialised)
        {
            if (on.laminar && !on.artificial && !on.antiClump) return f(Terms{p, laminar}, std::false_type());
            if (on.laminar && !on.artificial && on.antiClump) return f(Terms{p, laminar, antiClump}, std::false_type());
            if (!on.laminar && on.artificial && !on.antiClump) return f(Terms{p, artificial}, std::false_type());
        }
        f(Terms{p, Switchable<LaminarViscosity<R>>(laminar, on.laminar),
            Switchable<ArtificialViscosity<R>>(artificial, on.artificial),
            Switchable<AntiClump<R>>(antiClump, on.antiClump)}, std::false_type());
    }

    //- The terms that change density and positions
    template<bool Specialised, class F>
    void withDensityTerms(const F& f) const
    {
        const Continuity c{};
        if constexpr (Specialised)
        {
            if (!on.diffusion && !on.xsph && !on.shifting) return f(Terms{c}, std::false_type());
            if (on.diffusion && !on.xsph && !on.shifting) return f(Terms{c, diffusion}, std::false_type());
        }
        const Switchable<DensityDiffusion<D, R>> d(diffusion, on.diffusion);
        const Switchable<Xsph<R>> x(xsph, on.xsph);
        if (on.shifting) f(Terms{c, d, x}, std::true_type());
        else if (on.xsph) f(Terms{c, d, xsph}, std::false_type());
        else f(Terms{c, d}, std::false_type());
    }

    template<Part part, bool Specialised, class F>
    void withFluidTerms(const F& f) const
    {
        if constexpr (part == Part::all) withAllTerms<Specialised>(f);
        else if constexpr (part == Part::momentum) withMomentumTerms<Specialised>(f);
        else withDensityTerms<Specialised>(f);
    }
};

//- Call f(kernel, variable h?) with the types that fit the case
template<class F>
void withKernel(const SphConfig& c, const F& f)
{
    if (c.kernel == KernelKind::wendlandC2)
    {
        if (c.variableSmoothing) f(WendlandC2(), std::true_type()); else f(WendlandC2(), std::false_type());
    }
    else
    {
        if (c.variableSmoothing) f(CubicSpline(), std::true_type()); else f(CubicSpline(), std::false_type());
    }
}

} // namespace riprap
