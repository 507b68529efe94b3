/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/solidProperties: materials and what they do to each other.

        materials { glass { rho 2800; E 48e9; nu 0.2; }  steel { ... } }
        pairs
        {
            glass-glass { restitution 0.9; friction 0.3; }
            default     { restitution 0.8; friction 0.2; }  // all others
        }

    Numbers of laws that are not chosen may stand there, so that a case can be
    run with several laws; they are named in the log.
\*---------------------------------------------------------------------------*/

#include "readSolidProperties.H"
#include "listed.H"
#include "modelReader.H"
#include "solvers/dem/demLaws.hpp"
#include "labelPair.H"
#include "vector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static demMaterial readMaterial
(
    const word& name,
    const dictionary& entries,
    const demSettings& settings
)
{
    if (name.find('-') != std::string::npos || name == "default")
    {
        FatalIOErrorInFunction(entries)
            << "Material " << name << " cannot be named so: pairs are named"
            << " by two materials with - between, and default is all others"
            << exit(FatalIOError);
    }

    checkedDictionary dict(entries);
    demMaterial material;
    material.elastic.name = name;
    material.density = dict.positive("rho");

    const bool needed =
        normalNeeds(lawChoice(settings.config)).elasticConstants;
    material.elastic.young = needed ? dict.positive("E") : dict.positive("E", 0.0);
    if (needed)
    {
        dict.number("nu");
    }
    material.elastic.poisson =
        dict.between("nu", material.elastic.poisson, -0.99, 0.5);
    dict.end();
    return material;
}


//- k [N/m]: a number, or by Eq. 43, the contact as a column of the material
static void readStiffness(checkedDictionary& dict, riprap::PairProperties& p)
{
    dict.found("stiffness");
    const token first(dict.dict().lookup("stiffness"));
    if (first.isNumber())
    {
        p.normalStiffness = dict.positive("stiffness");
        return;
    }

    const word typed(dict.dict().get<word>("stiffness"));
    DynamicList<word> valid;
    valid.append("<number>");
    for (const riprap::CalibrationCard& calibration : riprap::calibrations())
    {
        if (!calibration.byRadii) continue;
        if (typed == calibration.word)
        {
            const riprap::BondStiffness k = readCalibration(dict, calibration);
            p.normalStiffness = k.normal*dict.positive("radiusFactor", 1);
            p.stiffnessRatio = k.shear/k.normal;
            return;
        }
        valid.append(calibration.word);
    }
    dict.unknownWord("stiffness", typed, wordList(valid));
}


//- What the calibrations of stiffnesses read
static wordHashSet calibrationEntries()
{
    wordHashSet names({"radiusFactor"});
    for (const riprap::CalibrationCard& calibration : riprap::calibrations())
    {
        if (!calibration.byRadii) continue;
        for (const riprap::CalibrationEntry& e : calibration.entries)
        {
            names.insert(e.name);
        }
    }
    return names;
}


static riprap::PairProperties readPair
(
    const dictionary& entries,
    const riprap::DemConfig& config,
    wordHashSet& unused
)
{
    checkedDictionary dict(entries);
    riprap::PairProperties p;
    const riprap::LawChoice laws(riprap::lawChoice(config));

    if (riprap::normalNeeds(laws).gravity)
    {
        const auto& g = config.gravity;
        p.gravity = mag(vector(g[0], g[1], g[2]));
        if (!(p.gravity > 0))
        {
            FatalIOErrorInFunction(dict.dict())
                << "Normal law " << config.normal.c_str() << " takes its"
                << " stiffness from gravity, and constant/g is zero"
                << exit(FatalIOError);
        }
    }

    for (const riprap::PairEntry& e : riprap::lawEntries(laws))
    {
        if (e.calibrated)
        {
            readStiffness(dict, p);
        }
        else
        {
            readEntry(dict, e, p);
        }
    }

    // Of laws that are not chosen, and of calibrations
    const auto isUnused = [&](const word& other)
    {
        if (!dict.isKnown(other) && dict.found(other))
        {
            unused.insert(other);
        }
    };
    for (const riprap::PairEntry& e : riprap::allLawEntries())
    {
        isUnused(e.name);
    }
    for (const word& other : calibrationEntries())
    {
        isUnused(other);
    }
    dict.end();
    return p;
}


//- The two materials of a pair's name
static labelPair materialsOf
(
    const word& key,
    const demSettings& settings,
    const dictionary& where
)
{
    const auto dash = key.find('-');
    if (dash == std::string::npos)
    {
        FatalIOErrorInFunction(where)
            << "Entry " << key << " names no pair: <material>-<material>, or"
            << " default; materials are "
            << listed(settings.materialNames()).c_str() << exit(FatalIOError);
    }
    return labelPair
    (
        settings.material(key.substr(0, dash), where),
        settings.material(key.substr(dash + 1), where)
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readSolidMaterials(checkedDictionary& solids, demSettings& settings)
{
    const dictionary& all = solids.subDict("materials");
    if (all.empty())
    {
        FatalIOErrorInFunction(solids.dict())
            << "Entry materials is missing or empty: materials { <name>"
            << " { rho ..; E ..; nu ..; } }" << exit(FatalIOError);
    }

    settings.materials.resize(all.size());
    label i = 0;
    for (const entry& e : all)
    {
        settings.materials[i++] =
            readMaterial(e.keyword(), namedDict(all, e), settings);
    }
}


void Foam::readSolidPairs(checkedDictionary& solids, demSettings& settings)
{
    const dictionary& all = solids.subDict("pairs");
    const label n = settings.materials.size();
    HashSet<labelPair, labelPair::Hash<>> known;
    DynamicList<riprap::DemPair> pairs;
    wordHashSet unused;

    auto isKnown = [&](label a, label b)
    {
        return known.found(labelPair(min(a, b), max(a, b)));
    };
    auto add = [&](label a, label b, const dictionary& entries)
    {
        known.insert(labelPair(min(a, b), max(a, b)));
        pairs.append
        (
            {int(a), int(b), readPair(entries, settings.config, unused)}
        );
    };

    for (const entry& e : all)
    {
        const dictionary& entries = namedDict(all, e);
        if (e.keyword() == "default") continue;

        const labelPair ab(materialsOf(e.keyword(), settings, all));
        if (isKnown(ab.first(), ab.second()))
        {
            FatalIOErrorInFunction(all)
                << "Entry " << e.keyword() << ": this pair is there twice"
                << exit(FatalIOError);
        }
        add(ab.first(), ab.second(), entries);
    }

    if (all.found("default", keyType::LITERAL))
    {
        for (label a = 0; a < n; ++a)
        {
            for (label b = a; b < n; ++b)
            {
                if (!isKnown(a, b)) add(a, b, all.subDict("default"));
            }
        }
    }

    settings.pairs = pairs;
    settings.unused = unused.sortedToc();
}


// ************************************************************************* //
