/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picDictionaries.H"
#include "checkedDictionary.H"
#include "deviceChoice.H"
#include "fluidProperties.H"
#include "IOdictionary.H"
#include "modelReader.H"
#include "particleDomain.H"
#include "picOpenings.H"
#include "slidingWalls.H"
#include "sphNames.H"
#include "Time.H"
#include "pic/terms/viscousSchemes.hpp"
#include "solvers/pic/transfer/picTransfers.hpp"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void readSeeds(checkedDictionary& pic, riprap::PicConfig& config)
{
    checkedDictionary dict(pic.subDict("seeds"));

    const scalar seeds =
        dict.between("perDirection", config.seedsPerDirection, 0, 8);
    config.seedsPerDirection = int(seeds);
    dict.require
    (
        config.seedsPerDirection == seeds,
        "perDirection",
        seeds,
        "a whole number; 0 takes the particles as they are"
    );
    config.jitter = dict.between("jitter", config.jitter, 0, 1);

    dict.end();
}


static void readMultirate(checkedDictionary& pic, riprap::PicConfig& config)
{
    checkedDictionary dict(pic.subDict("multirate"));
    if (!pic.dict().found("multirate")) return;

    config.slowInterval = int(dict.whole("interval", 10, 2, 100));
    config.slowCourant = dict.between("maxCo", config.slowCourant, 1e-6, 0.4);

    dict.end();
}


static void readWalls
(
    checkedDictionary& pic,
    const polyMesh& mesh,
    picSettings& settings
)
{
    riprap::PicConfig& config = settings.config;
    checkedDictionary dict(pic.subDict("walls"));
    config.noSlip = dict.either("slip", "noSlip", "freeSlip", config.noSlip);
    settings.motion = readWallMotion(dict.subDict("motion"));
    readSlidingWalls(dict.subDict("velocity"), mesh, config);
    dict.end();
}


//- Numbers of schemes that are not chosen may stand there, so that a case can
//  be run with several; they are named in the log
static void readTransfer(checkedDictionary& pic, picSettings& settings)
{
    riprap::PicConfig& config = settings.config;

    std::string spline;
    for (const riprap::SplineCard& card : riprap::splines())
    {
        if (card.order == config.splineOrder) spline = card.word;
    }
    spline = modelWord(pic, "spline", wordsOf(riprap::splines()), spline);
    for (const riprap::SplineCard& card : riprap::splines())
    {
        if (card.word == spline) config.splineOrder = card.order;
    }

    const auto all = riprap::transfers();
    config.transfer = modelWord(pic, "transfer", wordsOf(all), config.transfer);
    int choice = -1;
    try
    {
        choice = riprap::transferChoice(config);
    }
    catch (const std::invalid_argument& why)
    {
        FatalIOErrorInFunction(pic.dict())
            << "Entry spline is " << spline << ": " << why.what()
            << exit(FatalIOError);
    }

    const riprap::TransferCard& card = all[choice];
    for (const riprap::TransferEntry& e : card.entries)
    {
        readEntry(pic, e, config.transferNumbers);
    }
    riprap::TransferProperties others;
    DynamicList<word> unused;
    for (const riprap::TransferEntry& e : riprap::allTransferEntries())
    {
        if (!card.has(e.name) && pic.found(e.name))
        {
            readEntry(pic, e, others);
            unused.append(e.name);
        }
    }
    settings.unused = unused;
}


//- A fixed step may be longer than the scheme bears
static void checkTransferStep
(
    const dictionary& control,
    const riprap::PicConfig& config
)
{
    const auto card = riprap::transfers()[riprap::transferChoice(config)];
    const scalar longest = card.timeStep(config.transferNumbers);
    if (!config.adjustTimeStep && config.fixedTimeStep > longest)
    {
        FatalIOErrorInFunction(control)
            << "Entry deltaT is " << config.fixedTimeStep << ": transfer "
            << card.word << " bears steps of at most " << longest << " s"
            << exit(FatalIOError);
    }
}


static riprap::Vector3 pointOf(const dictionary& dict, const word& entry)
{
    const vector x(dict.get<vector>(entry));
    return riprap::Vector3{{x.x(), x.y(), x.z()}};
}


//- Does the zone begin where the mesh has ended? Its rate grows along a line:
//  the largest is at a corner
static bool beyondMesh
(
    const riprap::PicAbsorber& zone,
    const riprap::PicConfig& config
)
{
    scalar most = 0;
    for (int d = 0; d < config.dimensions; ++d)
    {
        const int axis = config.axes[d];
        const scalar way = zone.to[axis] - zone.from[axis];
        most += max
        (
            way*(config.domainMin[axis] - zone.from[axis]),
            way*(config.domainMax[axis] - zone.from[axis])
        );
    }
    return most <= 0;
}


