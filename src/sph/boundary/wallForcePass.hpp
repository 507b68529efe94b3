/*  Force of the fluid on wall points: the reaction, pair by pair, of what FluidPass adds to the
    fluid (the same terms, which are antisymmetric), hence equal and opposite to round-off. In a
    step it also sums the work that moving walls do on the fluid, - F . u dt, and the work of the
    walls' own pressure, which is what the fluid gets beyond that:

        m_w sum m p_w/rho_w^2 (v - u_w) . grad_w W dt

    a point of a wall presses as a volume of fluid would that is compressed, but has no density of
    its own that remembers it (docs/theory, Energy).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/pairLoop.hpp"
#include "core/containers/ghostMarks.hpp"
#include "sph/passes/fluidPass.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

template<class Backend, int Dim, class P, class Kernel, bool VariableH, class WallTerms>
struct WallForcePass
{
    using precision = P;
    using real = typename P::real;
    //- A wall point with the velocity that viscosity sees, and its own
    template<class T> struct Self : PairParticle<Dim, T> { Vec<Dim, T> own; };

    static constexpr const char* name = "wallForce";
    static constexpr int dimensions = Dim, sources = 1, channels = Dim + 1;
    static constexpr bool variableH = VariableH, hasMaxima = false;

    Box<Dim, P> box;
    CellGrid<Dim, P> grid;
    Source<Backend, Dim, P> source[1];
    RecordsView<Backend, Dim, P> wall;
    WallTerms terms;
    KernelConstants<Dim, real> kernel;
    FluidModel<Dim, P> model;
    int count;
    real* force;                // Dim a point [N]; null in a step
    const ClockData* clock;     // in a step; null: now
    const real* wallVelocity[Dim];  // null where all walls are fixed
    double* work;               // [J]
    double* pressureWork;       // [J]
    GhostMarks<Backend> ghosts;

    HD bool skips(int i) const { return ghosts(i); }
    HD bool enabled() const { return !clock || clock->active; }
    HD int targets() const { return count; }
    HD float* maxima() const { return nullptr; }
    HD Vec<Dim, typename P::position> position(int i) const { return wall.loadPosition(i); }

    template<class T>
    HD Self<T> self(int i) const
    {
        const PairParticle<Dim, real> p = wall.template load<VariableH>(i);
        Vec<Dim, real> own = filled<Dim>(real(0));
        if (wallVelocity[0]) for (int d = 0; d < Dim; ++d) own.c[d] = wallVelocity[d][i];
        return Self<T>{
            {convert<T>(p.velocity), T(p.pressureTerm), T(p.density), T(p.h)}, convert<T>(own)};
    }

    template<int S, class T>
    HD void pair(const Self<T>& self, const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, T r2,
        int, T* sums) const
    {
        const PairParticle<Dim, T>& i = self;
        PairGeometry<Dim, T> g = pairGeometry<Kernel, VariableH, false>(
            kernel, model.h0, i, j, dx, r2);
        g.approach = dot(self.own - j.velocity, dx);    // as in FluidPass
        Channels<T> c{T(real(0)), T(real(0)), T(real(0)), T(real(0))};
        terms(i, j, g, c);
        const T mf = T(model.mass)*g.f;
        for (int d = 0; d < Dim; ++d) sums[d] += mf*(c.radial*g.dx.c[d] + c.cross*g.dv.c[d]);
        sums[Dim] -= mf*i.pressureTerm*g.approach;
    }

    HD void finish(int i, const real* sums, float*) const
    {
        double power = 0;
        for (int d = 0; d < Dim; ++d)
        {
            const real f = model.wallMass*sums[d];
            if (force) force[Dim*i + d] = f;
            if (work) power -= double(f)*wallVelocity[d][i];
        }
        if (!work) return;
        work[i] += power*clock->dt;
        pressureWork[i] += double(model.wallMass)*sums[Dim]*clock->dt;
    }
};

} // namespace riprap
