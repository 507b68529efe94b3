/*  Looks at contacts without touching what they remember: force, overlap, point and energy of an
    entry; and sums of them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/passes/pairModel.hpp"

namespace riprap
{

//- What an entry of a list is
template<class R>
struct ProbedContact
{
    int other = -1;             // -1: the entry does not touch
    R energy = 0;
    double depth = 0;           // overlap, of the smaller diameter
};

//- Where it acts
template<int D, class R>
struct ProbedForce
{
    Vec<D, R> force, n;         // on the first; from it to the other
    R overlap, arm;             // arm: along n to the contact point
};

//- All entries of all particles, written out. The one pass that knows the law: whatever is summed,
//  counted or listed is read from what it writes
template<class Backend, int D, class P, class Law>
struct ProbeContacts : PairModel<Backend, D, P, Law>
{
    using real = typename P::real;
    using List = ContactListView<Backend, real>;
    static constexpr int H = PairModel<Backend, D, P, Law>::histories;
    static constexpr const char* name = "probeContacts";

    ProbedContact<real>* out;
    ProbedForce<D, real>* forces;       // nullptr: nobody asks

    HD void operator()(int i) const
    {
        if (i >= *this->active) return;
        for (int k = 0; k < this->list.count[i]; ++k) probe(i, this->list.index(i, k));
    }

private:

    HD void probe(int i, std::size_t e) const
    {
        out[e] = ProbedContact<real>();
        if (!(this->list.entry[e] & List::touching)) return;
        const int j = List::other(this->list.entry[e]);
        int mi, mj;
        const auto self = this->solids.body(i, mi), other = this->solids.body(j, mj);
        const int pair = this->pairOf(mi, mj);
        const Vec<D, real> dx = this->line(this->solids.position(i), this->solids.a[j]);
        const real distance = squareRoot(maximum(squaredNorm(dx), real(1e-30)));
        real gap = this->gap[pair], armA, armB, h[H + 1];
        if (this->list.rest) gap -= this->list.rest[e];
        if (self.radius + other.radius + gap <= distance) return;
        for (int c = 0; c < H; ++c) h[c] = this->list.template remembered<H>(e, c);
        const auto g = pairGeometry<D, real>(self, other, (real(1)/distance)*dx, distance, gap,
            real(this->clock.dt()), armA, armB);
        NormalForce<real> fn;
        const real reach = Law::NormalLaw::template reachOf<real>(this->parameters[pair].normal);
        const auto f = Law::template repeat<D, real>(this->parameters[pair], g, armA, armB, h, fn);
        if (!Law::NormalLaw::acts(h)) return;
        const real overlap = g.overlap - reach;
        out[e].other = j;
        out[e].energy = Law::template energy<D, real>(this->parameters[pair], g, fn, h);
        out[e].depth = 0.5*(double(overlap) - (double(this->gap[pair]) - double(reach)))
            /minimum(double(self.radius), double(other.radius));
        if (forces) forces[e] = ProbedForce<D, real>{f.force, g.n, overlap, armA};
    }
};

//- How many contacts a particle has. Both of a pair count what the one that lists it has found; on
//  a GPU, where both do, the first of them
template<class Backend, class R>
struct CountActing
{
    static constexpr const char* name = "countActing";
    ContactListView<Backend, R> list;
    const ProbedContact<R>* probed;
    const int* active;
    int* counts;

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        for (int k = 0; k < list.count[i]; ++k)
        {
            const int j = probed[list.index(i, k)].other;
            if (j < 0 || (Backend::gpu && j < i)) continue;
            increase(i);
            increase(j);
        }
    }

private:

    HD void increase([[maybe_unused]] int i) const
    {
#ifdef __CUDA_ARCH__
        atomicAdd(counts + i, 1);
#elif !defined(__CUDACC__)
        #pragma omp atomic
        counts[i] += 1;
#endif
    }
};

//- Energy of contacts, how many there are, each once, and the deepest one of a particle
template<class Backend, class R>
struct ContactSums
{
    static constexpr const char* name = "contactSums";
    ContactListView<Backend, R> list;
    const ProbedContact<R>* probed;
    const int* active;
    // of a scene on several ranks: a pair is with the rank of its owner
    const std::int32_t* calm = nullptr;

    HD void add(int i, double* sums) const
    {
        if (i >= *active) return;
        constexpr double each = Backend::gpu ? 0.5 : 1.0;       // lists are full, or half
        const bool mine = !(calm && calm[i] == ghostMark);
        for (int k = 0; k < list.count[i]; ++k)
        {
            const ProbedContact<R> c = probed[list.index(i, k)];
            if (mine) sums[0] += double(c.energy)*each;
            sums[1] += c.other < 0 ? 0 : each;
        }
    }

    HD double value(int i) const
    {
        double most = 0;
        for (int k = 0; i < *active && k < list.count[i]; ++k)
            most = maximum(most, probed[list.index(i, k)].depth);
        return most;
    }
};

} // namespace riprap
