/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "picSolids.H"
#include "listed.H"
#include "moduleLog.H"
#include "picShapes.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::picSolids::picSolids
(
    Time& runTime,
    fvMesh& mesh,
    const picSettings& fluid,
    const nearestPatch& boundary
)
:
    coupledSolids
    (
        runTime,
        mesh,
        "picProperties",
        fluid.config.device,
        fluid.config.precision,
        boundary
    ),
    fluid_(fluid.config),
    weak_(fluid.weak),
    contactVelocity_(fluid.contactVelocity),
    contactVelocityTime_(fluid.contactVelocityTime)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::shared_ptr<const riprap::PicSolids> Foam::picSolids::input
(
    scalar cellSize,
    bool continued
)
{
    readInput(continued);

    auto solids = std::make_shared<riprap::PicSolids>();
    solids->config = settings_.config;
    solids->input = input_;
    solids->shapes = picShapes(runTime_, fluid_, cellSize);
    shapes_.clear();
    for (const riprap::PicShape& shape : solids->shapes)
    {
        shapes_.append(shape.name);
    }
    solids->weak = weak_;
    solids->contactVelocity = contactVelocity_;
    solids->contactVelocityTime = contactVelocityTime_;
    return solids;
}


void Foam::picSolids::registerScene(riprap::PicScene& scene)
{
    scene_ = &scene;
    registerSolids(*scene.solids());
}


void Foam::picSolids::logModels() const
{
    Info<< nl << "Solids in the water" << nl;
    logItem("coupling") << (weak_ ? "weak" : "implicit")
        << ", contactVelocity " << contactVelocity_;
    if (contactVelocityTime_ > 0)
    {
        Info<< " in " << contactVelocityTime_ << " s";
    }
    else if (contactVelocity_ < 1) Info<< " a step";
    Info<< nl;
    if (scene_->solids()->device() != scene_->device())
    {
        logItem("device") << "CPU: so few solids are moved faster there"
            << nl;
    }
    if (shapes_.size()) logItem("shapes") << listed(shapes_).c_str() << nl;
    std::string limit;
    const scalar fluidStep = scene_->estimateTimeStep(limit);
    logSolids(fluidStep, limit);
}


void Foam::picSolids::logStep() const
{
    const riprap::PicScene::Coupling now(scene_->coupling());
    logSteps(now.subcycles, now.force);
}


// ************************************************************************* //
