/*  Rigid bodies that may not do everything. A constraint is a projection of what forces do, and
    never stores anything: reactions do no work.

    Centre of mass, T a projector (along a line n n^T, in a plane 1 - n n^T, none 0): v += dt T F/m
    About an axis n alone, J the inertia about the centre: w += dt n.M/(n.J n), spin w n, L = J w n
    Hinge, about n through a point, r from there to the centre: w += dt n.(M + r x F)/(n.J n + m |n
    x r|^2), v = w n x r
    A step turns r and the orientation by exactly w dt about n: the distance from the hinge is kept
    to round-off.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/precision.hpp"
#include "dem/motion/clumpState.hpp"
#include "dem/state/solidFields.hpp"

namespace riprap
{

enum class ClumpTurn {free, about, none};

//- Of a group, in the solver's axes
struct ClumpConstraint
{
    int any, hinge;
    ClumpTurn turn;
    double along[9];            // T
    double axis[3], point[3];   // axis: of length 1
};

HD Vec<3, double> vectorOf(const double* a) { return Vec<3, double>{{a[0], a[1], a[2]}}; }

//- From a point of space to a clump's centre; nearest image
template<int D, class P>
HD Vec<3, double> armFrom(const double* point, const ClumpData& c, const Box<D, P>& box)
{
    Vec<3, double> r{{0, 0, 0}};
    for (int d = 0; d < D; ++d)
    {
        r.c[d] = box.toMetres(d, c.x[d]) - point[d];
        if (box.periodic[d]) r.c[d] -= box.length[d]*rint(r.c[d]/box.length[d]);
    }
    return r;
}

//- The spin about an axis, and no other
HD void spinAbout(ClumpData& c, const Vec<3, double>& n, double w)
{
    const Vec<3, double> L = byInertia(c, c.q, w*n);
    for (int d = 0; d < 3; ++d) c.L[d] = L.c[d];
}

//- The velocity of a hinged body
HD void swingAbout(ClumpData& c, const Vec<3, double>& n, const Vec<3, double>& r, double w)
{
    const Vec<3, double> v = w*cross(n, r);
    for (int d = 0; d < 3; ++d) c.v[d] = v.c[d];
    spinAbout(c, n, w);
}

//- What a constraint leaves of the velocity at hand
template<int D, class P>
HD void restrain(ClumpData& c, const ClumpConstraint& s, const Box<D, P>& box)
{
    const Vec<3, double> n = vectorOf(s.axis);
    const double w = dot(spinOf(c, c.q), n);
    if (s.hinge) return swingAbout(c, n, armFrom(s.point, c, box), w);
    const Vec<3, double> v = vectorOf(c.v);
    for (int d = 0; d < 3; ++d)
        c.v[d] = s.along[3*d]*v.c[0] + s.along[3*d + 1]*v.c[1]
            + s.along[3*d + 2]*v.c[2];
    if (s.turn == ClumpTurn::about) spinAbout(c, n, w);
    if (s.turn == ClumpTurn::none) spinAbout(c, n, 0);
}

//- Force and moment about the centre, over dt
template<int D, class P>
HD void accelerate(ClumpData& c, const GroupData<D, typename P::real>& g,
    const ClumpConstraint* constraints, const Box<D, P>& box, const Vec<3, double>& f,
    const Vec<3, double>& m, double dt)
{
    if (!constraints || !constraints[c.group].any)
    {
        for (int d = 0; d < D; ++d) c.v[d] += double(g.free[d])*dt*f.c[d]/c.mass;
        for (int d = 0; d < 3; ++d) c.L[d] += double(g.freeSpin)*dt*m.c[d];
        return;
    }
    const ClumpConstraint& s = constraints[c.group];
    const Vec<3, double> n = vectorOf(s.axis);
    const double w = dot(spinOf(c, c.q), n), inertia = dot(n, byInertia(c, c.q, n));
    if (s.hinge)
    {
        const Vec<3, double> r = armFrom(s.point, c, box);
        const double all = inertia + c.mass*squaredNorm(cross(n, r));
        return swingAbout(c, n, r, w + dt*dot(n, m + cross(r, f))/all);
    }
    for (int d = 0; d < 3; ++d)
        c.v[d] += dt
            *(s.along[3*d]*f.c[0] + s.along[3*d + 1]*f.c[1] + s.along[3*d + 2]*f.c[2])
            /c.mass;
    if (s.turn == ClumpTurn::about) spinAbout(c, n, w + dt*dot(n, m)/inertia);
    if (s.turn == ClumpTurn::free) for (int d = 0; d < 3; ++d) c.L[d] += dt*m.c[d];
}

//- The orientation after dt of a body that turns about its constraint's axis alone, or not at all
HD void turnAbout(ClumpData& c, const ClumpConstraint& s, double dt)
{
    if (s.turn == ClumpTurn::none) return;
    const Vec<3, double> n = vectorOf(s.axis);
    const double w = dot(spinOf(c, c.q), n);
    double next[4];
    turn(c.q, w*n, dt, next);
    for (int e = 0; e < 4; ++e) c.q[e] = next[e];
    spinAbout(c, n, w);
}

//- A hinged body after dt
template<int D, class P>
HD void swing(ClumpData& c, const ClumpConstraint& s, const Box<D, P>& box, double dt)
{
    const Vec<3, double> n = vectorOf(s.axis), r = armFrom(s.point, c, box);
    const double w = dot(spinOf(c, c.q), n), upright[4] = {1, 0, 0, 0};
    double by[4], next[4];
    turn(upright, w*n, dt, by);
    turn(c.q, w*n, dt, next);
    const Vec<3, double> to = rotated(by, r);
    for (int e = 0; e < 4; ++e) c.q[e] = next[e];
    for (int d = 0; d < D; ++d)
        c.x[d] += std::int64_t(rint((to.c[d] - r.c[d])*box.unitsPerMetre[d]));
    swingAbout(c, n, to, w);
}

} // namespace riprap
