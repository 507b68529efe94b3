/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "deviceChoice.H"
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
    particleModule(runTime, mesh, "fluid"),
    asRead_(readSphSettings(mesh)),
    settings_(asRead_),
    bodies_(runTime, asRead_.walls.motion)
{
    if (coupledSolids::there(runTime))
    {
        solids_.reset(new coupledSolids(runTime, mesh, asRead_, boundary_));
    }
    else if (asRead_.couples)
    {
        FatalIOErrorInFunction(asRead_.dict)
            << "Entry coupling is there, but no solids to couple with:"
            << " constant/solidProperties is missing" << exit(FatalIOError);
    }
    useDevice(asRead_.config.device, asRead_.config.dimensions, asRead_.dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::sphDem::interrupt()
{
    askToStop();
    if (scene_)
    {
        scene_->interrupt();
    }
}


// ************************************************************************* //
