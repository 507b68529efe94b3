/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picRestart.H"
#include "allRanks.H"
#include "sceneState.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasPicRun(const Time& time)
{
    // The state of all processes is with the first
    return onAnyRank(Pstream::master() && hasState(time, "picRun", "picState"));
}


static void read(const dictionary& dict, picRestart& run)
{
    run.spacing = dict.get<scalar>("spacing");
    run.given = dict.get<scalar>("given");
    run.read(dict);

    const dictionary openings(dict.subOrEmptyDict("openings"));
    for (const word& name : openings.toc())
    {
        const dictionary& opening = openings.subDict(name);
        riprap::PicPassage& passage = run.passed[name];
        passage.in = count(opening, "in");
        passage.out = count(opening, "out");
        passage.volume = opening.get<scalar>("volume");
        passage.pending = opening.get<scalar>("pending");
    }

    if (!(run.spacing > 0 && run.given > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Not what riprapFoam wrote: spacing " << run.spacing
            << ", given " << run.given << exit(FatalIOError);
    }
}


picRestart readPicRun(const Time& time)
{
    const IOobject io(stateObject(time, "picRun", IOobject::MUST_READ));

    picRestart run;
    orDamaged(io, [&]() { read(stateDictionary(io), run); });
    return run;
}


void writePicRun(const Time& time, const picRestart& run)
{
    IOdictionary dict(stateObject(time, "picRun"));

    dict.add("spacing", exact(run.spacing));
    dict.add("given", exact(run.given));
    run.write(dict);

    dictionary openings;
    for (const auto& passage : run.passed)
    {
        dictionary opening;
        opening.add("in", exact(passage.second.in));
        opening.add("out", exact(passage.second.out));
        opening.add("volume", exact(passage.second.volume));
        opening.add("pending", exact(passage.second.pending));
        openings.add(word(passage.first, false), opening);
    }
    if (!run.passed.empty())
    {
        dict.add("openings", openings);
    }

    writeState(dict);
}


std::vector<std::int32_t> readPicState(const Time& time)
{
    return readStateWords(time, "picState");
}


void writePicState(const Time& time, stateWords&& words)
{
    writeStateWords(time, "picState", std::move(words));
}

} // End namespace Foam


// ************************************************************************* //
