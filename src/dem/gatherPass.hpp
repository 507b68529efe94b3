/*  Contact forces by gathering: every particle over its full list, nothing shared, hence repeatable bit for bit. For the GPU.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/pairModel.hpp"

namespace riprap
{

template<class Backend, int D, class P, class Law>
struct GatherPass : PairModel<Backend, D, P, Law>
{
    using real = typename P::real;
    using Model = PairModel<Backend, D, P, Law>;
    using List = ContactListView<Backend, real>;
    static constexpr const char* name = "contacts";
    static constexpr int H = Model::histories;

    SolidFields<D, P> fields;
    real largestGap;

    HD void operator()(int i) const
    {
        if (!this->clock->active || i >= *this->active) return;
        const auto xi = this->solids.position(i);
        int mi;
        const ContactBody<D, real> self = this->solids.body(i, mi);
        const real dt = real(this->clock->dt);
        Vec<D, real> force = filled<D>(real(0));
        Spin<D, real> moment = filled<spins<D>>(real(0));
        const List& list = this->list;
        const int count = list.count[i];
        const std::size_t first = list.index(i, 0);
        std::uint32_t next = count ? list.entry[first] : 0;
        for (int k = 0; k < count; ++k)
        {
            const std::size_t e = first + std::size_t(k)*List::width;
            const std::uint32_t entry = next;
            if (k + 1 < count) next = list.entry[e + List::width];
            const int j = List::other(entry);
            const Vec<D, real> dx = this->line(xi, this->solids.a[j]);
            const real r2 = squaredNorm(dx), reach = self.radius + this->solids.a[j].radius + largestGap;
            const bool touched = entry & List::touching;
            bool touches = r2 < reach*reach;
            if (touches) touches = contact(i, j, e, mi, self, dx, r2, dt, touched, force, moment);
            if (touches != touched) list.entry[e] = std::uint32_t(j) | (touches ? List::touching : 0u);
        }
        for (int d = 0; d < D; ++d) fields.f[d][i] = force.c[d];
        for (int c = 0; c < spins<D>; ++c) fields.m[c][i] = moment.c[c];
    }

private:

    //- False: they are near, but do not touch
    HD bool contact
    (
        int, int j, std::size_t e, int mi, const ContactBody<D, real>& self, const Vec<D, real>& dx, real r2, real dt,
        bool touched, Vec<D, real>& force, Spin<D, real>& moment
    ) const
    {
        int mj;
        const ContactBody<D, real> other = this->solids.body(j, mj);
        const int pair = this->pairOf(mi, mj);
        const real distance = squareRoot(maximum(r2, real(1e-30)));
        real gap = this->gap[pair];
        if (this->list.rest) gap -= this->list.rest[e];
        if (self.radius + other.radius + gap <= distance) return false;
        real armA, armB, h[H + 1];
        for (int c = 0; c < H; ++c) h[c] = touched ? this->list.template remembered<H>(e, c) : real(0);
        const auto g = pairGeometry<D, real>(self, other, (real(1)/distance)*dx, distance, gap, dt, armA, armB);
        NormalForce<real> fn;
        const auto f = Law::template evaluate<D, real>(this->parameters[pair], g, armA, armB, h, fn);
        for (int c = 0; c < H; ++c) this->list.template remembered<H>(e, c) = h[c];
        force = force + f.force;
        moment = moment + f.momentA;
        return true;
    }
};

} // namespace riprap
