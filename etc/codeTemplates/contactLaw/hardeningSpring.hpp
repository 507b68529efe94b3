/*  A template: copy it to src/dem/contact/normal, rename HardeningSpring and its word, replace the
    formula.

    Spring that hardens, with the dashpot of the linear spring (replace by the law's source):

        f_n = k delta (1 + beta delta/R*) + c V_n, S_n = k (1 + 2 beta delta/R*), c = 2 zeta sqrt(m*
        S_n)

    k [N/m], beta []; zeta from the restitution coefficient of a linear spring (restitution.hpp), as
    beta delta/R* is small.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"
#include "dem/contact/normal/dashpot.hpp"
#include "dem/contact/restitution.hpp"

namespace riprap
{

struct HardeningSpring : NormalCard
{
    static constexpr const char* word = "hardening";
    static constexpr const char* text = "spring that hardens with the overlap";

    // a number that only this law has is kept by name
    static constexpr PairEntry beta =
        PairEntry("hardening", "", "hardening").in(Range::zeroOrPositive).byDefault(0).like(3);
    static constexpr PairEntry entries[] = {
        PairEntry("stiffness", "N/m", "normal stiffness", &PairProperties::normalStiffness)
            .perMetre()
            .orCalibration()
            .like(1e5),
        beta, pairEntry::restitution, pairEntry::attraction, pairEntry::gap};
    static constexpr int history = 0;

    // what the user can do where contacts are too soft: an overlap goes with k^(-1/2)
    static constexpr const char* stiffenedBy = "A stiffness";
    static constexpr double stiffening = 2;

    //- Slope and force of the spring
    template<class T> HD static T slope(const T& k, const T& beta, const T& strain)
    {
        return k*(T(1.0f) + T(2.0f)*beta*strain);
    }
    template<class T>
    HD static T spring(const T& k, const T& beta, const T& strain, const T& overlap)
    {
        return k*overlap*(T(1.0f) + beta*strain);
    }

    //- At the overlap of the linear spring, which is deeper. Two equal bodies: m/2 at 2 v and R/2
    static double stiffness(const PairProperties& p, const Impact& b)
    {
        return slope(p.normalStiffness, beta.value(p),
            2*b.speed*std::sqrt(2*b.mass/p.normalStiffness)/b.radius);
    }

    template<class T>
    struct Parameters { T k, beta, twoZeta, floor; };

    static Parameters<double> make(const PairProperties& p)
    {
        return
        {
            p.normalStiffness, beta.value(p), 2*linearDampingRatio(p.restitution, p.attraction),
            p.attraction ? -1e30 : 0.0
        };
    }

    template<int D, class T>
    HD static NormalForce<T> force(const Parameters<T>& p, const ContactGeometry<D, T>& g, T*)
    {
        const T strain = g.overlap*inverse(g.reducedRadius);
        NormalForce<T> f;
        f.stiffness = slope(p.k, p.beta, strain);
        f.damping = dashpot(p.twoZeta, f.stiffness, g);
        f.elastic = spring(p.k, p.beta, strain, g.overlap);
        f.force = maximum(f.elastic + f.damping*dashpotApproach(g), p.floor);
        f.load = f.force;
        return f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const ContactGeometry<D, T>& g, const T*)
    {
        const T strain = g.overlap*inverse(g.reducedRadius);
        return p.k*g.overlap*g.overlap*(T(0.5f) + T(1.0/3.0)*p.beta*strain);
    }
};

} // namespace riprap
