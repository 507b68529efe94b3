/*  Linear spring and dashpot by overlap (paper 1, Eqs. 5, 9; Cundall & Strack 1979).

        f_n = k delta + 2 zeta sqrt(m* k) V_n

    k [N/m] (2D: per metre of depth, [N/m2]); zeta from the restitution coefficient, see
    restitution.hpp and dashpot.hpp. `floor` is 0 where the dashpot must not pull, and very low
    where it may.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"
#include "dem/contact/normal/dashpot.hpp"
#include "dem/contact/restitution.hpp"

namespace riprap
{

struct LinearSpring : SpringNormal
{
    static constexpr const char* word = "linear";
    static constexpr const char* text = "spring and dashpot by overlap";
    static constexpr PairEntry entries[] = {
        PairEntry("stiffness", "N/m", "normal stiffness", &PairProperties::normalStiffness)
            .perMetre()
            .orCalibration()
            .like(1e5),
        pairEntry::restitution, pairEntry::attraction, pairEntry::gap};
    static constexpr int history = 0;

    template<class T>
    struct Parameters { T k, twoZeta, floor; };

    static Parameters<double> make(const PairProperties& p)
    {
        return {p.normalStiffness, 2*linearDampingRatio(p.restitution, p.attraction),
            p.attraction ? -1e30 : 0.0};
    }

    static double stiffness(const PairProperties& p, const Impact&) { return p.normalStiffness; }
    static NormalDashpot dashpotOf(const PairProperties& p) { return {make(p).twoZeta, 0}; }

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T*)
    {
        NormalForce<T> f;
        f.stiffness = p.k;
        f.damping = dashpot(p.twoZeta, f.stiffness, g);
        f.elastic = p.k*g.overlap;
        f.force = maximum(f.elastic + f.damping*dashpotApproach(g), p.floor);
        f.load = f.force;
        return f;
    }

    //- Elastic energy [J]
    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g, const T*)
    { return T(0.5f)*p.k*g.overlap*g.overlap; }
};

} // namespace riprap
