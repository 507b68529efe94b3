/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: what a run would need. What is on and off has been
    said by logModels. Then the first steps, with the guards of a run: what they
    say, and how long a step takes. No file is written.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "deviceChoice.H"
#include "logPrecision.H"
#include "moduleLog.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::runEffort Foam::solverModules::sphDem::logEffort(scalar sampleInterval)
{
    const riprap::SphConfig& config = settings_.config;
    std::string limit;
    const scalar step = scene_->estimateTimeStep(limit);

    Info<< "Time step of the particles: " << step << " s, limit: "
        << limit.c_str() << nl;

    const auto take = [this](scalar t, int64_t n)
    {
        if (scene_->time() >= t)
        {
            return int64_t(0);
        }
        takeSteps(t, n);
        logEscaped(report_.escaped.size(), run_);
        return int64_t(report_.steps);
    };
    const scalar seconds = firstSteps(take, scene_->time(), step, 200);

    const scalar length = lengthAhead(sampleInterval, step);
    if (!(length > 0))
    {
        return runEffort();
    }

    // With speeds up to maxVelocity the acoustic limit is lower
    const scalar most =
    (
        config.adjustTimeStep
      ? 1 + config.maxVelocity/config.soundSpeed
      : 1
    );
    const scalar steps = length/step;

    Info<< "Particle steps to time " << runTime_.endTime().value() << ": "
        << std::to_string(int64_t(ceil(steps))).c_str() << " with this step, about "
        << std::to_string(int64_t(ceil(most*steps))).c_str() << " at maxVelocity" << nl;

    return logRunTime(seconds, steps, most*steps, run_.particles);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::runEffort Foam::solverModules::sphDem::dryRun(scalar sampleInterval)
{
    const logPrecision digits;

    Info<< "Particles" << nl
        << "    fluid: " << run_.particles << nl;
    reportWallPoints(walls_.points(), Info);
    Info<< "Neighbours: " << scene_->neighboursPerParticle()
        << " a particle" << nl << endl;

    Foam::logMemory
    (
        arraysTogether(*scene_),
        run_.particles + walls_.points().size()
    );
    return logEffort(sampleInterval);
}


// ************************************************************************* //
