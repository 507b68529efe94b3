/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "addToRunTimeSelectionTable.H"
#include "scene/sphScene.hpp"

namespace Foam
{
namespace solverModules
{
    defineTypeNameAndDebug(dem, 0);
    addToRunTimeSelectionTable(solverModule, dem, fvMesh);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverModules::dem::dem(Time& runTime, fvMesh& mesh)
:
    runTime_(runTime),
    mesh_(mesh),
    asRead_(readDemSettings(mesh)),
    settings_(asRead_),
    movingWalls_(runTime, asRead_.walls.motion),
    movingGroups_(runTime, asRead_.groupMotion),
    boundary_(mesh),
    escaped_(boundary_),
    interrupted_(false)
{
    try
    {
        riprap::chooseDevice(asRead_.config.device, 1, asRead_.config.dimensions);
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(asRead_.dict)
            << "Entry device: " << e.what() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::dem::interrupt()
{
    interrupted_ = true;
    if (scene_)
    {
        scene_->interrupt();
    }
}


// ************************************************************************* //
