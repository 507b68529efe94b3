/*  Tangential force of paper 2 (Eqs. 8, 12, 13, 15), whose spring knows the last step only: it
    holds no load at rest, a pile creeps.

        f_t = k_t V_s dt + c_t V_s,    |f_t| <= mu f_n, k_t = k_n/(2 (1 + psi)), c_t = c_n/sqrt(2 (1
                                       + psi))

    psi: Poisson's ratio (mean of the pair), or kappa = k_t/k_n given. No history.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"
#include "dem/contact/tangential/coulomb.hpp"

namespace riprap
{

struct OneStepSpring : TangentialCard
{
    static constexpr const char* word = "oneStep";
    static constexpr const char* text =
        "spring that knows the last step only: it holds no load at rest";
    static constexpr PairEntry entries[] = {
        pairEntry::friction, pairEntry::stiffnessRatio, pairEntry::tangentialDamping};
    static constexpr bool spring = false;
    template<int D> static constexpr int history = 0;

    template<class T> struct Parameters { T kappa, rootKappa, mu; };

    static Parameters<double> make(const PairProperties& p)
    {
        const double psi = 0.5*(p.poissonA + p.poissonB);
        const double kappa = p.stiffnessRatio >= 0 ? p.stiffnessRatio : 1/(2*(1 + psi));
        return {kappa, p.tangentialDamping ? std::sqrt(kappa) : 0, p.friction};
    }

    //- k_t/k_n
    static double stiffnessRatio(const PairProperties& p) { return make(p).kappa; }

    template<int D, class T>
    HD static Tangent<D, T> force(
        const Parameters<T>& p, const ContactGeometry<D, T>& g, const NormalForce<T>& fn, T*)
    {
        const Tangent<D, T> f = (p.kappa*fn.stiffness*g.dt + p.rootKappa*fn.damping)*g.slip;
        return coulombShare(squaredNorm(f), p.mu, fn.load)*f;
    }

    template<int D, class T>
    HD static T energy(const Parameters<T>&, const NormalForce<T>&, const T*) { return T(0.0f); }
};

} // namespace riprap
