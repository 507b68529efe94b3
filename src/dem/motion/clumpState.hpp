/*  The state of a rigid body of several spheres, and how it turns.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "dem/state/frame.hpp"

namespace riprap
{

struct ClumpData
{
    std::int64_t x[3];          // centre of mass, fixed point
    double v[3];
    double L[3];                // angular momentum in space; 2D: L[2]
    double q[4];                // orientation (w, x, y, z); 2D: about the third axis
    double f[3], m[3];          // contact forces and moments now
    double mass, inertia[3];    // principal
    int group;
    int touching;               // members on which a contact acts now
    // members that can touch a plane at once; of them at least so many share the body's mass
    int together, least;
    // left: it is out of the domain and its members with it; it stays where that happened
    int left, unused;
};

//- What a contact of one member moves: of the members that touch now each has its share. Dashpots
//  take it, so that they together have the restitution of one contact of the body. Of those that
//  touch for the first time nobody has counted how many they are: all that can
HD double contactMass(const ClumpData& c)
{
    if (c.touching <= 0) return c.mass/c.together;
    return c.mass/(c.touching > c.least ? c.touching : c.least);
}

//- R(q) a, or with `inverse` its transpose
HD Vec<3, double> rotated(const double* q, const Vec<3, double>& a, bool inverse = false)
{
    const double s = inverse ? -1 : 1;
    const Vec<3, double> u{{s*q[1], s*q[2], s*q[3]}};
    const Vec<3, double> t = 2.0*cross(u, a);
    return a + q[0]*t + cross(u, t);
}

//- The spin that goes with an angular momentum
HD Vec<3, double> spinOf(const ClumpData& c, const double* q)
{
    const Vec<3, double> L{{c.L[0], c.L[1], c.L[2]}};
    Vec<3, double> b = rotated(q, L, true);
    for (int d = 0; d < 3; ++d) b.c[d] = c.inertia[d] > 0 ? b.c[d]/c.inertia[d] : 0;
    return rotated(q, b);
}

//- exp(w dt) q, normalised
HD void turn(const double* q, const Vec<3, double>& w, double dt, double* to)
{
    const double speed = sqrt(squaredNorm(w)), half = 0.5*speed*dt;
    const double c = cos(half), s = speed > 0 ? sin(half)/speed : 0;
    const double e[4] = {c, s*w.c[0], s*w.c[1], s*w.c[2]};
    const double r[4] =
    {
        e[0]*q[0] - e[1]*q[1] - e[2]*q[2] - e[3]*q[3],
        e[0]*q[1] + e[1]*q[0] + e[2]*q[3] - e[3]*q[2],
        e[0]*q[2] - e[1]*q[3] + e[2]*q[0] + e[3]*q[1],
        e[0]*q[3] + e[1]*q[2] - e[2]*q[1] + e[3]*q[0]
    };
    const double norm = 1/sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2] + r[3]*r[3]);
    for (int k = 0; k < 4; ++k) to[k] = norm*r[k];
}

//- R I R^T a
HD Vec<3, double> byInertia(const ClumpData& c, const double* q, const Vec<3, double>& a)
{
    Vec<3, double> b = rotated(q, a, true);
    for (int d = 0; d < 3; ++d) b.c[d] *= c.inertia[d];
    return rotated(q, b);
}

} // namespace riprap
