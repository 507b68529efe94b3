/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphRun.H"
#include "labelIOList.H"
#include "IOdictionary.H"
#include "Time.H"
#include <cstdio>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static IOobject stateObject
(
    const Time& time,
    const word& name,
    IOobject::readOption read = IOobject::NO_READ
)
{
    return IOobject
    (
        name,
        time.timeName(),
        "uniform/riprap",
        time,
        read,
        IOobject::NO_WRITE,
        false
    );
}


//- As typed by someone who knows all digits
static word exact(scalar value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.17g", double(value));
    return word(text, false);
}


//- By way of a scalar (exact to 2^53): a label may have 32 bits
static int64_t count(const dictionary& dict, const word& entry)
{
    return int64_t(dict.get<scalar>(entry));
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasSphRun(const Time& time)
{
    return
        stateObject(time, "sphRun").typeHeaderOk<IOdictionary>(false)
     && stateObject(time, "sphState").typeHeaderOk<labelIOList>(false);
}


sphRun readSphRun(const Time& time)
{
    const IOdictionary dict(stateObject(time, "sphRun", IOobject::MUST_READ));

    sphRun run;
    run.spacing = dict.get<scalar>("spacing");
    run.maxVelocity = dict.get<scalar>("maxVelocity");
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
    dict.add("time", exact(run.time));
    dict.add("particles", exact(run.particles));
    dict.add("initialParticles", exact(run.initialParticles));
    dict.add("escaped", exact(run.escaped));
    dict.add("steps", exact(run.steps));
    dict.add("device", run.device);
    dict.add("precision", run.precision);

    dict.regIOobject::writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}


std::vector<std::int32_t> readSphState(const Time& time)
{
    const labelIOList words(stateObject(time, "sphState", IOobject::MUST_READ));
    return std::vector<std::int32_t>(words.begin(), words.end());
}


void writeSphState(const Time& time, const std::vector<std::int32_t>& state)
{
    labelIOList words(stateObject(time, "sphState"), label(state.size()));
    std::copy(state.begin(), state.end(), words.begin());

    words.regIOobject::writeObject
    (
        IOstream::BINARY,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}

} // End namespace Foam


// ************************************************************************* //
