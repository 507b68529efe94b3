/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRestart.H"
#include "allRanks.H"
#include "sceneState.H"
#include "OSspecific.H"

const Foam::word Foam::demRestart::file("demRun");
const Foam::word Foam::demRestart::stateFile("demState");

namespace Foam
{

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasDemRun(const Time& time, bool withState)
{
    // The state of all processes is with the first
    bool has = false;
    if (Pstream::master())
    {
        has =
            withState
          ? hasState(time, demRestart::file, demRestart::stateFile)
          : isFile(stateObject(time, demRestart::file).objectPath());
    }
    return onAnyRank(has);
}


demRestart readDemRun(const Time& time)
{
    const IOobject io(stateObject(time, demRestart::file, IOobject::MUST_READ));

    demRestart run;
    orDamaged(io, [&]()
    {
        const dictionary dict(stateDictionary(io));
        run.read(dict);
        run.digits = dict.getOrDefault<label>("digits", 6);
        run.brokenBefore = count(dict, "brokenBefore");
        run.timeStep = dict.get<scalar>("timeStep");
        run.stepFraction = dict.get<scalar>("stepFraction");
        run.maxDeltaT = dict.getOrDefault<scalar>("maxDeltaT", 0);
    });
    return run;
}


label writtenDigits(const Time& time)
{
    return
        time.writeFormat() == IOstream::BINARY
      ? 17 : label(IOstream::defaultPrecision());
}


void writeDemRun(const Time& time, const demRestart& run)
{
    IOdictionary dict(stateObject(time, demRestart::file));

    run.write(dict);
    dict.add("digits", writtenDigits(time));
    dict.add("brokenBefore", exact(run.brokenBefore));
    dict.add("timeStep", exact(run.timeStep));
    dict.add("stepFraction", exact(run.stepFraction));
    dict.add("maxDeltaT", exact(run.maxDeltaT));

    writeState(dict);
}

} // End namespace Foam


// ************************************************************************* //
