/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: what a run would need. The scene is thrown away
    afterwards, so a few of its steps may be taken to time them; no file is
    written.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "logPrecision.H"
#include "moduleLog.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::picDem::logEffort(scalar sampleInterval)
{
    std::string limit;
    const scalar step = scene_->estimateTimeStep(limit);

    Info<< "Time step of the particles: " << step << " s, limit: "
        << limit.c_str() << nl;

    const scalar length = lengthAhead(sampleInterval, step);
    if (!(length > 0))
    {
        return;
    }

    const scalar steps = length/step;
    Info<< "Particle steps to time " << runTime_.endTime().value() << ": "
        << int64_t(ceil(steps)) << " with this step; more as the water becomes"
        << " faster" << nl;

    logRunTime(secondsPerStep(*scene_, 5, 50), steps, steps, run_.particles);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::picDem::dryRun(scalar sampleInterval)
{
    const logPrecision digits;

    Info<< "Particles" << nl << "    fluid: " << run_.particles << nl << endl;
    Foam::logMemory(scene_->arrays(), run_.particles);
    logEffort(sampleInterval);
    Info<< "Nothing was run and nothing written" << nl << endl;
}


// ************************************************************************* //
