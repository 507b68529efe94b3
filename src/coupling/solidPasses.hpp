/*  The passes of the coupling: what solids do to the fluid, what the fluid does to solids, and the
    pressure that solids take from the fluid (solidTerms.hpp has the equations).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/solidPoints.hpp"
#include "coupling/solidTerms.hpp"
#include "sph/boundary/extrapolation.hpp"

namespace riprap
{

//- Nothing of solids yet, for fluid that has none near until the next sort
template<int D, class R>
struct ClearAction
{
    static constexpr const char* name = "clearSolidAction";

    SolidAction<D, R> action;

    HD void operator()(int i) const
    {
        for (int d = 0; d < D; ++d) action.a[d][i] = 0;
        action.rate[i] = 0;
        if (action.drift[0]) for (int d = 0; d < D; ++d) action.drift[d][i] = 0;
    }
};

//- Sums that FluidPass adds to its own: acceleration, density rate, drift of XSPH
template<class Backend, int Dim, class P, class Kernel, bool VariableH, Part part, class SolidTerms>
struct SolidToFluidPass
{
    using precision = P;
    using real = typename P::real;
    template<class T> using Self = PairParticle<Dim, T>;

    static constexpr const char* name = part == Part::density ? "solidDensityPass"
                                                              : "solidMomentumPass";
    static constexpr int dimensions = Dim, sources = 1, channels = 2*Dim + 1;
    // sums are cleared at each sort
    static constexpr bool variableH = VariableH, hasMaxima = false, sparse = true;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];      // solid points
    RecordsView<Backend, Dim, P> fluid;
    SolidTerms terms;
    KernelConstants<Dim, real> kernel;
    FluidModel<Dim, P> model;
    SolidAction<Dim, real> action;
    const real* mass;
    const real* own[Dim];
    const int* count;
    const ClockData* clock;
    GhostMarks<Backend> ghosts;             // fluid of other ranks

    HD bool skips(int i) const { return ghosts(i); }
    HD bool enabled() const { return clock->active; }
    HD int targets() const { return *count; }
    HD float* maxima() const { return nullptr; }
    HD Vec<Dim, typename P::position> position(int i) const { return fluid.loadPosition(i); }

    template<class T>
    HD Self<T> self(int i) const
    {
        const PairParticle<Dim, real> p = fluid.template load<VariableH>(i);
        return Self<T>{convert<T>(p.velocity), T(p.pressureTerm), T(p.density), T(p.h)};
    }

    template<int S, class T>
    HD void pair(const Self<T>& i, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2,
        int at, T* sums) const
    {
        Vec<Dim, T> u;
        for (int d = 0; d < Dim; ++d) u.c[d] = loadLanes<T>(own[d] + at);
        const PairGeometry<Dim, T> g = solidGeometry<Kernel, VariableH>(
            kernel, model.h0, i, j, u, dx, r2);
        const Channels<T> c =
            terms.template evaluate<part, PairParticle<Dim, T>, PairGeometry<Dim, T>, T>(i, j, g);
        const T m = loadLanes<T>(mass + at), mf = m*g.f;
        if constexpr (part != Part::density)
            for (int d = 0; d < Dim; ++d) sums[d] += mf*(c.radial*g.dx.c[d] + c.cross*g.dv.c[d]);
        if constexpr (part != Part::momentum)
        {
            sums[Dim] += mf*c.rate;
            for (int d = 0; d < Dim; ++d)
                sums[Dim + 1 + d] -= m*g.w*c.smooth*(i.velocity.c[d] - u.c[d]);
        }
    }

    HD void finish(int i, const real* sums, float*) const
    {
        if constexpr (part != Part::density) for (int d = 0; d < Dim; ++d) action.a[d][i] = sums[d];
        if constexpr (part != Part::momentum)
        {
            action.rate[i] = sums[Dim];
            if (action.drift[0])
                for (int d = 0; d < Dim; ++d) action.drift[d][i] = sums[Dim + 1 + d];
        }
    }
};

//- Force of the fluid on each solid particle, at its centre [N]
template<class Backend, int Dim, class P, class Kernel, bool VariableH, class SolidTerms>
struct FluidToSolidPass
{
    using precision = P;
    using real = typename P::real;
    template<class T> struct Self : PairParticle<Dim, T> { Vec<Dim, T> own; T mass; };

    static constexpr const char* name = "solidForce";
    static constexpr int dimensions = Dim, sources = 1, channels = Dim;
    static constexpr bool variableH = VariableH, hasMaxima = false;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];      // fluid
    RecordsView<Backend, Dim, P> solid;
    SolidTerms terms;
    KernelConstants<Dim, real> kernel;
    FluidModel<Dim, P> model;
    SolidPoints<Dim, P> points;
    const ClockData* clock;     // in a step; null: now
    GhostMarks<Backend> ghosts; // points that other ranks work out

    HD bool skips(int i) const { return ghosts(i); }
    HD bool enabled() const { return !clock || clock->active; }
    HD int targets() const { return *points.active; }
    HD float* maxima() const { return nullptr; }
    HD Vec<Dim, typename P::position> position(int i) const { return solid.loadPosition(i); }

    template<class T>
    HD Self<T> self(int i) const
    {
        const PairParticle<Dim, real> p = solid.template load<VariableH>(i);
        Vec<Dim, T> own;
        for (int d = 0; d < Dim; ++d) own.c[d] = T(points.own[d][i]);
        return Self<T>{{convert<T>(p.velocity), T(p.pressureTerm), T(p.density), T(p.h)}, own,
            T(points.mass[i])};
    }

    template<int S, class T>
    HD void pair(const Self<T>& i, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2, int,
        T* sums) const
    {
        Vec<Dim, T> back;       // from the solid to the fluid, as the other pass has it
        for (int d = 0; d < Dim; ++d) back.c[d] = -dx.c[d];
        const PairParticle<Dim, T>& solidParticle = i;
        const PairGeometry<Dim, T> g = solidGeometry<Kernel, VariableH>(
            kernel, model.h0, j, solidParticle, i.own, back, r2);
        const Channels<T> c =
            terms.template evaluate<Part::momentum, PairParticle<Dim, T>, PairGeometry<Dim, T>, T>(
                j, solidParticle, g);
        const T mf = i.mass*g.f;
        for (int d = 0; d < Dim; ++d) sums[d] += mf*(c.radial*g.dx.c[d] + c.cross*g.dv.c[d]);
    }

    HD void finish(int i, const real* sums, float*) const
    {
        for (int d = 0; d < Dim; ++d)
            points.force[std::size_t(points.key[i])*Dim + d] = -model.mass*sums[d];
    }
};

//- Pressure of solid points: paper 1, Eq. 41, or Adami et al. 2012, Eqs. 23 and 27 with g - a_S
template<class Backend, int Dim, class P, class Kernel, bool VariableH>
struct SolidPressurePass
{
    using precision = P;
    using real = typename P::real;
    template<class T> using Self = PairParticle<Dim, T>;

    static constexpr const char* name = "solidPressure";
    static constexpr int dimensions = Dim, sources = 1, channels = extrapolationSums<Dim>;
    static constexpr bool variableH = VariableH, hasMaxima = false;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];      // fluid
    RecordsView<Backend, Dim, P> solid;
    KernelConstants<Dim, real> kernel;
    FluidModel<Dim, P> model;
    SolidPoints<Dim, P> points;
    bool fromAround;            // Adami's; else Eq. 41
    const ClockData* clock;     // in a step; null: now
    GhostMarks<Backend> ghosts; // points that other ranks work out

    HD bool skips(int i) const { return ghosts(i); }
    HD bool enabled() const { return !clock || clock->active; }
    HD int targets() const { return *points.active; }
    HD float* maxima() const { return nullptr; }
    HD Vec<Dim, typename P::position> position(int i) const { return solid.loadPosition(i); }

    template<class T> HD Self<T> self(int) const
    {
        return Self<T>{filled<Dim>(T(real(0))), T(real(0)), T(real(1)), T(model.h0)};
    }

    template<int S, class T>
    HD void pair(const Self<T>& i, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2, int,
        T* sums) const
    {
        const PairGeometry<Dim, T> g = pairGeometry<Kernel, VariableH, true>(
            kernel, model.h0, i, j, dx, r2);
        addToExtrapolation<Dim, T>(j, dx, fromAround ? g.w : T(model.mass)*g.w/j.density, sums);
    }

    HD void finish(int i, const real* sums, float*) const
    {
        PairParticle<Dim, real> p;
        Vec<Dim, real> u, lift;
        for (int d = 0; d < Dim; ++d)
        {
            u.c[d] = points.own[d][i];
            lift.c[d] = model.gravity.c[d]
                - points.acceleration[std::size_t(points.key[i])*Dim + d];
        }
        p.velocity = u;
        p.h = model.h0;
        const real pressure = fromAround
            ? extrapolated<Dim, real>(sums, lift, u, kernel.wFactor, p.velocity)
            : sums[1];
        p.density = model.rho0*(real(1) + model.eos.deviation(pressure));
        p.pressureTerm = pressure/(p.density*p.density);
        solid.store(i, p);
    }
};

} // namespace riprap
