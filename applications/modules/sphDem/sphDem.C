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
    interrupted_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::sphDem::interrupt()
{
    interrupted_ = true;
    if (scene_)
    {
        scene_->interrupt();
    }
}


// ************************************************************************* //
