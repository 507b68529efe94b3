/*  The pass over the fluid: accelerations, density rates and drifts from fluid and wall neighbours,
    and what the time integration does at the end of it. A part of it alone (momentum or density)
    leaves the other's state untouched.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/pairLoop.hpp"
#include "core/containers/ghostMarks.hpp"
#include "sph/state/fluidFields.hpp"
#include "sph/terms/term.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

//- Kernel constants for a constant h, and what is needed to form them where it varies
template<int D, class R>
struct KernelConstants
{
    R alpha, inverseH, wFactor, fFactor;    // W = wFactor value(q), F = fFactor slope(q)
    R spacing;
    R inverseValueAtSpacing;                // 1/value(dp/h)

    template<class Kernel>
    static KernelConstants make(double h, double spacing)
    {
        const double a = Kernel::alpha(D);
        return KernelConstants
        {
            R(a), R(1/h), R(a/std::pow(h, D)), R(a/std::pow(h, D + 2)), R(spacing),
            R(1/Kernel::value(spacing/h))
        };
    }
};

//- Separation, kernel and its gradient of a pair
template<class Kernel, bool VariableH, bool NeedsW, int D, class T, class R>
HD PairGeometry<D, T> pairGeometry
(
    const KernelConstants<D, R>& k, R h0, const PairParticle<D, T>& i, const PairParticle<D, T>& j,
    const Vec<D, T>& dx, T r2
)
{
    PairGeometry<D, T> g;
    g.dx = dx;
    g.dv = i.velocity - j.velocity;
    g.r2 = r2;
    g.approach = dot(g.dv, dx);
    const T r = squareRoot(r2);
    if constexpr (VariableH)
    {
        g.h = T(R(0.5))*(i.h + j.h);
        const T inverse = T(R(1))/g.h;
        const T q = r*inverse;
        const T scale = T(k.alpha)*power<D>(inverse);
        g.f = scale*inverse*inverse*Kernel::slope(q);
        if constexpr (NeedsW)
        {
            const T value = Kernel::value(q);
            g.w = scale*value;
            g.wRatio = value/Kernel::value(T(k.spacing)*inverse);
        }
    }
    else
    {
        g.h = T(h0);
        const T q = r*T(k.inverseH);
        g.f = T(k.fFactor)*Kernel::slope(q);
        if constexpr (NeedsW)
        {
            const T value = Kernel::value(q);
            g.w = T(k.wFactor)*value;
            g.wRatio = value*T(k.inverseValueAtSpacing);
        }
    }
    return g;
}

//- Particle shifting (Lind et al. 2012, Skillen et al. 2013): drift -= A h |v| grad C, faded out
//  towards the free surface by the divergence of position
template<class R>
struct ShiftingModel { R coefficient, surface, interior; };

//- What solids do to fluid particles, summed by a pass of its own (coupling/solidPasses.hpp). Null:
//  there are none
template<int D, class R>
struct SolidAction
{
    R* a[D];                    // [m/s2]
    R* rate;                    // drho/dt [kg/m3/s]
    R* drift[D];                // of XSPH [m/s]; null: off
};

//- store: keep the sums only. close: also finish the step (half kick; the whole density step in
//  Part::density)
enum class Finish : int {store, close};

template<class Backend, int Dim, class P, class Kernel, bool VariableH, Part part, class FluidTerms,
    class WallTerms, bool Shifts>
struct FluidPass
{
    using precision = P;
    using real = typename P::real;
    template<class T> using Self = PairParticle<Dim, T>;

    static constexpr const char* name = part == Part::all
        ? "fluidPass"
        : (part == Part::momentum ? "momentumPass" : "densityPass");
    static constexpr bool momentum = part != Part::density, density = part != Part::momentum;
    static constexpr int dimensions = Dim, sources = 2;
    static constexpr bool variableH = VariableH, hasMaxima = true;
    static constexpr bool smooths = FluidTerms::smooths;
    static constexpr int smoothAt = Dim + 1;
    static constexpr int shiftAt = smoothAt + (smooths ? Dim : 0);
    static constexpr int channels = shiftAt + (Shifts ? Dim + 1 : 0);

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[2];      // fluid, wall
    FluidTerms fluidTerms;
    WallTerms wallTerms;
    KernelConstants<Dim, real> kernel;
    ShiftingModel<real> shifting;
    FluidModel<Dim, P> model;
    FluidFields<Dim, P> fluid;
    const real* wallVelocity[Dim];          // null where all walls are fixed
    const int* count;
    ClockData* clock;
    Finish mode;
    SolidAction<Dim, real> solids;
    GhostMarks<Backend> ghosts;

    HD bool skips(int i) const { return ghosts(i); }
    HD bool enabled() const { return clock->active; }
    HD int targets() const { return *count; }
    HD float* maxima() const { return clock->maxima; }
    HD Vec<Dim, typename P::position> position(int i) const
    {
        return source[0].records.loadPosition(i);
    }

    template<class T>
    HD Self<T> self(int i) const
    {
        const PairParticle<Dim, real> p = source[0].records.template load<VariableH>(i);
        return Self<T>{convert<T>(p.velocity), T(p.pressureTerm), T(p.density), T(p.h)};
    }

    template<int S, class T>
    HD void pair(const Self<T>& i, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2,
        int at, T* sums) const
    {
        constexpr bool needsW = S == 0 && FluidTerms::needsW;
        PairGeometry<Dim, T> g = pairGeometry<Kernel, VariableH, needsW>(
            kernel, model.h0, i, j, dx, r2);
        // the record of a wall holds the velocity that laminar viscosity sees; volume changes by
        // the wall's own, and so artificial viscosity only ever takes energy
        if constexpr (S == 1) g.approach = dot(wallApproach(i, at), dx);
        Channels<T> c{T(real(0)), T(real(0)), T(real(0)), T(real(0))};
        if constexpr (S == 0) fluidTerms(i, j, g, c); else wallTerms(i, j, g, c);
        const T mass(S == 0 ? model.mass : model.wallMass);
        const T mf = mass*g.f;
        if constexpr (momentum)
        {
            const T radial = mf*c.radial, cross = mf*c.cross;
            for (int d = 0; d < Dim; ++d) sums[d] += radial*g.dx.c[d] + cross*g.dv.c[d];
        }
        if constexpr (density) sums[Dim] += mf*c.rate;
        if constexpr (smooths && S == 0)
        {
            const T smooth = mass*g.w*c.smooth;
            for (int d = 0; d < Dim; ++d) sums[smoothAt + d] -= smooth*g.dv.c[d];
        }
        if constexpr (Shifts)
        {
            const T vf = mf/j.density;
            for (int d = 0; d < Dim; ++d) sums[shiftAt + d] += vf*g.dx.c[d];
            sums[shiftAt + Dim] -= vf*g.r2;
        }
    }

    HD void finish(int i, const real* sums, float* maxima) const
    {
        const real dt = mode == Finish::close ? real(clock->dt) : real(0);
        real a2 = 0, v2 = 0;
        for (int d = 0; d < Dim; ++d)
        {
            real v = fluid.v[d][i];
            if constexpr (momentum)
            {
                real a = sums[d] + model.gravity.c[d];
                if (solids.a[0]) a += solids.a[d][i];
                fluid.a[d][i] = a;
                v += real(0.5)*dt*a;
                fluid.v[d][i] = v;
                a2 += a*a;
            }
            v2 += v*v;
        }
        real deviation = fluid.deviation[i];
        if constexpr (density)
        {
            const real rate = (sums[Dim] + (solids.rate ? solids.rate[i] : real(0)))/model.rho0;
            fluid.rate[i] = rate;
            deviation += (part == Part::all ? real(0.5)*dt : dt)*rate;
            fluid.deviation[i] = deviation;
        }
        const real speed = squareRoot(v2);
        drift(i, sums, speed);
        // who leaves before the next step does not shorten it
        if (model.wild(deviation, v2, a2)) return;
        if constexpr (momentum) report(maxima[0], float(a2));
        report(maxima[1], float(model.eos.soundSpeed(deviation) + speed));
        report(maxima[2], float(absolute(deviation)));
        report(maxima[3], float(speed));
    }

private:

    //- v_i - u_w
    template<class T>
    HD Vec<Dim, T> wallApproach(const Self<T>& i, int at) const
    {
        Vec<Dim, T> v = i.velocity;
        if (wallVelocity[0])
            for (int d = 0; d < Dim; ++d) v.c[d] = v.c[d] - loadLanes<T>(wallVelocity[d] + at);
        return v;
    }

    HD void drift(int i, const real* sums, real speed) const
    {
        if constexpr (smooths || Shifts)
        {
            real fade = 0;
            if constexpr (Shifts)
            {
                fade = (sums[shiftAt + Dim] - shifting.surface)
                    /(shifting.interior - shifting.surface);
                fade = minimum(maximum(fade, real(0)), real(1))*shifting.coefficient*model.h0*speed;
            }
            for (int d = 0; d < Dim; ++d)
            {
                real u = 0;
                if constexpr (smooths)
                    u += sums[smoothAt + d] + (solids.drift[0] ? solids.drift[d][i] : real(0));
                if constexpr (Shifts)
                {
                    // never faster than a fifth of the particle's own speed
                    const real limit = real(0.2)*speed;
                    u += minimum(maximum(-fade*sums[shiftAt + d], -limit), limit);
                }
                fluid.drift[d][i] = u;
            }
        }
    }

    //- A value that is not finite is reported as infinity, which the clock's guard sees
    HD static void report(float& maximum, float value)
    {
        const float v = value < 1e30f ? value : 3e38f;
        maximum = v > maximum ? v : maximum;
    }
};

} // namespace riprap
