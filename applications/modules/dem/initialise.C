/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The scene of the current time: new, or continued to the bit.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "deviceChoice.H"
#include "demMotion.H"
#include "sphNames.H"
#include "wholeBoundary.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::dem::makeScene(const riprap::DemConfig& config)
{
    scene_.reset();
    part_.reset();
    try
    {
        scene_ = riprap::createDemScene(config, input_);
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(settings_.dict) << e.what() << exit(FatalIOError);
    }
    leaveCoresToWriting(scene_->device());
    if (ranks_.valid())
    {
        part_ = std::move(scene_);
        scene_ = riprap::wholeDemScene(*part_, *ranks_);
    }
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
    const polyMesh& boundary = wholeBoundary(mesh_);
    input_ = demInputWithMotion
    (
        boundary, settings_, solids, movingWalls_, movingGroups_, moving_, typeOfBondType_
    );
    coverSolids(boundary, movingWalls_, movingGroups_, input_, config);
    markWalledSides(boundary, input_.walls, config);
    if (continued)
    {
        // Else the state says whether its own fits
        run_.keepDomain(config);
    }

    config.ranks = ranks_.get();
    makeScene(config);

    if (!continued)
    {
        requireBeforePlanes(settings_, input_);
        run_ = demRestart();
        run_.initialParticles = solids.particles.size();
        run_.brokenBefore = broken;
    }
    run_.brokenBefore += solids.lostBonds;
    run_.timeStep = scene_->plan().timeStep;
    run_.stepFraction = config.stepFraction;
    run_.maxDeltaT = config.maxTimeStep;
    run_.time = runTime_.value();
    run_.setDomain(config);
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
        new solidCloud
        (
            mesh_, part_ ? *part_ : *scene_, *scene_, settings_, input_,
            typeOfBondType_, run_
        )
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
    part_.reset();

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
