/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/solidProperties: laws, time integration, guards. The default of
    each entry is the one that is set in riprap::DemConfig.
\*---------------------------------------------------------------------------*/

#include "readSolidProperties.H"
#include "deviceChoice.H"
#include "modelReader.H"
#include "rankBalance.H"
#include "dem/motion/integrators.hpp"
#include "solvers/dem/demLaws.hpp"
#include "sphNames.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of laws that are none, or that are some
static std::string wordsOff(const std::vector<riprap::LawCard>& laws, bool off)
{
    std::vector<riprap::LawCard> some;
    for (const riprap::LawCard& law : laws)
    {
        if (law.off == off) some.push_back(law);
    }
    return riprap::listOf(riprap::wordsOf(some));
}


static void readContact(checkedDictionary& solids, riprap::DemConfig& config)
{
    checkedDictionary dict(solids.subDict("contact"));
    const auto choose = [&](const char* entry, const auto& laws, auto& kind)
    {
        kind = modelWord(dict, entry, riprap::wordsOf(laws), kind);
    };
    choose("normal", riprap::normalLaws(), config.normal);
    choose("tangential", riprap::tangentialLaws(), config.tangential);
    choose("rolling", riprap::rollingLaws(), config.rolling);
    try
    {
        riprap::lawChoice(config);
    }
    catch (const std::invalid_argument& why)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry rolling is " << config.rolling.c_str() << ": "
            << why.what()
            << "; valid are rolling "
            << wordsOff(riprap::rollingLaws(), true).c_str()
            << ", or tangential "
            << wordsOff(riprap::tangentialLaws(), false).c_str()
            << exit(FatalIOError);
    }
    config.contactWithinBonds =
        dict.either("withinBonds", "yes", "no", config.contactWithinBonds);
    dict.end();
}


static void readTimeIntegration
(
    checkedDictionary& solids,
    riprap::DemConfig& config
)
{
    config.integrator = modelWord
    (
        solids,
        "timeIntegration",
        riprap::wordsOf<riprap::DemIntegrators>(),
        config.integrator
    );
    config.stepFraction = solids.positive("stepFraction", config.stepFraction);
    config.allowLargeStep =
        solids.either("allowLargeStep", "yes", "no", config.allowLargeStep);

    const scalar skin = solids.positiveOrAuto("skin");
    if (skin > 0)
    {
        config.skin = skin;
    }
    config.orientation =
        solids.either("orientation", "yes", "no", config.orientation);
}


static void readSleep(checkedDictionary& solids, riprap::DemConfig& config)
{
    checkedDictionary dict(solids.subDict("sleep"));
    config.sleepSpeed = dict.notNegative("speed", config.sleepSpeed);
    config.sleepAfter = dict.notNegative("after", config.sleepAfter);
    if (config.sleepAfter > 0 && !(config.sleepSpeed > 0))
    {
        FatalIOErrorInFunction(solids.subDict("sleep"))
            << "Entry after is the time after which solids sleep that are"
            << " slower than speed, which is missing or 0; valid is a positive"
            << " speed" << exit(FatalIOError);
    }
    dict.end();
}


static void readGuards(checkedDictionary& solids, escapeGuard& guards)
{
    checkedDictionary dict(solids.subDict("guards"));
    guards.read(dict);
    dict.end();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::dictionary& Foam::namedDict
(
    const dictionary& all,
    const entry& e
)
{
    if (!e.isDict())
    {
        FatalIOErrorInFunction(all)
            << "Entry " << e.keyword() << " is no dictionary: " << e.keyword()
            << " { ... }" << exit(FatalIOError);
    }
    return e.dict();
}


riprap::BondStiffness Foam::readCalibration
(
    checkedDictionary& dict,
    const riprap::CalibrationCard& calibration
)
{
    riprap::CalibrationNumbers numbers;
    for (const riprap::CalibrationEntry& e : calibration.entries)
    {
        readEntry(dict, e, numbers);
    }
    return calibration.of(numbers);
}


void Foam::readSolidProperties(const dictionary& all, demSettings& settings)
{
    riprap::DemConfig& config = settings.config;
    checkedDictionary solids(all);

    config.precision =
        solids.choice("precision", sphNames::precision, config.precision);
    config.device = readDevice(solids, config.device);
    readRankBalance(solids, config, false);

    readContact(solids, config);
    readSolidMaterials(solids, settings);
    readSolidPairs(solids, settings);
    readSolidGroups(solids, settings);
    readSolidBonds(solids, settings);
    readSolidWalls(solids, settings);
    readTimeIntegration(solids, config);
    readSleep(solids, config);
    readGuards(solids, settings.guards);

    solids.end();
}


// ************************************************************************* //
