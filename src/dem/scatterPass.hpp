/*  Contact forces over half lists, eight (or four) touching pairs at a time. For the CPU.

    Particles are cut into blocks of fixed size, whichever the number of threads. A block adds to its own particles; what its pairs
    do to particles of later blocks is put aside, entry by entry, and added by those blocks afterwards, in order: the same bits
    for any number of threads.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#ifndef __CUDACC__

#include <vector>
#include "core/pack.hpp"
#include "dem/pairModel.hpp"

namespace riprap
{

//- The forces that blocks leave to each other
template<int D, class R>
struct DeferredForces
{
    static constexpr int width = D + spins<D>;
    static constexpr int particlesPerBlock = 4096;

    int n = 0, blocks = 1;
    std::vector<int> firstSlot;         // of each block
    std::vector<R> force;               // width a slot
    std::vector<unsigned char> acts;
    std::vector<int> firstOf, slotOf;   // slots that a particle collects

    int begin(int block) const { return int((long long)n*block/blocks); }

    //- After a rebuild: `last(i)` calls back with each entry of particle i
    template<class List>
    void set(int particles, const List& list)
    {
        n = particles;
        blocks = std::max(1, n/particlesPerBlock);
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

template<int D, class P, class Law>
struct ScatterPass : PairModel<Cpu, D, P, Law>
{
    using real = typename P::real;
    using T = Pack<real>;
    using Model = PairModel<Cpu, D, P, Law>;
    using List = ContactListView<Cpu, real>;
    static constexpr const char* name = "contacts";
    static constexpr int H = Model::histories, S = spins<D>, lanes = T::width, words = D + S;

    DeferredForces<D, real>* deferred;
    real* sums;                 // words a particle
    real largestGap;

    //- Touching pairs, some registers full, and where the search for them stands
    struct Batch
    {
        static constexpr int room = 64;

        int count = 0;
        int i[room + 1], j[room + 1], slot[room + 1];
        std::size_t entry[room + 1];
        bool touched[room + 1];
        alignas(32) real dx[D][room + lanes];
        alignas(32) real r2[room + lanes];
        int next = 0, k = 0, nextSlot = 0;
    };

    void operator()(int block) const
    {
        if (!this->clock->active) return;
        const int begin = deferred->begin(block), blockEnd = deferred->begin(block + 1), end = std::min(blockEnd, *this->active);
        for (std::size_t k = std::size_t(begin)*words; k < std::size_t(std::max(end, begin))*words; ++k) sums[k] = 0;
        Batch batch;
        batch.next = begin;
        batch.nextSlot = deferred->firstSlot[block];
        while (batch.next < end)
        {
            collect(batch, end, blockEnd);
            for (int first = 0; first < batch.count; first += lanes) evaluate(batch, first);
        }
    }

private:

    HD void collect(Batch& b, int end, int blockEnd) const
    {
        b.count = 0;
        const bool simple = this->materials == 1 && !this->list.rest;
        for (; b.next < end; ++b.next, b.k = 0)
        {
            const int i = b.next, count = this->list.count[i];
            if (!count) continue;
            const auto xi = this->solids.position(i);
            const real radius = this->solids.radius(i) + largestGap;
            const std::size_t first = this->list.index(i, 0);
            while (b.k < count)
            {
                const std::size_t e = first + b.k++;
                const std::uint32_t entry = this->list.entry[e];
                const int j = List::other(entry);
                const SolidA<D, P> other = this->solids.a[j];
                const Vec<D, real> dx = this->line(xi, other);
                const real r2 = squaredNorm(dx), reach = radius + other.radius;
                int slot = -1;
                if (j >= blockEnd) { slot = b.nextSlot++; deferred->acts[slot] = 0; }
                bool hit = r2 < reach*reach;
                if (!simple) hit = hit && touches(i, j, e, r2);
                // whether a near pair touches is anybody's guess: it is written, and counts or not, without a branch
                const int l = b.count;
                b.count += hit;
                if (!hit && (entry & List::touching)) this->list.entry[e] = std::uint32_t(j);
                b.i[l] = i;
                b.j[l] = j;
                b.slot[l] = slot;
                b.entry[l] = e;
                b.touched[l] = entry & List::touching;
                for (int d = 0; d < D; ++d) b.dx[d][l] = dx.c[d];
                b.r2[l] = r2;
                if (b.count == Batch::room) return;
            }
        }
    }

    //- Where gaps and rests vary, nearness is not touching
    bool touches(int i, int j, std::size_t e, real r2) const
    {
        int mi, mj;
        const real radii = this->solids.body(i, mi).radius + this->solids.body(j, mj).radius;
        real reach = radii + this->gap[this->pairOf(mi, mj)];
        if (this->list.rest) reach -= this->list.rest[e];
        return reach > 0 && r2 < reach*reach;
    }

    //- Bodies of a batch, one array a number
    struct Lanes
    {
        static constexpr int numbers = D + S + 2;
        alignas(32) real value[numbers][lanes];

        HD void set(int l, const ContactBody<D, real>& b)
        {
            for (int d = 0; d < D; ++d) value[d][l] = b.velocity.c[d];
            for (int c = 0; c < S; ++c) value[D + c][l] = b.spin.c[c];
            value[D + S][l] = b.radius;
            value[D + S + 1][l] = b.mass;
        }
        HD ContactBody<D, T> body() const
        {
            ContactBody<D, T> b;
            for (int d = 0; d < D; ++d) b.velocity.c[d] = T::load(value[d]);
            for (int c = 0; c < S; ++c) b.spin.c[c] = T::load(value[D + c]);
            b.radius = T::load(value[D + S]);
            b.mass = T::load(value[D + S + 1]);
            return b;
        }
    };

    //- The pairs from `first` on, as many as a register holds
    HD void evaluate(const Batch& b, int first) const
    {
        constexpr int numbers = sizeof(typename Model::Parameters)/sizeof(real);
        Lanes laneA, laneB;
        alignas(32) real memory[H + 1][lanes], gaps[lanes], number[numbers][lanes];
        const int used = std::min(lanes, b.count - first);
        alignas(32) real line[D][lanes], r2[lanes];
        const bool uniform = this->materials == 1;
        for (int l = 0; l < lanes; ++l)
        {
            const int at = first + (l < used ? l : 0);      // idle lanes repeat the first pair
            const std::size_t e = b.entry[at];
            for (int d = 0; d < D; ++d) line[d][l] = b.dx[d][at];
            r2[l] = b.r2[at];
            int mi, mj;
            laneA.set(l, this->solids.body(b.i[at], mi));
            laneB.set(l, this->solids.body(b.j[at], mj));
            const int pair = uniform ? 0 : this->pairOf(mi, mj);
            if (!uniform)
            {
                const real* from = reinterpret_cast<const real*>(this->parameters + pair);
                for (int k = 0; k < numbers; ++k) number[k][l] = from[k];
            }
            gaps[l] = this->gap[pair];
            if (this->list.rest) gaps[l] -= this->list.rest[e];
            for (int c = 0; c < H; ++c) memory[c][l] = b.touched[at] ? this->list.template remembered<H>(e, c) : real(0);
        }
        typename Law::template Parameters<T> parameters;
        T* to = reinterpret_cast<T*>(&parameters);
        const real* one = reinterpret_cast<const real*>(this->parameters);
        for (int k = 0; k < numbers; ++k) to[k] = uniform ? T(one[k]) : T::load(number[k]);
        T h[H + 1];
        for (int c = 0; c < H; ++c) h[c] = T::load(memory[c]);
        const T distance = squareRoot(maximum(T::load(r2), T(real(1e-30)))), inverse = T(real(1))/distance;
        Vec<D, T> n;
        for (int d = 0; d < D; ++d) n.c[d] = inverse*T::load(line[d]);
        T armA, armB;
        const auto g = pairGeometry<D, T>
        (laneA.body(), laneB.body(), n, distance, T::load(gaps), T(real(this->clock->dt)), armA, armB);
        NormalForce<T> fn;
        const ContactForce<D, T> f = Law::template evaluate<D, T>(parameters, g, armA, armB, h, fn);
        scatter(b, first, used, f, h);
    }

    HD void scatter(const Batch& b, int first, int used, const ContactForce<D, T>& f, const T* h) const
    {
        // vectors in memory: their lanes are read one by one
        T all[D + 2*S + H + 1];
        for (int d = 0; d < D; ++d) all[d] = f.force.c[d];
        for (int c = 0; c < S; ++c) { all[D + c] = f.momentA.c[c]; all[D + S + c] = f.momentB.c[c]; }
        for (int c = 0; c < H; ++c) all[D + 2*S + c] = h[c];
        const real* value = reinterpret_cast<const real*>(all);
        for (int l = 0; l < used; ++l)
        {
            const int at = first + l;
            const std::size_t e = b.entry[at];
            for (int c = 0; c < H; ++c) this->list.template remembered<H>(e, c) = value[(D + 2*S + c)*lanes + l];
            if (!b.touched[at]) this->list.entry[e] |= List::touching;
            real* onA = sums + std::size_t(b.i[at])*words;
            for (int k = 0; k < words; ++k) onA[k] += value[k*lanes + l];
            const int slot = b.slot[at];
            real* onB = slot < 0 ? sums + std::size_t(b.j[at])*words : &deferred->force[std::size_t(slot)*words];
            if (slot >= 0)
            {
                for (int k = 0; k < words; ++k) onB[k] = 0;
                deferred->acts[slot] = 1;
            }
            for (int d = 0; d < D; ++d) onB[d] -= value[d*lanes + l];
            for (int c = 0; c < S; ++c) onB[D + c] += value[(D + S + c)*lanes + l];
        }
    }
};

//- A particle's force from its block's sum and what earlier blocks left to it
template<int D, class P>
struct CollectForces
{
    using real = typename P::real;
    static constexpr const char* name = "collectForces";
    static constexpr int words = D + spins<D>;

    const DeferredForces<D, real>* deferred;
    const real* sums;
    SolidFields<D, P> fields;
    const DemClockData* clock;
    const int* active;

    void operator()(int i) const
    {
        if (!clock->active || i >= *active) return;
        real total[words];
        for (int k = 0; k < words; ++k) total[k] = sums[std::size_t(i)*words + k];
        for (int s = deferred->firstOf[i]; s < deferred->firstOf[i + 1]; ++s)
        {
            const int slot = deferred->slotOf[s];
            if (!deferred->acts[slot]) continue;
            for (int k = 0; k < words; ++k) total[k] += deferred->force[std::size_t(slot)*words + k];
        }
        for (int d = 0; d < D; ++d) fields.f[d][i] = total[d];
        for (int c = 0; c < spins<D>; ++c) fields.m[c][i] = total[D + c];
    }
};

} // namespace riprap

#endif
