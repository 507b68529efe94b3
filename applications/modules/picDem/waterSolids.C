/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "waterSolids.H"
#include "listed.H"
#include "moduleLog.H"
#include "picShapes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of the water's density: lighter solids under a surface do not stand the
//  reflection, whose first solution takes them as pistons
//  (tutorials/picDem/freeBody/README.md)
const Foam::scalar lightest = 0.03;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::waterSolids::waterSolids
(
    Time& runTime,
    fvMesh& mesh,
    const picSettings& fluid,
    const boundaryFinder& boundary
)
:
    sceneSolids
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


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::waterSolids::warnOfLightSolids() const
{
    const riprap::DemParticles& p = input_.particles;

    scalar least = GREAT;
    for (std::size_t i = 0; i < p.radius.size(); ++i)
    {
        const int material = p.material.empty() ? 0 : p.material[i];
        least = min(least, settings_.materials[material].density);
    }

    if (least < lightest*fluid_.density && fluid_.reflection > 0)
    {
        IOWarningInFunction(dict())
            << "There are solids of " << least << " kg/m3, less than "
            << lightest << " of the water's rho: with 'reflection yes;', the"
            << " default of constant/picProperties, they are thrown out of the"
            << " water's surface. If they come near it, set 'reflection no;'"
            << nl << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::shared_ptr<const riprap::PicSolids> Foam::waterSolids::input
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


void Foam::waterSolids::registerScene(riprap::PicScene& scene)
{
    scene_ = &scene;
    registerSolids(*scene.solids());
}


void Foam::waterSolids::logModels() const
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
    warnOfLightSolids();
}


void Foam::waterSolids::logStep() const
{
    const riprap::PicScene::Coupling now(scene_->coupling());
    logSteps(now.subcycles, now.force);
}


// ************************************************************************* //
