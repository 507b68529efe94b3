/*  The part of a square in a disk: its area and first moments, exact.

    By the theorem of Gauss over the boundary, which is pieces of the four sides and arcs, r from
    the middle of the disk and n outwards:

        A = 1/2 integral of r.n ds,    integral of r dA = 1/3 integral of r (r.n) ds

    A piece of length l on a side at distance c along its normal adds c l to the first; arcs add r^2
    times their angle, which is minus what the pieces subtend, to whole turns. To the second arcs
    add r^2 times their way across, which is minus that of the pieces, since the boundary is closed.
    So four roots and one angle are all.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "core/simd/math.hpp"
#include "pic/shapes/faceCut.hpp"

namespace riprap
{

//- Pieces of the sides of a square that lie in a disk, taken up one after the other
struct SidesInDisk
{
    double radius2;
    double flux = 0;                    // sum of c l
    double cosine = 1, sine = 0;        // of the angle that pieces subtend, times a length
    double moment[2] = {0, 0};          // three times the integral of r, along the two axes
    bool any = false;

    //- The side at x along an axis (its normal points up it or down it), from low to high along the
    //  other
    HD void add(int axis, bool up, double x, double low, double high)
    {
        const double half2 = radius2 - x*x;
        if (!(half2 > 0)) return;
        const double half = std::sqrt(half2), from = maximum(low, -half), to = minimum(high, half),
                     length = to - from;
        if (!(length > 0)) return;
        const double c = up ? x : -x, s = c*length, k = c*c + from*to, before = cosine;
        any = true;
        flux += s;
        cosine = k*cosine - s*sine;
        sine = k*sine + s*before;
        moment[axis] -= (up ? half2 : -half2)*length;
        moment[1 - axis] += 0.5*s*(from + to);
    }

    //- Of all arcs in the square; within: the middle of the disk lies in it
    HD double arc(bool within) const
    {
        // a smaller disk leaves no square whole, a larger one has less than half a turn in one
        constexpr double turn = 2*M_PI, small2 = 0.35;
        if (!any) return within ? turn : 0;
        const double angle = -std::atan2(sine, cosine);
        if (within && radius2 < small2) return angle > 0 ? angle : angle + turn;
        return angle > 0 ? angle : angle < -1 ? angle + turn : 0;       // the last: round-off
    }
};

//- A square of side 1 whose lower corner is (x, y) away from the middle of a disk; moments from the
//  square's corner
HD SolidPart<3> diskInSquare(double x, double y, double radius2)
{
    // a side through the middle is a hair beside it, else a piece that begins there would subtend
    // nothing
    const auto beside = [](double at) { return absolute(at) < 1e-100 ? 1e-100 : at; };
    x = beside(x);
    y = beside(y);
    const double endX = beside(x + 1), endY = beside(y + 1);
    const double farX = maximum(-x, endX), farY = maximum(-y, endY),
                 nearX = maximum(0.0, maximum(x, -endX)), nearY = maximum(0.0, maximum(y, -endY));
    if (!(nearX*nearX + nearY*nearY < radius2)) return {0, {0, 0}};
    if (farX*farX + farY*farY <= radius2) return {1, {0.5, 0.5}};
    SidesInDisk sides{radius2};
    sides.add(0, false, x, y, endY);
    sides.add(0, true, endX, y, endY);
    sides.add(1, false, y, x, endX);
    sides.add(1, true, endY, x, endX);
    const double area = 0.5*(sides.flux + radius2*sides.arc(nearX + nearY == 0));
    const double share = maximum(0.0, minimum(1.0, area));
    const double moment[2] = {sides.moment[0]/3 - x*area, sides.moment[1]/3 - y*area};
    return {
        share, {maximum(0.0, minimum(share, moment[0])), maximum(0.0, minimum(share, moment[1]))}};
}

} // namespace riprap
