/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: what a run would need. Then the first steps, with the
    guards of a run: what they say, and how long a step takes. No file is
    written.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "deviceChoice.H"
#include "expectedSpeed.H"
#include "logPrecision.H"
#include "moduleLog.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::runEffort Foam::solverModules::picDem::logEffort(scalar sampleInterval)
{
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
    const scalar seconds = firstSteps(take, scene_->time(), step, 50);

    const scalar length = lengthAhead(sampleInterval, step);
    if (!(length > 0))
    {
        return runEffort();
    }

    if (!run_.particles)
    {
        // Solids alone, with steps of their own
        Info<< "Particle steps to time " << runTime_.endTime().value() << ": "
            << std::to_string(int64_t(ceil(length/step))).c_str() << " with this step" << nl;
        return logRunTime(seconds, length/step, length/step, run_.particles);
    }

    const particleCloud cloud(readFluid());
    const labelList moving(bodyOfObstacle());
    const expectedSpeed fast(
        {mesh_, settings_.config, cloud, run_.spacing, obstacles_, moving, bodies_, solids_});
    const scalar shortest = fast.step(settings_.config, step);
    const scalar steps = length/step, most = length/shortest;
    Info<< "Speed that may be reached: " << fast.value << " m/s, estimated by " << fast.by.c_str()
        << "; its time step: " << shortest << " s" << nl << "Particle steps to time "
        << runTime_.endTime().value() << ": " << std::to_string(int64_t(ceil(steps))).c_str()
        << " with this step, about " << std::to_string(int64_t(ceil(most))).c_str()
        << " at that speed" << nl;

    return logRunTime(seconds, steps, most, run_.particles);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::runEffort Foam::solverModules::picDem::dryRun(scalar sampleInterval)
{
    const logPrecision digits;
    pressure_.quiet = true;

    Info<< "Particles" << nl << "    fluid: " << run_.particles << nl << endl;
    Foam::logMemory(arraysTogether(*scene_), run_.particles);
    return logEffort(sampleInterval);
}


void Foam::solverModules::picDem::writeTrial()
{
    particleModule::writeTrial();
    fields_->write();
}


// ************************************************************************* //
