/*  A rigid body made of balls, as the grid sees it: a particle of the solids, or a clump of
    several.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/simd/math.hpp"
#include "pic/shapes/shapes.hpp"

namespace riprap
{

//- Balls that lie one after the other in memory. Distance to the nearest: exact outside, in the
//  body where balls overlap less than the true depth
template<int D>
struct BallSet
{
    const Ball<D>* balls;
    int count;

    HD double distance(const Vec<D, double>& x) const
    {
        double least = 1e300;
        for (int b = 0; b < count; ++b) least = minimum(least, balls[b].distance(x));
        return least;
    }

    HD const Ball<D>* single() const { return count == 1 ? balls : nullptr; }
    HD const SampledShape<D>* lattice() const { return nullptr; }

    //- Pieces that balls cover, from the lowest on: each adds what lies beyond the end of those
    //  before
    HD SolidPart<2> solidOfLine(const Vec<D, double>& x, int axis, double length) const
    {
        if (count == 1) return balls[0].solidOfLine(x, axis, length);
        SolidPart<2> part{0, {0}};
        double end = 0;
        for (bool more = true; more; )
        {
            double from = 0, to = 0;
            more = false;
            for (int b = 0; b < count; ++b)
            {
                double low, high;
                if (!balls[b].covers(x, axis, length, low, high) || !(high > end)) continue;
                if (more && (low > from || (low == from && high >= to))) continue;
                from = low;
                to = high;
                more = true;
            }
            if (!more) break;
            from = maximum(from, end);
            part.share += to - from;
            part.moment[0] += 0.5*(to*to - from*from);
            end = to;
        }
        return part;
    }

    HD double behindPole(const Vec<D, double>& x, int axis) const
    {
        return nearest(x).behindPole(x, axis);
    }

    HD const Ball<D>& nearest(const Vec<D, double>& x) const
    {
        int best = 0;
        for (int b = 1; b < count; ++b)
            if (balls[b].distance(x) < balls[best].distance(x)) best = b;
        return balls[best];
    }
};

//- The same with memory of its own
template<int D>
struct BallUnion
{
    std::vector<Ball<D>> balls;

    BallSet<D> set() const { return {balls.data(), int(balls.size())}; }
    double distance(const Vec<D, double>& x) const { return set().distance(x); }
    const Ball<D>* single() const { return set().single(); }
    const SampledShape<D>* lattice() const { return nullptr; }
    SolidPart<2> solidOfLine(const Vec<D, double>& x, int axis, double length) const
    {
        return set().solidOfLine(x, axis, length);
    }
    double behindPole(const Vec<D, double>& x, int axis) const { return set().behindPole(x, axis); }

    //- Nothing of it is farther from a point
    double reach(const Vec<D, double>& from) const
    {
        double most = 0;
        for (const Ball<D>& b : balls)
            most = maximum(most, std::sqrt(squaredNorm(b.centre - from)) + b.radius);
        return most;
    }
};

} // namespace riprap
