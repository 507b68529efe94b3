/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The scene of the current time: new, or continued to the bit.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "deviceChoice.H"
#include "sphNames.H"
#include "wallPoints.H"
#include "wholeBoundary.H"
#include "pic/ranks/gridBricks.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- They go on counting, whether the exact state is used or not
static void continueOpenings(const picRestart& run, riprap::PicConfig& config)
{
    for (riprap::PicOpening& opening : config.openings)
    {
        const auto passage = run.passed.find(opening.name);
        if (passage != run.passed.end())
        {
            opening.before = passage->second;
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::picDem::makeScene
(
    const particleCloud& cloud,
    bool continued
)
{
    try
    {
        scene_ = riprap::createPicScene
        (
            settings_.config,
            fluidInput(cloud),
            grid_.walls(),
            &pressure_,
            inside(continued)
        );
    }
    catch (const riprap::PicRefusal& e)
    {
        ranks_.refuse(settings_, e);
    }
    catch (const riprap::TooManyRanks& e)
    {
        FatalIOErrorInFunction(runTime_.globalPath()/runTime_.system()/"decomposeParDict")
            << "Entry numberOfSubdomains: " << e.what() << exit(FatalIOError);
    }
    catch (const std::invalid_argument& e)
    {
        FatalIOErrorInFunction(solids_ ? solids_->dict() : settings_.dict)
            << "The case cannot be run: " << e.what() << exit(FatalIOError);
    }
    leaveCoresToWriting(scene_->device());
    ranks_.join(scene_);
}


void Foam::solverModules::picDem::buildScene
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
    riprap::PicConfig& config = settings_.config;

    grid_.set(config);
    config.startTime = runTime_.value();
    config.spacing = givenSpacing();
    config.ranks = ranks_.transport();
    config.gatheredCells = pressure_.gatheredCells(config.gatheredCells);

    // What a run has written are its particles, not what cells are seeded by
    const bool written = hasPicRun(runTime_);
    if (written)
    {
        config.seedsPerDirection = 0;
    }
    continueOpenings(run_, config);

    scene_.reset();
    ranks_.clear();
    makeScene(cloud, continued);

    const label particles = label(scene_->farEnd({{1, 0, 0}}, 0).particles);
    if (!continued)
    {
        const auto passed = run_.passed;
        run_ = picRestart();
        run_.passed = passed;
        run_.initialParticles = particles;
        run_.given = config.spacing;
    }
    // Function objects measure by the spacing that the case was made with
    config.spacing = run_.given;
    run_.spacing = scene_->particleSpacing();
    run_.time = runTime_.value();
    run_.particles = particles;
    run_.device = sphNames::device[scene_->device()];
    run_.precision = sphNames::precision[config.precision];

    if (solids_)
    {
        solids_->registerScene(*scene_);
    }
}


void Foam::solverModules::picDem::registerScene()
{
    report_ = riprap::PicReport();
    report_.time = scene_->time();
    report_.fluid = run_.particles;

    cloud_.reset(new picCloud(mesh_, ranks_.part(*scene_), *scene_, run_));
    wordList walls;
    const polyMesh& boundary = wholeBoundary(mesh_);
    for (const label patchi : wallPatches(boundary))
    {
        walls.append(boundary.boundaryMesh()[patchi].name());
    }
    labelList bodyOfWall(walls.size(), -1);
    if (obstacles_.valid())
    {
        walls.append(obstacles_->names());
        bodyOfWall.append(bodyOfObstacle());
    }
    sceneObject_.reset
    (
        new picSceneObject
        (
            mesh_, *scene_, settings_.config, report_, bodies_, walls, bodyOfWall
        )
    );
    if (!fields_.valid())
    {
        fields_.reset(new gridFields(mesh_));
    }
    if (solids_)
    {
        solids_->registerCloud();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::picDem::initialise()
{
    cloud_.clear();
    sceneObject_.clear();
    if (solids_)
    {
        solids_->clear();
    }
    scene_.reset();
    ranks_.clear();

    const particleCloud cloud(readFluid());

    const bool continued = canContinue(cloud);
    buildScene(cloud, continued);

    if (continued && !loadState(cloud))
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
