/*  Rolling friction of constant torque (model A of Ai, Chen, Rotter & Ooi 2011; Zhou et al. 1999).

        M_A = mu_r R* f_n W/|W|,    M_B = -M_A

    W is the relative spin w_B - w_A without twist. The torque is at most what stops the rolling
    within a step, J |W|/dt with
    J = m* R*^2, a lower bound of the contact's inertia: else it would swing about rest.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/card.hpp"

namespace riprap
{

struct ConstantTorque : RollingCard
{
    static constexpr const char* word = "constantTorque";
    static constexpr const char* text = "torque of constant size against rolling";
    static constexpr PairEntry entries[] = {pairEntry::rollingFriction};
    template<int D> static constexpr int history = 0;

    template<class T> struct Parameters { T mu; };

    static Parameters<double> make(const PairProperties& p) { return {p.rollingFriction}; }

    template<int D, class T>
    HD static Spin<D, T> moment(
        const Parameters<T>& p, const ContactGeometry<D, T>& g, const NormalForce<T>& fn, T*)
    {
        const T speed = squareRoot(maximum(squaredNorm(g.roll), T(1e-36f)));
        const T torque = p.mu*g.reducedRadius*maximum(fn.load, T(0.0f))/speed;
        const T stop = g.reducedMass*g.reducedRadius*g.reducedRadius/g.dt;
        return minimum(torque, stop)*g.roll;
    }
};

} // namespace riprap
