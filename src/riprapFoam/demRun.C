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
    const IOobject io(stateObject(time, demRun::file, IOobject::MUST_READ));

    demRun run;
    orDamaged(io, [&]()
    {
        const IOdictionary dict(io);
        run.read(dict);
        run.brokenBefore = count(dict, "brokenBefore");
        run.timeStep = dict.get<scalar>("timeStep");
        run.stepFraction = dict.get<scalar>("stepFraction");
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

    writeState(dict);
}

} // End namespace Foam


// ************************************************************************* //
