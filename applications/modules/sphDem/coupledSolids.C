/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSolids.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledSolids::coupledSolids
(
    Time& runTime,
    fvMesh& mesh,
    const sphSettings& fluid,
    const boundaryFinder& boundary
)
:
    sceneSolids
    (
        runTime,
        mesh,
        "sphProperties",
        fluid.config.device,
        fluid.config.precision,
        boundary
    ),
    coupling_(fluid.coupling)
{}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- Of which particles keep the water out: mass over density; members of a
//  clump share that of the clump as their own volumes are
std::vector<double> Foam::coupledSolids::volumes() const
{
    const riprap::DemParticles& p = input_.particles;
    const int D = settings_.config.dimensions;
    const auto density = [&](std::size_t i)
    {
        return settings_.materials[p.material.empty() ? 0 : p.material[i]].density;
    };

    std::vector<double> shares(input_.clumps.size(), 0.0);
    for (std::size_t i = 0; i < p.clump.size(); ++i)
    {
        if (p.clump[i] >= 0) shares[p.clump[i]] += std::pow(p.radius[i], D);
    }

    std::vector<double> volume(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const int clump = p.clump.empty() ? -1 : p.clump[i];
        volume[i] = clump < 0
          ? p.mass[i]/density(i)
          : input_.clumps[clump].mass/density(i)
           *std::pow(p.radius[i], D)/shares[clump];
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

riprap::SolidInput Foam::coupledSolids::input
(
    const riprap::SphConfig& fluidConfig,
    const riprap::FluidInput& fluid,
    bool continued
)
{
    readInput(continued);
    if (!continued)
    {
        requireApart(fluidConfig, fluid);
    }

    riprap::SolidInput input;
    input.coupling = coupling_;
    input.config = settings_.config;
    input.input = input_;
    input.volume = volumes();
    return input;
}


void Foam::coupledSolids::registerScene(riprap::SphScene& scene)
{
    scene_ = &scene;
    registerSolids(*scene.solids());
}


// ************************************************************************* //
