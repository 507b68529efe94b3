/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    riprapFoam -dry-run: entries and models that this scene does not need.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "particleDomain.H"
#include "modelTrial.H"
#include "restingWalls.H"
#include "solvers/sph/termEffects.hpp"
#include "sph/passes/shifting.hpp"
#include "core/backend/gpus.hpp"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The word of a switch that leaves out the terms which do nothing, if some do
//  and there is one
static word wordWithoutIdle
(
    const riprap::TermSwitch& s,
    const riprap::SphConfig& c
)
{
    const std::vector<riprap::TermModel>& terms = riprap::pairTerms();
    const std::vector<riprap::TermEffect> effects(riprap::termEffects(c));
    std::vector<bool> wanted;
    bool any = false;
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
        const bool chosen = terms[i].chosen(c);
        const bool idle =
            chosen
         && effects[i].idle
         && word(terms[i].chosenBy.entry) == s.entry;
        wanted.push_back(chosen && !idle);
        any = any || idle;
    }
    for (const std::string& other : riprap::wordsOf(s))
    {
        riprap::SphConfig changed(c);
        s.set(changed, other);
        bool same = any;
        for (std::size_t i = 0; i < terms.size(); ++i)
        {
            same = same && terms[i].chosen(changed) == wanted[i];
        }
        if (same) return other;
    }
    return word();
}


//- Of a chosen term
static bool anyTerm
(
    const riprap::SphConfig& c,
    bool riprap::TermEffect::*does
)
{
    const std::vector<riprap::TermModel>& terms = riprap::pairTerms();
    const std::vector<riprap::TermEffect> effects(riprap::termEffects(c));
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
        if (terms[i].chosen(c) && effects[i].*does) return true;
    }
    return false;
}


static void termNeeds
(
    sceneNeeds& needs,
    const sphSettings& settings,
    const std::function<modelCost(const riprap::SphConfig&)>& trial
)
{
    const riprap::SphConfig& c = settings.config;
    const dictionary& dict = settings.dict;

    for (const riprap::TermSwitch& s : riprap::termSwitches())
    {
        const word instead(wordWithoutIdle(s, c));
        if (instead.empty()) continue;
        riprap::SphConfig changed(c);
        s.set(changed, instead);
        needs.on(dict, s.entry, "a factor of its terms is 0", instead, trial(changed));
    }
    if (shiftingOf(c).shifts && c.shiftingCoefficient == 0)
    {
        riprap::SphConfig changed(c);
        changed.shifting = riprap::NoShifting::word;
        needs.on(dict, "shifting", "A is 0", changed.shifting, trial(changed));
    }

    needs.idle(dict, settings.unused, "of terms that are not chosen");
    if (!shiftingOf(c).shifts)
    {
        needs.idle(dict, "shiftingCoeffs", "shifting is " + c.shifting);
    }
}


//- A few steps of both scenes, and whether they come out the same
static modelCost costOf
(
    riprap::SphScene& with,
    riprap::SphScene& without,
    scalar endTime
)
{
    return tryWithout
    (
        with,
        without,
        endTime,
        [](riprap::SphScene& scene)
        {
            const riprap::FluidState s(scene.fluid());
            return std::make_tuple(s.id, s.position, s.velocity, s.density);
        }
    );
}


//- A smoothing length that may vary by nothing is what the constant one is, but for
//  rounding
static void smoothingNeeds
(
    sceneNeeds& needs,
    const sphSettings& settings,
    const std::function<modelCost(const riprap::SphConfig&)>& trial
)
{
    const riprap::SphConfig& c = settings.config;
    const dictionary& dict = subDictOf(settings.dict, "smoothingLength");
    if (!c.variableSmoothing)
    {
        needs.idle(dict, "maxGrowth", "h is constant");
    }
    else if (c.maxSmoothingGrowth == 1)
    {
        riprap::SphConfig changed(c);
        changed.variableSmoothing = false;
        const modelCost cost(trial(changed));
        const scalar saved = cost.seconds - cost.without;
        needs.costly
        (
            dict,
            "model",
            "maxGrowth is 1, so h stays what it is; `model constant` "
          + (
                saved > 0
              ? "saves " + threeDigits(100*saved/cost.seconds) + " % of a step (measured)"
              : std::string("does the same")
            )
        );
    }
}


