/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "deviceChoice.H"
#include "wholeBoundary.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace solverModules
{
    defineTypeNameAndDebug(dem, 0);
    addToRunTimeSelectionTable(solverModule, dem, fvMesh);

    // Several processes can share it
    static const bool divided = solverModule::divided().insert(dem::typeName);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What does not depend on particles and cannot be divided over processes
static demSettings forRanks(demSettings settings)
{
    if (!Pstream::parRun()) return settings;

    riprap::DemConfig& config = settings.config;
    if (config.device == riprap::DeviceKind::gpu)
    {
        FatalIOErrorInFunction(settings.dict)
            << "Entry device is gpu: several processes of solver dem run on"
            << " CPUs alone; valid with -parallel are auto and cpu"
            << exit(FatalIOError);
    }
    if (config.sleepSpeed > 0)
    {
        FatalIOErrorInFunction(settings.dict.subDict("sleep"))
            << "Entry speed is " << config.sleepSpeed << ": solids sleep on one"
            << " process alone. With -parallel leave sleep out" << exit(FatalIOError);
    }
    config.device = riprap::DeviceKind::cpu;
    return settings;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverModules::dem::dem(Time& runTime, fvMesh& mesh)
:
    particleModule(runTime, mesh, "solids", ", and contacts begin without a history"),
    asRead_(forRanks(readDemSettings(wholeBoundary(mesh)))),
    settings_(asRead_),
    movingWalls_(runTime, asRead_.walls.motion),
    movingGroups_(runTime, asRead_.groupMotion)
{
    if (Pstream::parRun()) ranks_.reset(new pstreamTransport);
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
