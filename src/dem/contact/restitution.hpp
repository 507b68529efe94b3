/*  Damping ratio zeta of a dashpot c = 2 zeta sqrt(m* S) from the restitution coefficient e, S the
    spring's slope.

    Where the dashpot may pull until the bodies part (delta = 0), in closed form:
        linear   zeta = -ln e/sqrt(pi^2 + ln^2 e)                       (damped half oscillation)
        Hertz    zeta = sqrt(5/6) of the same                           (Antypov & Elliott 2011)
    Where it may not, the contact ends at f_n = 0, before delta = 0, and e is larger for the same
    zeta (Schwager & Poschel 2007; Thornton, Cummins & Cleary 2013). Then zeta is found by bisection
    on the impact itself, integrated without dimensions:
        x'' = -s(x) - 2 zeta sqrt(s'(x)) x',    s = x (linear), x^(3/2) (Hertz), x(0) = 0, x'(0) = 1
    e(zeta) does not depend on mass, stiffness or, for both laws, speed.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <cmath>

namespace riprap
{

namespace detail
{

//- Speed after an impact at speed 1 that ends when the force has fallen to zero
inline double speedAfterImpact(bool hertz, double zeta)
{
    const auto force = [&](double x, double v)
    {
        x = std::max(x, 0.0);
        const double root = std::sqrt(x);
        return hertz ? x*root + 2*zeta*std::sqrt(1.5*root)*v : x + 2*zeta*v;
    };
    const double dt = 1e-3;
    double x = 0, v = 1;
    for (int step = 0; step < 100000; ++step)
    {
        // Runge-Kutta of fourth order; the first step may begin with force (linear) or without
        // (Hertz)
        const double k1 = -force(x, v), x1 = x + 0.5*dt*v, v1 = v + 0.5*dt*k1;
        const double k2 = -force(x1, v1), x2 = x + 0.5*dt*v1, v2 = v + 0.5*dt*k2;
        const double k3 = -force(x2, v2), x3 = x + dt*v2, v3 = v + dt*k3;
        const double k4 = -force(x3, v3);
        const double before = force(x, v), speed = v;
        x += dt*(v + 2*v1 + 2*v2 + v3)/6;
        v += dt*(k1 + 2*k2 + 2*k3 + k4)/6;
        const double after = force(x, v);
        if (v < 0 && after <= 0) return -(speed + (v - speed)*before/(before - after + 1e-300));
        if (step > 0 && x <= 0) return -v;
    }
    return 0;
}

inline double dampingRatio(bool hertz, double e, bool attraction)
{
    if (e >= 1) return 0;
    const double logarithm = std::log(std::max(e, 1e-6));
    const double closed = -logarithm/std::sqrt(M_PI*M_PI + logarithm*logarithm)
        *(hertz ? std::sqrt(5.0/6.0) : 1.0);
    if (attraction) return closed;
    double low = 0, high = 20;
    if (speedAfterImpact(hertz, high) > e) return high;
    for (int k = 0; k < 45; ++k)
    {
        const double middle = 0.5*(low + high);
        (speedAfterImpact(hertz, middle) > e ? low : high) = middle;
    }
    return 0.5*(low + high);
}

} // namespace detail

inline double linearDampingRatio(double e, bool attraction)
{
    return detail::dampingRatio(false, e, attraction);
}
inline double hertzDampingRatio(double e, bool attraction)
{
    return detail::dampingRatio(true, e, attraction);
}

} // namespace riprap
