/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSolids.H"
#include "nearestPatch.H"
#include "demMotion.H"
#include "moduleLog.H"
#include "remedies.H"
#include "OSspecific.H"
#include "restingWalls.H"
#include "solidNeeds.H"
#include "solidRemedies.H"
#include "sphNames.H"
#include "timeManifest.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const char* const mostly =
    "Nothing is written: the last time directory is the last good one. A"
    " shorter time step (stepFraction of constant/solidProperties, the Courant"
    " numbers of constant/sphProperties), stiffer contacts for the speeds that"
    " occur, and a start without overlaps help against most causes";

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

bool Foam::coupledSolids::there(const Time& time)
{
    return isFile(time.globalPath()/time.constant()/"solidProperties");
}


Foam::coupledSolids::coupledSolids
(
    Time& runTime,
    fvMesh& mesh,
    const word& fluid,
    const riprap::DeviceKind device,
    const riprap::PrecisionKind precision,
    const nearestPatch& boundary
)
:
    runTime_(runTime),
    mesh_(mesh),
    asRead_(readDemSettings(wholeBoundary(mesh))),
    settings_(asRead_),
    movingWalls_(runTime, asRead_.walls.motion),
    movingGroups_(runTime, asRead_.groupMotion),
    boundary_(boundary),
    escaped_(boundary)
{
    // Device and precision are one choice: the fluid's
    const auto differ = [&](const word& entry, const word& own, const word& other)
    {
        if (asRead_.dict.found(entry) && own != other)
        {
            FatalIOErrorInFunction(asRead_.dict)
                << "Entry " << entry << " is " << own << ", and " << other
                << " in constant/" << fluid << ": solids are where their fluid"
                << " is. Leave it out here, or say " << other
                << exit(FatalIOError);
        }
    };
    if (asRead_.dict.found("gpu"))
    {
        FatalIOErrorInFunction(asRead_.dict)
            << "Entry gpu: solids are where their fluid is. Leave it out here,"
            << " and name the GPU in constant/" << fluid << exit(FatalIOError);
    }
    // Several processes of a fluid whose device is auto take the CPU, so do their
    // solids
    const bool choose =
        asRead_.config.device == riprap::DeviceKind::automatic;
    if (!(Pstream::parRun() && choose)) differ
    (
        "device",
        sphNames::device[asRead_.config.device],
        sphNames::device[device]
    );
    differ
    (
        "precision",
        sphNames::precision[asRead_.config.precision],
        sphNames::precision[precision]
    );
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::coupledSolids::readInput(bool continued)
{
    solidSet solids(readSolids(mesh_, asRead_));

    // The state that is loaded says which bonds are broken
    const label broken = continued ? 0 : solids.dropBroken();

    settings_ = asRead_;
    riprap::DemConfig& config = settings_.config;

    // A fixed deltaT is the fluid's: solids take as many steps as they need
    config.timeStep = 0;
    if (continued && config.stepFraction == run_.stepFraction)
    {
        config.timeStep = run_.timeStep;
    }
    // No motion is asked for what is outside the run
    const polyMesh& boundary = wholeBoundary(mesh_);
    during_ = Pair<scalar>(runTime_.value(), runTime_.endTime().value());
    input_ = demInputWithMotion
    (
        boundary, settings_, solids, movingWalls_, movingGroups_, during_, typeOfBondType_
    );
    coverSolids(boundary, movingWalls_, movingGroups_, input_, config);
    if (continued)
    {
        // Else the state says whether its own fits
        run_.keepDomain(config);
    }

    if (!continued)
    {
        requireBeforePlanes(settings_, input_);
        run_ = demRestart();
        run_.initialParticles = solids.particles.size();
        run_.brokenBefore = broken;
    }
    run_.brokenBefore += solids.lostBonds;
    run_.setDomain(config);
    run_.particles = solids.particles.size();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupledSolids::clear()
{
    cloud_.clear();
    sceneObject_.clear();
    solids_ = nullptr;
}


bool Foam::coupledSolids::canContinue(string& why)
{
    if (!hasDemRun(runTime_, false))
    {
        why = "it says nothing of lagrangian/solids";
        return false;
    }
    run_ = readDemRun(runTime_);
    const label n = readSolids(mesh_, asRead_).particles.size();
    if (run_.particles != n)
    {
        why = "it has " + Foam::name(label(run_.particles)) + " solid particles,"
            " the cloud " + Foam::name(n);
        return false;
    }

    const timeManifest& manifest(timeManifest::of(runTime_.timePath()));
    const std::string changed(manifest.changedSince("solids"));
    if (!changed.empty())
    {
        why = "lagrangian/solids has been changed since it was written ("
          + changed + ")";
        return false;
    }
    return true;
}


void Foam::coupledSolids::registerSolids(riprap::DemScene& solids)
{
    solids_ = &solids;
    run_.timeStep = solids.plan().timeStep;
    run_.stepFraction = settings_.config.stepFraction;
    run_.time = runTime_.value();
    run_.device = sphNames::device[solids.device()];
    run_.precision = sphNames::precision[settings_.config.precision];

    report_ = riprap::DemReport();
    report_.time = solids.time();
    report_.particles = run_.particles;
}


void Foam::coupledSolids::registerCloud()
{
    // The state is written with the fluid's
    cloud_.reset
    (
        new solidCloud
        (
            mesh_, *solids_, *solids_, settings_, input_, typeOfBondType_,
            run_, false
        )
    );
    sceneObject_.reset
    (
        new demSceneObject(mesh_, *solids_, settings_, input_, report_)
    );
}


bool Foam::coupledSolids::sameAsCloud(bool rewritten) const
{
    return matchesCloud
    (
        readSolids(mesh_, asRead_).particles,
        *solids_,
        settings_.config,
        mesh_.bounds().mag(),
        rewritten ? run_.digits : 0
    );
}


void Foam::coupledSolids::needs(sceneNeeds& needs)
{
    // Not tried: the fluid owns the scene. The plan says how much they hold
    const auto planned = [this](const riprap::DemConfig& config)
    {
        modelCost cost;
        cost.bytes = riprap::planDemScene(settings_.config, input_).bytes;
        cost.bytesWithout = riprap::planDemScene(config, input_).bytes;
        return cost;
    };
    solidNeeds(needs, settings_, input_, typeOfBondType_, planned);
    needs.idle(settings_.dict, "parallel", "each process computes all solids of a fluid");
    restingWalls
    (
        needs,
        subDictOf(subDictOf(settings_.dict, "walls"), "motion"),
        movingWalls_,
        runTime_
    );
}


void Foam::coupledSolids::moved()
{
    report_ = solids_->lastReport();
    cloud_->moved();
    run_.time = report_.time;
    run_.steps += report_.steps;
    run_.particles = report_.particles;

    if (report_.stop != riprap::DemStop::none)
    {
        FatalErrorInFunction
            << "Guard of the solids at time " << report_.time
            << " s, particle step " << run_.steps << ": "
            << (
                   report_.stopId < 0
                 ? std::string()
                 : boundary_.particle(report_.stopId, report_.stopPosition) + ' '
               ).c_str()
            << report_.stopMessage.c_str() << nl << advice().c_str()
            << exit(FatalError);
    }
    if (report_.escaped.size())
    {
        const int64_t before = escaped_.outflow();
        escaped_.add(report_.escaped);
        run_.escaped += report_.escaped.size();
        run_.outflow += escaped_.outflow() - before;
        escaped_.stopAbove
        (
            asRead_.guards.allowed(),
            report_,
            run_,
            advice().c_str()
        );
    }
}



bool Foam::coupledSolids::lighterThan(scalar density) const
{
    for (const demMaterial& m : settings_.materials)
    {
        if (m.density < density) return true;
    }
    return false;
}


void Foam::coupledSolids::remediesOf(remedies& helps) const
{
    solidRemedies(helps, settings_, input_, true);
}


Foam::string Foam::coupledSolids::advice() const
{
    remedies helps;
    remediesOf(helps);
    return helps.text(mostly);
}


// ************************************************************************* //
