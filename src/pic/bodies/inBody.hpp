/*  A body's share of a face, from its distances and, in 2D, its lines.

    In 3D the parts of faces are by distances at points a quarter of a cell apart. In 2D they are exact. Their sum is the body's area by chords at the planes of the faces, which misses up to (h/a)^1.5 of it where a plane
    nearly touches the body, and its added mass with it; there the mean over the planes of half a cell on either side is taken (inPole), and both converge
    with second order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/vec.hpp"
#include "pic/cutCells/faceCut.hpp"

namespace riprap
{

//- Of a face of direction d with its lower corner at x
template<int D>
HD Vec<D, double> middleOfFace(Vec<D, double> x, int d, double h)
{
    for (int e = 0; e < D; ++e) if (e != d) x[e] += 0.5*h;
    return x;
}

//- Faces of direction d from x along the other axis: the part in the body
EITHER_SIDE template<class Shape>
HD SolidPart<2> inBody(const Shape& shape, const Vec<2, double>& x, int d, double h)
{
    constexpr int planes = 8;
    const int along = 1 - d;
    const Vec<2, double> middle = middleOfFace(x, d, h);
    const double distance = shape.distance(middle);
    if (distance > h) return {0, {0}};
    if (distance < -h) return {1, {0.5}};
    SolidPart<2> part = shape.solidOfLine(x, along, h);
    const double inPole = 1 - shape.behindPole(middle, d)/h;
    if (!(inPole > 0)) return part;
    part.share *= 1 - inPole;
    part.moment[0] *= 1 - inPole;
    for (int k = 0; k < planes; ++k)
    {
        Vec<2, double> at = x;
        at[d] += h*((k + 0.5)/planes - 0.5);
        const SolidPart<2> there = shape.solidOfLine(at, along, h);
        part.share += inPole/planes*there.share;
        part.moment[0] += inPole/planes*there.moment[0];
    }
    return part;
}

//- A face of direction d in 3D with its lower corner at x. Distances at its corners alone would cut chords off the body: 2.3 % of the volume of a ball of 3.75 cells
//  a radius, and with it of its weight in water; those of sixteen parts leave a sixteenth of that
EITHER_SIDE template<class Shape>
HD SolidPart<3> inBody(const Shape& shape, const Vec<3, double>& x, int d, double h)
{
    constexpr int parts = 4;
    constexpr double reach = 0.75;      // cells: no corner of a face is farther from its middle
    const int a = d == 0 ? 1 : 0, c = d == 2 ? 1 : 2;
    const auto at = [&](int i, int j)
    {
        Vec<3, double> point = x;
        point[a] += h*i/parts;
        point[c] += h*j/parts;
        return point;
    };
    const double middle = shape.distance(at(parts/2, parts/2));
    if (middle > reach*h) return {0, {0, 0}};
    if (middle < -reach*h) return {1, {0.5, 0.5}};
    double low[parts + 1];      // distances at one end of a row of parts, and, as it is made, at the other
    for (int j = 0; j <= parts; ++j) low[j] = shape.distance(at(0, j));
    SolidPart<3> part{0, {0, 0}};
    for (int i = 0; i < parts; ++i)
    {
        double last = shape.distance(at(i + 1, 0));
        for (int j = 0; j < parts; ++j)
        {
            const double next = shape.distance(at(i + 1, j + 1));
            const SolidPart<3> p = solidOfSquare(low[j], last, low[j + 1], next);
            part.share += p.share/(parts*parts);
            part.moment[0] += (p.share*i + p.moment[0])/(parts*parts*parts);
            part.moment[1] += (p.share*j + p.moment[1])/(parts*parts*parts);
            low[j] = last;
            last = next;
        }
        low[parts] = last;
    }
    return part;
}

} // namespace riprap
