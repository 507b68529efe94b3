/*  Symplectic scheme: kick, half drift, density, half drift, kick. Two half passes over the pairs a
    step.

        v_{n+1/2}   = v_n + a_n dt/2
        x_{n+1/2}   = x_n + (v_{n+1/2} + drift) dt/2
        rho_{n+1}   = rho_n + dt rate(x_{n+1/2}, v_{n+1/2})         (pass over the density terms)
        x_{n+1}     = x_{n+1/2} + (v_{n+1/2} + drift) dt/2
        v_{n+1}     = v_{n+1/2} + a(x_{n+1}, rho_{n+1}) dt/2        (pass over the momentum terms)

    Density is a coordinate here: it moves with the velocity of the middle of the step, forces
    follow from it at the end. A sound wave then keeps its amplitude up to omega dt = 2, where the
    leapfrog with predicted density grows by (omega dt)^4/4 a step (docs/theory). Viscosity sees the
    velocity predicted to n+1 by a_n.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/time/leapfrog.hpp"

namespace riprap
{

template<class Backend, int D, class P>
struct SymplecticKick : Mover<Backend, D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "symplecticKick";

    HD void operator()(int i) const
    {
        const ClockData& c = *this->clock;
        if (!c.active || i >= *this->count || this->ghosts(i)) return;
        const FluidFields<D, P>& f = this->fluid;
        const real half = real(0.5*c.dt);
        Vec<D, real> v;
        for (int d = 0; d < D; ++d)
        {
            v.c[d] = f.v[d][i] + f.a[d][i]*half;
            f.v[d][i] = v.c[d];
        }
        if (this->tookOut(i, v, f.deviation[i])) return;
        const Vec<D, std::int64_t> x = this->moved(this->position(i), v + this->drift(i), 0.5*c.dt);
        for (int d = 0; d < D; ++d) f.x[d][i] = x.c[d];
        this->recordMoved(i, x, v, f.deviation[i]);
    }
};

template<class Backend, int D, class P>
struct SymplecticDrift : Mover<Backend, D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "symplecticDrift";
    // the few that meet a face must not take registers from all
    static constexpr int residentBlocks = 12;

    HD void operator()(int i) const
    {
        const ClockData& c = *this->clock;
        if (!c.active || i >= *this->count || this->ghosts(i)) return;
        const FluidFields<D, P>& f = this->fluid;
        const real half = real(0.5*c.dt);
        Vec<D, real> v, kick;
        for (int d = 0; d < D; ++d)
        {
            v.c[d] = f.v[d][i];
            kick.c[d] = f.a[d][i]*half;
        }
        if (this->tookOut(i, v, f.deviation[i])) return;
        const Vec<D, real> u = v + this->drift(i);
        Vec<D, std::int64_t> x = this->moved(this->position(i), u, 0.5*c.dt);
        this->keepOut(i, kick, x, v);
        for (int d = 0; d < D; ++d) f.x[d][i] = x.c[d];
        this->recordMoved(i, x, v + kick, f.deviation[i]);
        this->checkSkin(i, x, u);
    }
};

struct SphSymplectic : IntegratorCard
{
    static constexpr const char* word = "symplectic";
    static constexpr const char* text = "density in the middle of a step, forces at its end";
    static constexpr int passes = 2;
    // the density pass sees the walls as the step finds them
    static constexpr bool seesWallsFirst = true;
    // No scene stands the highest (benchmarks/README.md: 1.82)
    static constexpr double acousticCourant = 0.5, highestCourant = 2;

    template<class Step>
    static void run(Step& step)
    {
        step.template move<SymplecticKick>();
        step.moveToMiddle();
        step.template pass<Part::density>();
        step.template move<SymplecticDrift>();
        step.moveToEnd();
        step.template pass<Part::momentum>();
    }
};

} // namespace riprap
