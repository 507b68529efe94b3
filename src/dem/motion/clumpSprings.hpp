/*  Springs, and lines that go slack, between points of rigid bodies and points of space.

    l the distance of the two, e from the anchor to the body, u the velocity of the body's point, L
    the unstretched length:
        T = k (l - L) + c u.e,   F = -T e on the body; a line: T = 0 where l <= L, and never below 0

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/motion/clumpConstraint.hpp"

namespace riprap
{

struct SpringData
{
    double anchor[3];           // the solver's axes [m]
    double arm[3];              // from the centre to the point, in the body's principal axes
    double stiffness, damping, length;
    int slack;
};

//- What a spring does to its body now
struct SpringPull
{
    double length, tension;
    Vec<3, double> arm, force;  // arm: from the centre, in space
};

template<int D, class P>
HD SpringPull pullOf(const SpringData& s, const ClumpData& c, const Box<D, P>& box)
{
    SpringPull pull;
    pull.arm = rotated(c.q, vectorOf(s.arm));
    const Vec<3, double> d = armFrom(s.anchor, c, box) + pull.arm,
                         u = vectorOf(c.v) + cross(spinOf(c, c.q), pull.arm);
    pull.length = sqrt(squaredNorm(d));
    const Vec<3, double> e = pull.length > 0 ? (1/pull.length)*d : Vec<3, double>{{0, 0, 0}};
    const double stretch = pull.length - s.length;
    pull.tension = s.slack && stretch <= 0 ? 0 : s.stiffness*stretch + s.damping*dot(u, e);
    if (s.slack && pull.tension < 0) pull.tension = 0;
    pull.force = -pull.tension*e;
    return pull;
}

//- Those of each clump
template<int D, class P>
struct ClumpSprings
{
    const SpringData* spring;   // null: there are none
    const int* first;           // of a clump

    //- sums[0..2]: forces, sums[3..5]: moments
    HD void add(const ClumpData& c, int k, const Box<D, P>& box, double* sums) const
    {
        if (!spring || c.left) return;
        for (int e = first[k]; e < first[k + 1]; ++e)
        {
            const SpringPull pull = pullOf(spring[e], c, box);
            const Vec<3, double> m = cross(pull.arm, pull.force);
            for (int d = 0; d < 3; ++d) { sums[d] += pull.force.c[d]; sums[3 + d] += m.c[d]; }
        }
    }
};

} // namespace riprap
