/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The scene of the current time: new, or continued to the bit.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "sphNames.H"
#include "sweptDomain.H"
#include "wallPoints.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::dem::buildInput(const solidSet& solids)
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
        input_.groupMotion = [this](int motion, double t)
        {
            return rigidMotion(movingGroups_, motion, t, moving_.first(), moving_.second());
        };
    }
}


void Foam::solverModules::dem::coverMotion()
{
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


void Foam::solverModules::dem::buildScene(solidSet solids, bool continued)
{
    // The state that is loaded says which bonds are broken
    const label broken = continued ? 0 : solids.dropBroken();

    settings_ = asRead_;
    riprap::DemConfig& config = settings_.config;
    config.startTime = runTime_.value();
    moving_ = Pair<scalar>(config.startTime, config.startTime);
    if
    (
        continued
     && config.timeStep == 0
     && config.stepFraction == run_.stepFraction
     && config.maxTimeStep == run_.maxDeltaT
    )
    {
        // That of the start, not an estimate from where the solids are now
        config.timeStep = run_.timeStep;
    }
    buildInput(solids);
    coverMotion();

    try
    {
        scene_ = riprap::createDemScene(config, input_);
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(settings_.dict) << e.what() << exit(FatalIOError);
    }

    if (!continued)
    {
        run_ = demRun();
        run_.initialParticles = solids.particles.size();
        run_.brokenBefore = broken;
    }
    run_.brokenBefore += solids.lostBonds;
    run_.timeStep = scene_->plan().timeStep;
    run_.stepFraction = config.stepFraction;
    run_.maxDeltaT = config.maxTimeStep;
    run_.time = runTime_.value();
    run_.particles = solids.particles.size();
    run_.device = sphNames::device[scene_->device()];
    run_.precision = sphNames::precision[config.precision];
}


void Foam::solverModules::dem::registerScene()
{
    report_ = riprap::DemReport();
    report_.time = scene_->time();
    report_.particles = run_.particles;

    cloud_.reset
    (
        new solidCloud(mesh_, *scene_, settings_, input_, typeOfBondType_, run_)
    );
    sceneObject_.reset
    (
        new demSceneObject(mesh_, *scene_, settings_, input_, report_)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::dem::initialise()
{
    cloud_.clear();
    sceneObject_.clear();
    scene_.reset();

    const solidSet solids(readSolids(mesh_, asRead_));

    const bool continued = canContinue(solids);
    buildScene(solids, continued);

    if (continued && !loadState(solids))
    {
        buildScene(solids, false);
    }

    registerScene();

    if (!modelsLogged_)
    {
        logModels();
        modelsLogged_ = true;
    }
}


// ************************************************************************* //
