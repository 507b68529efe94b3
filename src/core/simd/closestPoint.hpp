/*  The point of a segment (2D) or triangle (3D) that is closest to a centre, and the feature that
    it lies on.

    Triangle: Ericson, Real-Time Collision Detection (2005), 5.1.5.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "core/simd/vec.hpp"

namespace riprap
{

//- Features: -1 is the inside of the element; then in 3D edges 01, 12, 20 and vertices 0, 1, 2; in
//  2D vertices 0, 1
static constexpr int insideElement = -1;
template<int D> inline constexpr int featureCount = D == 2 ? 2 : 6;

HD Vec<2, double> closestPoint(const Vec<2, double>* v, const Vec<2, double>& x, int& feature)
{
    const Vec<2, double> e = v[1] - v[0];
    const double t = dot(x - v[0], e)/squaredNorm(e);
    feature = t <= 0 ? 0 : (t >= 1 ? 1 : insideElement);
    return t <= 0 ? v[0] : (t >= 1 ? v[1] : v[0] + t*e);
}

HD Vec<3, double> closestPoint(const Vec<3, double>* v, const Vec<3, double>& x, int& feature)
{
    const Vec<3, double> ab = v[1] - v[0], ac = v[2] - v[0], ap = x - v[0];
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    feature = 3;
    if (d1 <= 0 && d2 <= 0) return v[0];
    const Vec<3, double> bp = x - v[1];
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    feature = 4;
    if (d3 >= 0 && d4 <= d3) return v[1];
    const double vc = d1*d4 - d3*d2;
    feature = 0;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return v[0] + (d1/(d1 - d3))*ab;
    const Vec<3, double> cp = x - v[2];
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    feature = 5;
    if (d6 >= 0 && d5 <= d6) return v[2];
    const double vb = d5*d2 - d1*d6;
    feature = 2;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return v[0] + (d2/(d2 - d6))*ac;
    const double va = d3*d6 - d5*d4;
    feature = 1;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return v[1] + ((d4 - d3)/((d4 - d3) + (d5 - d6)))*(v[2] - v[1]);
    feature = insideElement;
    const double denominator = 1/(va + vb + vc);
    return v[0] + (vb*denominator)*ab + (vc*denominator)*ac;
}

//- Unit normal of a segment or a triangle
HD Vec<2, double> elementNormal(const Vec<2, double>* v)
{
    const Vec<2, double> a = v[1] - v[0];
    const double length = sqrt(squaredNorm(a));
    return Vec<2, double>{{-a.c[1]/length, a.c[0]/length}};
}

HD Vec<3, double> elementNormal(const Vec<3, double>* v)
{
    const Vec<3, double> n = cross(v[1] - v[0], v[2] - v[0]);
    const double length = sqrt(squaredNorm(n));
    return Vec<3, double>{{n.c[0]/length, n.c[1]/length, n.c[2]/length}};
}

} // namespace riprap
