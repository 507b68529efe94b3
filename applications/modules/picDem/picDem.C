/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "geometryWalls.H"
#include "wallPoints.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace solverModules
{
    defineTypeNameAndDebug(picDem, 0);
    addToRunTimeSelectionTable(solverModule, picDem, fvMesh);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverModules::picDem::picDem(Time& runTime, fvMesh& mesh)
:
    particleModule(runTime, mesh, "fluid"),
    asRead_(readPicSettings(mesh)),
    settings_(asRead_),
    grid_(mesh, asRead_.config),
    obstacles_(wallGeometry(runTime)),
    bodies_(runTime, asRead_.motion),
    pressure_(runTime, "p", mesh.solverDict("p"))
{
    if (waterSolids::there(runTime))
    {
        solids_.reset(new waterSolids(runTime, mesh, asRead_, boundary_));
    }
    checkDevice(asRead_.config.device, asRead_.config.dimensions, asRead_.dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::picDem::interrupt()
{
    askToStop();
    if (scene_)
    {
        scene_->interrupt();
    }
}


// ************************************************************************* //
