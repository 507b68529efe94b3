/*  Two free bodies that meet, integrated in double by leapfrog with a contact law and nothing else:
    what closed forms of impacts are compared with.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "dem/contact/contact.hpp"

namespace riprap
{
namespace
{

template<int D>
struct Body
{
    Vec<D, double> x, v;
    Spin<D, double> w;
    double radius, mass;

    double inertia() const { return (D == 2 ? 0.5 : 0.4)*mass*radius*radius; }
    double kinetic() const { return 0.5*mass*squaredNorm(v) + 0.5*inertia()*squaredNorm(w); }
};

struct ImpactResult
{
    double duration = 0, maxOverlap = 0, maxForce = 0, highestEnergy = 0, stiffest = 0;
};

//- Until the bodies part, where a law reaches beyond the surfaces no sooner than that. Energy:
//  kinetic, with the spring's at whole steps (leapfrog's velocities averaged)
template<class Law, int D>
ImpactResult collide(
    Body<D>& a, Body<D>& b, PairProperties properties, double dt, double longest = 1)
{
    using Normal = typename Law::NormalLaw;
    properties.largestRadius = std::max(a.radius, b.radius);
    const double reach = Normal::reach(properties, properties.largestRadius),
                 gap = properties.gap + reach;
    const auto p = Law::template make<double>(properties);
    constexpr int size = Law::template history<D>;
    double h[size + 1] = {};
    ImpactResult r;
    for (double t = 0; t < longest; t += dt)
    {
        a.x = a.x + dt*a.v;
        b.x = b.x + dt*b.v;
        const Vec<D, double> line = b.x - a.x;
        const double d = std::sqrt(squaredNorm(line));
        if (a.radius + b.radius + gap <= d)
        {
            if (r.duration > 0) return r;
            continue;
        }
        double armA, armB;
        const ContactBody<D, double> ca{a.v, a.w, a.radius, a.mass}, cb{b.v, b.w, b.radius, b.mass};
        const auto g = pairGeometry<D, double>(ca, cb, (1/d)*line, d, gap, dt, armA, armB);
        NormalForce<double> fn;
        const auto f = Law::template evaluate<D, double>(p, g, armA, armB, h, fn);
        const double before = a.kinetic() + b.kinetic();
        a.v = a.v + (dt/a.mass)*f.force;
        b.v = b.v - (dt/b.mass)*f.force;
        a.w = a.w + (dt/a.inertia())*f.momentA;
        b.w = b.w + (dt/b.inertia())*f.momentB;
        const double stored = Law::template energy<D, double>(p, g, fn, h);
        r.highestEnergy = std::max(
            r.highestEnergy, 0.5*(before + a.kinetic() + b.kinetic()) + stored);
        r.duration += dt;
        r.maxOverlap = std::max(r.maxOverlap, g.overlap - reach);
        r.stiffest = std::max(r.stiffest, fn.stiffness);
        r.maxForce = std::max(r.maxForce, fn.force);
        if (Normal::reaches ? !Normal::acts(h) && g.approach < 0
                            : fn.force <= 0 && g.approach < 0 && !properties.attraction)
            return r;
    }
    return r;
}

//- Bodies about to touch, one beside the other along x; a moves at `speed`, `angle` away from the
//  line of centres
template<int D>
void approach(Body<D>& a, Body<D>& b, double speed, double angle)
{
    a.x = b.x = a.v = b.v = filled<D>(0.0);
    a.w = b.w = filled<spins<D>>(0.0);
    b.x.c[0] = a.radius + b.radius;
    a.v.c[0] = speed*std::cos(angle);
    a.v.c[1] = speed*std::sin(angle);
}

} // namespace
} // namespace riprap
