/*  A blow: forces from outside act on bodies at once over a time that no step resolves,

        v += dt F/m,   w += dt M/I;   of a clump  V += dt sum F/m,   L += dt sum (r x F + M)

    as the reversible multiple-time-step method has it for slow forces (Tuckerman, Berne & Martyna 1992, J. Chem. Phys. 97, 1990). Damping does not
    see it. Groups that move as they are told, and what is held of others, stay as they are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/motion/clumpSums.hpp"

namespace riprap
{

//- Over what time: given, or half of a step that the device alone knows and may have switched off
struct BlowTime
{
    double given;
    const double* step = nullptr;
    const int* on = nullptr;

    HD bool any() const { return !on || *on; }
    HD double operator()() const { return step ? 0.5**step : given; }
};

template<int D, class P>
struct PushSolids
{
    using real = typename P::real;
    static constexpr const char* name = "pushSolids";

    SolidFields<D, P> fields;
    const GroupData<D, real>* groups;
    const real* external;       // by key: D + spins numbers
    bool clumps;
    const int* active;
    BlowTime time;

    HD void operator()(int i) const
    {
        if (!time.any() || i >= *active || (clumps && fields.clump[i] >= 0)) return;
        const GroupData<D, real>& g = groups[fields.group[i]];
        if (g.motion >= 0) return;
        const real* f = external + (long long)fields.id[i]*(D + spins<D>);
        const double dt = time();
        for (int d = 0; d < D; ++d) fields.v[d][i] += double(g.free[d])*dt*double(f[d])/double(fields.mass[i]);
        for (int c = 0; c < spins<D>; ++c) fields.w[c][i] += g.freeSpin*real(dt)*fields.inverseInertia[i]*f[D + c];
    }
};

template<int D, class P>
struct PushClumps
{
    static constexpr const char* name = "pushClumps";
    static constexpr bool contacts = false;

    ClumpMembers<D, P> members;
    const GroupData<D, typename P::real>* groups;
    const ClumpConstraint* constraints;
    BlowTime time;

    HD bool active() const { return time.any(); }

    HD void use(ClumpData& c, const double* sums) const
    {
        accelerate(c, groups[c.group], constraints, members.box, vectorOf(sums), vectorOf(sums + 3), time());
    }
};

} // namespace riprap
