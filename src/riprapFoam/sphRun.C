/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphRun.H"
#include "sceneState.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasSphRun(const Time& time)
{
    return hasState(time, "sphRun", "sphState");
}


sphRun readSphRun(const Time& time)
{
    const IOdictionary dict(stateObject(time, "sphRun", IOobject::MUST_READ));

    sphRun run;
    run.spacing = dict.get<scalar>("spacing");
    run.maxVelocity = dict.get<scalar>("maxVelocity");
    run.density = dict.getOrDefault<scalar>("density", 0);
    run.time = dict.get<scalar>("time");
    run.particles = count(dict, "particles");
    run.initialParticles = count(dict, "initialParticles");
    run.escaped = count(dict, "escaped");
    run.steps = count(dict, "steps");
    run.device = dict.get<word>("device");
    run.precision = dict.get<word>("precision");

    if (!(run.spacing > 0 && run.maxVelocity > 0 && run.particles >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "Not what riprapFoam wrote: spacing " << run.spacing
            << ", maxVelocity " << run.maxVelocity << ", particles "
            << run.particles << exit(FatalIOError);
    }

    return run;
}


void writeSphRun(const Time& time, const sphRun& run)
{
    IOdictionary dict(stateObject(time, "sphRun"));

    dict.add("spacing", exact(run.spacing));
    dict.add("maxVelocity", exact(run.maxVelocity));
    dict.add("density", exact(run.density));
    dict.add("time", exact(run.time));
    dict.add("particles", exact(run.particles));
    dict.add("initialParticles", exact(run.initialParticles));
    dict.add("escaped", exact(run.escaped));
    dict.add("steps", exact(run.steps));
    dict.add("device", run.device);
    dict.add("precision", run.precision);

    writeState(dict);
}


std::vector<std::int32_t> readSphState(const Time& time)
{
    return readStateWords(time, "sphState");
}


void writeSphState(const Time& time, const std::vector<std::int32_t>& words)
{
    writeStateWords(time, "sphState", words);
}

} // End namespace Foam


// ************************************************************************* //
