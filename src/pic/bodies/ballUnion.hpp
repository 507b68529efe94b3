/*  A rigid body made of balls, as the grid sees it: a particle of the solids, or a clump of several.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <vector>
#include "pic/shapes/shapes.hpp"

namespace riprap
{

//- Distance to the nearest: exact outside, in the body where balls overlap less than the true depth
template<int D>
struct BallUnion
{
    std::vector<Ball<D>> balls;

    double distance(const Vec<D, double>& x) const
    {
        double nearest = 1e300;
        for (const Ball<D>& b : balls) nearest = std::min(nearest, b.distance(x));
        return nearest;
    }

    SolidPart<2> solidOfLine(const Vec<D, double>& x, int axis, double length) const
    {
        if (balls.size() == 1) return balls[0].solidOfLine(x, axis, length);
        std::vector<std::pair<double, double>> covered;
        for (const Ball<D>& b : balls)
        {
            double low, high;
            if (b.covers(x, axis, length, low, high)) covered.push_back({low, high});
        }
        std::sort(covered.begin(), covered.end());
        SolidPart<2> part{0, {0}};
        double end = 0;
        for (const auto& [low, high] : covered)
        {
            const double from = std::max(low, end);
            if (!(high > from)) continue;
            part.share += high - from;
            part.moment[0] += 0.5*(high*high - from*from);
            end = high;
        }
        return part;
    }

    double behindPole(const Vec<D, double>& x, int axis) const { return nearest(x).behindPole(x, axis); }

    const Ball<D>& nearest(const Vec<D, double>& x) const
    {
        const Ball<D>* best = &balls[0];
        for (const Ball<D>& b : balls) if (b.distance(x) < best->distance(x)) best = &b;
        return *best;
    }

    //- Nothing of it is farther from a point
    double reach(const Vec<D, double>& from) const
    {
        double most = 0;
        for (const Ball<D>& b : balls) most = std::max(most, std::sqrt(squaredNorm(b.centre - from)) + b.radius);
        return most;
    }
};

} // namespace riprap
