// SPDX-License-Identifier: GPL-3.0-or-later

#include "exactShapes.H"
#include "mathematicalConstants.H"
#include "tensorField.H"

namespace Foam
{

using constant::mathematical::pi;

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


Foam::scalar Foam::boxDistance(const vector& y, const vector& half, label dimensions)
{
    scalar outside = 0, inside = -GREAT;
    for (label d = 0; d < dimensions; ++d)
    {
        const scalar beyond = mag(y[d]) - half[d];
        outside += sqr(max(beyond, scalar(0)));
        inside = max(inside, beyond);
    }
    return inside > 0 ? Foam::sqrt(outside) : inside;
}


Foam::clumpShape Foam::boxShape(const boundBox& box)
{
    const vector span(box.span());
    clumpShape shape;
    shape.volume = span.x()*span.y()*span.z();
    shape.middle = box.midpoint();
    for (direction d = 0; d < vector::nComponents; ++d)
        shape.moments[d] = shape.volume*(magSqr(span) - sqr(span[d]))/12;
    shape.box = box;
    shape.distance = [box](const pointField& points)
    {
        scalarField all(points.size());
        forAll(points, i) all[i] = boxDistance(points[i] - box.midpoint(), 0.5*box.span(), 3);
        return all;
    };
    return shape;
}


Foam::clumpShape Foam::sphereShape(const point& centre, scalar radius)
{
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


Foam::clumpShape Foam::cylinderShape(const point& p1, const point& p2, scalar radius)
{
    const scalar length = mag(p2 - p1);
    const vector n((p2 - p1)/length);
    const point middle(0.5*(p1 + p2));
    clumpShape shape;
    shape.volume = pi*sqr(radius)*length;
    shape.middle = middle;
    const scalar across = shape.volume*(3*sqr(radius) + sqr(length))/12;
    shape.moments = vector(across, across, shape.volume*sqr(radius)/2);
    shape.axes = axesAbout(n);
    const vector reach(0.5*length*cmptMag(n)
        + radius
            *vector(Foam::sqrt(1 - min(sqr(n.x()), scalar(1))),
                Foam::sqrt(1 - min(sqr(n.y()), scalar(1))),
                Foam::sqrt(1 - min(sqr(n.z()), scalar(1)))));
    shape.box = boundBox(middle - reach, middle + reach);
    shape.distance = [middle, n, length, radius](const pointField& points)
    {
        scalarField all(points.size());
        forAll(points, i)
        {
            const vector r(points[i] - middle);
            const scalar along = r & n;
            all[i] = boxDistance(
                vector(along, mag(r - along*n), 0), vector(0.5*length, radius, 0), 2);
        }
        return all;
    };
    return shape;
}


Foam::boundBox Foam::boxOf(checkedDictionary& dict)
{
    dict.found("box");
    ITstream& is = dict.dict().lookup("box");
    const point a(is), b(is);
    dict.dict().checkITstream(is, "box");
    return boundBox(min(a, b), max(a, b));
}


Foam::clumpShape Foam::exactShape(checkedDictionary& dict)
{
    const word source(dict.dict().get<word>("source"));
    if (source == "box") return boxShape(boxOf(dict));
    const auto at = [&dict](const char* entry)
    {
        dict.found(entry);
        return dict.dict().get<point>(entry);
    };
    if (source == "cylinder") return cylinderShape(at("p1"), at("p2"), dict.positive("radius"));
    if (source == "sphere") return sphereShape(at("centre"), dict.positive("radius"));
    dict.unknownWord("source", source, wordList({"box", "cylinder", "sphere"}));
    return clumpShape();
}
