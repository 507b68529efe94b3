/*  A blow: forces from outside act on bodies at once over a time that no step resolves,

        v += dt F/m,   w += dt M/I;   of a clump  V += dt sum F/m,   L += dt sum (r x F + M)

    as the reversible multiple-time-step method has it for slow forces (Tuckerman, Berne & Martyna
    1992, J. Chem. Phys. 97, 1990). Damping does not see it. Groups that move as they are told, and
    what is held of others, stay as they are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/motion/clumpSums.hpp"

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
        for (int d = 0; d < D; ++d)
            fields.v[d][i] += double(g.free[d])*dt*double(f[d])/double(fields.mass[i]);
        for (int c = 0; c < spins<D>; ++c)
            fields.w[c][i] += g.freeSpin*real(dt)*fields.inverseInertia[i]*f[D + c];
    }
};

} // namespace riprap
