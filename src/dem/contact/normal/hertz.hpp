/*  Hertz (1882) with the dashpot of Tsuji, Tanaka & Ishida (1992), whose restitution does not depend on the speed.

        f_n = 4/3 E* sqrt(R* delta) delta + c V_n,    S_n = 2 E* sqrt(R* delta),    c = 2 zeta sqrt(m* S_n)
        1/E* = (1 - nu_A^2)/E_A + (1 - nu_B^2)/E_B

    zeta from the restitution coefficient, see restitution.hpp and dashpot.hpp. For disks the sphere's formula is taken per metre of depth.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/normal/dashpot.hpp"
#include "dem/contact/pairProperties.hpp"

namespace riprap
{

struct Hertz
{
    static constexpr int history = 0;

    template<class T>
    struct Parameters { T E, twoZeta, floor; };

    static Parameters<double> make(const PairProperties& p)
    {
        return {p.effectiveYoung(), 2*hertzDampingRatio(p.restitution, p.attraction), p.attraction ? -1e30 : 0.0};
    }

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T*)
    {
        NormalForce<T> f;
        f.stiffness = T(2.0f)*p.E*squareRoot(g.reducedRadius*g.overlap);
        f.damping = dashpot(p.twoZeta, f.stiffness, g);
        f.elastic = T(2.0/3.0)*f.stiffness*g.overlap;
        f.force = maximum(f.elastic + f.damping*dashpotApproach(g), p.floor);
        return f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g, const T*)
    { return T(8.0/15.0)*p.E*squareRoot(g.reducedRadius*g.overlap)*g.overlap*g.overlap; }
};

} // namespace riprap
