/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picRun.H"
#include "sceneState.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasPicRun(const Time& time)
{
    return hasState(time, "picRun", "picState");
}


picRun readPicRun(const Time& time)
{
    const IOdictionary dict(stateObject(time, "picRun", IOobject::MUST_READ));

    picRun run;
    run.spacing = dict.get<scalar>("spacing");
    run.given = dict.get<scalar>("given");
    run.read(dict);

    if (!(run.spacing > 0 && run.given > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Not what riprapFoam wrote: spacing " << run.spacing
            << ", given " << run.given << exit(FatalIOError);
    }

    return run;
}


void writePicRun(const Time& time, const picRun& run)
{
    IOdictionary dict(stateObject(time, "picRun"));

    dict.add("spacing", exact(run.spacing));
    dict.add("given", exact(run.given));
    run.write(dict);

    writeState(dict);
}


std::vector<std::int32_t> readPicState(const Time& time)
{
    return readStateWords(time, "picState");
}


void writePicState(const Time& time, const std::vector<std::int32_t>& words)
{
    writeStateWords(time, "picState", words);
}

} // End namespace Foam


// ************************************************************************* //
