/*  Water and solids in one scene: an SphScene that drives a DemScene on the same device, dimension
    and precision.

    Each step of the fluid begins with as many steps of the solids as their stable step asks for,
    under the fluid's force of its start; then the fluid sees the solids where they have got to.
    What either scene does alone is as in its own facade; the solids are read through
    SphScene::solids().

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/demScene.hpp"
#include "api/sphScene.hpp"

namespace riprap
{

struct CouplingConfig
{
    // how fluid and solid particles act on each other (coupling/couplings.hpp; paper 1, section
    // 5). The others leak (docs/coupling.md)
    std::string kind = "extrapolated";
    // viscous terms of the fluid act between fluid and solids
    bool viscosity = true;
    bool xsph = false;                      // so does XSPH; where the fluid has it
    bool antiClump = false;                 // so does the anti-clump term; where the fluid has it
    // when solids get the force of the fluid over a step of it (coupling/fluidForces.hpp)
    std::string force = "held";
};

//- Solids of a coupled scene. Volumes are those of which particles keep the water out, together
//  those of the bodies: a cell of the packing for bonded particles
struct SolidInput
{
    CouplingConfig coupling;
    // device, precision, dimensions, axes and gravity are taken from the fluid's
    DemConfig config;
    DemInput input;
    std::vector<double> volume;             // n [m3] (2D: m2), of DemInput::particles
    // of rigid bodies, which nothing passes: body is that of DemInput::clumps, points from its
    // centre along its
    WallFaceInput faces;
                                            // principal axes (2D: along the scene's as they were
                                            // when it was made)
};

//- What passes between fluid and solids now
struct CouplingState
{
    // 3 n [N] (2D: a metre of depth), in the order of DemScene::particles()
    std::vector<double> force;
    Vector3 total{{0, 0, 0}};
    // impulse that the fluid has got and solids get in the next step [N s]
    Vector3 pending{{0, 0, 0}};
    int subcycles = 0;                      // of the last step
};

//- @throws std::invalid_argument (inconsistent input), std::runtime_error (device failure)
std::unique_ptr<SphScene> createSphDemScene(const SphConfig&, const FluidInput&, const WallInput&,
    const SolidInput&, WallMotion motion = WallMotion());

//- Fluid particles inside solid ones at the start: pairs closer than the solid's radius and half
//  the fluid's spacing, less a tolerance (a fraction of the spacing). Empty: none
struct SolidOverlap { std::size_t count = 0, fluid = 0, solid = 0; double distance = 0; };
SolidOverlap solidsInFluid(
    const SphConfig&, const FluidInput&, const DemParticles&, double tolerance);

} // namespace riprap
