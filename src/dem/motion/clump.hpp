/*  Rigid bodies of several spheres: a body's state and its motion; dem/motion/clumpSums.hpp has what its members hand to it.

    Translation by leapfrog as for particles. Rotation keeps the angular momentum L in space:
        L_{n+1/2} = L_{n-1/2} + M_n dt                 w(q, L) = R(q) I^-1 R(q)^T L
        q* = exp(w(q_n, L) dt/2) q_n                   (the orientation of the half step)
        q_{n+1} = exp(w(q*, L) dt) q_n
    L is kept exactly in free flight, energy to second order (as the methods of Miller et al. 2002). In 2D L = I w.
    Verlet kicks by half a step before and after. Local and viscous damping as of a particle, on the body as a whole.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "dem/clock.hpp"
#include "dem/solidFields.hpp"

namespace riprap
{

struct ClumpData
{
    std::int64_t x[3];          // centre of mass, fixed point
    double v[3];
    double L[3];                // angular momentum in space; 2D: L[2]
    double q[4];                // orientation (w, x, y, z); 2D: about the third axis
    double f[3], m[3];          // contact forces and moments now
    double mass, inertia[3];    // principal
    int group, padding;
};

//- R(q) a, or with `inverse` its transpose
HD Vec<3, double> rotated(const double* q, const Vec<3, double>& a, bool inverse = false)
{
    const double s = inverse ? -1 : 1;
    const Vec<3, double> u{{s*q[1], s*q[2], s*q[3]}};
    const Vec<3, double> t = 2.0*cross(u, a);
    return a + q[0]*t + cross(u, t);
}

//- The spin that goes with an angular momentum
HD Vec<3, double> spinOf(const ClumpData& c, const double* q)
{
    const Vec<3, double> L{{c.L[0], c.L[1], c.L[2]}};
    Vec<3, double> b = rotated(q, L, true);
    for (int d = 0; d < 3; ++d) b.c[d] = c.inertia[d] > 0 ? b.c[d]/c.inertia[d] : 0;
    return rotated(q, b);
}

//- exp(w dt) q, normalised
HD void turn(const double* q, const Vec<3, double>& w, double dt, double* to)
{
    const double speed = sqrt(squaredNorm(w)), half = 0.5*speed*dt;
    const double c = cos(half), s = speed > 0 ? sin(half)/speed : 0;
    const double e[4] = {c, s*w.c[0], s*w.c[1], s*w.c[2]};
    const double r[4] =
    {
        e[0]*q[0] - e[1]*q[1] - e[2]*q[2] - e[3]*q[3],
        e[0]*q[1] + e[1]*q[0] + e[2]*q[3] - e[3]*q[2],
        e[0]*q[2] - e[1]*q[3] + e[2]*q[0] + e[3]*q[1],
        e[0]*q[3] + e[1]*q[2] - e[2]*q[1] + e[3]*q[0]
    };
    const double norm = 1/sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2] + r[3]*r[3]);
    for (int k = 0; k < 4; ++k) to[k] = norm*r[k];
}

//- Kick of a clump by its forces over dt
template<int D, class P>
struct ClumpKick
{
    const GroupData<D, typename P::real>* groups;
    double gravity[3];

    HD void operator()(ClumpData& c, double dt) const
    {
        const auto& g = groups[c.group];
        for (int d = 0; d < D; ++d)
        {
            double f = c.f[d] + double(g.gravity)*c.mass*gravity[d] + double(g.force[d]);
            f = locallyDamped(f, c.v[d], double(g.localDamping)) - double(g.viscous)*c.mass*c.v[d];
            c.v[d] += double(g.free[d])*dt*f/c.mass;
        }
        const Vec<3, double> w = spinOf(c, c.q);
        for (int s = 0; s < spins<D>; ++s)
        {
            const int d = D == 2 ? 2 : s;
            const double m = locallyDamped(c.m[d] + double(g.moment[s]), w.c[d], double(g.localDamping))
              - double(g.viscousSpin)*c.L[d];
            c.L[d] += double(g.freeSpin)*dt*m;
        }
    }
};

template<int D, class P>
struct MoveClumps
{
    static constexpr const char* name = "moveClumps";

    ClumpData* clumps;
    Box<D, P> box;
    ClumpKick<D, P> kick;
    bool verlet;
    const DemClockData* clock;

    HD void operator()(int k) const
    {
        const DemClockData& t = *clock;
        if (!t.active) return;
        ClumpData& c = clumps[k];
        kick(c, verlet ? 0.5*t.dt : 0.5*(t.previousDt + t.dt));
        for (int d = 0; d < D; ++d) c.x[d] += std::int64_t(rint(c.v[d]*t.dt*box.unitsPerMetre[d]));
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

    HD void operator()(int k) const { if (clock->active) kick(clumps[k], 0.5*clock->dt); }
};

} // namespace riprap
