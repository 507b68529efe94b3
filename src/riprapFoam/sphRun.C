/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphRun.H"
#include "labelIOList.H"
#include "IOdictionary.H"
#include "Hasher.H"
#include "OSspecific.H"
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


static label hashOf(const std::vector<std::int32_t>& words)
{
    return label(Hasher(words.data(), words.size()*sizeof(words[0]), 0));
}


static void damaged(const IOobject& file)
{
    FatalIOErrorInFunction(file.objectPath())
        << "The exact state of the particles is damaged: remove the folder "
        << file.path() << " to continue from lagrangian/fluid"
        << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool hasSphRun(const Time& time)
{
    IOobject run(stateObject(time, "sphRun"));
    IOobject state(stateObject(time, "sphState"));

    if (!isFile(run.objectPath()) && !isFile(state.objectPath()))
    {
        return false;
    }

    if
    (
        !run.typeHeaderOk<IOdictionary>(false)
     || !state.typeHeaderOk<labelIOList>(false)
    )
    {
        damaged(state);
    }
    return true;
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
    const labelIOList file(stateObject(time, "sphState", IOobject::MUST_READ));

    std::vector<std::int32_t> words;
    if (file.size() >= 2)
    {
        words.assign(file.begin() + 2, file.end());
    }

    if
    (
        file.size() < 2
     || file[0] != label(words.size())
     || file[1] != hashOf(words)
    )
    {
        damaged(file);
    }
    return words;
}


void writeSphState(const Time& time, const std::vector<std::int32_t>& words)
{
    labelIOList file(stateObject(time, "sphState"), label(words.size()) + 2);
    file[0] = words.size();
    file[1] = hashOf(words);
    std::copy(words.begin(), words.end(), file.begin() + 2);

    file.regIOobject::writeObject
    (
        IOstream::BINARY,
        IOstream::currentVersion,
        IOstream::UNCOMPRESSED,
        true
    );
}

} // End namespace Foam


// ************************************************************************* //
