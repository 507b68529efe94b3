/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The scene of the current time: new, or continued to the bit.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::sphDem::makeScene
(
    const riprap::FluidInput& fluid,
    const riprap::WallInput& walls,
    const riprap::WallMotion& motion
)
{
    scene_.reset();
    part_.reset();
    try
    {
        scene_ =
            riprap::createSphScene(settings_.config, fluid, walls, motion);
    }
    catch (const std::invalid_argument& e)
    {
        FatalErrorInFunction
            << "constant/sphProperties with the particles of "
            << runTime_.timePath()/"lagrangian/fluid" << ": " << e.what()
            << exit(FatalError);
    }
    if (ranks_.valid())
    {
        part_ = std::move(scene_);
        scene_ = riprap::wholeSphScene(*part_, *ranks_);
    }
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
    const riprap::WallInput walls(buildWalls(others));
    domainKept_ = !continued || run_.keepDomain(config);
    if (solids_)
    {
        solids_->read(continued);
    }

    if (continued && settings_.autoMaxVelocity)
    {
        // That of the run, not an estimate from where the fluid is now
        config.maxVelocity = run_.maxVelocity;
        config.soundSpeed = settings_.soundSpeedRatio*run_.maxVelocity;
    }
    else
    {
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

    const riprap::FluidInput fluid(fluidInput(cloud));
    if (!continued)
    {
        requireSpeeds(settings_, runTime_, cloud.vectors["U"]);
        warnOfOtherProperties();
    }

    const riprap::WallMotion motion
    (
        bodies_.size()
      ? [this](int body, double t) { return bodies_.pose(body, t); }
      : riprap::WallMotion()
    );
    if (solids_)
    {
        const riprap::SolidInput solids
        (
            solids_->input(config, fluid, continued)
        );
        try
        {
            scene_ =
                riprap::createSphDemScene(config, fluid, walls, solids, motion);
        }
        catch (const std::invalid_argument& e)
        {
            FatalIOErrorInFunction(solids_->dict())
                << e.what() << exit(FatalIOError);
        }
    }
    else
    {
        makeScene(fluid, walls, motion);
    }

    if (!continued)
    {
        run_ = sphRestart();
        run_.initialParticles = cloud.size();
    }
    run_.spacing = config.spacing;
    run_.maxVelocity = config.maxVelocity;
    run_.soundSpeed = config.soundSpeed;
    run_.density = config.density;
    run_.setDomain(config);
    run_.time = runTime_.value();
    run_.particles = cloud.size();
    run_.device = sphNames::device[scene_->device()];
    run_.precision = sphNames::precision[config.precision];

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
            bodies_,
            walls_
        )
    );
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
