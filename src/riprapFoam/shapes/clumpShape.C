// SPDX-License-Identifier: GPL-3.0-or-later

#include "clumpShape.H"
#include "closedSurface.H"
#include "exactShapes.H"
#include "momentOfInertia.H"
#include "principalAxes.H"
#include "triSurfaceSearch.H"

#include <memory>

Foam::clumpShape Foam::surfaceShape(checkedDictionary& dict, const Time& time)
{
    const std::shared_ptr<const triSurface> surface(readClosedSurface(dict, time).ptr());
    clumpShape shape;
    shape.box = boundBox(surface->points(), false);
    tensor J(Zero);
    momentOfInertia::massPropertiesSolid(*surface, 1, shape.volume, shape.middle, J);
    shape.moments = principalMoments(J, shape.axes);
    shape.distance = [surface](const pointField& points)
    {
        const triSurfaceSearch search(*surface);
        const boolList in(search.calcInside(points));
        const boundBox reach(surface->points(), false);
        scalarField all(points.size());
        forAll(points, i)
        {
            const vector span(2*(reach.span() + 2*cmptMag(points[i] - reach.midpoint())));
            const pointIndexHit hit(search.nearest(points[i], span));
            all[i] = (in[i] ? -1 : 1)*mag(hit.hitPoint() - points[i]);
        }
        return all;
    };
    return shape;
}


Foam::clumpShape Foam::readShape(
    checkedDictionary& dict, const Time& time, label dimensions, const int axes[3])
{
    return dimensions == 2 ? outlineShape(dict, axes) : surfaceShape(dict, time);
}


Foam::clumpShape Foam::keptShape(
    const dictionary& entries, const Time& time, label dimensions, const int axes[3])
{
    checkedDictionary dict(entries);
    clumpShape shape(
        dict.found("source") ? exactShape(dict) : readShape(dict, time, dimensions, axes));
    if (dict.found("centreOfMass")) shape.middle = entries.get<point>("centreOfMass");
    if (dict.found("axes")) shape.axes = entries.get<tensor>("axes");
    dict.end();
    return shape;
}


Foam::dictionary Foam::shapeEntries(const dictionary& region, const wordList& which)
{
    dictionary shape;
    for (const word& entry : which)
    {
        if (region.found(entry)) shape.add(region.lookupEntry(entry, keyType::REGEX));
    }
    return shape;
}
