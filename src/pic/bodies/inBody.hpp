/*  A body's share of a face, from its distances and, in 2D, its lines.

    In 3D the parts of faces are exact for a ball, else by distances at points a quarter of a cell
    apart. In 2D they are exact. Their sum is the body's area by chords at the planes of the faces,
    which misses up to (h/a)^1.5 of it where a plane nearly touches the body, in 3D up to (h/a)^2/4
    of its volume, and its added mass with it; there the mean over the planes of half a cell on
    either side is taken (inPole), and both converge with second order.

    Of a shape of its own that mean is by volumes, also in 3D: a share is then what the body has of
    the volume that the face moves, from the middle of one cell to that of the next (volume
    fractions: Batty, Bertails & Bridson 2007, ACM Trans. Graph. 26, 100). By planes alone a flat
    bottom would feel nothing of its depth within a layer of cells: the force would be that of the
    pressure in the middle of the layer.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"
#include "core/simd/vec.hpp"
#include "pic/shapes/diskInSquare.hpp"
#include "pic/shapes/sampledShape.hpp"
#include "pic/shapes/shapes.hpp"

namespace riprap
{

//- Cells: a body that is farther from the middle of a face has nothing of it, nor of half a cell on
//  either side
template<int D> inline constexpr double faceReach = D == 2 ? 1 : 0.875;

//- Of a face of direction d with its lower corner at x
template<int D>
HD Vec<D, double> middleOfFace(Vec<D, double> x, int d, double h)
{
    for (int e = 0; e < D; ++e) if (e != d) x[e] += 0.5*h;
    return x;
}

//- How much the surface about a face lies across its axis, 0 .. 1. Where an edge bends it, a cell
//  beside the face tells: what lies behind the edge is as flat
EITHER_SIDE template<int D>
HD double inPole(const SampledShape<D>& shape, const Vec<D, double>& middle, int d, double h)
{
    // 1 - cos of the angle between normals: a cell apart less than that of a ball of three cells a
    // radius; an edge that bends by half a right angle; half a cell apart that of a ball of eight
    // cells
    constexpr double round = 0.05, edge = 0.15, plane = 0.002;
    const Vec<D, double> normal = shape.normal(middle);
    const double own = shape.behindPole(middle, normal, d);
    double least = own;
    for (int e = 0; e < D; ++e)
        for (int side = -1; side <= 1 && e != d; side += 2)
        {
            Vec<D, double> beside = middle;
            beside[e] += side*h;
            const Vec<D, double> there = shape.normal(beside);
            const double behind = shape.behindPole(beside, there, d);
            if (!(behind < least)) continue;
            double bend = (1 - dot(normal, there) - round)/(edge - round);
            if (bend < 1)
            {
                beside[e] += 0.5*side*h;
                bend = maximum(bend, 1 - (1 - dot(there, shape.normal(beside)))/plane);
            }
            if (bend > 0) least = minimum(least, own + minimum(bend, 1.0)*(behind - own));
        }
    return 1 - least/h;
}

//- A part of the volume of a face, in cells from it along its direction: the whole lies between the
//  middles of the two cells
struct AlongFace
{
    double from = -0.5, to = 0.5;

    HD double middle() const { return 0.5*(from + to); }
};

//- What a shape has of the volume of a face, by distances at points an eighth of a cell apart
HD SolidPart<2> inVolume(
    const SampledShape<2>& shape, const Vec<2, double>& x, int d, double h, const AlongFace& part)
{
    constexpr int parts = 8;
    const int along = 1 - d;
    const auto at = [&](int i, int j)
    {
        Vec<2, double> point = x;
        point[along] += h*i/parts;
        point[d] += h*(part.from + (part.to - part.from)*j/parts);
        return shape.distance(point);
    };
    SolidPart<2> sum{0, {0}};
    double low[parts + 1];
    for (int j = 0; j <= parts; ++j) low[j] = at(0, j);
    for (int i = 0; i < parts; ++i)
    {
        double last = at(i + 1, 0);
        for (int j = 0; j < parts; ++j)
        {
            const double next = at(i + 1, j + 1);
            const SolidPart<3> p = solidOfSquare(low[j], last, low[j + 1], next);
            sum.share += p.share/(parts*parts);
            sum.moment[0] += (p.share*i + p.moment[0])/(parts*parts*parts);
            low[j] = last;
            last = next;
        }
        low[parts] = last;
    }
    return sum;
}

//- A quarter of a cell apart, across the face half a cell; a part's middle is taken for that of
//  what it has
HD SolidPart<3> inVolume(
    const SampledShape<3>& shape, const Vec<3, double>& x, int d, double h, const AlongFace& part)
{
    constexpr int parts = 4, layers = 2;
    const int a = d == 0 ? 1 : 0, c = d == 2 ? 1 : 2;
    double distance[parts + 1][parts + 1][layers + 1];
    for (int i = 0; i <= parts; ++i)
        for (int j = 0; j <= parts; ++j)
            for (int k = 0; k <= layers; ++k)
            {
                Vec<3, double> point = x;
                point[a] += h*i/parts;
                point[c] += h*j/parts;
                point[d] += h*(part.from + (part.to - part.from)*k/layers);
                distance[i][j][k] = shape.distance(point);
            }
    SolidPart<3> sum{0, {0, 0}};
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j)
            for (int k = 0; k < layers; ++k)
            {
                double corner[8];
                int in = 0;
                for (int n = 0; n < 8; ++n)
                {
                    corner[n] = distance[i + (n & 1)][j + (n >> 1 & 1)][k + (n >> 2)];
                    in += corner[n] < 0;
                }
                if (!in) continue;
                const double share = (in == 8 ? 1.0 : solidOfCube(corner))/(parts*parts*layers);
                sum.share += share;
                sum.moment[0] += share*(i + 0.5)/parts;
                sum.moment[1] += share*(j + 0.5)/parts;
            }
    return sum;
}

//- Parts a and b, weighted by 1 - w and w
template<int D>
HD SolidPart<D> between(const SolidPart<D>& a, const SolidPart<D>& b, double w)
{
    w = minimum(w, 1.0);
    SolidPart<D> part{a.share + w*(b.share - a.share), {}};
    for (int m = 0; m < D - 1; ++m) part.moment[m] = a.moment[m] + w*(b.moment[m] - a.moment[m]);
    return part;
}

//- Faces of direction d from x along the other axis: the part in the body; of a shape of its own,
//  in a part of the face's volume
EITHER_SIDE template<class Shape>
HD SolidPart<2> inBody(const Shape& shape, const Vec<2, double>& x, int d, double h,
    const AlongFace& volume = AlongFace())
{
    constexpr int planes = 8;
    const int along = 1 - d;
    const Vec<2, double> middle = middleOfFace(x, d, h);
    const double distance = shape.distance(middle);
    if (distance > faceReach<2>*h) return {0, {0}};
    if (distance < -faceReach<2>*h) return {1, {0.5}};
    if (const SampledShape<2>* own = shape.lattice())
    {
        Vec<2, double> plane = x;
        plane[d] += h*volume.middle();
        const SolidPart<2> part = shape.solidOfLine(plane, along, h);
        const double flat = riprap::inPole(*own, middle, d, h);
        return flat > 0 ? between(part, inVolume(*own, x, d, h, volume), flat) : part;
    }
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

//- The same, beside its poles the mean over planes
EITHER_SIDE HD SolidPart<3> inBallAndPole(const Ball<3>& ball, Vec<3, double> x, int d, double h)
{
    constexpr int planes = 8;
    SolidPart<3> part = inBall(ball, x, d, h);
    const Vec<3, double> middle = middleOfFace(x, d, h);
    const double inPole = 1 - ball.behindPole(middle, d)/h, face = x[d];
    if (!(inPole > 0) || std::fabs(ball.distance(middle)) > faceReach<3>*h) return part;
    part.share *= 1 - inPole;
    for (int m = 0; m < 2; ++m) part.moment[m] *= 1 - inPole;
    for (int k = 0; k < planes; ++k)
    {
        x[d] = face + h*((k + 0.5)/planes - 0.5);
        const SolidPart<3> there = inBall(ball, x, d, h);
        part.share += inPole/planes*there.share;
        for (int m = 0; m < 2; ++m) part.moment[m] += inPole/planes*there.moment[m];
    }
    return part;
}

//- A face of direction d in 3D with its lower corner at x. Where the body is not one ball,
//  distances at the face's corners alone would cut chords off it: of a ball of 3.75 cells a radius
//  2.3 % of the volume, and with it of its weight in water; those of sixteen parts leave a
//  sixteenth of that
EITHER_SIDE template<class Shape>
HD SolidPart<3> inBody(const Shape& shape, const Vec<3, double>& x, int d, double h,
    const AlongFace& volume = AlongFace())
{
    constexpr int parts = 4;
    const int a = d == 0 ? 1 : 0, c = d == 2 ? 1 : 2;
    if (const Ball<3>* ball = shape.single()) return inBallAndPole(*ball, x, d, h);
    const SampledShape<3>* own = shape.lattice();
    const double plane = own ? h*volume.middle() : 0;
    const auto at = [&](int i, int j)
    {
        Vec<3, double> point = x;
        point[a] += h*i/parts;
        point[c] += h*j/parts;
        point[d] += plane;
        return point;
    };
    const Vec<3, double> face = middleOfFace(x, d, h);
    const double middle = shape.distance(face);
    if (middle > faceReach<3>*h) return {0, {0, 0}};
    if (middle < -faceReach<3>*h) return {1, {0.5, 0.5}};
    // distances at one end of a row of parts, and, as it is made, at the other
    double low[parts + 1];
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
    if (own)
    {
        const double flat = inPole(*own, face, d, h);
        if (flat > 0) return between(part, inVolume(*own, x, d, h, volume), flat);
    }
    return part;
}

//- Faces of direction d along the first axis, the lower corner of one of them at x: which may the
//  body have a part of? Told with less work
template<int D, class Shape>
struct RowInBody
{
    const Shape& shape;
    Vec<D, double> x;
    int d;
    double h;
    const Ball<3>* ball = nullptr;
    // of a ball: the square of what it has of a line along the row that comes nearest to its middle
    double half2 = 1;

    HD RowInBody(const Shape& of, const Vec<D, double>& first, int direction, double edge)
        : shape(of), x(first), d(direction), h(edge)
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
        return e == d ? maximum(0.0, std::fabs(r) - 0.5*h) : maximum(0.0, maximum(r, -r - h));
    }
};

} // namespace riprap
