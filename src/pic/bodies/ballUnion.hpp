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

    //- Nothing of it is farther from a point
    double reach(const Vec<D, double>& from) const
    {
        double most = 0;
        for (const Ball<D>& b : balls) most = std::max(most, std::sqrt(squaredNorm(b.centre - from)) + b.radius);
        return most;
    }
};

} // namespace riprap
