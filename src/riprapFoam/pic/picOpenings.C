/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picOpenings.H"
#include "checkedDictionary.H"
#include "Function1.H"
#include "didYouMean.H"
#include "listed.H"
#include "modelReader.H"
#include "singleValues.H"
#include "SubField.H"
#include "Time.H"
#include "pic/openings/kinds.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of type patch itself: walls, cyclics and empty ones are derived from it
static void requirePatch
(
    const dictionary& dict,
    const word& name,
    const polyMesh& mesh
)
{
    DynamicList<word> open;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.type() == polyPatch::typeName)
        {
            open.append(patch.name());
        }
    }
    if (!open.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "There is no patch " << name << " of type patch; the mesh has "
            << listedFor(name, wordList(open)).c_str() << exit(FatalIOError);
    }
}


template<class Type>
static std::shared_ptr<Function1<Type>> series
(
    checkedDictionary& dict,
    const word& opening,
    const word& entry,
    const char* what
)
{
    if (!dict.found(entry))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Opening " << opening << " needs " << entry << ", " << what
            << exit(FatalIOError);
    }
    requireSingleValues(dict.subDict(entry + "Coeffs"), "Opening " + opening);
    if (!isSingleValue(dict.dict().lookup(entry)))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Opening " << opening << ": entry " << entry << " holds more"
            << " than its value, " << what << exit(FatalIOError);
    }
    return std::shared_ptr<Function1<Type>>
    (
        Function1<Type>::New(entry, dict.dict()).ptr()
    );
}


//- Largest size of what a series gives, from now to the end of the run
template<class Value>
static scalar largest(const Time& time, const Value& value)
{
    const label samples = 1000;
    scalar most = 0;
    for (label i = 0; i <= samples; ++i)
    {
        const scalar past = (time.endTime().value() - time.value())*i/samples;
        most = max(most, mag(value(time.value() + max(past, scalar(0)))));
    }
    return most;
}


//- Water that is faster than sound in it is not incompressible: a wrong unit
static void requireSlow
(
    const dictionary& entries,
    const word& opening,
    const char* entry,
    scalar speed
)
{
    const scalar sound = 1500;
    if (speed <= sound) return;
    FatalIOErrorInFunction(entries)
        << "Opening " << opening << ": entry " << entry << " means a speed of "
        << speed << " m/s, above that of sound in water" << exit(FatalIOError);
}


static void requireNear
(
    const dictionary& entries,
    const word& opening,
    scalar level,
    const polyMesh& mesh
)
{
    const scalar most = 100*mesh.bounds().mag() + mag(mesh.bounds().midpoint());
    if (mag(level) <= most) return;
    FatalIOErrorInFunction(entries)
        << "Opening " << opening << ": entry level reaches " << level
        << " m, more than 100 times the size of the mesh away from it, "
        << mesh.bounds().min() << " to " << mesh.bounds().max()
        << exit(FatalIOError);
}


static std::function<riprap::Vector3(scalar)> velocities
(
    checkedDictionary& dict,
    const word& opening,
    const polyMesh& mesh
)
{
    const auto u =
        series<vector>(dict, opening, "velocity", "a vector [m/s]");
    requireSlow
    (
        dict.dict(),
        opening,
        "velocity",
        largest(mesh.time(), [&](scalar t) { return u->value(t); })
    );
    return [u](scalar t)
    {
        const vector v(u->value(t));
        return riprap::Vector3{{v.x(), v.y(), v.z()}};
    };
}


//- In 2D per metre
static std::function<scalar(scalar)> flowRates
(
    checkedDictionary& dict,
    const word& opening,
    const polyMesh& mesh,
    const riprap::PicConfig& config
)
{
    const auto rate =
        series<scalar>(dict, opening, "flowRate", "into the mesh [m3/s]");
    const polyPatch& patch = mesh.boundaryMesh()[mesh.boundaryMesh().findPatchID(opening)];
    requireSlow
    (
        dict.dict(),
        opening,
        "flowRate",
        largest(mesh.time(), [&](scalar t) { return rate->value(t); })
       /max(sum(mag(patch.faceAreas())), VSMALL)
    );
    const scalar thickness =
        config.dimensions == 2 ? mesh.bounds().span()[config.axes[2]] : 1;
    return [rate, thickness](scalar t)
    {
        return rate->value(t)/thickness;
    };
}


static std::function<scalar(scalar)> heights
(
    checkedDictionary& dict,
    const word& opening,
    const polyMesh& mesh,
    const riprap::PicConfig& config
)
{
    scalar g2 = 0;
    for (int d = 0; d < config.dimensions; ++d)
    {
        g2 += sqr(config.gravity[config.axes[d]]);
    }
    if (!(g2 > 0))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Opening " << opening << " has a level, and there is no gravity"
            << " that says what is up" << exit(FatalIOError);
    }
    const auto level =
        series<scalar>(dict, opening, "level", "a height against gravity [m]");
    const auto height = [level](scalar t) { return level->value(t); };
    requireNear(dict.dict(), opening, largest(mesh.time(), height), mesh);
    return height;
}


static riprap::PicOpening readOpening
(
    const dictionary& entries,
    const word& name,
    const polyMesh& mesh,
    const riprap::PicConfig& config
)
{
    checkedDictionary dict(entries);
    riprap::PicOpening opening;
    opening.name = name;
    const auto kinds = riprap::wordsOf<riprap::OpeningKinds>();

    if (!dict.found("type"))
    {
        FatalIOErrorInFunction(entries)
            << "Opening " << name << " needs a type, one of "
            << riprap::listOf(kinds).c_str() << exit(FatalIOError);
    }
    opening.kind = modelWord(dict, "type", kinds, opening.kind);

    const riprap::Given given = riprap::givenAt(opening.kind);
    switch (given)
    {
        case riprap::Given::velocity:
            opening.velocity = velocities(dict, name, mesh);
            break;
        case riprap::Given::discharge:
            opening.flowRate = flowRates(dict, name, mesh, config);
            break;
        case riprap::Given::pressure:
            break;
    }

    if (given == riprap::Given::pressure || dict.found("level"))
    {
        opening.level = heights(dict, name, mesh, config);
    }
    dict.end();
    return opening;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readOpenings
(
    const dictionary& openings,
    const polyMesh& mesh,
    riprap::PicConfig& config
)
{
    for (const entry& e : openings)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(openings)
                << "Entry " << e.keyword() << " must be a dictionary: a patch"
                << " through which water comes and goes" << exit(FatalIOError);
        }
        requirePatch(openings, e.keyword(), mesh);
        config.openings.push_back
        (
            readOpening(e.dict(), e.keyword(), mesh, config)
        );
    }
}


// ************************************************************************* //
