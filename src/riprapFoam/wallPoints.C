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
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "wall points are generated on the undecomposed mesh" << exit(FatalError);
    }

    DynamicList<word> names;
    for (const label patchi : patchIDs) names.append(mesh.boundaryMesh()[patchi].name());
    if (bodies) names.append(bodies->names());

    wallGenerator generator(mesh, controls, bodies, names.size());
    const wallSpace& space = generator.space();

    refuseBaffles(space, patchIDs);
    generator.lay(patchElements(space, patchIDs), controls.layers, -1, "patches");
    for (label i = 0; bodies && i < bodies->size(); ++i)
    {
        wallElements elements(bodyElements(space, *bodies, i, patchIDs.size() + i));
        if (bodies->side(i) == geometryWalls::solidSide::both)
        {
            const label half = (controls.layers + 1)/2;
            generator.lay(elements, half, i, bodies->names()[i]);
            elements.flip();
            generator.lay(elements, half, i, bodies->names()[i]);
        }
        else
        {
            generator.lay(elements, controls.layers, i, bodies->names()[i]);
        }
    }
    return generator.finish(wordList(names));
}
