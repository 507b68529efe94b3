// SPDX-License-Identifier: GPL-3.0-or-later

#include "regionShapes.H"
#include "exactShapes.H"
#include "mathematicalConstants.H"
#include "tensorField.H"

namespace Foam
{

using constant::mathematical::pi;

// In the frame's directions: along rows, from row to row, the last; in 2D the last is the empty one
static vector inFrame(const vector& x, const particlePacking& frame)
{
    return vector(x[frame.axis(0)], x[frame.axis(1)], x[frame.axis(2)]);
}


// A rectangle with its sides along given directions, in 2D
static clumpShape rectangle
(
    const point& middle,
    const vector& along,
    const vector& across,
    scalar length,
    scalar width,
    const boundBox& box
)
{
    clumpShape shape;
    shape.volume = length*width;
    shape.middle = middle;
    shape.moments[2] = shape.volume*(sqr(length) + sqr(width))/12;
    shape.box = box;
    shape.distance = [=](const pointField& points)
    {
        const vector half(0.5*length, 0.5*width, 0);
        scalarField all(points.size());
        forAll(points, i)
        {
            const vector r(points[i] - middle);
            all[i] = boxDistance(vector(r & along, r & across, 0), half, 2);
        }
        return all;
    };
    return shape;
}


static clumpShape disk(const point& centre, scalar radius, const particlePacking& frame)
{
    clumpShape shape;
    shape.volume = pi*sqr(radius);
    shape.middle = frame.inPlane(centre);
    shape.moments[2] = shape.volume*sqr(radius)/2;
    shape.box = boundBox(shape.middle - radius*vector::one, shape.middle + radius*vector::one);
    const point middle(shape.middle);
    shape.distance = [middle, radius, frame](const pointField& points)
    {
        scalarField all(points.size());
        forAll(points, i) all[i] = mag(frame.inPlane(points[i]) - middle) - radius;
        return all;
    };
    return shape;
}

} // namespace Foam


Foam::clumpShape Foam::boxShape(const boundBox& box, const particlePacking& frame)
{
    if (frame.planar())
    {
        const vector span(box.span());
        vector a(Zero), b(Zero);
        a[frame.axis(0)] = b[frame.axis(1)] = 1;
        return rectangle(frame.inPlane(box.midpoint()), a, b, span & a, span & b, box);
    }
    return boxShape(box);
}


Foam::clumpShape Foam::sphereShape(const point& centre, scalar radius, const particlePacking& frame)
{
    if (frame.planar())
    {
        // The section's circle
        const scalar off = mag(frame.inPlane(centre) - centre);
        return disk(centre, Foam::sqrt(max(sqr(radius) - sqr(off), scalar(0))), frame);
    }
    return sphereShape(centre, radius);
}


Foam::clumpShape Foam::cylinderShape
(
    const point& p1,
    const point& p2,
    scalar radius,
    const particlePacking& frame,
    const dictionary& where
)
{
    const scalar length = mag(p2 - p1);
    const vector n((p2 - p1)/length);
    const point middle(0.5*(p1 + p2));
    if (frame.planar())
    {
        const scalar out = mag(inFrame(n, frame).z());
        if (out > 1 - 1e-9) return disk(middle, radius, frame);
        if (out > 1e-9)
        {
            FatalIOErrorInFunction(where) << "Entries p1 and p2: in this 2D case a cylinder must "
                                             "lie along the empty direction or across it"
                                          << exit(FatalIOError);
        }
        vector empty(Zero);
        empty[frame.axis(2)] = 1;
        const vector across(empty ^ n);
        const scalar off = mag(frame.inPlane(middle) - middle);
        const scalar half = Foam::sqrt(max(sqr(radius) - sqr(off), scalar(0)));
        const vector reach(cmptMag(0.5*length*n) + cmptMag(half*across));
        const point centre(frame.inPlane(middle));
        return rectangle(
            centre, n, across, length, 2*half, boundBox(centre - reach, centre + reach));
    }
    return cylinderShape(p1, p2, radius);
}


Foam::tensor Foam::inertiaOf(const clumpShape& shape)
{
    const tensor moments(shape.moments.x(), 0, 0, 0, shape.moments.y(), 0, 0, 0, shape.moments.z());
    return shape.axes & moments & shape.axes.T();
}


Foam::vectorField Foam::normalsOf
(
    const clumpShape& shape,
    const pointField& points,
    scalar length,
    const particlePacking& frame
)
{
    vectorField normals(points.size(), Zero);
    for (label d = 0; d < (frame.planar() ? 2 : 3); ++d)
    {
        vector step(Zero);
        step[frame.axis(d)] = length;
        const scalarField rise(shape.distance(points + step) - shape.distance(points - step));
        forAll(normals, i) normals[i][frame.axis(d)] = rise[i];
    }
    for (vector& n : normals) n = mag(n) > VSMALL ? n/mag(n) : vector(Zero);
    return normals;
}
