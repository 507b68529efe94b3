/*  Contact forces by gathering: every particle over its full list, nothing shared, hence repeatable
    bit for bit. For the GPU.

    The loop waits for memory, not for arithmetic: a pair that touched in the last step will mostly
    do so again, so its neighbour's velocity, spin and history are asked for together with its
    position; and an entry is read one ahead.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/passes/pairModel.hpp"

namespace riprap
{

template<class Backend, int D, class P, class Law>
struct ContactGather : PairModel<Backend, D, P, Law>
{
    using real = typename P::real;
    using Model = PairModel<Backend, D, P, Law>;
    using List = ContactListView<Backend, real>;
    static constexpr int H = Model::histories;

    real largestGap;

    //- What all contacts do to i
    HD void sum(int i, const Vec<D, typename P::position>& xi, const ContactBody<D, real>& self,
        int mi, real dt, Vec<D, real>& force, Spin<D, real>& moment) const
    {
        if (this->alone >= 0) sumOver<true>(i, xi, self, mi, dt, force, moment);
        else sumOver<false>(i, xi, self, mi, dt, force, moment);
    }

private:

    //- alone: all particles are of one material
    template<bool alone>
    HD void sumOver(int i, const Vec<D, typename P::position>& xi, const ContactBody<D, real>& self,
        int mi, real dt, Vec<D, real>& force, Spin<D, real>& moment) const
    {
        const List& list = this->list;
        const int count = list.count[i];
        const std::uint32_t first = std::uint32_t(list.index(i, 0));        // as blocks begin
        std::uint32_t next = count ? list.entry[first] : 0;
        for (int k = 0; k < count; ++k)
        {
            const std::uint32_t e = first + std::uint32_t(k*List::width);
            const std::uint32_t entry = next;
            if (k + 1 < count) next = list.entry[e + List::width];
            const int j = List::other(entry);
            const bool touched = entry & List::touching;
            const SolidA<D, P> aj = this->solids.a[j];
            typename SolidRecords<D, P>::Words words;
            real h[H + 1] = {};
            if (touched)
            {
                words = this->solids.words(j);
                list.template recall<H>(e, h);
            }
            const Vec<D, real> dx = this->line(xi, aj);
            const real r2 = squaredNorm(dx), reach = self.radius + aj.radius + largestGap;
            bool touches = r2 < reach*reach;
            if (touches)
            {
                if (!touched) words = this->solids.words(j);
                int mj;
                const ContactBody<D, real> other = SolidRecords<D, P>::bodyOf(aj, words, mj);
                touches = contact<alone>(
                    e, this->pairOf(mi, mj), self, other, dx, r2, dt, h, force, moment);
            }
            if (touches != touched)
                list.entry[e] = std::uint32_t(j) | (touches ? List::touching : 0u);
        }
    }

    //- False: they are near, but do not touch
    template<bool alone>
    HD bool contact(std::size_t e, int pair, const ContactBody<D, real>& self,
        const ContactBody<D, real>& other, const Vec<D, real>& dx, real r2, real dt, real* h,
        Vec<D, real>& force, Spin<D, real>& moment) const
    {
        const real toUnit = inverseRoot(maximum(r2, real(1e-30))), distance = r2*toUnit;
        real gap = alone ? this->singlePairGap : this->gap[pair];
        if (this->list.rest) gap -= this->list.rest[e];
        if (self.radius + other.radius + gap <= distance) return false;
        real armA, armB;
        const auto g = pairGeometry<D, real>(self, other, toUnit*dx, distance, gap, dt, armA, armB);
        NormalForce<real> fn;
        const auto f = Law::template evaluate<D, real>(
            alone ? this->singlePair : this->parameters[pair], g, armA, armB, h, fn);
        this->list.template remember<H>(e, h);
        force = force + f.force;
        moment = moment + f.momentA;
        return true;
    }
};

//- The pass alone: forces into the fields
template<class Backend, int D, class P, class Law>
struct GatherPass : ContactGather<Backend, D, P, Law>
{
    using real = typename P::real;
    static constexpr const char* name = "contacts";

    SolidFields<D, P> fields;

    HD void operator()(int i) const
    {
        if (!this->clock.active() || i >= *this->active) return;
        int material;
        const ContactBody<D, real> self = this->solids.body(i, material);
        Vec<D, real> force = filled<D>(real(0));
        Spin<D, real> moment = filled<spins<D>>(real(0));
        this->sum(
            i, this->solids.position(i), self, material, real(this->clock.dt()), force, moment);
        for (int d = 0; d < D; ++d) fields.f[d][i] = force.c[d];
        for (int c = 0; c < spins<D>; ++c) fields.m[c][i] = moment.c[c];
    }
};

} // namespace riprap
