/*  Sums over a clump's members of forces and of moments about its centre, sum F and sum (r x F + M)
    [N, N m], and what is done with them:

    GatherClumps: contact forces of now, with the force from outside and that of springs, are the
    clump's forces
    PushClumps:   a blow from outside (dem/motion/push.hpp)

    Of small clumps a thread sums one. A body of thousands of members would keep one thread waiting
    for memory all step long: of such ones a block of threads sums one, each thread its share in the
    members' order, then halves of the block are added: always the same order, always the same bits.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/blocks.hpp"
#include "dem/motion/clump.hpp"
#include "dem/motion/clumpSprings.hpp"

namespace riprap
{

//- Members of each clump, and what acts on one
template<int D, class P>
struct ClumpMembers
{
    using real = typename P::real;

    ClumpData* clumps;
    Box<D, P> box;
    SolidFields<D, P> fields;
    const int* first;           // members of each clump
    const int* member;          // keys of particles
    const int* slotOf;          // where a key is
    const real* external;       // by key: D + spins numbers; may be null

    //- sums[0..2]: forces, sums[3..5]: moments, sums[6]: is it touched?; of the e-th member
    template<bool contacts>
    HD void add(const ClumpData& c, int e, double* sums) const
    {
        const int i = slotOf[member[e]];
        if (i < 0) return;
        const real* more = external ? external + (long long)member[e]*(D + spins<D>) : nullptr;
        Vec<3, double> arm{{0, 0, 0}}, force{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
        {
            arm.c[d] = double(std::int64_t(std::uint64_t(fields.x[d][i]) - std::uint64_t(c.x[d])))
                *box.unit[d];
            if (contacts) force.c[d] = double(fields.f[d][i]);
            if (more) force.c[d] += double(more[d]);
            sums[d] += force.c[d];
        }
        if (contacts)
        {
            bool touched = false;
            for (int d = 0; d < D; ++d) touched = touched || fields.f[d][i] != 0;
            sums[6] += touched;
        }
        const Vec<3, double> t = cross(arm, force);
        for (int s = 0; s < spins<D>; ++s)
        {
            const int d = D == 2 ? 2 : s;
            sums[3 + d] += t.c[d];
            if (contacts) sums[3 + d] += double(fields.m[s][i]);
            if (more) sums[3 + d] += double(more[D + s]);
        }
    }
};

template<int D, class P>
struct GatherClumps
{
    static constexpr const char* name = "gatherClumps";
    static constexpr bool contacts = true;

    ClumpMembers<D, P> members;
    ClumpSprings<D, P> springs;
    const DemClockData* clock;  // null: now

    HD bool active() const { return !clock || clock->forcesDue(); }

    HD void use(ClumpData& c, double* sums) const
    {
        springs.add(c, int(&c - members.clumps), members.box, sums);
        for (int d = 0; d < 3; ++d) { c.f[d] = sums[d]; c.m[d] = sums[3 + d]; }
        c.touching = int(sums[6]);
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
    double dt;

    HD bool active() const { return true; }

    HD void use(ClumpData& c, const double* sums) const
    {
        accelerate(
            c, groups[c.group], constraints, members.box, vectorOf(sums), vectorOf(sums + 3), dt);
    }
};

//- A thread a clump
template<class Sum>
struct EachClump
{
    static constexpr const char* name = Sum::name;

    Sum sum;

    HD void operator()(int k) const
    {
        if (!sum.active()) return;
        ClumpData& c = sum.members.clumps[k];
        double sums[7] = {};
        for (int e = sum.members.first[k]; e < sum.members.first[k + 1]; ++e)
            sum.members.template add<Sum::contacts>(c, e, sums);
        sum.use(c, sums);
    }
};

//- A block a clump
template<class Sum>
struct BlockEachClump
{
    static constexpr const char* name = Sum::name;
    static constexpr int threads = 256;
    struct Shared { double sums[7][threads]; };

    Sum sum;

    HD void operator()(const Team& team, Shared& shared, int k) const
    {
        if (!sum.active()) return;
        ClumpData& c = sum.members.clumps[k];
        double sums[7] = {};
        for (int e = sum.members.first[k] + team.index; e < sum.members.first[k + 1];
             e += team.size)
            sum.members.template add<Sum::contacts>(c, e, sums);
        for (int s = 0; s < 7; ++s) shared.sums[s][team.index] = sums[s];
        team.wait();
        for (int half = team.size/2; half > 0; half /= 2)
        {
            if (team.index < half)
                for (int s = 0; s < 7; ++s)
                    shared.sums[s][team.index] += shared.sums[s][team.index + half];
            team.wait();
        }
        if (team.index > 0) return;
        for (int s = 0; s < 7; ++s) sums[s] = shared.sums[s][0];
        sum.use(c, sums);
    }
};

//- Members from which on a block is quicker than a thread
static constexpr int membersOfABlock = 64;

template<class Backend, class Sum>
void sumClumps(Context<Backend>& context, int clumps, [[maybe_unused]] int largest, const Sum& sum)
{
    if constexpr (Backend::gpu)
        if (largest > membersOfABlock)
            return forEachBlock(context, clumps, BlockEachClump<Sum>{sum});
    forEach(context, clumps, EachClump<Sum>{sum});
}

} // namespace riprap
