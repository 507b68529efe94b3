/*  A body's share of a face, from its distances and, in 2D, its lines.

    In 3D the parts of faces are exact for a ball, else by distances at points a quarter of a cell apart. In 2D they are exact. Their sum is the body's area by chords at the planes of the faces, which misses up to (h/a)^1.5 of it where a plane
    nearly touches the body, and its added mass with it; there the mean over the planes of half a cell on either side is taken (inPole), and both converge
    with second order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/vec.hpp"
#include "pic/shapes/diskInSquare.hpp"
#include "pic/shapes/shapes.hpp"

namespace riprap
{

//- Cells: a body that is farther from the middle of a face has nothing of it. In 3D no corner is farther; in 2D a pole is spread over half a cell
template<int D> inline constexpr double faceReach = D == 2 ? 1 : 0.75;

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
    if (distance > faceReach<2>*h) return {0, {0}};
    if (distance < -faceReach<2>*h) return {1, {0.5}};
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

//- What a ball has of a face: a disk's part of a square
HD SolidPart<3> inBall(const Ball<3>& ball, const Vec<3, double>& x, int d, double h)
{
    const Vec<3, double> r = (1/h)*(x - ball.centre);
    const double radius = ball.radius/h;
    return diskInSquare(d == 0 ? r[1] : r[0], d == 2 ? r[1] : r[2], radius*radius - r[d]*r[d]);
}

//- A face of direction d in 3D with its lower corner at x. Where the body is not one ball, distances at the face's corners alone would cut chords off it: of a ball of 3.75 cells
//  a radius 2.3 % of the volume, and with it of its weight in water; those of sixteen parts leave a sixteenth of that
EITHER_SIDE template<class Shape>
HD SolidPart<3> inBody(const Shape& shape, const Vec<3, double>& x, int d, double h)
{
    constexpr int parts = 4;
    const int a = d == 0 ? 1 : 0, c = d == 2 ? 1 : 2;
    if (const Ball<3>* ball = shape.single()) return inBall(*ball, x, d, h);
    const auto at = [&](int i, int j)
    {
        Vec<3, double> point = x;
        point[a] += h*i/parts;
        point[c] += h*j/parts;
        return point;
    };
    const double middle = shape.distance(at(parts/2, parts/2));
    if (middle > faceReach<3>*h) return {0, {0, 0}};
    if (middle < -faceReach<3>*h) return {1, {0.5, 0.5}};
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

//- Faces of direction d along the first axis, the lower corner of one of them at x: which may the body have a part of? Told with less work
template<int D, class Shape>
struct RowInBody
{
    const Shape& shape;
    Vec<D, double> x;
    int d;
    double h;
    const Ball<3>* ball = nullptr;
    double half2 = 1;               // of a ball: the square of what it has of a line along the row that comes nearest to its middle

    HD RowInBody(const Shape& of, const Vec<D, double>& first, int direction, double edge) : shape(of), x(first), d(direction), h(edge)
    {
        if constexpr (D == 3)
            if ((ball = shape.single()))
            {
                half2 = ball->radius*ball->radius;
                for (int e = 1; e < 3; ++e)
                {
                    const double near = away(e);
                    half2 -= near*near;
                }
            }
    }

    HD bool none() const { return !(half2 > 0); }

    //- The face whose lower corner is there along the row
    HD bool may(double at)
    {
        x[0] = at;
        if (ball)
        {
            const double near = away(0);
            return near*near < half2;
        }
        return !(shape.distance(middleOfFace(x, d, h)) > faceReach<D>*h);
    }

private:

    //- Along an axis, of the face from the ball's middle
    HD double away(int e) const
    {
        const double r = x[e] - ball->centre[e];
        return e == d ? r : maximum(0.0, maximum(r, -r - h));
    }
};

} // namespace riprap
