/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: what a run would need. What is on and off has been
    said by logModels. The scene is thrown away afterwards, so a few of its
    steps may be taken to time them; no file is written.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "logPrecision.H"
#include "moduleLog.H"
#include "clockTime.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- Wall time of a particle step [s], 0 if none could be taken
Foam::scalar Foam::solverModules::sphDem::secondsPerStep()
{
    const scalar end = scene_->time() + 1e6;

    // The first steps build what later ones use
    scene_->advance(end, 5);

    clockTime stopwatch;
    std::int64_t steps = 0;
    while (stopwatch.elapsedTime() < 1 && steps < 200)
    {
        const riprap::SphReport report(scene_->advance(end, 10));
        if (report.stop != riprap::StopReason::none || report.steps == 0)
        {
            break;
        }
        steps += report.steps;
    }
    return steps ? stopwatch.elapsedTime()/steps : 0;
}


void Foam::solverModules::sphDem::logEffort(scalar sampleInterval)
{
    const riprap::SphConfig& config = settings_.config;
    const scalar length = runTime_.endTime().value() - runTime_.value();

    std::string limit;
    const scalar step = scene_->estimateTimeStep(limit);

    Info<< "Time step of the particles: " << step << " s, limit: "
        << limit.c_str() << nl
        << "Time steps of OpenFOAM: "
        << (sampleInterval > 0 ? sampleInterval : step) << " s" << nl;

    if (!(length > 0) || length > 1e6*sampleInterval + 1e12*step)
    {
        Info<< "No endTime ahead: the number of steps is not known" << nl;
        return;
    }

    // With speeds up to maxVelocity the acoustic limit is lower
    const scalar most =
    (
        config.adjustTimeStep
      ? 1 + config.maxVelocity/config.soundSpeed
      : 1
    );
    const scalar steps = length/step;
    const scalar seconds = secondsPerStep();

    Info<< "Particle steps to time " << runTime_.endTime().value() << ": "
        << int64_t(ceil(steps)) << " with this step, about "
        << int64_t(ceil(most*steps)) << " at maxVelocity" << nl;

    if (seconds > 0)
    {
        Info<< "Expected run time: " << steps*seconds << " to "
            << most*steps*seconds << " s, without output; measured on this"
            << " machine now: " << 1/seconds << " steps/s, "
            << run_.particles/seconds << " particle-steps/s" << nl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::sphDem::dryRun(scalar sampleInterval)
{
    const logPrecision digits;

    Info<< "Particles" << nl
        << "    fluid: " << run_.particles << nl;
    reportWallPoints(walls_, Info);
    Info<< "Neighbours: " << scene_->neighboursPerParticle()
        << " a particle" << nl << endl;

    Foam::logMemory(scene_->arrays(), run_.particles + walls_.size());
    logEffort(sampleInterval);

    Info<< "Nothing was run and nothing written" << nl << endl;
}


// ************************************************************************* //
