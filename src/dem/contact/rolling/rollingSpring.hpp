/*  Elastic-plastic spring-dashpot rolling friction (model C of Ai, Chen, Rotter & Ooi 2011).

        M <- M + k_r W dt, |M| <= mu_r R* f_n,    k_r = 2.25 k_n mu_r^2 R*^2 (Iwashita & Oda 1998;
                                                  Jiang et al. 2005)
        M_A = M + c_r W while |M| is below its limit, M_A = M at it; c_r = 2 eta_r sqrt(J k_r), J =
        m* R*^2 (1 + beta)

    with beta = 2/5 for spheres, 1/2 for disks. M [N m] is the history; it holds a body at rest on a
    slope up to tan(slope) =
    mu_r. W is the relative spin without twist.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"

namespace riprap
{

struct RollingSpring : RollingCard
{
    static constexpr const char* word = "spring";
    static constexpr const char* text = "elastic-plastic rolling spring and dashpot";
    static constexpr PairEntry entries[] =
    {
        pairEntry::rollingFriction,
        PairEntry("rollingDamping", "", "rolling damping", &PairProperties::rollingDamping)
            .in(Range::zeroOrPositive).byDefault(0).losslessAt(0).show(Shown::never)
    };
    static constexpr bool spring = true;
    template<int D> static constexpr int history = spins<D>;

    template<class T> struct Parameters { T mu, twoEta; };

    static Parameters<double> make(const PairProperties& p)
    {
        return {p.rollingFriction, 2*p.rollingDamping};
    }

    template<int D, class T>
    HD static Spin<D, T> moment(
        const Parameters<T>& p, const ContactGeometry<D, T>& g, const NormalForce<T>& fn, T* h)
    {
        const T arm = p.mu*g.reducedRadius;
        const T k = T(2.25f)*fn.stiffness*arm*arm;
        Spin<D, T> m;
        for (int c = 0; c < spins<D>; ++c) m.c[c] = h[c];
        m = turned(g.n, m) + (k*g.since)*g.roll;
        const T limit = arm*maximum(fn.load, T(0.0f));
        const T share = minimum(T(1.0f), limit*inverseRoot(maximum(squaredNorm(m), T(1e-36f))));
        m = share*m;
        for (int c = 0; c < spins<D>; ++c) h[c] = m.c[c];
        const T inertia = g.reducedMass*g.reducedRadius*g.reducedRadius*T(D == 2 ? 1.5f : 1.4f);
        const T damping = selectGreater(T(1.0f), share, T(0.0f), p.twoEta*squareRoot(inertia*k));
        return m + damping*g.roll;
    }
};

} // namespace riprap
