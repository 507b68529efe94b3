/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Every model in use, once, and what is off.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "deviceChoice.H"
#include "logPrecision.H"
#include "moduleLog.H"
#include "modelReader.H"
#include "listed.H"
#include "solvers/sph/sphModels.hpp"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::wordList Foam::solverModules::sphDem::modelsOff() const
{
    const riprap::SphConfig& c = settings_.config;
    using namespace riprap;

    DynamicList<word> off;
    if (!c.variableSmoothing) off.append("variableSmoothingLength");
    for (const TermModel& term : pairTerms())
    {
        if (!term.chosen(c)) off.append(term.word);
    }
    if (c.shifting == ShiftingKind::none) off.append("shifting");
    if (walls_.size() == 0) off.append("walls");
    if (bodies_.size() == 0) off.append("movingWalls");
    if (!solids_) off.append("solids");
    if (!c.adjustTimeStep) off.append("adjustTimeStep");

    return wordList(off);
}


namespace Foam
{

//- Numbers of a term, from the one at `first` on
static void logNumbers
(
    const riprap::TermModel& term,
    std::size_t first,
    const riprap::TermProperties& terms
)
{
    for (std::size_t i = first; i < term.entries.size(); ++i)
    {
        if (isShown(term.entries[i], terms))
        {
            Info<< ", ";
            printEntry(Info(), term.entries[i], terms, false);
        }
    }
}


//- A term that its first number chooses
static void logNumber
(
    const riprap::TermModel& term,
    const riprap::TermProperties& terms
)
{
    logItem(term.word) << term.entries[0].value(terms);
    logNumbers(term, 1, terms);
    Info<< nl;
}


//- The word of an entry, and the terms that it chooses
static void logChoice
(
    const riprap::TermSwitch& s,
    const riprap::SphConfig& c
)
{
    const std::string chosen(s.word(c));
    const bool viscosity = word(s.entry) == "viscosity";
    if (chosen == "none" && !viscosity)
    {
        return;
    }
    logItem(s.entry) << chosen.c_str();
    if (viscosity)
    {
        Info<< ", mu " << c.viscosity << " Pa s, nu " << c.viscosity/c.density
            << " m2/s";
    }
    for (const riprap::TermModel& term : riprap::pairTerms())
    {
        if (word(term.chosenBy.entry) == s.entry && term.chosen(c))
        {
            logNumbers(term, 0, c);
        }
    }
    Info<< nl;
}


static void logTerms(const riprap::SphConfig& c)
{
    using namespace riprap;

    // Where the first of the terms stands that an entry's words choose from
    wordHashSet logged;
    for (const TermModel& term : pairTerms())
    {
        if (term.words.empty())
        {
            if (term.chosen(c)) logNumber(term, c);
        }
        else if (logged.insert(term.chosenBy.entry))
        {
            logChoice(term.chosenBy, c);
        }
    }
    if (c.shifting != ShiftingKind::none)
    {
        logItem("shifting")
            << sphNames::shifting[c.shifting] << ", A "
            << c.shiftingCoefficient << ", surfaceThreshold "
            << c.shiftingSurfaceThreshold << nl;
    }
}

} // End namespace Foam


void Foam::solverModules::sphDem::logModels() const
{
    const logPrecision digits;

    const riprap::SphConfig& c = settings_.config;
    const riprap::DeviceChoice choice =
        riprap::chooseDevice(c.device, run_.particles, c.dimensions);

    Info<< nl << "Smoothed particle hydrodynamics" << nl;
    logItem("particles") << "fluid " << run_.particles << ", walls "
        << walls_.size() << nl;
    logItem("space") << c.dimensions << "D: " << axesText(c, false).c_str()
        << "; periodic: " << axesText(c, true).c_str() << nl;
    logDevice
    (
        scene_->deviceName(),
        choice.reason,
        scene_->device(),
        arraysTogether(*scene_)
    );
    logItem("precision") << sphNames::precision[c.precision] << nl;

    logItem("kernel") << c.kernel.c_str() << nl;
    logItem("smoothingLength") << (c.variableSmoothing ? "variable" : "constant")
        << ", h0 " << c.smoothingRatio*c.spacing << " m = "
        << c.smoothingRatio << " x spacing " << c.spacing << " m";
    if (c.variableSmoothing)
    {
        Info<< ", growth up to " << c.maxSmoothingGrowth;
    }
    Info<< nl;

    logItem("equationOfState") << sphNames::equationOfState[c.eos];
    if (c.eos == riprap::EosKind::Tait)
    {
        Info<< ", gamma " << c.gamma;
    }
    Info<< ", rho " << c.density << " kg/m3, c0 " << c.soundSpeed << " m/s = "
        << settings_.soundSpeedRatio << " x maxVelocity " << c.maxVelocity
        << " m/s" << (settings_.autoMaxVelocity ? " (auto)" : "") << nl;

    logTerms(c);

    if (walls_.size())
    {
        logItem("walls") << sphNames::wallModel[c.wallModel] << ", "
            << (c.noSlip ? "noSlip" : "freeSlip") << ", " << walls_.layers
            << " layers of spacing " << walls_.spacing << " m, "
            << (settings_.walls.impermeable ? "impermeable" : "permeable")
            << nl;
    }
    for (const string& note : walls_.notes)
    {
        logItem("") << note.c_str() << nl;
    }
    for (label i = 0; i < bodies_.size(); ++i)
    {
        logItem("moving walls") << bodies_.name(i) << ": " << bodies_.function(i)
            << nl;
    }

    logItem("timeIntegration") << sphNames::timeIntegration[c.integrator];
    if (c.adjustTimeStep)
    {
        Info<< ", acousticCourant " << c.acousticCourant << ", forceCourant "
            << c.forceCourant << ", viscousCourant " << c.viscousCourant;
    }
    else
    {
        Info<< ", fixed deltaT " << c.fixedTimeStep << " s";
    }
    Info<< nl;

    logItem("guards") << "densityDeviation " << c.maxDensityDeviation
        << ", speedRatio " << c.maxSpeedRatio << ", wild "
        << (c.removeWild ? "remove" : "stop") << ", maxWild "
        << settings_.maxWild << " 1/s, escape "
        << (settings_.guards.stopAtEscape ? "stop" : "warn")
        << ", maxEscaped " << settings_.guards.maxEscaped << nl;
    if (settings_.unused.size())
    {
        logItem("not used") << listed(settings_.unused).c_str()
            << ": of terms that are not chosen" << nl;
    }
    logItem("off") << listed(modelsOff()).c_str() << nl << endl;

    if (solids_)
    {
        solids_->logModels();
    }
}


// ************************************************************************* //
