/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSolids.H"
#include "boundaryFinder.H"
#include "OSspecific.H"
#include "particleDomain.H"
#include "sphNames.H"
#include "sweptDomain.H"
#include "wallPoints.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const char* const advice =
    "Nothing is written: the last time directory is the last good one. A"
    " shorter time step (stepFraction of constant/solidProperties, the Courant"
    " numbers of constant/sphProperties), stiffer contacts for the speeds that"
    " occur, and a start without overlaps help against most causes";

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

bool Foam::coupledSolids::there(const Time& time)
{
    return isFile(time.path()/time.constant()/"solidProperties");
}


Foam::coupledSolids::coupledSolids
(
    Time& runTime,
    fvMesh& mesh,
    const sphSettings& fluid,
    const boundaryFinder& boundary
)
:
    runTime_(runTime),
    mesh_(mesh),
    coupling_(fluid.coupling),
    asRead_(readDemSettings(mesh)),
    settings_(asRead_),
    movingWalls_(runTime, asRead_.walls.motion),
    movingGroups_(runTime, asRead_.groupMotion),
    escaped_(boundary)
{
    requireSameAs(fluid);
    if (fluid.autoFluidForce) coupling_.force = riprap::FluidForceKind::impulse;
    for (const demGroup& g : asRead_.groups)
    {
        // it takes a share of the unbalanced force, of which the fluid's must be a part
        if (g.group.localDamping <= 0 || coupling_.force != riprap::FluidForceKind::impulse) continue;
        if (fluid.autoFluidForce) coupling_.force = riprap::FluidForceKind::held;
        else
        {
            FatalIOErrorInFunction(fluid.dict)
                << "Entry fluidForce of couplingCoeffs is impulse, but group " << g.group.name.c_str()
                << " of constant/solidProperties has local damping, which must see the fluid's force: valid are held and interpolated"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- Device and precision are one choice: the fluid's
void Foam::coupledSolids::requireSameAs(const sphSettings& fluid) const
{
    const auto differ = [&](const word& entry, const word& own, const word& other)
    {
        if (asRead_.dict.found(entry) && own != other)
        {
            FatalIOErrorInFunction(asRead_.dict)
                << "Entry " << entry << " is " << own << ", and " << other
                << " in constant/sphProperties: solids are where their fluid"
                << " is. Leave it out here, or say " << other
                << exit(FatalIOError);
        }
    };
    differ
    (
        "device",
        sphNames::device[asRead_.config.device],
        sphNames::device[fluid.config.device]
    );
    differ
    (
        "precision",
        sphNames::precision[asRead_.config.precision],
        sphNames::precision[fluid.config.precision]
    );
}


void Foam::coupledSolids::setWalls(const solidSet& solids)
{
    scalar smallest = GREAT;
    for (const double radius : solids.particles.radius)
    {
        smallest = min(smallest, 2*radius);
    }
    const autoPtr<geometryWalls> geometry(wallGeometry(runTime_));
    input_ = demInput
    (
        settings_,
        solids,
        demWallInput(mesh_, settings_, geometry.get(), movingWalls_, smallest),
        typeOfBondType_
    );

    if (movingWalls_.size())
    {
        input_.wallMotion =
            [this](int body, double t) { return movingWalls_.pose(body, t); };
    }
    if (movingGroups_.size())
    {
        // No motion is asked for what is outside the run
        const scalar begin = runTime_.value();
        const scalar end = runTime_.endTime().value();
        input_.groupMotion = [this, begin, end](int motion, double t)
        {
            return rigidMotion(movingGroups_, motion, t, begin, end);
        };
    }

    List<boundBox> reference(movingWalls_.size());
    for (const riprap::DemWall& wall : input_.walls)
    {
        for (std::size_t i = 0; wall.motion >= 0 && i < wall.vertices.size(); i += 3)
        {
            const double* x = &wall.vertices[i];
            reference[wall.motion].add(point(x[0], x[1], x[2]));
        }
    }
    Foam::coverMotion
    (
        mesh_,
        movingWalls_,
        reference,
        0,
        settings_.config
    );
    // Groups escape like single particles: they widen nothing
    Foam::coverMotion
    (
        mesh_,
        movingGroups_,
        List<boundBox>(movingGroups_.size()),
        0,
        settings_.config
    );
}


//- Of which particles keep the water out: mass over density; members of a
//  clump share that of the clump as their own masses are
std::vector<double> Foam::coupledSolids::volumes() const
{
    const riprap::DemParticles& p = input_.particles;
    const auto density = [&](std::size_t i)
    {
        return settings_.materials[p.material.empty() ? 0 : p.material[i]].density;
    };

    std::vector<double> members(input_.clumps.size(), 0.0);
    for (std::size_t i = 0; i < p.clump.size(); ++i)
    {
        if (p.clump[i] >= 0) members[p.clump[i]] += p.mass[i];
    }

    std::vector<double> volume(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const int clump = p.clump.empty() ? -1 : p.clump[i];
        volume[i] = clump < 0
          ? p.mass[i]/density(i)
          : input_.clumps[clump].mass/density(i)*p.mass[i]/members[clump];
    }
    return volume;
}


void Foam::coupledSolids::requireApart
(
    const riprap::SphConfig& config,
    const riprap::FluidInput& fluid
) const
{
    // A tenth of a spacing is what packings and round-off need
    const scalar tolerance = 0.1;
    const riprap::SolidOverlap overlap =
        riprap::solidsInFluid(config, fluid, input_.particles, tolerance);
    if (overlap.count == 0)
    {
        return;
    }
    const double* x = &fluid.position[3*overlap.fluid];
    FatalErrorInFunction
        << "Solids overlap the fluid at the start: " << label(overlap.count)
        << " particles of lagrangian/fluid, the worst one at "
        << point(x[0], x[1], x[2]) << ", " << overlap.distance
        << " m from the centre of solid particle "
        << input_.particles.id[overlap.solid] << " of radius "
        << input_.particles.radius[overlap.solid] << " m. Surfaces may touch:"
        << " a fluid particle reaches half its spacing, "
        << 0.5*config.spacing << " m. Mend the regions of"
        << " system/setParticlesDict" << exit(FatalError);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupledSolids::clear()
{
    cloud_.clear();
    sceneObject_.clear();
    scene_ = nullptr;
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
    return true;
}


riprap::SolidInput Foam::coupledSolids::input
(
    const riprap::SphConfig& fluidConfig,
    const riprap::FluidInput& fluid,
    bool continued
)
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
    setWalls(solids);

    if (!continued)
    {
        requireApart(fluidConfig, fluid);
        run_ = demRun();
        run_.initialParticles = solids.particles.size();
        run_.brokenBefore = broken;
    }
    run_.particles = solids.particles.size();

    riprap::SolidInput input;
    input.coupling = coupling_;
    input.config = config;
    input.input = input_;
    input.volume = volumes();
    return input;
}


void Foam::coupledSolids::registerScene(riprap::SphScene& scene)
{
    scene_ = &scene;
    riprap::DemScene& solids = *scene.solids();
    run_.timeStep = solids.plan().timeStep;
    run_.stepFraction = settings_.config.stepFraction;
    run_.time = runTime_.value();
    run_.device = sphNames::device[solids.device()];
    run_.precision = sphNames::precision[settings_.config.precision];

    report_ = riprap::DemReport();
    report_.time = solids.time();
    report_.particles = run_.particles;

    // The state is written with the fluid's
    cloud_.reset
    (
        new solidCloud
        (
            mesh_, solids, settings_, input_, typeOfBondType_, run_, false
        )
    );
    sceneObject_.reset
    (
        new demSceneObject(mesh_, solids, settings_, input_, report_)
    );
}


bool Foam::coupledSolids::sameAsCloud() const
{
    return sameSolids
    (
        readSolids(mesh_, asRead_).particles,
        *scene_->solids(),
        settings_.config,
        mesh_.bounds().mag()
    );
}


void Foam::coupledSolids::moved()
{
    report_ = scene_->solids()->lastReport();
    cloud_->moved();
    run_.time = report_.time;
    run_.steps += report_.steps;
    run_.particles = report_.particles;

    if (report_.stop != riprap::DemStop::none)
    {
        FatalErrorInFunction
            << "Guard of the solids at time " << report_.time
            << " s, particle step " << run_.steps << ": "
            << report_.stopMessage.c_str() << nl << advice << exit(FatalError);
    }
    if (report_.escaped.size())
    {
        escaped_.add(report_.escaped);
        run_.escaped += report_.escaped.size();
        escaped_.stopAbove
        (
            asRead_.guards.allowed(),
            report_,
            run_,
            advice
        );
    }
}


// ************************************************************************* //
