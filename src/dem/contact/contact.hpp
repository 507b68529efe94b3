/*  A contact law is Contact<Normal, Tangential, Rolling>; its history is theirs, one after the
    other.

    A new law is one header beside its like: its card (card.hpp), Parameters<T> (reals only),
    make(PairProperties), history, and its force.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/geometry.hpp"
#include "api/pairProperties.hpp"

namespace riprap
{

//- Two bodies as a contact sees them
template<int D, class T>
struct ContactBody
{
    Vec<D, T> velocity;
    Spin<D, T> spin;
    T radius, mass;
};

template<class Normal, class Tangential, class Rolling>
struct Contact
{
    using NormalLaw = Normal;
    using TangentialLaw = Tangential;
    using RollingLaw = Rolling;

    static constexpr bool turns = !(Tangential::off && Rolling::off);   // are there moments?

    template<int D> static constexpr int tangentialAt = Normal::history;
    template<int D>
    static constexpr int rollingAt = Normal::history + Tangential::template history<D>;
    template<int D> static constexpr int history = rollingAt<D> + Rolling::template history<D>;

    //- Reals only, so that a lane of a pack is filled by copying them one by one
    template<class T>
    struct Parameters
    {
        typename Normal::template Parameters<T> normal;
        typename Tangential::template Parameters<T> tangential;
        typename Rolling::template Parameters<T> rolling;
    };

    template<class R>
    static Parameters<R> make(const PairProperties& p)
    {
        const Parameters<double> all{Normal::make(p), Tangential::make(p), Rolling::make(p)};
        Parameters<R> r;
        const double* from = reinterpret_cast<const double*>(&all);
        R* to = reinterpret_cast<R*>(&r);
        for (std::size_t k = 0; k < sizeof(all)/sizeof(double); ++k) to[k] = R(from[k]);
        return r;
    }

    //- From here on the history changes its sign when A and B are exchanged: vectors in space and
    //  moments do; a normal force does not, nor does a stretch along t in 2D, since t turns with n
    template<int D> static constexpr int turnsFrom = D == 3 ? tangentialAt<D> : rollingAt<D>;

    //- Forces of the contact; h is read and written
    template<int D, class T>
    HD static ContactForce<D, T> evaluate(const Parameters<T>& p, const ContactGeometry<D, T>& g,
        const T& armA, const T& armB, T* h, NormalForce<T>& fn)
    {
        fn = Normal::force(p.normal, g, h);
        const Tangent<D, T> ft = Tangential::force(p.tangential, g, fn, h + tangentialAt<D>);
        const Spin<D, T> m = Rolling::template moment<D, T>(p.rolling, g, fn, h + rollingAt<D>);
        const Spin<D, T> turn = tangentMoment(g.n, ft);
        return ContactForce<D, T>{
            fromTangent(g.n, ft) - fn.force*g.n, armA*turn + m, armB*turn - m};
    }

    //- The forces of the last step once more, from what it left in h: what is remembered has had
    //  its increment
    template<int D, class T>
    HD static ContactForce<D, T> repeat(const Parameters<T>& p, const ContactGeometry<D, T>& g,
        const T& armA, const T& armB, T* h, NormalForce<T>& fn)
    {
        ContactGeometry<D, T> still = g;
        still.since = T(0.0f);
        return evaluate<D, T>(p, still, armA, armB, h, fn);
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g,
        const NormalForce<T>& fn, const T* h)
    {
        return Normal::energy(p.normal, g, h)
            + Tangential::template energy<D, T>(p.tangential, fn, h + tangentialAt<D>);
    }
};

//- Motion of B past A at a contact: n from A to B, arms from the centres to the contact point
template<int D, class T>
HD void setMotion(ContactGeometry<D, T>& g, const ContactBody<D, T>& a, const ContactBody<D, T>& b,
    const T& armA, const T& armB)
{
    const Vec<D, T> v = b.velocity - a.velocity;
    g.approach = -dot(v, g.n);
    const Vec<D, T> surface = v - spinCross(armA*a.spin + armB*b.spin, g.n);
    g.slip = toTangent(g.n, surface);
    g.roll = withoutTwist(g.n, b.spin - a.spin);
}

//- The geometry of two particles whose centres are d apart along n (from A to B), touching from
//  `gap` apart
template<int D, class T>
HD ContactGeometry<D, T> pairGeometry(const ContactBody<D, T>& a, const ContactBody<D, T>& b,
    const Vec<D, T>& n, const T& distance, const T& gap, const T& dt, T& armA, T& armB)
{
    ContactGeometry<D, T> g;
    g.n = n;
    // a contact of no overlap at all must divide nothing by zero
    g.overlap = maximum(a.radius + b.radius + gap - distance, T(1e-12f));
    const T half = T(0.5f)*(gap - g.overlap);
    armA = a.radius + half;
    armB = b.radius + half;
    setMotion(g, a, b, armA, armB);
    const T sum = a.mass + b.mass;
    g.reducedMass = a.mass*b.mass*inverse(sum);
    g.meanMass = T(0.5f)*sum;
    g.reducedRadius = a.radius*b.radius*inverse(a.radius + b.radius);
    g.dt = dt;
    g.since = dt;
    return g;
}

//- A particle and a wall, whose surface lies at `distance` along n and moves with `velocity` there
template<int D, class T>
HD ContactGeometry<D, T> wallGeometry(const ContactBody<D, T>& a, const Vec<D, T>& velocity,
    const Spin<D, T>& spin, const Vec<D, T>& n, const T& distance, const T& gap, const T& dt,
    T& armA)
{
    ContactGeometry<D, T> g;
    g.n = n;
    g.overlap = maximum(a.radius + gap - distance, T(1e-12f));
    armA = distance;
    const T armB(0.0f);
    setMotion(g, a, ContactBody<D, T>{velocity, spin, T(0.0f), T(0.0f)}, armA, armB);
    g.reducedMass = a.mass;
    g.meanMass = a.mass;
    g.reducedRadius = a.radius;
    g.dt = dt;
    g.since = dt;
    return g;
}

} // namespace riprap
