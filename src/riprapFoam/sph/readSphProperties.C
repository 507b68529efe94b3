/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    constant/sphProperties, one function a part. The default of each entry is
    the one that is set in riprap::SphConfig, or stands here.
\*---------------------------------------------------------------------------*/

#include "sphDictionaries.H"
#include "checkedDictionary.H"
#include "deviceChoice.H"
#include "modelReader.H"
#include "rankBalance.H"
#include "coupling/couplings.hpp"
#include "coupling/fluidForces.hpp"
#include "solvers/sph/sphModels.hpp"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void readKernel(checkedDictionary& sph, riprap::SphConfig& config)
{
    config.kernel =
        modelWord(sph, "kernel", riprap::kernelWords(), config.kernel);

    checkedDictionary h(sph.subDict("smoothingLength"));
    // Below 0.8 a particle loses its neighbours, above 4 it has over 200
    // (2D) or 2000 (3D)
    config.smoothingRatio = h.between("ratio", config.smoothingRatio, 0.8, 4);
    config.variableSmoothing = h.either("model", "variable", "constant", false);
    config.maxSmoothingGrowth =
        h.between("maxGrowth", config.maxSmoothingGrowth, 1, 4);
    h.end();
}


static void readEquationOfState(checkedDictionary& sph, sphSettings& settings)
{
    riprap::SphConfig& config = settings.config;
    riprap::EquationProperties& equation = config;

    equation.eos = modelWord
    (
        sph,
        "equationOfState",
        wordsOf(riprap::equationsOfState()),
        equation.eos
    );
    for (const riprap::EquationModel& model : riprap::equationsOfState())
    {
        for (const riprap::EquationEntry& e : model.entries)
        {
            if (e.required && equation.eos != model.word && !sph.found(e.name))
            {
                continue;
            }
            readEntry(sph, e, equation);
        }
    }

    const scalar maxVelocity = sph.positiveOrAuto("maxVelocity");
    settings.autoMaxVelocity = (maxVelocity == 0);
    settings.soundSpeedRatio =
        sph.positive("soundSpeedRatio", settings.soundSpeedRatio);

    if (!settings.autoMaxVelocity)
    {
        config.maxVelocity = maxVelocity;
        config.soundSpeed = settings.soundSpeedRatio*maxVelocity;
    }
}


//- Zero or positive, and no more than any scene stands
static scalar upTo
(
    checkedDictionary& coeffs,
    const word& entry,
    scalar otherwise,
    scalar most
)
{
    const scalar value = coeffs.notNegative(entry, otherwise);
    return value > most ? coeffs.between(entry, otherwise, 0, most) : value;
}


//- The numbers of a pair term
static void readTerm
(
    checkedDictionary& dict,
    const riprap::TermModel& term,
    riprap::TermProperties& terms
)
{
    for (const riprap::TermEntry& e : term.entries)
    {
        if (e.required && !term.chosen(terms) && !dict.found(e.name))
        {
            continue;
        }
        e.set(terms, e.otherwise);
        if (term.words.empty() && &e == &term.entries[0])
        {
            const scalar value = dict.notNegativeOrNone(e.name, e.otherwise);
            if (value > e.highest) dict.between(e.name, e.otherwise, 0, e.highest);
            e.set(terms, value);
            continue;
        }
        readEntry(dict, e, terms);
    }
}


static void readPairTerms(checkedDictionary& sph, sphSettings& settings)
{
    riprap::TermProperties& terms = settings.config;

    for (const riprap::TermSwitch& s : riprap::termSwitches())
    {
        s.set(terms, modelWord(sph, s.entry, wordsOf(s), s.otherwise));
    }

    DynamicList<word> coeffs;
    for (const riprap::TermModel& term : riprap::pairTerms())
    {
        const word name(term.coeffs);
        if (name.empty())
        {
            readTerm(sph, term, terms);
        }
        else if (!coeffs.found(name))
        {
            coeffs.append(name);
        }
    }

    // Terms may share a dictionary
    DynamicList<word> unused;
    for (const word& name : coeffs)
    {
        checkedDictionary dict(sph.subDict(name));
        bool used = false;
        for (const riprap::TermModel& term : riprap::pairTerms())
        {
            if (name == term.coeffs)
            {
                readTerm(dict, term, terms);
                used = used || term.chosen(terms);
            }
        }
        dict.end();
        if (!used && dict.dict().size())
        {
            unused.append(name);
        }
    }
    settings.unused = unused;
}


static void readShifting(checkedDictionary& sph, riprap::SphConfig& config)
{
    config.shifting =
        modelWord(sph, "shifting", wordsOf(riprap::shiftings()), config.shifting);
    {
        checkedDictionary coeffs(sph.subDict("shiftingCoeffs"));
        config.shiftingCoefficient =
            upTo(coeffs, "A", config.shiftingCoefficient, 100);
        config.shiftingSurfaceThreshold = coeffs.positive
        (
            "surfaceThreshold",
            config.dimensions == 2 ? 1.5 : 2.75
        );
        // Inside the fluid the divergence of position is the dimension
        coeffs.require
        (
            config.shiftingSurfaceThreshold < config.dimensions,
            "surfaceThreshold",
            config.shiftingSurfaceThreshold,
            config.dimensions == 2 ? "less than 2 in 2D" : "less than 3 in 3D"
        );
        coeffs.end();
    }
}


