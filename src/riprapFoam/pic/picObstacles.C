/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picObstacles.H"
#include "wallSurface.H"
#include "wallPoints.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A body that rests must reach into the mesh; one that moves may come later
static void requireInside
(
    const polyMesh& mesh,
    const geometryWalls& surfaces,
    label i,
    const pointField& points
)
{
    // Some surfaces do not know their own bounds
    const boundBox reach(points, false);
    if (points.empty() || !mesh.bounds().overlaps(reach))
    {
        FatalIOErrorInFunction(surfaces.dict(i))
            << "Surface " << surfaces.names()[i] << " of constant/geometry, "
            << reach << ", does not meet the mesh, " << mesh.bounds()
            << ": move it there, or leave it out" << exit(FatalIOError);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<riprap::PicObstacle> Foam::picObstacles
(
    const polyMesh& mesh,
    const geometryWalls& surfaces,
    const labelList& bodyOf,
    scalar cellSize
)
{
    wallPointsControls controls;
    controls.spacing = cellSize;
    const wallSpace space(mesh, controls);

    std::vector<riprap::PicObstacle> all;
    forAll(surfaces, i)
    {
        const wallElements elements(bodyElements(space, surfaces, i, 0));
        if (bodyOf[i] < 0)
        {
            requireInside(mesh, surfaces, i, pointField(elements.points));
        }

        riprap::PicObstacle o;
        o.name = surfaces.names()[i];
        o.closed = surfaces.side(i) != geometryWalls::solidSide::both;
        o.solidOutside =
            surfaces.side(i) == geometryWalls::solidSide::outside;
        o.body = bodyOf[i];
        o.part = wallPatches(mesh).size() + i;
        for (const point& p : elements.points)
        {
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                o.vertices.push_back(p[d]);
            }
        }
        for (const auto& e : elements.elements)
        {
            for (label v = 0; v < (space.planar ? 2 : 3); ++v)
            {
                o.elements.push_back(e[v]);
            }
        }
        all.push_back(std::move(o));
    }
    return all;
}


void Foam::requireObstacles
(
    const polyMesh& mesh,
    const geometryWalls& surfaces,
    const List<wallMotion>& motion,
    scalar spacing
)
{
    const wallBodies bodies(mesh.time(), motion);
    picObstacles(mesh, surfaces, bodies.bodyOf(surfaces.names()), spacing);
}


// ************************************************************************* //
