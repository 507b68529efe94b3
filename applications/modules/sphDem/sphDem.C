/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "deviceChoice.H"
#include "particleDomain.H"
#include "wholeBoundary.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace solverModules
{
    defineTypeNameAndDebug(sphDem, 0);
    addToRunTimeSelectionTable(solverModule, sphDem, fvMesh);

    // Several processes can share it
    static const bool divided = solverModule::divided().insert(sphDem::typeName);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Several processes take a GPU if they are told to
static sphSettings settingsOfRanks(sphSettings settings)
{
    if (!Pstream::parRun()) return settings;

    if (settings.config.device == riprap::DeviceKind::automatic)
    {
        settings.config.device = riprap::DeviceKind::cpu;
    }
    return settings;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverModules::sphDem::sphDem(Time& runTime, fvMesh& mesh)
:
    particleModule(runTime, mesh, "fluid"),
    asRead_(settingsOfRanks(readSphSettings(wholeBoundary(mesh)))),
    settings_(asRead_),
    walls_(runTime, mesh, asRead_.walls.motion)
{
    if (Pstream::parRun()) ranks_.reset(new pstreamTransport);

    if (sphSolids::there(runTime))
    {
        solids_.reset(new sphSolids(runTime, mesh, asRead_, boundary_));
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
