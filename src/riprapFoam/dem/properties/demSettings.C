/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSettings.H"
#include "readSolidProperties.H"
#include "didYouMean.H"
#include "particleDomain.H"
#include "Switch.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void readTimeStep(const dictionary& dict, riprap::DemConfig& config)
{
    checkedDictionary control(dict);
    if (dict.getOrDefault<Switch>("adjustTimeStep", false))
    {
        config.maxTimeStep = control.found("maxDeltaT") ? control.positive("maxDeltaT") : 0;
    }
    else
    {
        config.timeStep = control.positive("deltaT");
    }
}


static label indexOf
(
    const word& name,
    const wordList& names,
    const char* what,
    const dictionary& where
)
{
    const label i = names.find(name);
    if (i < 0)
    {
        FatalIOErrorInFunction(where)
            << "Unknown " << what << ' ' << name << "; constant/solidProperties has "
            << listedFor(name, names).c_str() << exit(FatalIOError);
    }
    return i;
}


template<class List, class Name>
static wordList namesOf(const List& list, const Name& name)
{
    wordList names(list.size());
    forAll(list, i)
    {
        names[i] = name(list[i]);
    }
    return names;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::demSettings::materialNames() const
{
    return namesOf
    (
        materials,
        [](const demMaterial& m) { return word(m.elastic.name, false); }
    );
}


Foam::wordList Foam::demSettings::groupNames() const
{
    return namesOf
    (
        groups,
        [](const demGroup& g) { return word(g.group.name, false); }
    );
}


Foam::wordList Foam::demSettings::bondNames() const
{
    return namesOf(bondTypes, [](const demBondType& b) { return b.name; });
}


Foam::label Foam::demSettings::material
(
    const word& name,
    const dictionary& where
) const
{
    return indexOf(name, materialNames(), "material", where);
}


Foam::label Foam::demSettings::group
(
    const word& name,
    const dictionary& where
) const
{
    return indexOf(name, groupNames(), "group", where);
}


Foam::label Foam::demSettings::bondType
(
    const word& name,
    const dictionary& where
) const
{
    return indexOf(name, bondNames(), "bond type", where);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::demSettings Foam::readDemSettings(const polyMesh& mesh)
{
    demSettings settings;
    const Time& time = mesh.time();

    setDomain(settings.config, readParticleDomain(mesh));
    readTimeStep(time.controlDict(), settings.config);
    settings.config.startTime = time.value();

    settings.dict = readConstant("solidProperties", time);
    readSolidProperties(settings.dict, settings);

    return settings;
}


// ************************************************************************* //
