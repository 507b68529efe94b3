/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: what a run would need. What is on and off has been
    said by logModels. The scene is thrown away afterwards, so a few of its
    steps may be taken to time them; no file is written.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "logPrecision.H"
#include "moduleLog.H"
#include "clockTime.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- Wall time of a particle step [s], 0 if none could be taken
Foam::scalar Foam::solverModules::dem::secondsPerStep()
{
    const scalar end = scene_->time() + 1e6;

    // The first steps build what later ones use
    scene_->advance(end, 5);

    clockTime stopwatch;
    std::int64_t steps = 0;
    while (stopwatch.elapsedTime() < 1 && steps < 2000)
    {
        const riprap::DemReport report(scene_->advance(end, 20));
        if (report.stop != riprap::DemStop::none || report.steps == 0)
        {
            break;
        }
        steps += report.steps;
    }
    return steps ? stopwatch.elapsedTime()/steps : 0;
}


void Foam::solverModules::dem::logEffort(scalar sampleInterval)
{
    const scalar length = runTime_.endTime().value() - runTime_.value();
    const scalar step = scene_->plan().timeStep;

    Info<< "Time steps of OpenFOAM: "
        << (sampleInterval > 0 ? sampleInterval : step) << " s" << nl;

    if (!(length > 0) || length > 1e6*sampleInterval + 1e12*step)
    {
        Info<< "No endTime ahead: the number of steps is not known" << nl;
        return;
    }

    const scalar steps = length/step;
    const scalar seconds = secondsPerStep();
    Info<< "Particle steps to time " << runTime_.endTime().value() << ": "
        << int64_t(ceil(steps)) << nl;
    if (seconds > 0)
    {
        Info<< "Expected run time: " << steps*seconds << " s, without output;"
            << " measured on this machine now: " << 1/seconds << " steps/s, "
            << run_.particles/seconds << " particle-steps/s" << nl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::dem::dryRun(scalar sampleInterval)
{
    const logPrecision digits;
    const riprap::DemPlan plan(scene_->plan());

    Info<< "Particles" << nl
        << "    solids: " << label(plan.particles) << nl
        << "    clumps: " << label(plan.clumps) << nl
        << "    bonds: " << label(plan.bonds) << nl
        << "    wall elements: " << label(plan.wallElements) << nl
        << "Neighbours: " << scene_->neighboursPerParticle()
        << " a particle" << nl << endl;

    logMemory(scene_->arrays(), run_.particles);

    Info<< "Time step of the particles: " << plan.timeStep << " s, limit: "
        << plan.cause.c_str() << nl;
    for (const riprap::StepLimit& limit : plan.limits)
    {
        Info<< "    " << limit.name.c_str() << ": critical "
            << limit.critical << " s, " << limit.cause.c_str() << nl;
    }
    for (const std::string& warning : plan.warnings)
    {
        Info<< "Warning: " << warning.c_str() << nl;
    }
    logEffort(sampleInterval);
    Info<< "Nothing was run and nothing written" << nl << endl;
}


// ************************************************************************* //
