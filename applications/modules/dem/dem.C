/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "deviceChoice.H"
#include "addToRunTimeSelectionTable.H"

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
    particleModule(runTime, mesh, "solids", ", and contacts begin without a history"),
    asRead_(readDemSettings(mesh)),
    settings_(asRead_),
    movingWalls_(runTime, asRead_.walls.motion),
    movingGroups_(runTime, asRead_.groupMotion)
{
    useDevice(asRead_.config.device, asRead_.config.dimensions, asRead_.dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::dem::interrupt()
{
    askToStop();
    if (scene_)
    {
        scene_->interrupt();
    }
}


// ************************************************************************* //
