/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphSolids.H"
#include "bodyFaces.H"
#include "particleCloudIO.H"
#include "remedies.H"
#include "coupling/fluidForces.hpp"
#include "solvers/sph/sphModels.hpp"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sphSolids::sphSolids
(
    Time& runTime,
    fvMesh& mesh,
    const sphSettings& fluid,
    const nearestPatch& boundary
)
:
    coupledSolids
    (
        runTime,
        mesh,
        "sphProperties",
        fluid.config.device,
        fluid.config.precision,
        boundary
    ),
    coupling_(fluid.coupling),
    impermeable_(fluid.walls.impermeable)
{
    if (fluid.autoFluidForce) coupling_.force = riprap::ImpulsiveForce::word;
    for (const demGroup& g : asRead_.groups)
    {
        // it takes a share of the unbalanced force, of which the fluid's must be a part
        if (g.group.localDamping <= 0 || !riprap::fluidForceOf(coupling_.force).blows)
            continue;
        if (fluid.autoFluidForce) coupling_.force = riprap::HeldForce::word;
        else
        {
            FatalIOErrorInFunction(fluid.dict)
                << "Entry fluidForce of couplingCoeffs is " << coupling_.force.c_str()
                << ", but group "
                << g.group.name.c_str()
                << " of constant/solidProperties has local damping, which must see the fluid's "
                   "force: valid are held and interpolated"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

//- Of which particles keep the water out: mass over density; members of a
//  rigid body share its own volume as their masses are
std::vector<double> Foam::sphSolids::volumes() const
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
        if (clump < 0)
        {
            volume[i] = p.mass[i]/density(i);
            continue;
        }
        const riprap::DemClump& body = input_.clumps[clump];
        const double whole =
            body.volume > 0 ? body.volume : body.mass/density(i);
        volume[i] = whole*p.mass[i]/members[clump];
    }
    return volume;
}


void Foam::sphSolids::requireApart
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


//- Water sees a particle at its centre alone, as far as the kernel reaches
void Foam::sphSolids::requireFine
(
    const riprap::SphConfig& config,
    const std::vector<double>& volume
) const
{
    const scalar support = riprap::supportOf(config);
    label larger = 0, unseen = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < volume.size(); ++i)
    {
        const scalar size = std::pow(volume[i], 1.0/config.dimensions);
        larger += size > config.spacing*(1 + 1e-3);
        unseen += size > support;
        if (volume[i] > volume[worst]) worst = i;
    }
    if (!larger) return;

    const scalar largest = std::pow(volume[worst], 1.0/config.dimensions);
    OStringStream where;
    where
        << "particle " << input_.particles.id[worst] << ", of radius "
        << input_.particles.radius[worst] << " m, stands for a "
        << (config.dimensions == 2 ? "square of " : "cube of ") << largest
        << " m; the fluid's spacing is " << config.spacing << " m";
    if (unseen)
    {
        FatalErrorInFunction
            << "Solids are too coarse for the fluid: " << where.str().c_str()
            << ", and its kernel reaches " << support << " m: fluid would be"
            << " inside of " << unseen << " particles. Make bodies of particles"
            << " no larger than the fluid's spacing: a region with `rigid yes;`"
            << " and `spacing " << config.spacing << ";`"
            << " in system/setParticlesDict" << exit(FatalError);
    }
    WarningInFunction
        << larger << " of " << label(volume.size()) << " solid particles"
        << " are larger than the fluid's spacing: " << where.str().c_str()
        << ". Particles should not be larger" << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sphSolids::read(bool continued)
{
    readInput(continued);
}


riprap::SolidInput Foam::sphSolids::input
(
    const riprap::SphConfig& fluidConfig,
    const riprap::FluidInput& fluid,
    bool continued
)
{
    if (!continued)
    {
        requireApart(fluidConfig, fluid);
    }

    riprap::SolidInput input;
    input.coupling = coupling_;
    input.config = settings_.config;
    input.input = input_;
    input.volume = volumes();
    requireFine(fluidConfig, input.volume);
    if (impermeable_)
    {
        const dictionary properties(readCloudProperties(runTime_, "solids"));
        input.faces =
            bodyFaces(properties, runTime_, fluidConfig, input_.clumps);
    }
    bodiesWithFaces_ = bodiesWithFaces(input.faces);
    return input;
}


void Foam::sphSolids::registerScene(riprap::SphScene& scene)
{
    scene_ = &scene;
    registerSolids(*scene.solids());
}



void Foam::sphSolids::remediesOf(remedies& helps) const
{
    coupledSolids::remediesOf(helps);

    // local damping must see the force (refused with a blow)
    bool damped = false;
    for (const demGroup& g : asRead_.groups)
    {
        damped = damped || g.group.localDamping > 0;
    }
    helps.when
    (
        !damped && !riprap::fluidForceOf(coupling_.force).blows,
        string("fluidForce ") + riprap::ImpulsiveForce::word
      + " of couplingCoeffs (is " + coupling_.force + ")"
    );
}


// ************************************************************************* //
