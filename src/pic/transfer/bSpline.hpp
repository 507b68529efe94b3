/*  B-splines of order 1 (linear), 2 (quadratic) and 3 (cubic) on a line of nodes one unit apart.

        B1(s) = 1 - |s|                                         |s| < 1
        B2(s) = 3/4 - s^2 |s| < 1/2, (3/2 - |s|)^2/2 |s| < 3/2
        B3(s) = |s|^3/2 - s^2 + 2/3 |s| < 1, (2 - |s|)^3/6 |s| < 2

    Steffen, Kirby & Berzins (2008), Int. J. Numer. Meth. Eng. 76. Each sums to 1 over the nodes and
    reproduces a linear field.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"

namespace riprap
{

template<int Order>
struct BSpline
{
    static_assert(Order >= 1 && Order <= 3, "linear, quadratic or cubic");
    static constexpr int nodes = Order + 1;
    static constexpr double support = 0.5*(Order + 1);      // half width, in distances of nodes

    //- sum of B(s - i) (i - s)^2 over the nodes: what divides the first moment of a field in an
    //  affine map (orders 2, 3)
    static constexpr double secondMoment = Order == 2 ? 0.25 : 1.0/3.0;

    //- The first node of those that see a point at s
    template<class R>
    HD static int first(R s)
    {
        if constexpr (Order == 1) return floorInt(s);
        else if constexpr (Order == 2) return floorInt(s - R(0.5));
        else return floorInt(s) - 1;
    }

    //- The same for a point in the cell that s is counted from, s being 0 .. 1 from a face
    //  (`faces`) or -0.5 .. 0.5 from the cell's middle
    template<class R>
    HD static int firstInCell(R s, [[maybe_unused]] bool faces)
    {
        if constexpr (Order == 2) return faces && s >= R(0.5) ? 0 : -1;
        else return (s < 0 ? -1 : 0) - (Order == 3 ? 1 : 0);
    }

    //- Values of nodes first .. first + Order at a point that is f = s - first beyond the first
    template<class R>
    HD static void weights(R f, R* w)
    {
        if constexpr (Order == 1) { w[0] = 1 - f; w[1] = f; }
        else if constexpr (Order == 2)
        {
            w[0] = R(0.5)*(R(1.5) - f)*(R(1.5) - f);
            w[1] = R(0.75) - (f - 1)*(f - 1);
            w[2] = R(0.5)*(f - R(0.5))*(f - R(0.5));
        }
        else
        {
            const R a = 2 - f, b = f - 1;       // f in 1 .. 2
            w[0] = a*a*a/6;
            w[1] = R(0.5)*b*b*b - b*b + R(2)/3;
            w[2] = R(0.5)*a*a*a - a*a + R(2)/3;
            w[3] = b*b*b/6;
        }
    }

    //- dw/ds of the same
    template<class R>
    HD static void slopes(R f, R* w)
    {
        if constexpr (Order == 1) { w[0] = -1; w[1] = 1; }
        else if constexpr (Order == 2) { w[0] = f - R(1.5); w[1] = -2*(f - 1); w[2] = f - R(0.5); }
        else
        {
            const R a = 2 - f, b = f - 1;
            w[0] = R(-0.5)*a*a;
            w[1] = R(1.5)*b*b - 2*b;
            w[2] = R(-1.5)*a*a + 2*a;
            w[3] = R(0.5)*b*b;
        }
    }

    //- d2w/ds2 of the same, of orders 2 and 3
    template<class R>
    HD static void curvatures([[maybe_unused]] R f, R* w)
    {
        static_assert(Order > 1, "linear ones have none");
        if constexpr (Order == 2) { w[0] = 1; w[1] = -2; w[2] = 1; }
        else
        {
            const R a = 2 - f, b = f - 1;
            w[0] = a;
            w[1] = 3*b - 2;
            w[2] = 3*a - 2;
            w[3] = b;
        }
    }

    //- One node's value at a distance s
    template<class R>
    HD static R value(R s)
    {
        const R a = absolute(s);
        if constexpr (Order == 1) return maximum(1 - a, R(0));
        else if constexpr (Order == 2)
        {
            const R far = maximum(R(1.5) - a, R(0));
            return a < R(0.5) ? R(0.75) - a*a : R(0.5)*far*far;
        }
        else
        {
            const R far = maximum(2 - a, R(0));
            return a < 1 ? R(0.5)*a*a*a - a*a + R(2)/3 : far*far*far/6;
        }
    }
};

} // namespace riprap
