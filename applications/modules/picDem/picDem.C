/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "deviceChoice.H"
#include "geometryWalls.H"
#include "wallPoints.H"
#include "wholeBoundary.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace solverModules
{
    defineTypeNameAndDebug(picDem, 0);
    addToRunTimeSelectionTable(solverModule, picDem, fvMesh);

    // Several processes can share it
    static const bool divided = solverModule::divided().insert(picDem::typeName);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Several processes do not look for a GPU
static picSettings settingsOfRanks(picSettings settings)
{
    if (!Pstream::parRun()) return settings;

    if (settings.config.device == riprap::DeviceKind::automatic)
    {
        settings.config.device = riprap::DeviceKind::cpu;
    }
    return settings;
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

const Foam::dictionary& Foam::solverModules::picDem::solverOfPressure() const
{
    const dictionary& all = mesh_.solutionDict();
    if (!all.isDict("solvers") || !all.subDict("solvers").isDict("p"))
    {
        FatalIOErrorInFunction(all)
            << "There is no dictionary p in solvers: the pressure needs"
            << " its linear solver, as  solvers { p { solver cudaPCG;"
            << " tolerance 1e-8; relTol 0; } }" << exit(FatalIOError);
    }
    return mesh_.solverDict("p");
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverModules::picDem::picDem(Time& runTime, fvMesh& mesh)
:
    particleModule(runTime, mesh, "fluid"),
    asRead_(settingsOfRanks(readPicSettings(wholeBoundary(mesh)))),
    settings_(asRead_),
    grid_(mesh, asRead_.config),
    obstacles_(wallGeometry(runTime)),
    bodies_(runTime, asRead_.motion),
    pressure_(runTime, "p", solverOfPressure()),
    ranks_(runTime)
{
    if (Pstream::parRun())
    {
        ranks_.check(asRead_, pressure_);
    }

    if (picSolids::there(runTime))
    {
        solids_.reset(new picSolids(runTime, mesh, asRead_, boundary_));
    }
    useDevice(asRead_.config.device, asRead_.config.dimensions, asRead_.dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::picDem::updateFields()
{
    const wallTimes::part timed("fields");
    fields_->update(*scene_, grid_.gridCell(), settings_.config);
}


void Foam::solverModules::picDem::interrupt()
{
    askToStop();
    if (scene_)
    {
        scene_->interrupt();
    }
}


// ************************************************************************* //
