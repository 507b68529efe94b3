/*  Adhesive elastic spheres (Johnson, Kendall & Roberts 1971) with a dashpot: f_n and delta by the
    radius a of the contact area,

        delta = a^2/R* - sqrt(2 pi w a/E*),    f_n = 4 E* a^3/(3 R*) - sqrt(8 pi w E* a^3) + c V_n
        S_n = 2 E* a,    c = 2 zeta sqrt(m* S_n)

    with w the work of adhesion [J/m2]: twice the surface energy, of surfaces of one kind. Pulled
    with more than 3/2 pi w R* bodies part. The contact is made at delta = 0, where the force jumps
    to -4/3 pi w R*, and is lost at

        delta = -3 a_s^2/R*,    a_s = (pi w R*^2/(8 E*))^(1/3),    f_n = -5/6 pi w R*

    Between the two it depends on whether they have touched: that is the history. A touch and
    parting takes 7.09 (w^5 R*^4/E*^2)^(1/3) of the bodies' energy (Thornton & Ning 1998), whatever
    the speed. Friction is limited by mu (f_n + 3 pi w R*) (Thornton 1991).

    a is worked out in units of a_s of the largest bodies, where with t = delta/reach and rho, R* as
    a part of theirs, Z = sqrt(a) and M obey

        Z^4 - 4 rho Z - 3 rho t = 0,    M^3 + 3 rho t M - 2 rho^2 = 0, 2 Z = sqrt(2 M) + sqrt(8
                                        rho/sqrt(2 M) - 2 M)

    (Ferrari). M is found by Newton's method from above, where it converges without fail; at the
    separation M is a simple root while Z is a double one. The slope of f_n is S_n (1 - 3 s/4)/(1 -
    s/4), s = (4 rho/Z^3) < 4: below S_n wherever it is positive. zeta is that of Hertz: without
    adhesion the law is Hertz's with attraction. For disks the sphere's formula is taken per metre
    of depth.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"
#include "dem/contact/normal/dashpot.hpp"
#include "dem/contact/restitution.hpp"

namespace riprap
{

struct Jkr : ElasticNormal
{
    static constexpr const char* word = "jkr";
    static constexpr const char* text = "adhesive elastic spheres of Johnson, Kendall and Roberts, "
                                        "which part when pulled with 3/2 pi w R*";
    static constexpr PairEntry workOfAdhesion =
        PairEntry("workOfAdhesion", "J/m2", "work of adhesion").like(2);
    static constexpr PairEntry entries[] = {workOfAdhesion, pairEntry::restitution, pairEntry::gap};
    static constexpr int history = 1;           // 1: they have touched
    static constexpr bool reaches = true, bounds = true;

    //- a_s of this reduced radius, and how far surfaces are apart where they part
    static double radiusAtEnd(const PairProperties& p, double R)
    { return std::cbrt(M_PI*workOfAdhesion.value(p)*R*R/(8*p.effectiveYoung())); }
    static double reach(const PairProperties& p, double R)
    {
        return 3*std::pow(radiusAtEnd(p, R), 2)/R;
    }

    //- Elastic energy less that of adhesion [J]: what f_n takes from a = 0 on; a_s that of the
    //  largest bodies
    template<class T>
    HD static T energyOf(const T& E, const T& R, const T& as, const T& rho, const T& Z)
    {
        const T Z3 = Z*Z*Z, area = as*as*inverse(R);
        return T(4.0/3.0)*E*as*area*area*Z*Z3*(T(0.4f)*Z3*Z3 - T(4.0f)*rho*Z3 + T(6.0f)*rho*rho);
    }

    //- S_n at the largest contact area of an impact: where adhesion and the bodies' energy are
    //  stored. Masses and radii as for Hertz
    static double stiffness(const PairProperties& p, const Impact& b)
    {
        const double E = p.effectiveYoung(), as = radiusAtEnd(p, b.radius);
        const auto stored = [&](double Z) { return energyOf(E, b.radius, as, 1.0, Z); };
        // at delta = 0
        const double first = std::cbrt(4), most = stored(first) + 0.5*b.mass*b.speed*b.speed;
        double low = first, high = 2*first;
        while (stored(high) < most) high *= 2;
        for (int k = 0; k < 60; ++k)
        {
            const double middle = 0.5*(low + high);
            (stored(middle) < most ? low : high) = middle;
        }
        return 2*E*as*high*high;
    }

    template<class T>
    // R* of the largest bodies, and a_s of these
    struct Parameters { T E, twoZeta, reach, largest, a; };

    static Parameters<double> make(const PairProperties& p)
    {
        const double R = p.largestRadius;
        return {p.effectiveYoung(), 2*hertzDampingRatio(p.restitution, true), reach(p, R), R,
            radiusAtEnd(p, R)};
    }

    template<class T, class Q> HD static T reachOf(const Q& p) { return p.reach; }
    template<class T> HD static bool acts(const T* h) { return h[0] > T(0.5f); }

    //- sqrt(a/a_s)
    template<class T>
    HD static T rootOfArea(const T& rho, const T& t)
    {
        const T three = T(3.0f)*rho*t, two = T(2.0f)*rho*rho, root = squareRoot(rho);
        // above the root: rho^(2/3) < rho^(5/8), and M < 2 rho/(3 t) where t > 0
        T M = T(2.0f)*root*squareRoot(squareRoot(squareRoot(rho)));
        M = minimum(M, two*inverse(maximum(three, T(1e-6f)*two)));
        for (int k = 0; k < 7; ++k)
        {
            const T M2 = M*M;
            M = (T(2.0f)*M*M2 + two)*inverse(maximum(T(3.0f)*M2 + three, T(1e-12f)*rho));
        }
        const T first = squareRoot(T(2.0f)*M);
        return T(0.5f)
            *(first
                + squareRoot(maximum(T(8.0f)*rho*inverse(first) - first*first, T(0.0f))));
    }

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T* h)
    {
        const T none(0.0f), one(1.0f), overlap = g.overlap - p.reach;
        const T rho = minimum(g.reducedRadius*inverse(p.largest), one),
                t = overlap*inverse(p.reach);
        const T held = selectGreater(t*t*t, -rho, h[0], none);
        h[0] = selectGreater(overlap, none, one, held);
        const T Z = rootOfArea(rho, t), Z3 = Z*Z*Z, a = p.a*Z*Z;
        const T unit = T(4.0/3.0)*p.E*p.a*p.a*p.a*inverse(p.largest);
        NormalForce<T> f;
        f.stiffness = h[0]*(T(2.0f)*p.E*a);
        f.damping = dashpot(p.twoZeta, f.stiffness, g);
        f.elastic = h[0]*(unit*Z3*(Z3*inverse(rho) - T(6.0f)));
        f.force = f.elastic + f.damping*g.approach;
        f.load = f.force + h[0]*(T(18.0f)*unit*rho);
        return f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g, const T* h)
    {
        const T rho = minimum(g.reducedRadius*inverse(p.largest), T(1.0f)),
                t = (g.overlap - p.reach)*inverse(p.reach);
        return h[0]*energyOf(p.E, g.reducedRadius, p.a, rho, rootOfArea(rho, t));
    }
};

} // namespace riprap
