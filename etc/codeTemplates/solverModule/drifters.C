/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "drifters.H"
#include "checkedDictionary.H"
#include "clockTime.H"
#include "logPrecision.H"
#include "moduleLog.H"
#include "particleDomain.H"
#include "sceneNeeds.H"
#include "timeWriter.H"
#include "wallTimes.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace solverModules
{
    defineTypeNameAndDebug(drifterCloud, 0);
    defineTypeNameAndDebug(drifters, 0);
    addToRunTimeSelectionTable(solverModule, drifters, fvMesh);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solverModules::drifters::drifters(Time& runTime, fvMesh& mesh)
:
    runTime_(runTime),
    mesh_(mesh),
    interrupted_(false)
{
    const IOdictionary dict(readConstant("drifterProperties", runTime));
    checkedDictionary entries(dict);
    const vector flow(entries.velocity("flow"));
    relaxationTime_ = entries.positive("relaxationTime", dimTime);
    entries.end();

    const riprap::Vector3 g(readParticleDomain(mesh).gravity);
    terminalVelocity_ = flow + relaxationTime_*vector(g[0], g[1], g[2]);
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::drifters::move(scalar dt)
{
    const wallTimes::part timed("solver");

    const scalar kept = exp(-dt/relaxationTime_);
    const scalar way = -relaxationTime_*expm1(-dt/relaxationTime_);
    vectorField& v = particles_.vectors["U"];
    forAll(v, i)
    {
        const vector faster(v[i] - terminalVelocity_);
        particles_.position[i] += terminalVelocity_*dt + way*faster;
        v[i] = terminalVelocity_ + kept*faster;
    }
    time_ += dt;
    ++steps_;
}


void Foam::solverModules::drifters::checkInside() const
{
    const labelList cell
    (
        locateParticles(mesh_, particles_.position, particles_.cell, false)
    );
    const label i = cell.find(-1);
    if (i >= 0)
    {
        FatalErrorInFunction
            << "Guard at time " << time_ << " s, particle step " << steps_
            << ": particle " << particles_.labels["id"][i] << " at "
            << particles_.position[i] << " m has left the mesh, velocity "
            << particles_.vectors["U"][i] << " m/s" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::drifters::initialise()
{
    time_ = runTime_.value();
    particles_ = readParticleCloud(mesh_, "drifters");
    requiredVectors(mesh_, particles_, "U");
    if (!particles_.labels.found("id"))
    {
        particles_.labels.set("id", identity(particles_.size()));
    }
    checkInside();
    cloud_.reset(new drifterCloud(mesh_, particles_));

    const logPrecision digits;
    logItem("particles") << particles_.size() << nl;
    logItem("terminal velocity") << terminalVelocity_ << " m/s" << nl;
    Info<< endl;
}


Foam::scalar Foam::solverModules::drifters::advance(scalar t, bool singleStep)
{
    const scalar longest = runTime_.controlDict().get<scalar>("deltaT");
    do
    {
        // no step that is left over by round-off
        const scalar ahead = t - time_;
        move(ahead < longest*(1 + 1e-9) ? ahead : longest);
    }
    while (time_ < t*(1 - SMALL) && !singleStep && !interrupted_);

    checkInside();
    cloud_->moved();
    return time_;
}


void Foam::solverModules::drifters::report()
{
    scalar fastest = 0;
    for (const vector& v : particles_.vectors["U"])
    {
        fastest = max(fastest, mag(v));
    }
    const logPrecision digits;
    Info<< "Particle steps = " << steps_ << ", largest velocity = " << fastest
        << " m/s" << nl << endl;
}


Foam::runEffort Foam::solverModules::drifters::dryRun(scalar)
{
    const logPrecision digits;
    const scalar length = runTime_.endTime().value() - time_;
    runEffort effort;
    effort.steps = length/runTime_.controlDict().get<scalar>("deltaT");
    Info<< "Particle steps to time " << runTime_.endTime().value() << ": "
        << label(std::ceil(effort.steps*(1 - 1e-9))) << nl;

    // the first steps of a run, with its guards
    const clockTime clock;
    label tried = 0;
    while (clock.elapsedTime() < 0.2 && trialStep())
    {
        ++tried;
    }
    effort.secondsPerStep = tried ? clock.elapsedTime()/tried : 0;
    return effort;
}


void Foam::solverModules::drifters::needs(sceneNeeds&)
{}


bool Foam::solverModules::drifters::trialStep()
{
    const scalar step = runTime_.controlDict().get<scalar>("deltaT");
    if (time_ + step > runTime_.endTime().value())
    {
        return false;
    }
    advance(time_ + step, true);
    return true;
}


void Foam::solverModules::drifters::writeTrial()
{
    cloud_->write();
}


void Foam::solverModules::drifters::interrupt()
{
    interrupted_ = true;
}


// ************************************************************************* //
