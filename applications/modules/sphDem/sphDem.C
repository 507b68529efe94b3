/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace solverModules
{
    defineTypeNameAndDebug(sphDem, 0);
    addToRunTimeSelectionTable(solverModule, sphDem, fvMesh);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverModules::sphDem::sphDem(Time& runTime, fvMesh& mesh)
:
    runTime_(runTime),
    mesh_(mesh),
    asRead_(readSphSettings(mesh)),
    settings_(asRead_),
    bodies_(runTime, asRead_.walls.motion),
    boundary_(mesh),
    escaped_(boundary_)
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

void Foam::solverModules::sphDem::interrupt()
{
    if (scene_)
    {
        scene_->interrupt();
    }
}


// ************************************************************************* //
