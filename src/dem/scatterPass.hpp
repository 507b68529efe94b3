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

    //- Touching pairs until a register is full
    struct Batch
    {
        int count = 0;
        int i[lanes], j[lanes], slot[lanes];
        std::size_t entry[lanes];
        bool touched[lanes];
        alignas(32) real dx[D][lanes];
        alignas(32) real r2[lanes];
    };

    void operator()(int block) const
    {
        if (!this->clock->active) return;
        const int begin = deferred->begin(block), end = std::min(deferred->begin(block + 1), *this->active);
        for (std::size_t k = std::size_t(begin)*words; k < std::size_t(std::max(end, begin))*words; ++k) sums[k] = 0;
        Batch batch;
        int slot = deferred->firstSlot[block];
        const int blockEnd = deferred->begin(block + 1);
        for (int i = begin; i < end; ++i)
        {
            const auto xi = this->solids.position(i);
            const real radius = this->solids.radius(i) + largestGap;
            const std::size_t first = this->list.index(i, 0);
            const int count = this->list.count[i];
            for (int k = 0; k < count; ++k)
            {
                const std::uint32_t entry = this->list.entry[first + k];
                const int j = List::other(entry);
                const SolidA<D, P> other = this->solids.a[j];
                const Vec<D, real> dx = this->line(xi, other);
                const real r2 = squaredNorm(dx), reach = radius + other.radius;
                const bool crosses = j >= blockEnd;
                const int own = crosses ? slot++ : -1;
                if (crosses) deferred->acts[own] = 0;
                if (!(r2 < reach*reach) || !touches(i, j, first + k, r2))
                {
                    if (entry & List::touching) this->list.entry[first + k] = std::uint32_t(j);
                    continue;
                }
                const int l = batch.count++;
                batch.i[l] = i;
                batch.j[l] = j;
                batch.slot[l] = own;
                batch.entry[l] = first + k;
                batch.touched[l] = entry & List::touching;
                for (int d = 0; d < D; ++d) batch.dx[d][l] = dx.c[d];
                batch.r2[l] = r2;
                if (batch.count == lanes) flush(batch);
            }
        }
        if (batch.count) flush(batch);
    }

private:

    //- Where gaps and rests vary, nearness is not touching
    bool touches(int i, int j, std::size_t e, real r2) const
    {
        if (this->materials == 1 && !this->list.rest) return true;
        int mi, mj;
        const real radii = this->solids.body(i, mi).radius + this->solids.body(j, mj).radius;
        real reach = radii + this->gap[this->pairOf(mi, mj)];
        if (this->list.rest) reach -= this->list.rest[e];
        return reach > 0 && r2 < reach*reach;
    }

    void setBody(ContactBody<D, T>& to, int lane, const ContactBody<D, real>& from) const
    {
        for (int d = 0; d < D; ++d) to.velocity.c[d].v[lane] = from.velocity.c[d];
        for (int c = 0; c < S; ++c) to.spin.c[c].v[lane] = from.spin.c[c];
        to.radius.v[lane] = from.radius;
        to.mass.v[lane] = from.mass;
    }

    void flush(Batch& b) const
    {
        ContactBody<D, T> bodyA, bodyB;
        typename Law::template Parameters<T> parameters;
        T gap, h[H + 1];
        T* words = reinterpret_cast<T*>(&parameters);
        constexpr int numbers = sizeof(typename Model::Parameters)/sizeof(real);
        for (int l = b.count; l < lanes; ++l)       // idle lanes repeat the first pair
        {
            b.i[l] = b.i[0];
            b.j[l] = b.j[0];
            b.entry[l] = b.entry[0];
            b.touched[l] = b.touched[0];
            for (int d = 0; d < D; ++d) b.dx[d][l] = b.dx[d][0];
            b.r2[l] = b.r2[0];
        }
        const bool uniform = this->materials == 1;
        if (uniform)
        {
            const real* from = reinterpret_cast<const real*>(this->parameters);
            for (int k = 0; k < numbers; ++k) words[k] = T(from[k]);
            gap = T(this->gap[0]);
        }
        for (int l = 0; l < lanes; ++l)
        {
            int mi, mj;
            setBody(bodyA, l, this->solids.body(b.i[l], mi));
            setBody(bodyB, l, this->solids.body(b.j[l], mj));
            if (!uniform)
            {
                const int pair = this->pairOf(mi, mj);
                const real* from = reinterpret_cast<const real*>(this->parameters + pair);
                for (int k = 0; k < numbers; ++k) words[k].v[l] = from[k];
                gap.v[l] = this->gap[pair];
            }
            if (this->list.rest) gap.v[l] -= this->list.rest[b.entry[l]];
            for (int c = 0; c < H; ++c) h[c].v[l] = b.touched[l] ? this->list.template remembered<H>(b.entry[l], c) : real(0);
        }
        const T distance = squareRoot(maximum(T::load(b.r2), T(real(1e-30)))), inverse = T(real(1))/distance;
        Vec<D, T> n;
        for (int d = 0; d < D; ++d) n.c[d] = inverse*T::load(b.dx[d]);
        T armA, armB;
        const auto g = pairGeometry<D, T>(bodyA, bodyB, n, distance, gap, T(real(this->clock->dt)), armA, armB);
        NormalForce<T> fn;
        const ContactForce<D, T> f = Law::template evaluate<D, T>(parameters, g, armA, armB, h, fn);
        for (int l = 0; l < b.count; ++l) scatter(b, l, f, h);
        b.count = 0;
    }

    void scatter(const Batch& b, int l, const ContactForce<D, T>& f, const T* h) const
    {
        const std::size_t e = b.entry[l];
        for (int c = 0; c < H; ++c) this->list.template remembered<H>(e, c) = h[c].v[l];
        if (!b.touched[l]) this->list.entry[e] |= List::touching;
        real* onA = sums + std::size_t(b.i[l])*words;
        for (int d = 0; d < D; ++d) onA[d] += f.force.c[d].v[l];
        for (int c = 0; c < S; ++c) onA[D + c] += f.momentA.c[c].v[l];
        const int slot = b.slot[l];
        if (slot < 0)
        {
            real* onB = sums + std::size_t(b.j[l])*words;
            for (int d = 0; d < D; ++d) onB[d] -= f.force.c[d].v[l];
            for (int c = 0; c < S; ++c) onB[D + c] += f.momentB.c[c].v[l];
            return;
        }
        real* later = &deferred->force[std::size_t(slot)*words];
        for (int d = 0; d < D; ++d) later[d] = -f.force.c[d].v[l];
        for (int c = 0; c < S; ++c) later[D + c] = f.momentB.c[c].v[l];
        deferred->acts[slot] = 1;
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
