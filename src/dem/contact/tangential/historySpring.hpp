/*  Tangential spring that remembers its stretch, with Coulomb's limit (paper 1, Eqs. 7, 10, 12, 13;
    Cundall & Strack 1979; the accumulated form of paper 2's Eq. 8 as in Zhang et al. 2009). For
    normal laws of constant stiffness.

        s <- s + V_s dt, no longer than mu f_n/k_t,    f_t = k_t s + c_t V_s,    |f_t| <= mu f_n
        k_t = kappa k_n,    c_t = sqrt(kappa) c_n

    The limit holds for the spring alone, and then for the sum: what is stored, k_t s^2/2, then
    never grows by more than the bodies' work f_t.V_s. (A stretch chosen so that spring and dashpot
    together meet the limit would store energy out of nothing where the dashpot alone exceeds it.) s
    [m] is the history. kappa: given (paper 1's k_s/k_n), or (1 - nu)/(1 - nu/2), the ratio of two
    spheres pressed together (Mindlin 1949), with the mean nu of the pair.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"
#include "dem/contact/tangential/coulomb.hpp"

namespace riprap
{

struct HistorySpring : TangentialCard
{
    static constexpr const char* word = "history";
    static constexpr const char* text =
        "spring with memory, beside normal springs of constant stiffness";
    static constexpr PairEntry entries[] = {
        pairEntry::friction, pairEntry::stiffnessRatio, pairEntry::tangentialDamping};
    template<class Normal> static constexpr bool goesWith = Normal::constantStiffness;
    template<int D> static constexpr int history = spins<D>;

    template<class T> struct Parameters { T kappa, rootKappa, mu; };

    static Parameters<double> make(const PairProperties& p)
    {
        const double kappa = p.stiffnessRatio >= 0 ? p.stiffnessRatio : p.ratioByPoisson();
        return {kappa, p.tangentialDamping ? std::sqrt(kappa) : 0, p.friction};
    }

    //- k_t/k_n
    static double stiffnessRatio(const PairProperties& p) { return make(p).kappa; }

    template<int D, class T>
    HD static Tangent<D, T> force(
        const Parameters<T>& p, const ContactGeometry<D, T>& g, const NormalForce<T>& fn, T* h)
    {
        Tangent<D, T> s;
        for (int c = 0; c < spins<D>; ++c) s.c[c] = h[c];
        const T k = p.kappa*fn.stiffness;
        s = turned(g.n, s) + g.since*g.slip;
        s = coulombShare(k*k*squaredNorm(s), p.mu, fn.load)*s;
        for (int c = 0; c < spins<D>; ++c) h[c] = s.c[c];
        const Tangent<D, T> f = k*s + (p.rootKappa*fn.damping)*g.slip;
        return coulombShare(squaredNorm(f), p.mu, fn.load)*f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>& p, const NormalForce<T>& fn, const T* h)
    {
        T s2(0.0f);
        for (int c = 0; c < spins<D>; ++c) s2 = s2 + h[c]*h[c];
        return T(0.5f)*p.kappa*fn.stiffness*s2;
    }
};

} // namespace riprap
