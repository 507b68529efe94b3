/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRun.H"
#include "sceneState.H"

const Foam::word Foam::demRun::file("demRun");
const Foam::word Foam::demRun::stateFile("demState");

namespace Foam
{

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasDemRun(const Time& time)
{
    return hasState(time, demRun::file, demRun::stateFile);
}


demRun readDemRun(const Time& time)
{
    const IOdictionary dict(stateObject(time, demRun::file, IOobject::MUST_READ));

    demRun run;
    run.time = dict.get<scalar>("time");
    run.particles = count(dict, "particles");
    run.initialParticles = count(dict, "initialParticles");
    run.escaped = count(dict, "escaped");
    run.brokenBefore = count(dict, "brokenBefore");
    run.steps = count(dict, "steps");
    run.timeStep = dict.get<scalar>("timeStep");
    run.stepFraction = dict.get<scalar>("stepFraction");
    run.device = dict.get<word>("device");
    run.precision = dict.get<word>("precision");

    if (run.particles < 0 || run.initialParticles <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Not what riprapFoam wrote: particles " << run.particles
            << ", initialParticles " << run.initialParticles
            << exit(FatalIOError);
    }
    return run;
}


void writeDemRun(const Time& time, const demRun& run)
{
    IOdictionary dict(stateObject(time, demRun::file));

    dict.add("time", exact(run.time));
    dict.add("particles", exact(run.particles));
    dict.add("initialParticles", exact(run.initialParticles));
    dict.add("escaped", exact(run.escaped));
    dict.add("brokenBefore", exact(run.brokenBefore));
    dict.add("steps", exact(run.steps));
    dict.add("timeStep", exact(run.timeStep));
    dict.add("stepFraction", exact(run.stepFraction));
    dict.add("device", run.device);
    dict.add("precision", run.precision);
    writeState(dict);
}

} // End namespace Foam


// ************************************************************************* //
