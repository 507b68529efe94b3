/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demMotion.H"
#include "sweptDomain.H"
#include "wallPoints.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

riprap::DemInput Foam::demInputWithMotion
(
    const polyMesh& mesh,
    const demSettings& settings,
    const solidSet& solids,
    const wallBodies& walls,
    const wallBodies& groups,
    const Pair<scalar>& during,
    labelList& typeOfBondType
)
{
    scalar smallest = GREAT;
    for (const double radius : solids.particles.radius)
    {
        smallest = min(smallest, 2*radius);
    }
    const autoPtr<geometryWalls> geometry(wallGeometry(mesh.time()));
    riprap::DemInput input
    (
        demInput
        (
            settings,
            solids,
            demWallInput(mesh, settings, geometry.get(), walls, smallest),
            typeOfBondType
        )
    );

    if (walls.size())
    {
        input.wallMotion =
            [&walls](int body, double t) { return walls.pose(body, t); };
    }
    if (groups.size())
    {
        input.groupMotion = [&groups, &during](int motion, double t)
        {
            return rigidMotion(groups, motion, t, during.first(), during.second());
        };
    }
    return input;
}


void Foam::coverSolids
(
    const polyMesh& mesh,
    const wallBodies& walls,
    const wallBodies& groups,
    const riprap::DemInput& input,
    riprap::DemConfig& config
)
{
    List<boundBox> reference(walls.size());
    for (const riprap::DemWall& wall : input.walls)
    {
        for (std::size_t i = 0; wall.motion >= 0 && i < wall.vertices.size(); i += 3)
        {
            const double* x = &wall.vertices[i];
            reference[wall.motion].add(point(x[0], x[1], x[2]));
        }
    }
    coverMotion(mesh, walls, reference, 0, config);
    coverMotion(mesh, groups, List<boundBox>(groups.size()), 0, config);
}


// ************************************************************************* //
