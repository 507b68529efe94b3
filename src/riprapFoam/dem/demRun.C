/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRun.H"
#include "sceneState.H"
#include "OSspecific.H"

const Foam::word Foam::demRun::file("demRun");
const Foam::word Foam::demRun::stateFile("demState");

namespace Foam
{

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasDemRun(const Time& time, bool withState)
{
    if (!withState)
    {
        return isFile(stateObject(time, demRun::file).objectPath());
    }
    return hasState(time, demRun::file, demRun::stateFile);
}


demRun readDemRun(const Time& time)
{
    const IOobject io(stateObject(time, demRun::file, IOobject::MUST_READ));

    demRun run;
    orDamaged(io, [&]()
    {
        const IOdictionary dict(io);
        run.read(dict);
        run.brokenBefore = count(dict, "brokenBefore");
        run.timeStep = dict.get<scalar>("timeStep");
        run.stepFraction = dict.get<scalar>("stepFraction");
        run.maxDeltaT = dict.getOrDefault<scalar>("maxDeltaT", 0);
    });
    return run;
}


void writeDemRun(const Time& time, const demRun& run)
{
    IOdictionary dict(stateObject(time, demRun::file));

    run.write(dict);
    dict.add("brokenBefore", exact(run.brokenBefore));
    dict.add("timeStep", exact(run.timeStep));
    dict.add("stepFraction", exact(run.stepFraction));
    dict.add("maxDeltaT", exact(run.maxDeltaT));

    writeState(dict);
}

} // End namespace Foam


// ************************************************************************* //
