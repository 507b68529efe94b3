/*  A blow: forces from outside act on bodies at once over a time that no step resolves,

        v += dt F/m,   w += dt M/I;   of a clump  V += dt sum F/m,   L += dt sum (r x F + M)

    as the reversible multiple-time-step method has it for slow forces (Tuckerman, Berne & Martyna 1992, J. Chem. Phys. 97, 1990). Damping does not
    see it. Groups that move as they are told, and what is held of others, stay as they are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/motion/clump.hpp"

namespace riprap
{

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
    double dt;

    HD void operator()(int i) const
    {
        if (i >= *active || (clumps && fields.clump[i] >= 0)) return;
        const GroupData<D, real>& g = groups[fields.group[i]];
        if (g.motion >= 0) return;
        const real* f = external + (long long)fields.id[i]*(D + spins<D>);
        for (int d = 0; d < D; ++d) fields.v[d][i] += double(g.free[d])*dt*double(f[d])/double(fields.mass[i]);
        for (int c = 0; c < spins<D>; ++c) fields.w[c][i] += g.freeSpin*real(dt)*fields.inverseInertia[i]*f[D + c];
    }
};

template<int D, class P>
struct PushClumps
{
    using real = typename P::real;
    static constexpr const char* name = "pushClumps";

    ClumpData* clumps;
    Box<D, P> box;
    SolidFields<D, P> fields;
    const GroupData<D, real>* groups;
    const int* first;           // members of each clump
    const int* member;          // keys of particles
    const int* slotOf;          // where a key is
    const real* external;
    double dt;

    HD void operator()(int k) const
    {
        ClumpData& c = clumps[k];
        const GroupData<D, real>& g = groups[c.group];
        double f[3] = {}, m[3] = {};
        for (int e = first[k]; e < first[k + 1]; ++e)
        {
            const int i = slotOf[member[e]];
            if (i < 0) continue;
            const real* more = external + (long long)member[e]*(D + spins<D>);
            Vec<3, double> arm{{0, 0, 0}}, force{{0, 0, 0}};
            for (int d = 0; d < D; ++d)
            {
                arm.c[d] = double(std::int64_t(std::uint64_t(fields.x[d][i]) - std::uint64_t(c.x[d])))*box.unit[d];
                force.c[d] = double(more[d]);
                f[d] += force.c[d];
            }
            const Vec<3, double> t = cross(arm, force);
            for (int s = 0; s < spins<D>; ++s)
            {
                const int d = D == 2 ? 2 : s;
                m[d] += t.c[d] + double(more[D + s]);
            }
        }
        for (int d = 0; d < D; ++d) c.v[d] += double(g.free[d])*dt*f[d]/c.mass;
        for (int d = 0; d < 3; ++d) c.L[d] += double(g.freeSpin)*dt*m[d];
    }
};

} // namespace riprap
