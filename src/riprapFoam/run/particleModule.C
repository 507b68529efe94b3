/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleModule.H"
#include "sceneNeeds.H"
#include "sceneCloud.H"
#include "timeManifest.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleModule::particleModule
(
    Time& runTime,
    fvMesh& mesh,
    const word& cloudName,
    const std::string& lostWithState
)
:
    cloudName_(cloudName),
    lostWithState_(lostWithState),
    interrupted_(false),
    runTime_(runTime),
    mesh_(mesh),
    boundary_(wholeBoundary(mesh)),
    escaped_(boundary_)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

bool Foam::particleModule::startFromCloud() const
{
    Info<< "Starting from the fields of lagrangian/" << cloudName_
        << " at time " << runTime_.timeName() << nl << endl;
    return false;
}


bool Foam::particleModule::notUsed(const std::string& why) const
{
    Info<< "State in uniform/riprap is not used: " << why.c_str() << nl
        << "The run continues from the fields of lagrangian/" << cloudName_
        << ": not bit for bit" << lostWithState_.c_str() << nl << endl;
    return false;
}


bool Foam::particleModule::mayContinue(const restartRecord& run, int64_t cloudSize)
{
    if (Time::timeName(run.time) != runTime_.timeName())
    {
        return notUsed("it is of time " + Time::timeName(run.time));
    }
    if (run.particles != cloudSize)
    {
        return notUsed
        (
            "it has " + std::to_string(run.particles) + " particles, the"
            " cloud " + std::to_string(cloudSize)
        );
    }

    const timeManifest& manifest(timeManifest::of(runTime_.timePath()));
    rewritten_ = manifest.redistributed;
    asWritten_ = manifest.is == timeManifest::kind::whole && !rewritten_;
    const std::string changed(manifest.changedSince(cloudName_));
    if (!changed.empty())
    {
        return notUsed
        (
            "the cloud has been changed since it was written (" + changed + ")"
        );
    }

    // The directory's name is rounded
    runTime_.setTime(run.time, runTime_.timeIndex());
    return true;
}


std::string Foam::particleModule::offender
(
    label id,
    const riprap::Vector3& x
) const
{
    return id < 0 ? std::string() : boundary_.particle(id, x) + ' ';
}


Foam::scalar Foam::particleModule::firstSteps
(
    const std::function<int64_t(scalar t, int64_t n)>& take,
    scalar now,
    scalar step,
    int64_t most
)
{
    const scalar longEnough = 1;
    const scalar end = min(runTime_.endTime().value(), now + most*step);
    if (!(end > now))
    {
        return 0;
    }

    dryRun_ = true;
    take_ = take;
    end_ = runTime_.endTime().value();
    Info<< "First steps, with all guards" << endl;

    // What later steps use is built in the first two
    clockTime all;
    int64_t taken = take(end, 2);
    clockTime stopwatch;
    int64_t timed = 0;
    for (int64_t n = 1; taken < most; n = min(2*n, most/10 + 1))
    {
        const int64_t more = take(end, min(n, most - taken));
        taken += more;
        timed += more;
        if (more == 0 || all.elapsedTime() > longEnough)
        {
            break;
        }
    }
    const scalar seconds = timed ? stopwatch.elapsedTime()/timed : 0;

    Info<< "    " << taken << " taken: no guard has stopped them" << nl;
    dryRun_ = false;
    return seconds;
}


void Foam::particleModule::logEscaped(label now, const restartRecord& run) const
{
    if (now)
    {
        escaped_.log(now, run.escaped, run.outflow);
    }
}


void Foam::particleModule::logProgress()
{
    progress_.log
    (
        runTime_.value(),
        runTime_.startTime().value(),
        runTime_.endTime().value()
    );
}


void Foam::particleModule::controlNeeds
(
    sceneNeeds& needs,
    bool adjusts,
    bool cells
) const
{
    const dictionary& control = runTime_.controlDict();
    if (!adjusts)
    {
        needs.idle(control, "maxDeltaT", "adjustTimeStep is no");
    }
    if (!adjusts || !cells)
    {
        needs.idle
        (
            control,
            wordList({"maxCo", "maxFlyingCo"}),
            cells ? "adjustTimeStep is no" : "of picDem alone"
        );
    }
}


Foam::scalar Foam::particleModule::lengthAhead
(
    scalar sampleInterval,
    scalar step
) const
{
    const scalar length = runTime_.endTime().value() - runTime_.value();

    Info<< "Time steps of OpenFOAM: "
        << (sampleInterval > 0 ? sampleInterval : step) << " s" << nl;

    // More steps than anyone would wait for: endTime stands for `until stopped`
    if (!(length > 0) || length > 1e6*sampleInterval + 1e12*step)
    {
        Info<< "No endTime ahead: the number of steps is not known" << nl;
        return 0;
    }
    return length;
}


Foam::runEffort Foam::particleModule::logRunTime
(
    scalar seconds,
    scalar least,
    scalar most,
    int64_t particles
) const
{
    if (seconds > 0)
    {
        Info<< "Expected run time: " << least*seconds;
        if (most > least)
        {
            Info<< " to " << most*seconds;
        }
        Info<< " s, without output; measured on this machine now: "
            << 1/seconds << " steps/s, " << particles/seconds
            << " particle-steps/s" << nl;
    }
    return {seconds, least};
}


bool Foam::particleModule::trialStep()
{
    if (!take_) return false;

    dryRun_ = true;
    const bool taken = take_(end_, 1) > 0;
    dryRun_ = false;
    return taken;
}


void Foam::particleModule::writeTrial()
{
    for (const sceneCloud* cloud : mesh_.lookupClass<sceneCloud>())
    {
        cloud->write();
    }
}


// ************************************************************************* //
