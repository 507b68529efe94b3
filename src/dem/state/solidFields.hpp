/*  The solids' state on the device (structure of arrays, sorted together) and what is done to
    groups of them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/simd/precision.hpp"
#include "dem/state/frame.hpp"

namespace riprap
{

//- From this count of calm checks on a particle sleeps
static constexpr std::int32_t asleepFrom = 1 << 20;

//- Instead of it, of another rank's particle
static constexpr std::int32_t ghostMark = 1 << 29;

template<int D, class P>
struct SolidFields
{
    using real = typename P::real;

    std::int64_t* x[D];         // fixed-point position
    // velocity: of half a step ago (leapfrog) or now (Verlet) [m/s]. In single precision g dt would
    // be
    double* v[D];
                                // rounded to the velocity's last digit, step after step the same
                                // way
    real* w[spins<D>];          // spin, likewise [rad/s]
    real* f[D];                 // force now, before damping [N]
    real* m[spins<D>];          // moment now [N m]
    real* radius;
    real* mass;
    real* inverseInertia;
    std::int32_t* material;
    std::int32_t* group;
    std::int32_t* clump;        // null: there are none
    // orientation: angle, or quaternion (w, x, y, z); null: not followed
    real* turn[D == 2 ? 1 : 4];
    std::int32_t* id;
    std::int32_t* calm;         // checks at rest in a row; null: nobody sleeps

    HD bool ghost(int i) const { return calm && calm[i] == ghostMark; }
    HD bool asleep(int i) const { return calm && calm[i] >= asleepFrom; }

    HD Vec<D, std::int64_t> position(int i) const
    {
        Vec<D, std::int64_t> r;
        for (int d = 0; d < D; ++d) r.c[d] = x[d][i];
        return r;
    }
    HD Vec<D, double> velocity(int i) const
    {
        Vec<D, double> r;
        for (int d = 0; d < D; ++d) r.c[d] = v[d][i];
        return r;
    }
    HD Spin<D, real> spin(int i) const
    {
        Spin<D, real> r;
        for (int c = 0; c < spins<D>; ++c) r.c[c] = w[c][i];
        return r;
    }
    HD Vec<D, real> force(int i) const
    {
        Vec<D, real> r;
        for (int d = 0; d < D; ++d) r.c[d] = f[d][i];
        return r;
    }
    HD Spin<D, real> momentOn(int i) const
    {
        Spin<D, real> r;
        for (int c = 0; c < spins<D>; ++c) r.c[c] = m[c][i];
        return r;
    }
    HD void addForce(int i, const Vec<D, real>& force, const Spin<D, real>& moment) const
    {
        for (int d = 0; d < D; ++d) f[d][i] += force.c[d];
        for (int c = 0; c < spins<D>; ++c) m[c][i] += moment.c[c];
    }
};

//- What is done to the particles of a group
template<int D, class R>
struct GroupData
{
    R free[D];                  // 1: this component of the velocity follows forces, 0: it is held
    R freeSpin;
    R gravity;                  // 1 or 0
    R force[D];
    R moment[spins<D>];
    R localDamping, viscous, viscousSpin;
    int damped;                 // is any of these not zero?
    int motion;                 // prescribed motion, -1: none
};

//- Local damping of a component (paper 1, Eq. 25): against the velocity, a share alpha of the
//  unbalanced force
template<class R>
HD R locallyDamped(R force, R velocity, R alpha)
{
    const R sign = velocity > 0 ? R(1) : (velocity < 0 ? R(-1) : R(0));
    return force - alpha*absolute(force)*sign;
}

} // namespace riprap
