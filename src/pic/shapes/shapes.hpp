/*  Signed distances of simple solids [m]: negative inside, positive in the open.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "core/simd/vec.hpp"
#include "pic/shapes/faceCut.hpp"

namespace riprap
{

template<int D> struct SampledShape;

//- Disk or sphere
template<int D>
struct Ball
{
    Vec<D, double> centre;
    double radius;

    HD double distance(const Vec<D, double>& x) const
    {
        return std::sqrt(squaredNorm(x - centre)) - radius;
    }

    //- Its only ball: shapes that are no ball have none
    HD const Ball* single() const { return this; }

    //- Its lattice: shapes that are sampled have one
    HD const SampledShape<D>* lattice() const { return nullptr; }

    //- Of the line from x along an axis, in parts of its length, what lies inside: from low to
    //  high; false: nothing
    HD bool covers(
        const Vec<D, double>& x, int axis, double length, double& low, double& high) const
    {
        const Vec<D, double> r = x - centre;
        const double half2 = radius*radius - (squaredNorm(r) - r[axis]*r[axis]);
        if (!(half2 > 0)) return false;
        const double half = std::sqrt(half2);
        low = (-half - r[axis])/length;
        high = (half - r[axis])/length;
        low = low > 0 ? low : 0;
        high = high < 1 ? high : 1;
        return high > low;
    }

    HD SolidPart<2> solidOfLine(const Vec<D, double>& x, int axis, double length) const
    {
        double low, high;
        if (!covers(x, axis, length, low, high)) return {0, {0}};
        return {high - low, {0.5*(high*high - low*low)}};
    }

    //- How far behind the plane that touches the surface across an axis the surface lies where it
    //  is nearest to x
    HD double behindPole(const Vec<D, double>& x, int axis) const
    {
        const Vec<D, double> r = x - centre;
        const double far = std::sqrt(squaredNorm(r));
        return far > 0 ? radius*(1 - std::fabs(r[axis])/far) : radius;
    }
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
            const double below = lower[d] - x[d], above = x[d] - upper[d],
                         beyond = below > above ? below : above;
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
