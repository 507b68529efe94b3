/*  The dashpot beside a normal spring, so that an impact has its restitution at steps of finite
    length.

    A force is worked out at t_n from the velocity half a step before. To first order in dt the late
    velocity makes a dashpot c work like one of c (1 + zeta w dt) beside a spring k (1 + zeta w dt),
    w = sqrt(S/m*): its zeta is larger by 1 + zeta w dt/2. So

        c = 2 zeta sqrt(m* S)/(1 + zeta w dt/2)

    A contact begins and ends within a step. It is there from dt delta/|V_n| before t_n on, and the
    force acts to half a step after it: where that is less than a step ago, delta < |V_n| dt, the
    dashpot acts for delta/(|V_n| dt) + 1/2 of a step instead of all of it (at the end of a contact
    alike, time reversed):

        f = c (V_n/2 + sign(V_n) delta/dt)

    Both vanish with the step, and at rest: the spring's force is not touched.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/contact/geometry.hpp"

namespace riprap
{

//- c [N s/m] of a spring of slope S
template<int D, class T>
HD T dashpot(const T& twoZeta, const T& S, const ContactGeometry<D, T>& g)
{
    const T root = twoZeta*squareRoot(g.reducedMass*S);
    return g.reducedMass*root*inverse(g.reducedMass + T(0.25f)*g.dt*root);
}

//- The rate of approach that the dashpot is to be given
template<int D, class T>
HD T dashpotApproach(const ContactGeometry<D, T>& g)
{
    // a scene that has not begun has no step
    const T none(0.0f), perStep = g.overlap*inverse(maximum(g.dt, T(1e-30f))),
                        half = T(0.5f)*g.approach;
    const T partly = half + selectGreater(g.approach, none, perStep, -perStep);
    return selectGreater(
        selectGreater(g.approach, none, g.approach, -g.approach), perStep, partly, g.approach);
}

} // namespace riprap
