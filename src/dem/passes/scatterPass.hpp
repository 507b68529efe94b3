/*  Contact forces over half lists, eight (or four) touching pairs at a time. For the CPU.

    Particles are cut into blocks of fixed size, whichever the number of threads. A block adds to
    its own particles; what its pairs do to particles of later blocks is put aside, entry by entry,
    and added by those blocks afterwards, in order: the same bits for any number of threads.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#ifndef __CUDACC__

#include <algorithm>
#include <vector>
#include "core/simd/pack.hpp"
#include "core/containers/records.hpp"
#include "dem/lists/awakeLists.hpp"
#include "dem/passes/pairModel.hpp"

namespace riprap
{

//- The forces that blocks leave to each other
template<int D, class R>
struct DeferredForces
{
    //- Numbers kept of a particle: force and moment, in rows of four (3D: one each; 2D: one for
    //  both)
    static constexpr int width = D == 3 ? 8 : 4;
    static constexpr int particlesPerBlock = 4096;

    int n = 0, blocks = 1;
    std::vector<int> firstSlot;         // of each block
    std::vector<R> force;               // width a slot
    std::vector<unsigned char> acts;
    std::vector<int> firstOf, slotOf;   // slots that a particle collects

    //- Entries of a block that are looked at, and the first slot among them; without sleepers it is
    //  all of them
    struct Range { int begin, end, slot; };
    std::vector<Range> range;
    std::vector<int> firstRange;        // of each block

    std::vector<int> cuts;              // of blocks given from outside; empty: they are of one size

    AwakeLists awake;                   // empty where nobody may sleep

    int begin(int block) const
    {
        return cuts.empty() ? int((long long)n*block/blocks) : cuts[block];
    }

    //- After a rebuild, and when someone fell asleep or woke: leave out entries between those that
    //  sleep
    template<class List, class Asleep>
    void setRanges(const List& list, bool anyAsleep, const Asleep& asleep)
    {
        range.clear();
        firstRange.assign(1, 0);
        awake.clear(anyAsleep);
        for (int b = 0; b < blocks && !anyAsleep; ++b)
        {
            range.push_back(Range{list.base[begin(b)], list.base[begin(b + 1)], firstSlot[b]});
            firstRange.push_back(b + 1);
        }
        if (!anyAsleep) return;
        for (int b = 0; b < blocks; ++b)
        {
            int slot = firstSlot[b];
            bool open = false;
            awake.open();
            for (int i = begin(b), last = begin(b + 1); i < last; ++i)
            {
                const int first = list.base[i], end = first + list.count[i];
                const bool sleeps = asleep(i);
                bool idle = sleeps;
                int crossing = 0;
                for (int e = first; e < end && (idle || blocks > 1); ++e)
                {
                    const int j = List::other(list.entry[e]);
                    idle = idle && asleep(j);
                    crossing += j >= last;
                }
                if (!idle && open) range.back().end = end;
                else if (!idle) range.push_back(Range{first, end, slot});
                open = !idle;
                if (!sleeps) awake.add(i);
                if (!idle) awake.looking.push_back(i);
                slot += blocks > 1 ? crossing : 0;
            }
            firstRange.push_back(int(range.size()));
        }
        awake.close(n, list);
    }

    static int blocksOf(std::int64_t particles)
    {
        return int(std::max<std::int64_t>(1, particles/particlesPerBlock));
    }

    //- After a rebuild. given: the first particle of each block, and the end
    template<class List>
    void set(int particles, const List& list, const std::vector<int>& given = {})
    {
        n = particles;
        cuts = given;
        blocks = cuts.empty() ? blocksOf(n) : int(cuts.size()) - 1;
        firstSlot.assign(blocks + 1, 0);
        firstOf.assign(n + 1, 0);
        if (blocks == 1) return;
        const auto crossing = [&](auto f)
        {
            for (int b = 0; b < blocks; ++b)
                for (int i = begin(b), end = begin(b + 1); i < end; ++i)
                    for (int k = 0; k < list.count[i]; ++k)
                    {
                        const int j = List::other(list.entry[list.index(i, k)]);
                        if (j >= end) f(b, j);
                    }
        };
        crossing([&](int b, int j) { ++firstSlot[b + 1]; ++firstOf[j + 1]; });
        for (int b = 0; b < blocks; ++b) firstSlot[b + 1] += firstSlot[b];
        for (int i = 0; i < n; ++i) firstOf[i + 1] += firstOf[i];
        const int slots = firstSlot[blocks];
        force.resize(std::size_t(slots)*width);
        acts.assign(slots, 0);
        slotOf.resize(slots);
        std::vector<int> next(firstOf.begin(), firstOf.end() - 1);
        int slot = 0;
        crossing([&](int, int j) { slotOf[next[j]++] = slot++; });
    }
};

//- Some registers full of entries of half lists that touch, and where the search for them stands:
//  the same for all contact laws
template<int D, class P>
struct TouchingEntries
{
    using real = typename P::real;
    using T = Pack<real>;
    using List = ContactListView<Cpu, real>;
    using Pairs = PairSetting<Cpu, D, P>;
    static constexpr int lanes = T::width, room = 64;

    int count = 0;
    int entry[room + lanes], slot[room + lanes], i[room + lanes], j[room + lanes];
    int next = 0, nextSlot = 0;

    //- Positions and radii, and in 2D masses, of the particles index(l), one a lane
    struct Places { Vec<D, typename PositionPack<P>::type> x; T radius, mass; };

    template<class Index>
    HD static Places places(const SolidRecords<D, P>& solids, const Index& index)
    {
        T v[4];
        loadRows(
            [&](int l) { return reinterpret_cast<const real*>(solids.a + index(l)); }, v);
        Places p;
        for (int d = 0; d < D; ++d)
        {
            if constexpr (sizeof(real) == 4) p.x.c[d].v = PackInt32::vec(v[d].v);
            else p.x.c[d] = v[d];
        }
        p.radius = v[D];
        p.mass = v[3];
        return p;
    }

    //- From a to b, nearest image
    HD static Vec<D, T> line(const Box<D, P>& box, const Places& a, const Places& b)
    {
        Vec<D, T> dx;
        for (int d = 0; d < D; ++d)
            dx.c[d] = box.template separation<T>(d, b.x.c[d], a.x.c[d]);
        return dx;
    }

    //- The next entries that touch, a register of candidates at a time. Those that touched and no
    //  longer do forget: what does not touch has a history of zeros. words: of a history
    HD_SHARED void collect(
        const Pairs& pairs, const real& largestGap, int words, int last, int blockEnd)
    {
        count = 0;
        const auto& list = pairs.list;
        const bool simple = pairs.alone >= 0 && !list.rest;
        const T gap(largestGap);
        for (; next < last && count <= room - lanes; next += lanes)
        {
            const int used = std::min(lanes, last - next);
            const auto at = [&](int l) { return next + (l < used ? l : 0); };
            const Places pi = places(pairs.solids, [&](int l) { return list.owner[at(l)]; });
            const Places pj = places(
                pairs.solids, [&](int l) { return List::other(list.entry[at(l)]); });
            const T reach = pi.radius + pj.radius + gap, r2 = squaredNorm(line(pairs.box, pi, pj));
            const unsigned there = (1u << used) - 1;
            const auto entries = IntegerPack<lanes>::load(list.entry + next);
            const auto others = entries & std::int32_t(~List::touching);
            unsigned hits = greaterBits(reach*reach, r2) & there;
            const unsigned crossing = signBits(others > blockEnd - 1) & there;
            if (!simple)
                for (unsigned left = hits; left; left &= left - 1)
                {
                    const int l = __builtin_ctz(left);
                    if (!touches(pairs, next + l, r2.v[l])) hits &= ~(1u << l);
                }
            for (unsigned left = signBits(entries) & there & ~hits; left; left &= left - 1)
                forget(list, words, next + __builtin_ctz(left));
            for (unsigned left = hits; left; left &= left - 1)
            {
                const int l = __builtin_ctz(left), e = next + l, k = count++;
                const unsigned bit = 1u << l;
                entry[k] = e;
                i[k] = list.owner[e];
                j[k] = List::other(list.entry[e]);
                slot[k] = crossing & bit ? nextSlot + __builtin_popcount(crossing & (bit - 1)) : -1;
            }
            nextSlot += __builtin_popcount(crossing);
        }
    }

private:

    static void forget(const List& list, int words, std::size_t e)
    {
        list.entry[e] &= ~List::touching;
        for (int c = 0; c < words; ++c) list.history[e*words + c] = 0;
    }

    //- Where gaps and rests vary, nearness is not touching
    static bool touches(const Pairs& pairs, std::size_t e, real r2)
    {
        int mi, mj;
        const real radii = pairs.solids.body(pairs.list.owner[e], mi).radius
            + pairs.solids.body(List::other(pairs.list.entry[e]), mj).radius;
        real reach = radii + pairs.gap[pairs.pairOf(mi, mj)];
        if (pairs.list.rest) reach -= pairs.list.rest[e];
        return reach > 0 && r2 < reach*reach;
    }
};

template<int D, class P, class Law>
struct ScatterPass : PairModel<Cpu, D, P, Law>
{
    using real = typename P::real;
    using T = Pack<real>;
    using Model = PairModel<Cpu, D, P, Law>;
    using List = ContactListView<Cpu, real>;
    using Batch = TouchingEntries<D, P>;
    using Places = typename Batch::Places;
    static constexpr const char* name = "contacts";
    static constexpr int H = Model::histories, S = spins<D>, lanes = T::width,
                         words = DeferredForces<D, real>::width;
    static constexpr int rows = (H + 3)/4, words4 = words/4;
    // of a law that turns nobody moments stay the zeros that they are
    static constexpr int written = D == 3 && !Law::turns ? 1 : words4;
    using RowOf = typename Row<real>::vec;
    using LooseRow = typename Row<real>::loose;

    DeferredForces<D, real>* deferred;
    real* sums;                 // words a particle
    real largestGap;

    void operator()(int block) const
    {
        if (!this->clock.active()) return;
        const int begin = deferred->begin(block), blockEnd = deferred->begin(block + 1),
                  end = std::min(blockEnd, *this->active);
        if (end <= begin) return;
        clearSums(block, begin, end);
        for (int k = deferred->firstSlot[block]; k < deferred->firstSlot[block + 1]; ++k)
            deferred->acts[k] = 0;
        Batch batch;
        for (int r = deferred->firstRange[block]; r < deferred->firstRange[block + 1]; ++r)
        {
            const auto& range = deferred->range[r];
            batch.next = range.begin;
            batch.nextSlot = range.slot;
            while (batch.next < range.end)
            {
                batch.collect(*this, largestGap, 4*rows, range.end, blockEnd);
                for (int first = 0; first < batch.count; first += lanes) evaluate(batch, first);
            }
        }
    }

private:

    //- Of those that take part
    void clearSums(int block, int begin, int end) const
    {
        const AwakeLists& awake = deferred->awake;
        if (awake.some)
            for (int k = awake.first[block]; k < awake.first[block + 1]; ++k)
                clearSums(awake.runs[k].begin, awake.runs[k].end);
        else clearSums(begin, end);
    }

    void clearSums(int begin, int end) const
    {
        std::fill(sums + std::size_t(begin)*words, sums + std::size_t(end)*words, real(0));
    }

    //- The bodies index(l), one a lane
    template<class Index>
    HD ContactBody<D, T> bodies(const Index& index, const Places& place) const
    {
        ContactBody<D, T> q;
        T v[4];
        loadRows([&](int l) { return this->solids.b[index(l)].c; }, v);
        for (int d = 0; d < D; ++d) q.velocity.c[d] = v[d];
        q.radius = place.radius;
        if constexpr (D == 2)
        {
            q.spin.c[0] = v[2];
            q.mass = place.mass;
        }
        else
        {
            q.mass = v[3];
            loadRows([&](int l) { return this->solids.c[index(l)].c; }, v);
            for (int c = 0; c < S; ++c) q.spin.c[c] = v[c];
        }
        return q;
    }

    //- Parameters and gaps of pairs of several materials
    template<class Entry>
    HD_APART void setPairs(
        const Entry& entry, typename Law::template Parameters<T>& parameters, T& gap) const
    {
        constexpr int numbers = sizeof(typename Model::Parameters)/sizeof(real);
        alignas(32) real number[numbers][lanes], gaps[lanes];
        for (int l = 0; l < lanes; ++l)
        {
            int mi, mj;
            const int e = entry(l);
            this->solids.body(this->list.owner[e], mi);
            this->solids.body(List::other(this->list.entry[e]), mj);
            const int pair = this->pairOf(mi, mj);
            const real* from = reinterpret_cast<const real*>(this->parameters + pair);
            for (int k = 0; k < numbers; ++k) number[k][l] = from[k];
            gaps[l] = this->gap[pair];
            if (this->list.rest) gaps[l] -= this->list.rest[e];
        }
        T* to = reinterpret_cast<T*>(&parameters);
        for (int k = 0; k < numbers; ++k) to[k] = T::load(number[k]);
        gap = T::load(gaps);
    }

    //- The pairs from `first` on, as many as a register holds
    HD void evaluate(const Batch& b, int first) const
    {
        const int used = std::min(lanes, b.count - first);
        // idle lanes repeat the first pair
        const auto lane = [&](int l) { return first + (l < used ? l : 0); };
        const auto entry = [&](int l) { return b.entry[lane(l)]; };
        const auto owner = [&](int l) { return b.i[lane(l)]; };
        const auto other = [&](int l) { return b.j[lane(l)]; };
        const Places placeA = Batch::places(this->solids, owner),
                     placeB = Batch::places(this->solids, other);
        const ContactBody<D, T> bodyA = bodies(owner, placeA), bodyB = bodies(other, placeB);
        typename Law::template Parameters<T> parameters;
        T gap;
        if (this->alone >= 0 && !this->list.rest)
        {
            constexpr int numbers = sizeof(typename Model::Parameters)/sizeof(real);
            T* to = reinterpret_cast<T*>(&parameters);
            const real* one = reinterpret_cast<const real*>(this->parameters + this->alone);
            for (int k = 0; k < numbers; ++k) to[k] = T(one[k]);
            gap = T(this->gap[this->alone]);
        }
        else setPairs(entry, parameters, gap);
        T h[4*rows + 1];
        for (int r = 0; r < rows; ++r)
            loadRows([&](int l)
                { return this->list.history + (std::size_t(entry(l))*rows + r)*4; },
                h + 4*r);
        const Vec<D, T> dx = Batch::line(this->box, placeA, placeB);
        const T distance = squareRoot(maximum(squaredNorm(dx), T(real(1e-30)))),
                inverse = T(real(1))/distance;
        const Vec<D, T> n = inverse*dx;
        T armA, armB;
        const auto g = pairGeometry<D, T>(
            bodyA, bodyB, n, distance, gap, T(real(this->clock.dt())), armA, armB);
        NormalForce<T> fn;
        const ContactForce<D, T> f = Law::template evaluate<D, T>(parameters, g, armA, armB, h, fn);
        scatter(b, first, used, f, h);
    }

    HD void scatter(
        const Batch& b, int first, int used, const ContactForce<D, T>& f, const T* h) const
    {
        const T none(real(0));
        RowOf memory[rows + 1][lanes], onA[words4][lanes], onB[words4][lanes];
        for (int r = 0; r < rows; ++r) storeRows(h + 4*r, memory[r]);
        if constexpr (D == 3)
        {
            const T force[4] = {f.force.c[0], f.force.c[1], f.force.c[2], none},
                    back[4] = {-force[0], -force[1], -force[2], none};
            const T momentA[4] = {f.momentA.c[0], f.momentA.c[1], f.momentA.c[2], none};
            const T momentB[4] = {f.momentB.c[0], f.momentB.c[1], f.momentB.c[2], none};
            storeRows(force, onA[0]);
            storeRows(back, onB[0]);
            if constexpr (Law::turns)
            {
                storeRows(momentA, onA[1]);
                storeRows(momentB, onB[1]);
            }
        }
        else
        {
            const T a[4] = {f.force.c[0], f.force.c[1], f.momentA.c[0], none};
            const T c[4] = {-f.force.c[0], -f.force.c[1], f.momentB.c[0], none};
            storeRows(a, onA[0]);
            storeRows(c, onB[0]);
        }
        for (int l = 0; l < used; ++l)
        {
            const int at = first + l, slot = b.slot[at];
            const std::size_t e = b.entry[at];
            for (int r = 0; r < rows; ++r)
                *reinterpret_cast<LooseRow*>(
                    this->list.history + (e*rows + r)*4) = memory[r][l];
            const int i = b.i[at], j = b.j[at];
            this->list.entry[e] = std::uint32_t(j) | List::touching;
            for (int w = 0; w < written; ++w)
            {
                LooseRow& sum = *reinterpret_cast<LooseRow*>(sums + std::size_t(i)*words + 4*w);
                sum = sum + onA[w][l];
            }
            for (int w = 0; w < written; ++w)
            {
                if (slot >= 0)
                    *reinterpret_cast<LooseRow*>(
                        &deferred->force[std::size_t(slot)*words + 4*w]) = onB[w][l];
                else
                {
                    LooseRow& sum = *reinterpret_cast<LooseRow*>(sums + std::size_t(j)*words + 4*w);
                    sum = sum + onB[w][l];
                }
            }
            if (slot >= 0) deferred->acts[slot] = 1;
        }
    }
};

} // namespace riprap

#endif
