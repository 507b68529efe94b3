/*  The largest step that a close packing of equal bodies stands, in units of sqrt(m/k): what
    leapfrog and velocity Verlet with dashpots taken half a step late need of each of its fastest
    modes,

        (w dt)^2 + 2 C dt < 4,    w^2: the mode's stiffness over its inertia, C: its dashpots over
                                  its inertia

    With q contacts a body (spheres 12, disks 6) of which a share a = 2/3 (1 in 2D) resists each
    spin, I = i m R^2 (i = 2/5, 1/2) and
    kappa = k_t/k_n:

        neighbours move against each other       w^2 = 2 (q/D) k/m
        all spin alike, friction holds           w^2 = 2 a q kappa k/(i m)
        neighbours spin against each other       w^2 = 2 a q k_r/(i m R^2), k_r = 2.25 mu_r^2
                                                 (R/2)^2 k

    Without dashpots: 0.707 and 0.816 smooth, 0.316/sqrt(kappa) and 0.408/sqrt(kappa) with friction:
    the lattices' own normal modes, and what was found by bisection (benchmarks/demStability).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>

namespace riprap
{

//- The contacts of the packing, made without dimensions by m, R and k
struct PackedContact
{
    int dimensions = 3;
    double inertia = 0.4;           // i
    double kappa = 0;               // k_t/k_n; 0: smooth
    // no: the tangential spring is one step's slip (paper 2), a dashpot k_t dt
    bool tangentialSpring = true;
    double rolling = 0;             // mu_r of a rolling spring
    double rollingDamping = 0;      // its fraction of critical
    double twoZeta = 0;             // of dashpot.hpp; 0: none
    double plainDamping = 0;        // 2 alpha of a dashpot that knows no step (paper 2, Eq. 11)
    bool tangentialDamping = true;
};

inline bool packingStands(const PackedContact& p, double step)
{
    const double q = p.dimensions == 3 ? 12 : 6, normal = 2*q/p.dimensions,
                 spin = 2*(p.dimensions == 3 ? 8 : 6)/p.inertia;
    // dashpots by sqrt(m k): m* = m/2, and m_ij = m in paper 2
    const double root = std::sqrt(0.5);
    const double c = p.twoZeta*root/(1 + 0.5*p.twoZeta*root*step) + p.plainDamping;
    const double ct = p.tangentialDamping ? std::sqrt(p.kappa)*c : 0;
    const double kr = 2.25*0.25*p.rolling*p.rolling;
    const double cr = 2*p.rollingDamping*std::sqrt(0.125*(1 + p.inertia)*kr);
    const double friction = p.tangentialSpring ? p.kappa*step*step + 2*ct*step
                                               : 2*(p.kappa*step + ct)*step;
    return normal*(step*step + 2*c*step) < 4 && spin*friction < 4
        && spin*(kr*step*step + 2*cr*step) < 4;
}

inline double packingLimit(const PackedContact& p)
{
    double low = 0, high = 2;
    for (int k = 0; k < 50; ++k)
    {
        const double middle = 0.5*(low + high);
        (packingStands(p, middle) ? low : high) = middle;
    }
    return low;
}

} // namespace riprap
