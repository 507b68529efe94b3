/*  Looks at contacts without touching what they remember: force, overlap, point and energy of an
    entry.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/passes/pairModel.hpp"

namespace riprap
{

template<int D, class R>
struct ProbedContact
{
    int other;                  // -1: the entry does not touch
    Vec<D, R> force;            // on the first
    R overlap, arm, energy;     // arm: along n from the first to the contact point
    Vec<D, R> n;
};

template<class Backend, int D, class P, class Law>
struct ContactProbe : PairModel<Backend, D, P, Law>
{
    using real = typename P::real;
    using List = ContactListView<Backend, real>;
    static constexpr int H = PairModel<Backend, D, P, Law>::histories;

    HD ProbedContact<D, real> probe(int i, int k) const
    {
        ProbedContact<D, real> r{};
        const std::size_t e = this->list.index(i, k);
        r.other = -1;
        if (!(this->list.entry[e] & List::touching)) return r;
        const int j = List::other(this->list.entry[e]);
        int mi, mj;
        const auto self = this->solids.body(i, mi), other = this->solids.body(j, mj);
        const Vec<D, real> dx = this->line(this->solids.position(i), this->solids.a[j]);
        const real distance = squareRoot(maximum(squaredNorm(dx), real(1e-30)));
        real gap = this->gap[this->pairOf(mi, mj)], armA, armB, h[H + 1];
        if (this->list.rest) gap -= this->list.rest[e];
        if (self.radius + other.radius + gap <= distance) return r;
        for (int c = 0; c < H; ++c) h[c] = this->list.template remembered<H>(e, c);
        const real dt = real(this->clock.dt());
        const auto g = pairGeometry<D, real>(
            self, other, (real(1)/distance)*dx, distance, gap, dt, armA, armB);
        NormalForce<real> fn;
        const real reach = Law::NormalLaw::template reachOf<real>(
            this->parameters[this->pairOf(mi, mj)].normal);
        const auto f = Law::template repeat<D, real>(
            this->parameters[this->pairOf(mi, mj)], g, armA, armB, h, fn);
        if (!Law::NormalLaw::acts(h)) return r;
        r.other = j;
        r.force = f.force;
        r.overlap = g.overlap - reach;
        r.arm = armA;
        r.n = g.n;
        r.energy = Law::template energy<D, real>(this->parameters[this->pairOf(mi, mj)], g, fn, h);
        return r;
    }
};

//- All entries of all particles, written out
template<class Backend, int D, class P, class Law>
struct ProbeAll
{
    using real = typename P::real;
    static constexpr const char* name = "probeContacts";

    ContactProbe<Backend, D, P, Law> probe;
    ProbedContact<D, real>* out;

    HD void operator()(int i) const
    {
        if (i >= *probe.active) return;
        for (int k = 0; k < probe.list.count[i]; ++k)
            out[probe.list.index(i, k)] = probe.probe(i, k);
    }
};

//- Whom all entries of all particles touch, -1: nobody
template<class Backend, int D, class P, class Law>
struct ProbeOthers
{
    static constexpr const char* name = "probeOthers";

    ContactProbe<Backend, D, P, Law> probe;
    int* out;

    HD void operator()(int i) const
    {
        if (i >= *probe.active) return;
        for (int k = 0; k < probe.list.count[i]; ++k)
            out[probe.list.index(i, k)] = probe.probe(i, k).other;
    }
};

template<class Backend, int D, class P, class Law>
struct SumContactEnergy
{
    static constexpr const char* name = "contactEnergy";
    ContactProbe<Backend, D, P, Law> probe;
    // of a scene on several ranks: a pair is with the rank of its owner
    const std::int32_t* calm = nullptr;

    HD void add(int i, double* sums) const
    {
        if (i >= *probe.active || (calm && calm[i] == ghostMark)) return;
        for (int k = 0; k < probe.list.count[i]; ++k)
            sums[0] += double(probe.probe(i, k).energy)*(Backend::gpu ? 0.5 : 1.0);
    }
};

//- Overlap of a particle's deepest contact with others, of the smaller diameter
template<class Backend, int D, class P, class Law>
struct DeepestOverlap
{
    using real = typename P::real;
    static constexpr const char* name = "deepestOverlap";
    ContactProbe<Backend, D, P, Law> probe;

    HD double value(int i) const
    {
        double most = 0;
        for (int k = 0; i < *probe.active && k < probe.list.count[i]; ++k)
        {
            const auto c = probe.probe(i, k);
            if (c.other < 0) continue;
            int a, b;
            const double radius = minimum(double(probe.solids.body(i, a).radius),
                double(probe.solids.body(c.other, b).radius));
            const int pair = probe.pairOf(a, b);
            const double reach = double(
                Law::NormalLaw::template reachOf<real>(probe.parameters[pair].normal));
            most = maximum(
                most, 0.5*(double(c.overlap) - (double(probe.gap[pair]) - reach))/radius);
        }
        return most;
    }
};

//- How many contacts there are, each counted once
template<class Backend, int D, class P, class Law>
struct SumContacts
{
    static constexpr const char* name = "countContacts";
    ContactProbe<Backend, D, P, Law> probe;

    HD void add(int i, double* sums) const
    {
        if (i >= *probe.active) return;
        for (int k = 0; k < probe.list.count[i]; ++k)
            sums[0] += probe.probe(i, k).other < 0 ? 0 : (Backend::gpu ? 0.5 : 1.0);
    }
};

} // namespace riprap
