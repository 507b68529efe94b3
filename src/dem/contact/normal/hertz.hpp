/*  Hertz (1882) with the dashpot of Tsuji, Tanaka & Ishida (1992), whose restitution does not
    depend on the speed.

        f_n = 4/3 E* sqrt(R* delta) delta + c V_n, S_n = 2 E* sqrt(R* delta), c = 2 zeta sqrt(m*
        S_n)
        1/E* = (1 - nu_A^2)/E_A + (1 - nu_B^2)/E_B

    zeta from the restitution coefficient, see restitution.hpp and dashpot.hpp. For disks the
    sphere's formula is taken per metre of depth.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"
#include "dem/contact/normal/dashpot.hpp"
#include "dem/contact/restitution.hpp"

namespace riprap
{

struct Hertz : ElasticNormal
{
    static constexpr const char* word = "hertz";
    static constexpr const char* text =
        "elastic spheres of Hertz, with a dashpot whose restitution does not depend on the speed";
    static constexpr PairEntry entries[] = {
        pairEntry::restitution, pairEntry::attraction, pairEntry::gap};
    static constexpr int history = 0;

    template<class T>
    struct Parameters { T E, twoZeta, floor; };

    static Parameters<double> make(const PairProperties& p)
    {
        return {p.effectiveYoung(), 2*hertzDampingRatio(p.restitution, p.attraction),
            p.attraction ? -1e30 : 0.0};
    }

    //- df/d(delta) of the spring
    template<class T> HD static T slope(const T& E, const T& R, const T& overlap)
    {
        return T(2.0f)*E*squareRoot(R*overlap);
    }

    //- Depth of an impact (Johnson 1985, section 11.4)
    static double impactOverlap(double E, const Impact& b)
    {
        return std::pow(15*b.mass*b.speed*b.speed/(16*E*std::sqrt(b.radius)), 0.4);
    }

    //- Two equal ones meet at twice the speed: m*/2, R*/2; against a wall the same overlap ensues
    //  within 15 %
    static double stiffness(const PairProperties& p, const Impact& b)
    {
        const double E = p.effectiveYoung();
        return slope(E, b.radius, impactOverlap(E, b));
    }

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T*)
    {
        NormalForce<T> f;
        f.stiffness = slope(p.E, g.reducedRadius, g.overlap);
        f.damping = dashpot(p.twoZeta, f.stiffness, g);
        f.elastic = T(2.0/3.0)*f.stiffness*g.overlap;
        f.force = maximum(f.elastic + f.damping*dashpotApproach(g), p.floor);
        f.load = f.force;
        return f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g, const T*)
    { return T(8.0/15.0)*p.E*squareRoot(g.reducedRadius*g.overlap)*g.overlap*g.overlap; }
};

} // namespace riprap
