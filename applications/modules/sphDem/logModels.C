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
    if (!shiftingOf(c).shifts) off.append("shifting");
    if (walls_.points().size() == 0) off.append("walls");
    if (walls_.bodies().size() == 0) off.append("movingWalls");
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
    if (shiftingOf(c).shifts)
    {
        logItem("shifting")
            << c.shifting.c_str() << ", A "
            << c.shiftingCoefficient << ", surfaceThreshold "
            << c.shiftingSurfaceThreshold << nl;
    }
}


static void logSmoothingLength(const riprap::SphConfig& c)
{
    logItem("smoothingLength") << (c.variableSmoothing ? "variable" : "constant")
        << ", h0 " << c.smoothingRatio*c.spacing << " m = "
        << c.smoothingRatio << " x spacing " << c.spacing << " m";
    if (c.variableSmoothing)
    {
        Info<< ", growth up to " << c.maxSmoothingGrowth;
    }
    Info<< nl;
}


static void logEquationOfState(const sphSettings& settings)
{
    const riprap::SphConfig& c = settings.config;
    const riprap::EquationProperties& equation = c;
    logItem("equationOfState") << c.eos.c_str();
    for (const riprap::EquationEntry& e : equationOf(c).entries)
    {
        if (isShown(e, equation))
        {
            Info<< ", ";
            printEntry(Info(), e, equation, c.dimensions == 2);
        }
    }
    Info<< ", rho " << c.density << " kg/m3, c0 " << c.soundSpeed << " m/s = "
        << settings.soundSpeedRatio << " x maxVelocity " << c.maxVelocity
        << " m/s" << (settings.autoMaxVelocity ? " (auto)" : "") << nl;
}


static void logWalls(const sphSettings& settings, const fluidWalls& walls)
{
    const riprap::SphConfig& c = settings.config;
    const wallPoints& points = walls.points();
    const wallBodies& bodies = walls.bodies();
    if (points.size())
    {
        logItem("walls") << c.wallModel.c_str() << ", "
            << (c.noSlip ? "noSlip" : "freeSlip") << ", " << points.layers
            << " layers of spacing " << points.spacing << " m, "
            << (settings.walls.impermeable ? "impermeable" : "permeable")
            << nl;
    }
    for (const string& note : points.notes)
    {
        logItem("") << note.c_str() << nl;
    }
    for (label i = 0; i < bodies.size(); ++i)
    {
        logItem("moving walls") << bodies.name(i) << ": " << bodies.function(i)
            << nl;
    }
}


static void logTimeIntegration(const riprap::SphConfig& c)
{
    logItem("timeIntegration") << c.integrator.c_str();
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
        << walls_.points().size() << nl;
    logSpace(c);
    logDevice
    (
        scene_->deviceName(),
        choice.reason,
        scene_->device(),
        arraysTogether(*scene_)
    );
    logItem("precision") << sphNames::precision[c.precision] << nl;
    logItem("kernel") << c.kernel.c_str() << nl;
    logSmoothingLength(c);
    logEquationOfState(settings_);
    logTerms(c);
    logWalls(settings_, walls_);
    logTimeIntegration(c);

    logItem("guards") << "densityDeviation " << c.maxDensityDeviation
        << ", speedRatio " << c.maxSpeedRatio << ", wild "
        << (c.removeWild ? "remove" : "stop") << ", maxWild "
        << settings_.maxWild << " 1/s, " << settings_.guards << nl;
    logUnused(settings_.unused, ": of terms that are not chosen");
    logItem("off") << listed(modelsOff()).c_str() << nl << endl;

    if (solids_)
    {
        solids_->logModels();
    }
}


// ************************************************************************* //
