// SPDX-License-Identifier: GPL-3.0-or-later

#include "regionShapes.H"
#include "mathematicalConstants.H"
#include "tensorField.H"

namespace Foam
{

using constant::mathematical::pi;

// Distance to a box about the origin, negative inside; y: how far beyond its middle, by direction
static scalar boxDistance(const vector& y, const vector& half, label dimensions)
{
    scalar outside = 0, inside = -GREAT;
    for (direction d = 0; d < dimensions; ++d)
    {
        const scalar beyond = mag(y[d]) - half[d];
        outside += sqr(max(beyond, scalar(0)));
        inside = max(inside, beyond);
    }
    return inside > 0 ? Foam::sqrt(outside) : inside;
}


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


// Axes of a body of revolution about n, as columns
static tensor axesAbout(const vector& n)
{
    direction least = 0;
    for (direction d = 1; d < vector::nComponents; ++d) if (mag(n[d]) < mag(n[least])) least = d;
    vector other(Zero);
    other[least] = 1;
    const vector a(normalised(other - (other & n)*n)), b(n ^ a);
    return tensor(a.x(), b.x(), n.x(), a.y(), b.y(), n.y(), a.z(), b.z(), n.z());
}

} // namespace Foam


Foam::clumpShape Foam::boxShape(const boundBox& box, const particlePacking& frame)
{
    const vector span(box.span());
    if (frame.planar())
    {
        vector a(Zero), b(Zero);
        a[frame.axis(0)] = b[frame.axis(1)] = 1;
        return rectangle(frame.inPlane(box.midpoint()), a, b, span & a, span & b, box);
    }
    clumpShape shape;
    shape.volume = span.x()*span.y()*span.z();
    shape.middle = box.midpoint();
    for (direction d = 0; d < vector::nComponents; ++d) shape.moments[d] = shape.volume*(magSqr(span) - sqr(span[d]))/12;
    shape.box = box;
    shape.distance = [box](const pointField& points)
    {
        scalarField all(points.size());
        forAll(points, i) all[i] = boxDistance(points[i] - box.midpoint(), 0.5*box.span(), 3);
        return all;
    };
    return shape;
}


Foam::clumpShape Foam::sphereShape(const point& centre, scalar radius, const particlePacking& frame)
{
    if (frame.planar())
    {
        // The section's circle
        const scalar off = mag(frame.inPlane(centre) - centre);
        return disk(centre, Foam::sqrt(max(sqr(radius) - sqr(off), scalar(0))), frame);
    }
    clumpShape shape;
    shape.volume = 4*pi/3*pow3(radius);
    shape.middle = centre;
    shape.moments = 0.4*shape.volume*sqr(radius)*vector::one;
    shape.box = boundBox(centre - radius*vector::one, centre + radius*vector::one);
    shape.distance = [centre, radius](const pointField& points)
    {
        return scalarField(mag(points - centre) - radius);
    };
    return shape;
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
            FatalIOErrorInFunction(where)
                << "Entries p1 and p2: in this 2D case a cylinder must lie along the empty direction or across it"
                << exit(FatalIOError);
        }
        vector empty(Zero);
        empty[frame.axis(2)] = 1;
        const vector across(empty ^ n);
        const scalar off = mag(frame.inPlane(middle) - middle);
        const scalar half = Foam::sqrt(max(sqr(radius) - sqr(off), scalar(0)));
        const vector reach(cmptMag(0.5*length*n) + cmptMag(half*across));
        const point centre(frame.inPlane(middle));
        return rectangle(centre, n, across, length, 2*half, boundBox(centre - reach, centre + reach));
    }

    clumpShape shape;
    shape.volume = pi*sqr(radius)*length;
    shape.middle = middle;
    const scalar across = shape.volume*(3*sqr(radius) + sqr(length))/12;
    shape.moments = vector(across, across, shape.volume*sqr(radius)/2);
    shape.axes = axesAbout(n);
    const vector reach
    (
        0.5*length*cmptMag(n)
      + radius*vector(Foam::sqrt(1 - min(sqr(n.x()), scalar(1))), Foam::sqrt(1 - min(sqr(n.y()), scalar(1))), Foam::sqrt(1 - min(sqr(n.z()), scalar(1))))
    );
    shape.box = boundBox(middle - reach, middle + reach);
    shape.distance = [middle, n, length, radius](const pointField& points)
    {
        scalarField all(points.size());
        forAll(points, i)
        {
            const vector r(points[i] - middle);
            const scalar along = r & n;
            all[i] = boxDistance(vector(along, mag(r - along*n), 0), vector(0.5*length, radius, 0), 2);
        }
        return all;
    };
    return shape;
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
