/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphRestart.H"
#include "allRanks.H"
#include "sceneState.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasSphRun(const Time& time)
{
    // The state of all processes is with the first
    return onAnyRank(Pstream::master() && hasState(time, "sphRun", "sphState"));
}


sphRestart readSphRun(const Time& time)
{
    const IOobject io(stateObject(time, "sphRun", IOobject::MUST_READ));

    sphRestart run;
    orDamaged(io, [&]()
    {
        const dictionary dict(stateDictionary(io));
        run.spacing = dict.get<scalar>("spacing");
        run.maxVelocity = dict.get<scalar>("maxVelocity");
        run.density = dict.getOrDefault<scalar>("density", 0);
        run.wild = dict.getOrDefault<scalar>("wild", 0);
        run.read(dict);

        if (!(run.spacing > 0 && run.maxVelocity > 0))
        {
            FatalIOErrorInFunction(dict)
                << "not what riprapFoam wrote: spacing " << run.spacing
                << ", maxVelocity " << run.maxVelocity << exit(FatalIOError);
        }
    });
    return run;
}


void writeSphRun(const Time& time, const sphRestart& run)
{
    IOdictionary dict(stateObject(time, "sphRun"));

    dict.add("spacing", exact(run.spacing));
    dict.add("maxVelocity", exact(run.maxVelocity));
    dict.add("density", exact(run.density));
    dict.add("wild", exact(run.wild));
    run.write(dict);

    writeState(dict);
}


std::vector<std::int32_t> readSphState(const Time& time)
{
    return readStateWords(time, "sphState");
}


void writeSphState(const Time& time, stateWords&& words)
{
    writeStateWords(time, "sphState", std::move(words));
}

} // End namespace Foam


// ************************************************************************* //