//- Equation of state and viscosity
static void equationNeeds
(
    sceneNeeds& needs,
    const sphSettings& settings,
    const Time& time
)
{
    const riprap::SphConfig& c = settings.config;
    for (const riprap::EquationModel& other : riprap::equationsOfState())
    {
        for (const riprap::EquationEntry& e : other.entries)
        {
            const auto& own = equationOf(c).entries;
            const bool used = std::any_of(own.begin(), own.end(), [&](const auto& mine)
            {
                return word(mine.name) == e.name;
            });
            if (!used) needs.idle(settings.dict, e.name, "equationOfState is " + c.eos);
        }
    }
    if (!anyTerm(c, &riprap::TermEffect::seesViscosity))
    {
        const std::string why
        (
            "no term that is chosen looks at it; the file must have it"
        );
        needs.idle
        (
            readConstant("fluidProperties", time),
            wordList({"mu", "nu"}),
            why
        );
    }
}


static void wallNeeds
(
    sceneNeeds& needs,
    const sphSettings& settings,
    label points,
    bool solids
)
{
    const dictionary& walls = subDictOf(settings.dict, "walls");
    if (points == 0)
    {
        needs.idle(walls, wordList({"model", "slip"}), "there are no wall points");
        if (!solids)
        {
            needs.idle(walls, "impermeable", "there are no walls");
        }
    }
    else if (!anyTerm(settings.config, &riprap::TermEffect::atWalls))
    {
        needs.idle(walls, "slip", "no term that is chosen acts at walls");
    }
}


static void guardNeeds(sceneNeeds& needs, const sphSettings& settings)
{
    const dictionary& guards = subDictOf(settings.dict, "guards");
    if (!settings.config.removeWild)
    {
        needs.idle(guards, "maxWild", "guards/wild is stop");
    }
    if (settings.guards.stopAtEscape)
    {
        needs.idle(guards, "maxEscaped", "guards/escape is stop");
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::sphDem::needs(sceneNeeds& needs)
{
    const riprap::SphConfig& c = settings_.config;
    const dictionary& dict = settings_.dict;

    // Both scenes anew: the run's own has gone on
    riprap::FluidInput fluid;
    riprap::WallInput walls;
    const scalar room = scene_->device() == riprap::DeviceKind::gpu
      ? scalar(riprap::gpuInUse().free) : GREAT;
    const auto trial = [&](const riprap::SphConfig& changed)
    {
        if (solids_ || !roomForTrial(*scene_, room)) return modelCost();
        if (fluid.size() == 0)
        {
            otherSpeeds others;
            walls = walls_.build(settings_, others);
            fluid = fluidInput(readFluid());
        }
        const auto scene = [&](const riprap::SphConfig& config)
        {
            return riprap::createSphScene
            (
                config, fluid, walls, walls_.bodies().motion()
            );
        };
        const auto with = scene(c), without = scene(changed);
        return costOf(*with, *without, runTime_.endTime().value());
    };
    termNeeds(needs, settings_, trial);
    smoothingNeeds(needs, settings_, trial);
    equationNeeds(needs, settings_, runTime_);
    wallNeeds(needs, settings_, walls_.points().size(), bool(solids_));

    restingWalls
    (
        needs,
        subDictOf(subDictOf(dict, "walls"), "motion"),
        walls_.bodies(),
        runTime_
    );

    if (!c.adjustTimeStep)
    {
        needs.idle
        (
            dict,
            wordList({"acousticCourant", "forceCourant", "viscousCourant"}),
            "adjustTimeStep is no"
        );
    }
    guardNeeds(needs, settings_);
    controlNeeds(needs, c.adjustTimeStep, false);
    if (solids_)
    {
        solids_->needs(needs);
    }
}


// ************************************************************************* //
