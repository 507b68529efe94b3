// SPDX-License-Identifier: GPL-3.0-or-later

#include "fittedPacking.H"
#include "pointGrid.H"
#include "ListOps.H"
#include "sph/kernels/wendlandC2.hpp"

namespace Foam
{

// Iterations at most, and the largest move, in spacings, at which it ends
static const label mostMoves = 100;
static const scalar restingMove = 2e-3;
// Longest move of an iteration, in spacings
static const scalar longestMove = 0.1;


// Towards the surface, of unit length
static vectorField waysOut(const fittedPacking& f, const pointField& points)
{
    vectorField n(normalsOf(f.shape, points, 1e-3*f.spacing, f.frame));
    if (!f.inside) n = -n;
    return n;
}


// Depths of the points that may be nearer to the surface than a length: `least` is below each one's
// depth, and becomes it for those
static labelList nearer(
    const fittedPacking& f, const pointField& points, scalar length, scalarField& least)
{
    DynamicList<label> some;
    forAll(least, i) if (least[i] < length) some.append(i);
    const scalarField depth(f.depth(pointField(points, some)));
    DynamicList<label> near;
    forAll(some, k)
    {
        least[some[k]] = depth[k];
        if (depth[k] < length) near.append(some[k]);
    }
    return labelList(std::move(near));
}


static void keepOff(const fittedPacking& f, pointField& points, scalarField& least)
{
    const labelList near(nearer(f, points, f.off, least));
    const vectorField n(waysOut(f, pointField(points, near)));
    forAll(near, k) points[near[k]] -= (f.off - least[near[k]])*n[k];
}


// Images behind the surface of points within a reach of it
static pointField mirrored(
    const fittedPacking& f, const pointField& points, scalar reach, scalarField& least)
{
    const labelList near(nearer(f, points, reach, least));
    const pointField some(points, near);
    return pointField(some + 2*scalarField(least, near)*waysOut(f, some));
}

} // namespace Foam


Foam::scalarField Foam::fittedPacking::depth(const pointField& points) const
{
    const scalarField distance(shape.distance(points));
    return inside ? scalarField(-distance) : distance;
}


Foam::pointField Foam::fittedPacking::fill() const
{
    const scalar cell = frame.planar() ? sqr(spacing) : pow3(spacing);
    const label n = max(label(1), label(std::lround(shape.volume/cell)));

    // The deepest of a lattice about the shape's middle, which more than covers it
    boundBox box(shape.box);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        const label half = label(std::ceil(0.5*box.span()[d]/spacing)) + 1;
        const scalar middle = box.midpoint()[d];
        box.min()[d] = middle - half*spacing;
        box.max()[d] = middle + half*spacing;
    }
    if (frame.planar())
    {
        const direction empty = frame.axis(2);
        box.min()[empty] = frame.inPlane(Zero)[empty] - spacing;
        box.max()[empty] = frame.inPlane(Zero)[empty] + spacing;
    }
    const particlePacking lattice(frame.with(spacing));
    const pointField candidates(lattice.fill(box, box));
    labelList order;
    sortedOrder(scalarField(-depth(candidates)), order);
    order.setSize(min(n, order.size()));
    pointField points(candidates, order);
    relax(points, pointField(), scalarField(), true);
    return points;
}


void Foam::fittedPacking::relax(
    pointField& points, const pointField& held, const scalarField& volume, bool mirrors) const
{
    const label D = frame.planar() ? 2 : 3;
    const scalar h = 1.25*spacing, reach = 2*h;
    const scalar weight = std::pow(spacing, D)*riprap::WendlandC2::alpha(D)/std::pow(h, D);
    scalarField least(points.size(), -GREAT);
    for (label move = 0; move < mostMoves; ++move)
    {
        keepOff(*this, points, least);
        pointField all(held);
        all.append(points);
        if (mirrors) all.append(mirrored(*this, points, reach, least));
        const pointGrid grid(reach, all);

        scalar largest = 0;
        vectorField way(points.size(), Zero);
        forAll(points, i)
        {
            grid.near
            (
                points[i],
                [&](label j, const vector& apart, scalar r)
                {
                    const scalar part = j < held.size() ? volume[j] : 1;
                    way[i] -= 0.5*part*weight*riprap::WendlandC2::slope(r/h)*apart;
                }
            );
            if (mag(way[i]) > longestMove*spacing) way[i] *= longestMove*spacing/mag(way[i]);
            largest = max(largest, mag(way[i]));
        }
        points += way;
        least -= mag(way);
        for (point& p : points) p = frame.inPlane(p);
        if (largest < restingMove*spacing) break;
    }
    keepOff(*this, points, least);
}
