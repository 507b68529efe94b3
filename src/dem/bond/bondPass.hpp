/*  Bond forces: one thread a bond computes and keeps them, then each particle gathers its own, in
    order. No atomics.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/blocks.hpp"
#include "dem/bond/parallelBond.hpp"
#include "dem/state/clock.hpp"
#include "dem/lists/listBuild.hpp"
#include "dem/lists/stepState.hpp"

namespace riprap
{

template<int D, class P>
struct BondFields
{
    using real = typename P::real;

    int n;
    const std::int32_t* ids[2];         // keys of the ends
    const std::int32_t* type;
    double* rest;                       // unstressed gap [m]
    real* history;                      // bondHistory a bond
    std::int32_t* broken;               // BondBreak
    BondForce<D, real>* force;          // of the last step
    const BondParameters<real>* types;
    const int* slotOf;                  // where a key is
};

template<int D, class P>
struct BondPass
{
    using real = typename P::real;
    static constexpr const char* name = "bonds";

    BondFields<D, P> bonds;
    Box<D, P> box;
    SolidFields<D, P> fields;
    SolidRecords<D, P> solids;
    ForceClock clock;
    StepState<D, P> state;      // of fused steps

    HD void operator()(int k) const
    {
        if (clock.active()) bonds.force[k] = compute(k, bonds.history + k*bondHistory<D>);
    }

    //- history: of this bond, read and written
    HD BondForce<D, real> compute(int k, real* history) const
    {
        if (bonds.broken[k]) return BondForce<D, real>{};
        const int i = bonds.slotOf[bonds.ids[0][k]], j = bonds.slotOf[bonds.ids[1][k]];
        int unused;
        const ContactBody<D, real> a = solids.body(i, unused), b = solids.body(j, unused);
        const bool fused = clock.turn == ForceTurn::ahead;
        const Vec<D, std::int64_t> xi = fused ? state.place(i) : fields.position(i),
                                   xj = fused ? state.place(j) : fields.position(j);
        double line[D], d2 = 0;
        for (int d = 0; d < D; ++d)
        {
            // 64 bits and double: a bond's stretch is far smaller than its length
            line[d] = double(std::int64_t(std::uint64_t(xj.c[d]) - std::uint64_t(xi.c[d])))
                *box.unit[d];
            d2 += line[d]*line[d];
        }
        const double distance = sqrt(d2);
        Vec<D, real> n;
        for (int d = 0; d < D; ++d) n.c[d] = real(line[d]/distance);
        const double stretch = distance - (double(a.radius) + double(b.radius)) - bonds.rest[k];
        BondForce<D, real> f = bondForce(bonds.types[bonds.type[k]], a, b, n, real(distance),
            real(stretch), real(clock.dt()), history);
        if (f.broken != int(BondBreak::none))
        {
            bonds.broken[k] = int(f.broken);
            clock.raised->needRebuild = 1;      // the two may touch from now on
            f = BondForce<D, real>{};
        }
        return f;
    }
};

//- The same by blocks of the GPU. Forces and histories are records: threads that write one each
//  write words far apart, ten times what memory must move. So a block's records pass through shared
//  memory, whole
template<int D, class P>
struct BondBlocks
{
    using real = typename P::real;
    using Force = BondForce<D, real>;
    static constexpr const char* name = "bonds";
    static constexpr int threads = 256, historyWords = bondHistory<D>*sizeof(real)/4,
                         forceWords = sizeof(Force)/4;
    struct Shared { alignas(8) unsigned history[threads*historyWords], force[threads*forceWords]; };

    BondPass<D, P> pass;

    HD void operator()(const Team& team, Shared& shared, int block) const
    {
        if (!pass.clock.active()) return;       // the same for all threads
        const int first = block*threads,
                  count = pass.bonds.n - first < threads ? pass.bonds.n - first : threads;
        unsigned* histories = reinterpret_cast<unsigned*>(pass.bonds.history)
            + std::size_t(first)*historyWords;
        unsigned* forces = reinterpret_cast<unsigned*>(pass.bonds.force)
            + std::size_t(first)*forceWords;
        team.each(count*historyWords, [&](int w) { shared.history[w] = histories[w]; });
        team.each(count, [&](int k)
        {
            reinterpret_cast<Force*>(shared.force)[k]
              = pass.compute(first + k, reinterpret_cast<real*>(shared.history) + k*bondHistory<D>);
        });
        team.each(count*historyWords, [&](int w) { histories[w] = shared.history[w]; });
        team.each(count*forceWords, [&](int w) { forces[w] = shared.force[w]; });
    }
};

template<int D, class P>
struct GatherBonds
{
    using real = typename P::real;
    static constexpr const char* name = "gatherBonds";

    BondTable table;
    const BondForce<D, real>* force;
    SolidFields<D, P> fields;
    ForceClock clock;
    const int* active;

    HD void operator()(int i) const
    {
        if (!clock.active() || i >= *active) return;
        Vec<D, real> f = filled<D>(real(0));
        Spin<D, real> m = filled<spins<D>>(real(0));
        if (sum(table, force, fields.id[i], f, m)) fields.addForce(i, f, m);
    }

    //- What its bonds do to the particle of this key; false: it has none
    HD static bool sum(const BondTable& table, const BondForce<D, real>* force, int key,
        Vec<D, real>& f, Spin<D, real>& m)
    {
        const int first = table.first[key], last = table.first[key + 1];
        for (int k = first; k < last; ++k)
        {
            const BondForce<D, real>& b = force[table.reference[k] >> 1];
            const bool second = table.reference[k] & 1;
            f = second ? f - b.force : f + b.force;
            m = m + (second ? b.momentB : b.momentA);
        }
        return first < last;
    }
};

//- After a sort: bonds of particles that left are lost
template<int D, class P>
struct LoseBonds
{
    static constexpr const char* name = "loseBonds";
    BondFields<D, P> bonds;

    HD void operator()(int k) const
    {
        if (!bonds.broken[k]
            && (bonds.slotOf[bonds.ids[0][k]] < 0 || bonds.slotOf[bonds.ids[1][k]] < 0))
            bonds.broken[k] = int(BondBreak::lost);
    }
};

//- Bonded pairs that overlapped when they were bonded touch only beyond that overlap
template<class Backend, int D, class P>
struct RestBonds
{
    static constexpr const char* name = "restBonds";
    BondFields<D, P> bonds;
    ContactListView<Backend, typename P::real> list;

    HD void operator()(int k) const
    {
        if (!(bonds.rest[k] < 0)) return;
        const int a = bonds.slotOf[bonds.ids[0][k]], b = bonds.slotOf[bonds.ids[1][k]];
        if (a < 0 || b < 0) return;
        set(a < b ? a : b, a < b ? b : a, k);
        if (Backend::gpu) set(a < b ? b : a, a < b ? a : b, k);
    }

private:

    HD void set(int owner, int partner, int k) const
    {
        for (int l = 0; l < list.count[owner]; ++l)
        {
            const std::size_t e = list.index(owner, l);
            if (list.other(list.entry[e]) == partner)
                list.rest[e] = typename P::real(-bonds.rest[k]);
        }
    }
};

} // namespace riprap
