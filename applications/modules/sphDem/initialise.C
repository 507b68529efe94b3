/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The scene of the current time: new, or continued to the bit.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "deviceChoice.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What the scene is like that a run has now
static void setRun
(
    sphRestart& run,
    const riprap::SphConfig& config,
    label particles,
    riprap::DeviceKind device
)
{
    run.spacing = config.spacing;
    run.maxVelocity = config.maxVelocity;
    run.soundSpeed = config.soundSpeed;
    run.density = config.density;
    run.setDomain(config);
    run.particles = particles;
    run.device = sphNames::device[device];
    run.precision = sphNames::precision[config.precision];
}


//- Of several processes the scene is their parts together
static void joinParts
(
    autoPtr<pstreamTransport>& ranks,
    std::unique_ptr<riprap::SphScene>& scene,
    std::unique_ptr<riprap::SphScene>& part
)
{
    if (!ranks.valid()) return;

    part = std::move(scene);
    scene = riprap::wholeSphScene(*part, *ranks);
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::sphDem::makeScene
(
    const riprap::FluidInput& fluid,
    const riprap::WallInput& walls
)
{
    try
    {
        scene_ = riprap::createSphScene
        (
            settings_.config,
            fluid,
            walls,
            walls_.bodies().motion()
        );
    }
    catch (const std::invalid_argument& e)
    {
        FatalErrorInFunction
            << "constant/sphProperties with the particles of "
            << runTime_.timePath()/"lagrangian/fluid" << ": " << e.what()
            << exit(FatalError);
    }
    leaveCoresToWriting(scene_->device());
}


void Foam::solverModules::sphDem::makeCoupledScene
(
    const riprap::FluidInput& fluid,
    const riprap::WallInput& walls,
    bool continued
)
{
    const riprap::SphConfig& config = settings_.config;
    const riprap::SolidInput solids
    (
        solids_->input(config, fluid, continued)
    );
    try
    {
        scene_ = riprap::createSphDemScene
        (
            config,
            fluid,
            walls,
            solids,
            walls_.bodies().motion()
        );
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(solids_->dict())
            << e.what() << exit(FatalIOError);
    }
    leaveCoresToWriting(scene_->device());
}


//- Of a run that is continued, not an estimate from where the fluid is now
void Foam::solverModules::sphDem::setSpeeds
(
    const particleCloud& cloud,
    bool continued,
    otherSpeeds others
)
{
    if (continued && settings_.autoMaxVelocity)
    {
        settings_.config.maxVelocity = run_.maxVelocity;
        settings_.config.soundSpeed = settings_.soundSpeedRatio*run_.maxVelocity;
        return;
    }

    addSolids(others);
    setMaxVelocity
    (
        settings_,
        wholeBoundary(mesh_),
        cloud.position,
        cloud.vectors["U"],
        others
    );
}


void Foam::solverModules::sphDem::buildScene
(
    const particleCloud& cloud,
    bool continued
)
{
    if (solids_)
    {
        solids_->clear();
    }
    settings_ = asRead_;
    riprap::SphConfig& config = settings_.config;

    setSpacing(settings_, fluidSpacing(runTime_));
    config.startTime = runTime_.value();
    config.ranks = ranks_.get();

    otherSpeeds others;
    const riprap::WallInput walls(walls_.build(settings_, others));
    domainKept_ = !continued || run_.keepDomain(config);
    if (solids_)
    {
        solids_->read(continued);
    }

    setSpeeds(cloud, continued, others);

    const riprap::FluidInput fluid(fluidInput(cloud));
    if (!continued)
    {
        requireSpeeds(settings_, runTime_, cloud.vectors["U"]);
        warnOfOtherProperties();
    }

    scene_.reset();
    part_.reset();
    if (solids_)
    {
        makeCoupledScene(fluid, walls, continued);
    }
    else
    {
        makeScene(fluid, walls);
    }
    joinParts(ranks_, scene_, part_);

    if (!continued)
    {
        run_ = sphRestart();
        run_.initialParticles = cloud.size();
    }
    setRun(run_, config, cloud.size(), scene_->device());
    run_.time = runTime_.value();

    if (solids_)
    {
        solids_->registerScene(*scene_);
    }
}


void Foam::solverModules::sphDem::registerScene()
{
    report_ = riprap::SphReport();
    report_.time = scene_->time();
    report_.fluid = run_.particles;

    cloud_.reset(new fluidCloud(mesh_, part_ ? *part_ : *scene_, *scene_, run_));
    sceneObject_.reset
    (
        new sphSceneObject
        (
            mesh_,
            *scene_,
            settings_.config,
            report_,
            walls_.bodies(),
            walls_.points()
        )
    );
    if (solids_)
    {
        solids_->registerCloud();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::sphDem::initialise()
{
    cloud_.clear();
    sceneObject_.clear();
    if (solids_)
    {
        solids_->clear();
    }
    scene_.reset();
    part_.reset();

    const particleCloud cloud(readFluid());

    const bool continued = canContinue(cloud);
    const sphRestart before(run_);
    buildScene(cloud, continued);

    if (continued && loadState(cloud, before))
    {
        warnUnread(cloud);
    }
    else if (continued)
    {
        buildScene(cloud, false);
    }

    registerScene();

    if (!modelsLogged_)
    {
        logModels();
        modelsLogged_ = true;
    }
}


// ************************************************************************* //
