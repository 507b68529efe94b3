/*  Tangential spring of Mindlin (1949) for Hertz contacts, k_t = 8 G* a with a = sqrt(R* delta), in
    a form that creates no energy.

    k_t varies with the overlap, so that a force F kept by increments, dF = k_t V_s dt, has F^2/(2
    k_t) stored in it that grows while the contact unloads: out of nothing (Elata & Berryman 1996).
    Scaling F with k_t on unloading throws more away than that. Here the history is the root of the
    stored energy,

        q <- q + sqrt(k_t) V_s dt, no longer than mu f_n/sqrt(k_t), f_t = sqrt(k_t) q + c_t V_s,
        |f_t| <= mu f_n

    so that d(q^2/2) = q.sqrt(k_t) V_s dt = f_t.V_s dt, whatever the overlap does meanwhile: what is
    stored is exactly the work that was done on the spring. No path gains energy, stuck or slipping,
    and nothing is lost but to slip. While the overlap stays it is Mindlin's spring, f_t = k_t s.
    docs/solids.md has it beside the other two forms.

        k_t = kappa S_n, kappa = 4 G* / E*; c_t = sqrt(kappa) c_n (damping as of the normal dashpot)

    q [J^(1/2)] is the history.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"
#include "dem/contact/tangential/coulomb.hpp"

namespace riprap
{

struct Mindlin : TangentialCard
{
    static constexpr const char* word = "history";
    static constexpr const char* text =
        "Mindlin's spring with memory, beside normal laws whose stiffness varies";
    static constexpr PairEntry entries[] = {
        pairEntry::friction, pairEntry::stiffnessRatio, pairEntry::tangentialDamping};
    template<class Normal> static constexpr bool goesWith = !Normal::constantStiffness;
    template<int D> static constexpr int history = spins<D>;

    template<class T> struct Parameters { T kappa, rootKappa, mu; };

    static Parameters<double> make(const PairProperties& p)
    {
        // beside a law without elastic constants: as for spheres of one material
        const double byMaterials = p.youngA > 0 && p.youngB > 0
            ? 4*p.effectiveShear()/p.effectiveYoung()
            : p.ratioByPoisson();
        const double kappa = p.stiffnessRatio >= 0 ? p.stiffnessRatio : byMaterials;
        return {kappa, p.tangentialDamping ? std::sqrt(kappa) : 0, p.friction};
    }

    //- k_t/k_n
    static double stiffnessRatio(const PairProperties& p) { return make(p).kappa; }

    template<int D, class T>
    HD static Tangent<D, T> force(
        const Parameters<T>& p, const ContactGeometry<D, T>& g, const NormalForce<T>& fn, T* h)
    {
        const T root = squareRoot(p.kappa*fn.stiffness);
        Tangent<D, T> q;
        for (int c = 0; c < spins<D>; ++c) q.c[c] = h[c];
        q = turned(g.n, q) + (root*g.since)*g.slip;
        q = coulombShare(root*root*squaredNorm(q), p.mu, fn.load)*q;
        for (int c = 0; c < spins<D>; ++c) h[c] = q.c[c];
        const Tangent<D, T> f = root*q + (p.rootKappa*fn.damping)*g.slip;
        return coulombShare(squaredNorm(f), p.mu, fn.load)*f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>&, const NormalForce<T>&, const T* h)
    {
        T q2(0.0f);
        for (int c = 0; c < spins<D>; ++c) q2 = q2 + h[c]*h[c];
        return T(0.5f)*q2;
    }
};

} // namespace riprap
