/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: what a run would need. What is on and off has been
    said by logModels. Then the first steps, with the guards of a run: what they
    say, and how long a step takes. No file is written.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "logPrecision.H"
#include "moduleLog.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::runEffort Foam::solverModules::dem::logEffort(scalar sampleInterval)
{
    const scalar step = scene_->plan().timeStep;
    const auto take = [this](scalar t, int64_t n)
    {
        if (scene_->time() >= t)
        {
            return int64_t(0);
        }
        takeSteps(t, n);
        logEscaped(report_.escaped.size(), run_);
        logPassedWalls();
        checkOverlaps();
        return int64_t(report_.steps);
    };
    const scalar seconds = firstSteps(take, scene_->time(), step, 2000);

    const scalar length = lengthAhead(sampleInterval, step);
    if (!(length > 0))
    {
        return runEffort();
    }

    const scalar steps = length/step;
    Info<< "Particle steps to time " << runTime_.endTime().value() << ": "
        << std::to_string(int64_t(ceil(steps))).c_str() << nl;

    return logRunTime(seconds, steps, steps, run_.particles);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::runEffort Foam::solverModules::dem::dryRun(scalar sampleInterval)
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
    return logEffort(sampleInterval);
}


// ************************************************************************* //