//- Zones that absorb waves; those that absorb nothing are not kept
static void readAbsorbers(checkedDictionary& pic, riprap::PicConfig& config)
{
    const dictionary& zones = pic.subDict("absorb");
    for (const entry& e : zones)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(zones)
                << "Entry " << e.keyword() << " must be a dictionary with from,"
                << " to and rate: a zone that absorbs waves"
                << exit(FatalIOError);
        }
        checkedDictionary dict(e.dict());
        riprap::PicAbsorber zone;
        zone.name = e.keyword();
        for (const word end : {"from", "to"})
        {
            if (!dict.found(end))
            {
                FatalIOErrorInFunction(e.dict())
                    << "Zone " << e.keyword() << " needs " << end
                    << ", a point: where it "
                    << (end == "from" ? "begins" : "is whole")
                    << exit(FatalIOError);
            }
        }
        zone.from = pointOf(e.dict(), "from");
        zone.to = pointOf(e.dict(), "to");
        zone.rate = dict.notNegative("rate", 0);
        dict.end();

        scalar length = 0;
        for (int d = 0; d < config.dimensions; ++d)
        {
            const int axis = config.axes[d];
            length += sqr(zone.to[axis] - zone.from[axis]);
        }
        if (!(length > 0))
        {
            FatalIOErrorInFunction(e.dict())
                << "Zone " << e.keyword() << " begins and ends at the same"
                << " place: from and to must differ along a solved direction"
                << exit(FatalIOError);
        }
        if (zone.rate > 0 && !beyondMesh(zone, config))
        {
            config.absorbers.push_back(zone);
        }
    }
}


static void readGuards(checkedDictionary& pic, picSettings& settings)
{
    checkedDictionary dict(pic.subDict("guards"));
    settings.config.maxCourantEver =
        dict.positive("Courant", settings.config.maxCourantEver);
    if (dict.found("maxSpeed"))
    {
        settings.config.maxSpeed = dict.positive("maxSpeed", 1);
    }
    settings.guards.read(dict);
    dict.end();
}


static void readPicProperties
(
    checkedDictionary pic,
    const polyMesh& mesh,
    picSettings& settings
)
{
    riprap::PicConfig& config = settings.config;

    config.precision =
        pic.choice("precision", sphNames::precision, config.precision);
    config.device = readDevice(pic, config.device);

    readSeeds(pic, config);

    readTransfer(pic, settings);
    config.advectionOrder =
        pic.choice("advection", picNames::advection, config.advectionOrder);
    config.reflection =
        pic.either("reflection", "yes", "no", config.reflection > 0) ? 1 : 0;
    config.positionCorrection =
        pic.notNegativeOrNone("positionCorrection", config.positionCorrection);

    readMultirate(pic, config);

    config.viscousScheme = modelWord
    (
        pic,
        "viscosity",
        riprap::wordsOf<riprap::ViscousSchemes>(),
        config.viscousScheme
    );
    if (!riprap::viscousSchemeOf(config.viscousScheme).acts)
    {
        config.viscosity = 0;
    }

    readWalls(pic, mesh, settings);
    readAbsorbers(pic, config);
    readOpenings(pic.subDict("openings"), mesh, config);
    settings.contactVelocity =
        pic.between("contactVelocity", settings.contactVelocity, 0, 1);
    if (pic.found("contactVelocityTime"))
    {
        settings.contactVelocityTime = pic.positive("contactVelocityTime");
    }
    settings.weak = pic.either("coupling", "weak", "implicit", false);
    readGuards(pic, settings);

    pic.end();
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

picSettings readPicSettings(const polyMesh& mesh)
{
    picSettings settings;
    riprap::PicConfig& config = settings.config;
    const Time& time = mesh.time();

    setDomain(config, readParticleDomain(mesh));
    readFluidProperties(readConstant("fluidProperties", time), config);

    settings.dict = readConstant("picProperties", time);
    readPicProperties(checkedDictionary(settings.dict), mesh, settings);

    readTimeStep(time.controlDict(), config);
    checkTransferStep(time.controlDict(), config);
    // Velocities are extended by five cells; up to two a step have been tried
    // (benchmarks/picStability)
    checkedDictionary control(time.controlDict());
    config.maxCourant = control.between("maxCo", config.maxCourant, 1e-6, 2);
    // Particles that fall freely, whose way is followed cell by cell
    const scalar most = max(config.maxCourant, 0.8*config.maxCourantEver);
    config.maxFlyingCourant = control.between
    (
        "maxFlyingCo",
        max(config.maxCourant, min(config.maxFlyingCourant, most)),
        config.maxCourant,
        most
    );
    config.startTime = time.value();

    return settings;
}

} // End namespace Foam


// ************************************************************************* //
