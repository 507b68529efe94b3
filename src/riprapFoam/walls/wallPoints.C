// SPDX-License-Identifier: GPL-3.0-or-later
/*  Wall points of patches and of constant/geometry, one after the other */

#include "wallPoints.H"
#include "wallGenerator.H"

#include <cmath>

Foam::label Foam::wallPointsControls::layersFor(scalar support, scalar spacing)
{
    // A whole number of spacings must not become one more by round-off
    return max(label(1), label(std::ceil(support/spacing - 1e-6)));
}


namespace Foam
{

static void addFaces
(
    const wallSpace& space,
    const wallElements& from,
    label part,
    scalar halfThickness,
    wallFaces& faces
)
{
    const label offset = faces.points.size();
    faces.points.append(from.points);
    forAll(from.elements, i)
    {
        FixedList<label, 3> e(from.elements[i]);
        const point &a = from.points[e[0]], &b = from.points[e[1]];
        const vector n(space.planar ? space.left(b - a) : ((b - a) ^ (from.points[e[2]] - a)));
        // a face of no area is a rounding error of whoever drew it: those beside it close the
        // surface
        if (mag(n) < (space.planar ? 1e-9 : 1e-12*space.spacing)*space.spacing) continue;
        for (label& v : e) if (v >= 0) v += offset;
        faces.elements.append(e);
        faces.normal.append(n/mag(n));
        faces.source.append(from.source[i]);
        faces.part.append(part);
        faces.halfThickness.append(halfThickness);
    }
}

} // namespace Foam


Foam::wallPoints Foam::generateWallPoints
(
    const polyMesh& mesh,
    const labelList& patchIDs,
    const geometryWalls* bodies,
    const wallPointsControls& controls
)
{
    if (!(controls.spacing > 0) || controls.layers < 1)
    {
        FatalErrorInFunction
            << "walls need a spacing and layers above zero, not " << controls.spacing << " and "
            << controls.layers << exit(FatalError);
    }

    DynamicList<word> names;
    for (const label patchi : patchIDs) names.append(mesh.boundaryMesh()[patchi].name());
    if (bodies) names.append(bodies->names());

    wallGenerator generator(mesh, controls, bodies, names.size());
    const wallSpace& space = generator.space();

    refuseBaffles(space, patchIDs);
    wallFaces faces;
    const wallElements patches(patchElements(space, patchIDs));
    addFaces(space, patches, 0, 0, faces);
    generator.lay(patches, controls.layers, -1, "patches");
    for (label i = 0; bodies && i < bodies->size(); ++i)
    {
        wallElements elements(bodyElements(space, *bodies, i, patchIDs.size() + i));
        if (bodies->side(i) == geometryWalls::solidSide::both)
        {
            const label half = (controls.layers + 1)/2;
            addFaces(space, elements, 1 + i, half*controls.spacing, faces);
            generator.lay(elements, half, i, bodies->names()[i]);
            elements.flip();
            generator.lay(elements, half, i, bodies->names()[i]);
        }
        else
        {
            addFaces(space, elements, 1 + i, 0, faces);
            generator.lay(elements, controls.layers, i, bodies->names()[i]);
        }
    }
    wallPoints points(generator.finish(wordList(names)));
    points.faces = faces;
    return points;
}