static void readWalls(checkedDictionary& sph, sphSettings& settings)
{
    sphWalls& walls = settings.walls;
    riprap::SphConfig& config = settings.config;

    walls.dict = sph.subDict("walls");
    checkedDictionary dict(walls.dict);

    config.wallModel =
        modelWord(dict, "model", wordsOf(riprap::wallModels()), config.wallModel);
    walls.spacing = dict.positive("spacing", 0.0);

    const scalar layers = dict.positiveOrAuto("layers");
    walls.layers = label(layers);
    if (walls.layers != layers || layers > 20)
    {
        FatalIOErrorInFunction(walls.dict)
            << "Entry layers is " << layers
            << ": it must be auto or a whole number from 1 to 20"
            << exit(FatalIOError);
    }

    config.noSlip = dict.either("slip", "noSlip", "freeSlip", config.noSlip);

    walls.impermeable = dict.either("impermeable", "yes", "no", walls.impermeable);

    walls.everyWallPatch = !dict.found("patches");
    if (!walls.everyWallPatch)
    {
        walls.patches = walls.dict.get<wordRes>("patches");
    }

    walls.motion = readWallMotion(dict.subDict("motion"));
    dict.end();
}


static void readCoupling(checkedDictionary& sph, sphSettings& settings)
{
    riprap::CouplingConfig& coupling = settings.coupling;
    const riprap::SphConfig& config = settings.config;

    settings.couples =
        sph.found("coupling") || sph.subDict("couplingCoeffs").size();
    coupling.kind =
        modelWord(sph, "coupling", riprap::wordsOf<riprap::Couplings>(), coupling.kind);

    checkedDictionary coeffs(sph.subDict("couplingCoeffs"));
    settings.autoFluidForce = !coeffs.found("fluidForce");
    coupling.force = modelWord
    (
        coeffs,
        "fluidForce",
        riprap::wordsOf<riprap::FluidForces>(),
        coupling.force
    );
    coupling.viscosity =
        coeffs.either("viscosity", "yes", "no", coupling.viscosity);
    coupling.xsph = coeffs.either("XSPH", "yes", "no", coupling.xsph);
    coupling.antiClump =
        coeffs.either("antiClump", "yes", "no", coupling.antiClump);
    coeffs.end();

    const auto needs = [&](bool wanted, bool there, const char* entry)
    {
        if (wanted && !there)
        {
            FatalIOErrorInFunction(coeffs.dict())
                << "Entry " << entry << " of couplingCoeffs is yes, but "
                << entry << " of constant/sphProperties is none"
                << exit(FatalIOError);
        }
    };
    needs(coupling.xsph, config.xsph > 0, "XSPH");
    needs(coupling.antiClump, config.antiClump > 0, "antiClump");
}


// Positive, and no more than any scene stands
static scalar courantNumber
(
    checkedDictionary& sph,
    const word& entry,
    scalar otherwise,
    scalar most
)
{
    const scalar value = sph.positive(entry, otherwise);
    return value > most ? sph.between(entry, otherwise, 0, most) : value;
}


static void readTimeIntegration(checkedDictionary& sph, riprap::SphConfig& config)
{
    config.integrator =
        modelWord(sph, "timeIntegration", wordsOf(riprap::integrators()), "symplectic");
    const riprap::IntegratorModel& integrator = integratorOf(config);
    config.acousticCourant = courantNumber
    (
        sph,
        "acousticCourant",
        integrator.acousticCourant,
        integrator.highestCourant
    );
    // The highest are above what any scene stands (benchmarks/README.md: 0.62
    // and 0.164)
    config.forceCourant = courantNumber(sph, "forceCourant", config.forceCourant, 1);
    config.viscousCourant =
        courantNumber(sph, "viscousCourant", config.viscousCourant, 0.25);
}


static void readGuards(checkedDictionary& sph, sphSettings& settings)
{
    riprap::SphConfig& config = settings.config;

    checkedDictionary dict(sph.subDict("guards"));
    config.maxDensityDeviation =
        dict.positive("densityDeviation", 0.5);
    config.maxSpeedRatio = dict.positive("speedRatio", config.maxSpeedRatio);
    config.removeWild = dict.either("wild", "remove", "stop", true);
    settings.maxWild = dict.notNegative("maxWild", settings.maxWild);
    settings.guards.read(dict);
    dict.end();
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void readSphProperties(checkedDictionary sph, sphSettings& settings)
{
    riprap::SphConfig& config = settings.config;

    config.precision =
        sph.choice("precision", sphNames::precision, config.precision);
    config.device = readDevice(sph, config.device);
    readRankBalance(sph, config, true);

    readKernel(sph, config);
    readEquationOfState(sph, settings);
    readPairTerms(sph, settings);
    readShifting(sph, config);
    readWalls(sph, settings);
    readCoupling(sph, settings);
    readTimeIntegration(sph, config);
    readGuards(sph, settings);

    sph.end();
}

} // End namespace Foam


// ************************************************************************* //
