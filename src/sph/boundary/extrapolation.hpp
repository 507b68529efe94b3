/*  Pressure and velocity that a point of a wall or of a solid takes from the fluid around it
    (Adami, Hu & Adams 2012):

        p = (sum p_f W + (g - a) . sum rho_f (x - x_f) W)/sum W (their Eq. 27), not below zero:
        nothing pulls
        v = 2 u - sum v_f W/sum W                                      (their Eqs. 22, 23)

    u and a are the point's own velocity and acceleration.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "sph/passes/fluidPass.hpp"

namespace riprap
{

//- Sums over fluid neighbours
template<int Dim> inline constexpr int extrapolationSums = 2 + 2*Dim;

template<int Dim, class T>
HD void addToExtrapolation(
    const PairParticle<Dim, T>& j, const Vec<Dim, T>& dx, const T& weight, T* sums)
{
    sums[0] += weight;
    sums[1] += j.pressureTerm*j.density*j.density*weight;
    for (int d = 0; d < Dim; ++d)
    {
        sums[2 + d] += j.density*dx.c[d]*weight;
        sums[2 + Dim + d] += j.velocity.c[d]*weight;
    }
}

//- Pressure and velocity; zero and u where there is no fluid. lift: g - a; wFactor: of the kernel,
//  below a millionth of which nothing is near
template<int Dim, class R>
HD R extrapolated(
    const R* sums, const Vec<Dim, R>& lift, const Vec<Dim, R>& u, R wFactor, Vec<Dim, R>& velocity)
{
    velocity = u;
    if (!(sums[0] > R(1e-6)*wFactor)) return R(0);
    const R inverse = R(1)/sums[0];
    R pressure = sums[1];
    for (int d = 0; d < Dim; ++d)
    {
        pressure += lift.c[d]*sums[2 + d];
        velocity.c[d] = R(2)*u.c[d] - sums[2 + Dim + d]*inverse;
    }
    return maximum(pressure*inverse, R(0));
}

} // namespace riprap
