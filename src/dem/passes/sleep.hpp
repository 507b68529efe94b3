/*  Particles at rest in a settled pile sleep: their contacts with each other and their motion are
    skipped.

    Every few steps, and after every search for neighbours:
        calm      for so many checks in a row |v| < v_s and |w| R < v_s
        falls asleep, with its velocity set to zero: who is calm, and all of whose neighbours are
        calm or asleep
        wakes     who has a neighbour or a bonded partner that is awake and moves faster than v_s;
                  or a wall near that moves; or when a force from outside has changed
    Neighbours are all in the list, touching or not: what comes near is seen before it touches. A
    sleeper is a wall to those awake that touch it. What its contacts remember is kept: it wakes
    with the forces that it fell asleep with. Members of clumps and particles that move as
    prescribed do not sleep.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/bond/bondPass.hpp"
#include "dem/walls/wallPass.hpp"

namespace riprap
{

//- What is read and written by checks
template<int D, class P>
struct SleepState
{
    SolidFields<D, P> fields;
    SolidRecords<D, P> solids;      // of now
    StepState<D, P> state;          // of fused steps
    const int* active;
    std::int32_t* wakes;            // a neighbour moves
    std::int32_t* waits;            // a neighbour is not calm yet
    std::int32_t needed;            // checks in a row
    std::int32_t* stirs;            // set where someone may fall asleep or wake; may be null
    std::int32_t* changed;          // set where someone does; may be null

    HD bool asleep(int i) const { return fields.asleep(i); }

    //- Threads may write the same flag: it is the same number
    HD static void set(std::int32_t* flag)
    {
#ifdef __CUDA_ARCH__
        *flag = 1;
#else
        __atomic_store_n(flag, 1, __ATOMIC_RELAXED);
#endif
    }
    HD static void setAny(std::int32_t* flag) { if (flag) set(flag); }
};

template<int D, class P>
struct CountCalm
{
    using real = typename P::real;
    static constexpr const char* name = "countCalm";

    SleepState<D, P> sleep;
    real speed;
    const int* wallFirst;           // null: no walls
    const WallEntry* wallEntry;
    const WallData* walls;

    HD void operator()(int i) const
    {
        if (i >= *sleep.active) return;
        int material;
        const ContactBody<D, real> q = sleep.solids.body(i, material);
        const real v2 = squaredNorm(q.velocity), w2 = squaredNorm(q.spin)*q.radius*q.radius;
        const bool member = sleep.fields.clump && sleep.fields.clump[i] >= 0;
        const bool still = !member && !wallMoves(i) && v2 < speed*speed && w2 < speed*speed;
        std::int32_t& calm = sleep.fields.calm[i];
        const bool asleep = sleep.asleep(i);
        sleep.wakes[i] = asleep && !still;
        sleep.waits[i] = 0;
        if (!asleep && !still) calm = 0;
        else if (calm < sleep.needed) ++calm;
        if (calm >= sleep.needed) sleep.setAny(sleep.stirs);
    }

private:

    HD bool wallMoves(int i) const
    {
        if (!wallFirst) return false;
        for (int e = wallFirst[i]; e < wallFirst[i + 1]; ++e)
        {
            const WallData& w = walls[wallEntry[e].wall];
            double sum = 0;
            for (int d = 0; d < 3; ++d) sum += fabs(w.frame.velocity[d]) + fabs(w.frame.spin[d]);
            if (w.motion >= 0 && sum > 0) return true;
        }
        return false;
    }
};

//- What neighbours and bonded partners are doing. Threads may write the same one: it is the same
//  number
template<class Backend, int D, class P>
struct MarkRestless
{
    static constexpr const char* name = "markRestless";

    SleepState<D, P> sleep;
    ContactListView<Backend, typename P::real> list;
    BondTable bonds;
    const int* slotOf;

    HD void operator()(int i) const
    {
        if (i >= *sleep.active) return;
        for (int k = 0; k < list.count[i]; ++k)
        {
            const int j = list.other(list.entry[list.index(i, k)]);
            mark(i, j);
            if (!Backend::gpu) mark(j, i);
        }
        if (!bonds.first) return;
        const int id = sleep.fields.id[i];
        for (int k = bonds.first[id]; k < bonds.first[id + 1]; ++k)
        {
            const int bond = bonds.reference[k] >> 1,
                      j = slotOf[bonds.ids[1 - (bonds.reference[k] & 1)][bond]];
            if (!bonds.broken[bond] && j >= 0) mark(i, j);
        }
    }

private:

    HD void mark(int i, int j) const
    {
        const std::int32_t calm = sleep.fields.calm[j];
        if (calm == 0) sleep.set(sleep.wakes + i);
        if (calm < sleep.needed) sleep.set(sleep.waits + i);
    }
};

//- Full lists: a contact between one asleep and one awake has gone on at the other's end
template<class Backend, int D, class P>
struct TakeHistories
{
    static constexpr const char* name = "takeHistories";

    SleepState<D, P> sleep;
    ContactListView<Backend, typename P::real> list;
    // numbers kept; from which on they change their sign at the other end
    int histories, turns;

    HD void operator()(int i) const
    {
        if (i >= *sleep.active || !sleep.asleep(i) || !sleep.wakes[i]) return;
        for (int k = 0; k < list.count[i]; ++k)
        {
            const std::size_t own = list.index(i, k);
            const int j = list.other(list.entry[own]);
            if (sleep.asleep(j)) continue;
            for (int l = 0; l < list.count[j]; ++l)
            {
                const std::size_t e = list.index(j, l);
                if (list.other(list.entry[e]) != i) continue;
                list.entry[own] = std::uint32_t(j) | (list.entry[e] & list.touching);
                for (int c = 0; c < histories; ++c)
                {
                    const auto h = list.history[list.place(histories, e, c)];
                    list.history[list.place(histories, own, c)] = c < turns ? h : -h;
                }
            }
        }
    }
};

template<int D, class P>
struct FallAsleep
{
    using real = typename P::real;
    static constexpr const char* name = "fallAsleep";

    SleepState<D, P> sleep;
    const GroupData<D, real>* groups;

    HD void operator()(int i) const
    {
        if (i >= *sleep.active) return;
        std::int32_t& calm = sleep.fields.calm[i];
        if (calm >= asleepFrom)
        {
            if (sleep.wakes[i]) turnOut(i, calm);
            return;
        }
        if (sleep.state.own) sleep.state.own[i].flags &= ~OwnWords<real>::asleep;
        const bool moved = groups[sleep.fields.group[i]].motion >= 0;
        if (calm < sleep.needed || sleep.waits[i] || moved) return;
        calm = asleepFrom;
        sleep.setAny(sleep.changed);
        int material;
        ContactBody<D, real> q = sleep.solids.body(i, material);
        q.velocity = filled<D>(real(0));
        q.spin = filled<spins<D>>(real(0));
        const auto x = sleep.solids.position(i);
        sleep.solids.store(i, x, q, material);
        for (int d = 0; d < D; ++d) sleep.fields.v[d][i] = 0;
        for (int c = 0; c < spins<D>; ++c) sleep.fields.w[c][i] = 0;
        if (!sleep.state.own) return;
        // in both records: steps leave it alone
        sleep.state.to.store(i, x, q, material);
        for (int d = 0; d < D; ++d)
        {
            const Vec<D, std::int64_t> place = sleep.state.place(i);
            sleep.state.low[d][i] = StepState<D, P>::lowOf(place.c[d], 0);
        }
        sleep.state.own[i].flags |= OwnWords<real>::asleep;
    }

private:

    HD void turnOut(int i, std::int32_t& calm) const
    {
        calm = 0;
        sleep.setAny(sleep.changed);
        if (sleep.state.own) sleep.state.own[i].flags &= ~OwnWords<real>::asleep;
    }
};

//- Those whose force from outside has changed
template<int D, class P>
struct MarkChanged
{
    static constexpr const char* name = "markChanged";
    SleepState<D, P> sleep;
    const std::int32_t* changed;    // of a key

    HD void operator()(int i) const
    {
        if (i < *sleep.active) sleep.wakes[i] = sleep.asleep(i) && changed[sleep.fields.id[i]];
    }
};

template<int D, class P>
struct WakeMarked
{
    static constexpr const char* name = "wakeMarked";
    SleepState<D, P> sleep;
    HD void operator()(int i) const
    {
        if (i < *sleep.active && sleep.wakes[i]) sleep.fields.calm[i] = 0;
    }
};

//- How many sleep
struct CountAsleep
{
    static constexpr const char* name = "countAsleep";
    const std::int32_t* calm;
    const int* active;

    HD void add(int i, double* sums) const { sums[0] += i < *active && calm[i] >= asleepFrom; }
};

} // namespace riprap
