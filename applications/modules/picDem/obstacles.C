/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What is inside the mesh: the surfaces of constant/geometry, and solids.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "picObstacles.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- Of each surface the body that moves it, -1: it rests. Patches of the mesh
//  cannot move: the grid is theirs
Foam::labelList Foam::solverModules::picDem::bodyOfObstacle() const
{
    if (!obstacles_.valid())
    {
        if (bodies_.size())
        {
            FatalIOErrorInFunction(asRead_.dict)
                << "Entry walls/motion moves " << bodies_.name(0) << ", and there"
                << " is no constant/geometry: picDem moves entries of that"
                << " dictionary, not the mesh's patches" << exit(FatalIOError);
        }
        return labelList();
    }
    return bodies_.bodyOf(obstacles_->names());
}


riprap::PicInside Foam::solverModules::picDem::inside(bool continued)
{
    riprap::PicInside inside;
    const labelList bodyOf(bodyOfObstacle());

    if (obstacles_.valid())
    {
        inside.obstacles =
            picObstacles(wholeBoundary(mesh_), *obstacles_, bodyOf, grid_.cellSize());
    }
    if (solids_)
    {
        inside.solids = solids_->input(grid_.cellSize(), continued);
    }
    if (bodies_.size())
    {
        if (settings_.config.dimensions == 2)
        {
            const scalar begin = runTime_.value();
            for (label body = 0; body < bodies_.size(); ++body)
            {
                bodies_.requirePlanar
                (
                    body,
                    settings_.config.axes[2],
                    begin,
                    max(begin, runTime_.endTime().value())
                );
            }
        }
        inside.motion = bodies_.motion();
    }
    return inside;
}


// ************************************************************************* //
