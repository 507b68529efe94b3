/*  Rigid bodies of several spheres: a body's state and its motion; dem/motion/clumpSums.hpp has
    what its members hand to it.

    Translation by leapfrog as for particles. Rotation keeps the angular momentum L in space:
        L_{n+1/2} = L_{n-1/2} + M_n dt                 w(q, L) = R(q) I^-1 R(q)^T L
        q* = exp(w(q_n, L) dt/2) q_n                   (the orientation of the half step)
        q_{n+1} = exp(w(q*, L) dt) q_n
    L is kept exactly in free flight, energy to second order (as the methods of Miller et al. 2002).
    In 2D L = I w.
    Verlet kicks by half a step before and after. Local and viscous damping as of a particle, on the
    body as a whole. What a group's constraint leaves: dem/motion/clumpConstraint.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/state/clock.hpp"
#include "dem/motion/clumpConstraint.hpp"
#include "dem/state/solidFields.hpp"

namespace riprap
{

//- Kick of a clump by its forces over dt
template<int D, class P>
struct ClumpKick
{
    const GroupData<D, typename P::real>* groups;
    double gravity[3];
    Box<D, P> box;
    const ClumpConstraint* constraints;         // of groups; null: none is constrained

    HD void operator()(ClumpData& c, double dt) const
    {
        const auto& g = groups[c.group];
        Vec<3, double> f{{0, 0, 0}}, m{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
        {
            const double all = c.f[d] + double(g.gravity)*c.mass*gravity[d] + double(g.force[d]);
            f.c[d] = locallyDamped(all, c.v[d], double(g.localDamping))
                - double(g.viscous)*c.mass*c.v[d];
        }
        const Vec<3, double> w = spinOf(c, c.q);
        for (int s = 0; s < spins<D>; ++s)
        {
            const int d = D == 2 ? 2 : s;
            m.c[d] = locallyDamped(c.m[d] + double(g.moment[s]), w.c[d], double(g.localDamping))
                - double(g.viscousSpin)*c.L[d];
        }
        accelerate(c, g, constraints, box, f, m, dt);
    }
};

template<int D, class P>
struct MoveClumps
{
    static constexpr const char* name = "moveClumps";

    ClumpData* clumps;
    ClumpKick<D, P> kick;
    bool verlet;
    const DemClockData* clock;

    HD void operator()(int k) const
    {
        const DemClockData& t = *clock;
        ClumpData& c = clumps[k];
        if (!t.active || c.left) return;
        kick(c, verlet ? 0.5*t.dt : 0.5*(t.previousDt + t.dt));
        if (kick.constraints && kick.constraints[c.group].hinge)
            return swing(c, kick.constraints[c.group], kick.box, t.dt);
        for (int d = 0; d < D; ++d)
            c.x[d] += std::int64_t(rint(c.v[d]*t.dt*kick.box.unitsPerMetre[d]));
        if (kick.constraints && kick.constraints[c.group].turn != ClumpTurn::free)
            return turnAbout(c, kick.constraints[c.group], t.dt);
        double middle[4], next[4];
        turn(c.q, spinOf(c, c.q), 0.5*t.dt, middle);
        turn(c.q, spinOf(c, middle), t.dt, next);
        for (int e = 0; e < 4; ++e) c.q[e] = next[e];
    }
};

template<int D, class P>
struct FinishClumps
{
    static constexpr const char* name = "finishClumps";

    ClumpData* clumps;
    ClumpKick<D, P> kick;
    const DemClockData* clock;

    HD void operator()(int k) const
    {
        if (clock->forcesDue() && !clumps[k].left) kick(clumps[k], 0.5*clock->dt);
    }
};

} // namespace riprap
