/*  Signed distances of simple solids [m]: negative inside, positive in the open.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "core/vec.hpp"

namespace riprap
{

//- Disk or sphere
template<int D>
struct Ball
{
    Vec<D, double> centre;
    double radius;

    HD double distance(const Vec<D, double>& x) const { return std::sqrt(squaredNorm(x - centre)) - radius; }
};

//- Half space: solid where normal.(x - point) < 0; normal of length 1
template<int D>
struct HalfSpace
{
    Vec<D, double> point, normal;

    HD double distance(const Vec<D, double>& x) const { return dot(x - point, normal); }
};

//- Box along the axes
template<int D>
struct AxisBox
{
    Vec<D, double> lower, upper;

    HD double distance(const Vec<D, double>& x) const
    {
        double outside = 0, inside = -1e300;
        for (int d = 0; d < D; ++d)
        {
            const double below = lower[d] - x[d], above = x[d] - upper[d], beyond = below > above ? below : above;
            if (beyond > 0) outside += beyond*beyond;
            inside = beyond > inside ? beyond : inside;
        }
        return outside > 0 ? std::sqrt(outside) : inside;
    }
};

//- The solid is where the other is not: a tank
template<class Shape>
struct Complement
{
    Shape shape;

    template<int D>
    HD double distance(const Vec<D, double>& x) const { return -shape.distance(x); }
};

} // namespace riprap
