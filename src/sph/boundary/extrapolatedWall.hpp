/*  Extrapolated wall pressure (extrapolation.hpp), and the density that the equation of state gives
    for it. v_w enters laminar viscosity only, volume changes and artificial viscosity see u_w (with
    v_w there, energy grows: docs/theory).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/pairLoop.hpp"
#include "core/containers/ghostMarks.hpp"
#include "sph/boundary/extrapolation.hpp"
#include "sph/boundary/wallFields.hpp"

namespace riprap
{

template<class Backend, int Dim, class P, class Kernel, bool VariableH>
struct ExtrapolatedWallPass
{
    using precision = P;
    using real = typename P::real;
    template<class T> using Self = PairParticle<Dim, T>;

    static constexpr const char* name = "extrapolatedWall";
    static constexpr int dimensions = Dim, sources = 1, channels = extrapolationSums<Dim>;
    static constexpr bool variableH = VariableH, hasMaxima = false, sparse = true;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];      // fluid
    RecordsView<Backend, Dim, P> wall;
    WallFields<Dim, P> fields;
    KernelConstants<Dim, real> kernel;
    FluidModel<Dim, P> model;
    int count;
    const ClockData* clock;     // in a step; null: now
    GhostMarks<Backend> ghosts;

    HD bool skips(int i) const
    {
        if constexpr (!Backend::gpu)
            if (!all() && source[0].ranges && source[0].ranges.none(i)) return true;
        return ghosts(i);
    }
    HD bool enabled() const { return !clock || clock->active; }
    HD int targets() const { return count; }
    HD float* maxima() const { return nullptr; }
    // in a step nobody sees walls about which no fluid is listed: fluid lists walls from as far as
    // walls list fluid
    HD bool all() const { return !clock; }
    HD Vec<Dim, typename P::position> position(int i) const { return wall.loadPosition(i); }

    template<class T>
    HD Self<T> self(int) const
    {
        return Self<T>{filled<Dim>(T(real(0))), T(real(0)), T(real(1)), T(model.h0)};
    }

    template<int S, class T>
    HD void pair(const Self<T>& i, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2, int,
        T* sums) const
    {
        const PairGeometry<Dim, T> g = pairGeometry<Kernel, VariableH, true>(
            kernel, model.h0, i, j, dx, r2);
        addToExtrapolation<Dim, T>(j, dx, g.w, sums);
    }

    HD void finish(int i, const real* sums, float*) const
    {
        Vec<Dim, real> u = filled<Dim>(real(0)), lift = model.gravity;
        if (fields.v[0])
            for (int d = 0; d < Dim; ++d) { u.c[d] = fields.v[d][i]; lift.c[d] -= fields.a[d][i]; }
        PairParticle<Dim, real> p;
        const real pressure = extrapolated<Dim, real>(sums, lift, u, kernel.wFactor, p.velocity);
        p.density = model.rho0*(real(1) + model.eos.deviation(pressure));
        p.pressureTerm = pressure/(p.density*p.density);
        p.h = model.h0;
        wall.store(i, p);
    }
};

struct ExtrapolatedWalls
{
    static constexpr const char* word = "extrapolated";
    static constexpr const char* text = "points take the pressure of the fluid (Adami et al. 2012)";
    static constexpr bool followsFluid = true;

    //- In each step, over the fluid about each point
    template<class Backend, int D, class P, class Kernel, bool VariableH>
    using Pass = ExtrapolatedWallPass<Backend, D, P, Kernel, VariableH>;
};

} // namespace riprap
