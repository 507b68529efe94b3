/*  What acts on a particle, put together from what the passes over contacts, walls and bonds have
    left (CPU), and motion by it at once: while steps follow one another forces need not be written
    down.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#ifndef __CUDACC__

#include "dem/bond/bondPass.hpp"
#include "dem/motion/mover.hpp"
#include "dem/passes/scatterPass.hpp"
#include "dem/walls/wallPass.hpp"

namespace riprap
{

template<int D, class P>
struct CollectedForce
{
    using real = typename P::real;
    static constexpr int words = DeferredForces<D, real>::width;

    const DeferredForces<D, real>* deferred;
    const real* sums;               // of the block's own contacts
    const int* wallFirst;           // entries of a particle; null: there are no walls
    const real* wallForce;
    BondTable bonds;
    const BondForce<D, real>* bondForce;
    const std::int32_t* id;

    void operator()(int i, Vec<D, real>& f, Spin<D, real>& m) const
    {
        real total[words];
        for (int k = 0; k < words; ++k) total[k] = sums[std::size_t(i)*words + k];
        for (int s = deferred->firstOf[i], last = deferred->firstOf[i + 1]; s < last; ++s)
        {
            const int slot = deferred->slotOf[s];
            if (!deferred->acts[slot]) continue;
            for (int k = 0; k < words; ++k)
                total[k] += deferred->force[std::size_t(slot)*words + k];
        }
        for (int d = 0; d < D; ++d) f.c[d] = total[d];
        for (int c = 0; c < spins<D>; ++c) m.c[c] = total[(D == 3 ? 4 : D) + c];
        if (wallFirst)
            for (int e = wallFirst[i]; e < wallFirst[i + 1]; ++e)
            {
                const real* kept = wallForce + std::size_t(e)*wallWords<D>;
                for (int d = 0; d < D; ++d) f.c[d] += kept[d];
                for (int c = 0; c < spins<D>; ++c) m.c[c] += kept[D + c];
            }
        if (bonds.first) GatherBonds<D, P>::sum(bonds, bondForce, id[i], f, m);
    }
};

//- Into the fields. A sleeper's are those of when it fell asleep
template<int D, class P>
struct CollectForces
{
    using real = typename P::real;
    static constexpr const char* name = "collectForces";

    CollectedForce<D, P> collected;
    SolidFields<D, P> fields;
    const int* active;

    void operator()(int i) const
    {
        if (i >= *active || fields.asleep(i)) return;
        Vec<D, real> f;
        Spin<D, real> m;
        collected(i, f, m);
        for (int d = 0; d < D; ++d) fields.f[d][i] = f.c[d];
        for (int c = 0; c < spins<D>; ++c) fields.m[c][i] = m.c[c];
    }
};

//- Kick and drift by them (no members of clumps). Plain: nobody whom it moves sleeps or is another
//  process's, no fluid, damping or prescribed motion acts, so that nothing asks a particle for them
template<int D, class P, bool Plain>
struct MoveCollected
{
    using real = typename P::real;
    static constexpr const char* name = "moveSolids";

    CollectedForce<D, P> collected;
    MoveSolids<D, P> mover;

    HD void operator()(int i) const
    {
        if (Plain && !isPlain(i)) __builtin_unreachable();
        if (!mover.clock->active || i >= *mover.active || mover.fields.asleep(i)) return;
        Vec<D, real> f;
        Spin<D, real> m;
        collected(i, f, m);
        mover.move(i, f, m);
    }

    //- What the compiler may take for granted
    HD bool isPlain(int i) const
    {
        const GroupData<D, real>& group = mover.groups[mover.fields.group[i]];
        return !mover.fields.calm && !mover.external && !mover.clumps && !mover.verlet
            && !mover.sharesMass && !mover.frames.frame && group.motion < 0 && !group.damped;
    }
};

} // namespace riprap

#endif
