/*  Chooses device, dimension and precision, checks consistency, and builds the scene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/pic/picInstances.hpp"
#include "solvers/pic/transfer/picTransfers.hpp"
#include "core/ranks/transport.hpp"
#include "api/particleLimit.hpp"
#include "api/sphScene.hpp"
#include "pic/openings/kinds.hpp"
#include "pic/terms/viscousSchemes.hpp"

#include <cfenv>
#include <cmath>
#include <stdexcept>

namespace riprap
{

namespace
{

//- Diameter in cells that a grid can tell from a point. benchmarks/picDemStability compiles this
//  file with less
#ifndef RIPRAP_SMALLEST_SOLID
#define RIPRAP_SMALLEST_SOLID 4
#endif
constexpr double smallestSolid = RIPRAP_SMALLEST_SOLID;

void require(bool condition, const std::string& what)
{
    if (!condition) throw std::invalid_argument(what);
}

//- Comparisons are written so that a NaN fails them
void checkNumbers(const PicConfig& c)
{
    require(c.dimensions == 2 || c.dimensions == 3, "dimensions must be 2 or 3");
    int axes = 0;
    for (const int a : c.axes) if (a >= 0 && a < 3) axes |= 1 << a;
    require(axes == 7, "the axes must be 0, 1 and 2 in any order");
    require(c.cellSize > 0, "the cells' size must be positive");
    require(c.spacing > 0, "the fluid's spacing must be positive");
    require(c.density > 0, "the density must be positive");
    require(c.viscosity >= 0, "the viscosity must not be negative");
    require(viscousSchemeOf(c.viscousScheme).acts || c.viscosity == 0,
        "viscosity is none, and the fluid has some");
    for (const PicOpening& o : c.openings) givenAt(o.kind);
    for (const double g : c.gravity) require(std::isfinite(g), "gravity must be a number");
    require(c.seedsPerDirection >= 0 && c.seedsPerDirection <= 8,
        "the seeds a direction must lie in 0 .. 8");
    require(c.jitter >= 0 && c.jitter <= 1, "the jitter must lie in 0 .. 1");
    transferOf(c);
    require(c.advectionOrder == 2 || c.advectionOrder == 3, "the advection's order must be 2 or 3");
    require(c.positionCorrection >= 0, "the position correction must not be negative");
    require(c.adjustTimeStep || c.fixedTimeStep > 0, "a fixed time step must be positive");
    require(c.maxTimeStep > 0, "the largest time step must be positive");
    require(c.maxCourant > 0 && c.maxCourant <= 2, "the Courant number must lie in 0 .. 2");
    require(c.slowInterval >= 1, "an interval of slow particles must be a step or more");
    require(c.slowCourant > 0 && c.slowCourant <= 0.4,
        "the path of slow particles in an interval must lie in 0 .. 0.4 cells");
    require(c.maxFlyingCourant >= c.maxCourant,
        "the Courant number of flying particles must not be below that of the others");
    double cells = 1;
    for (int d = 0; d < c.dimensions; ++d)
    {
        const int axis = c.axes[d];
        cells *= c.cells[axis];
        const double length = c.domainMax[axis] - c.domainMin[axis];
        require(c.cells[axis] >= 4, "there must be four cells or more along each direction");
        require(std::abs(length - c.cells[axis]*c.cellSize) < 1e-6*length,
            "the cells do not fill the domain");
    }
    requireCountable(cells, mostCells, "cells");
}

void checkFluid(const PicConfig& c, const FluidInput& f, bool solids)
{
    require(f.velocity.size() == f.position.size(), "fluid arrays of different lengths");
    require(f.id.empty() || f.id.size() == f.size(), "fluid ids of another length");
    require(f.size() > 0 || solids, "there are no fluid particles");
    requireCountable(double(f.size()), mostFluidParticles, "fluid particles");
    for (std::size_t i = 0; i < f.size(); ++i)
        for (int d = 0; d < c.dimensions; ++d)
        {
            const int axis = c.axes[d];
            const double x = f.position[3*i + axis];
            // no text is made of millions that are right
            if (!(x >= c.domainMin[axis] && x <= c.domainMax[axis]))
                require(false, "fluid particle " + std::to_string(i) + " is outside the domain");
            if (!std::isfinite(f.velocity[3*i + axis]))
                require(false, "fluid particle " + std::to_string(i) + " has no proper velocity");
        }
}


//- What the fluid decides
DemConfig onDeviceOf(const PicConfig& fluid, DeviceKind device, DemConfig solids)
{
    solids.device = device;
    solids.precision = fluid.precision;
    solids.dimensions = fluid.dimensions;
    for (int d = 0; d < 3; ++d) solids.axes[d] = fluid.axes[d];
    solids.gravity = fluid.gravity;
    solids.startTime = fluid.startTime;
    return solids;
}

//- Lengths of a case are rounded decimals: 0.16 m are 4 cells of 0.04 m
double smallest(const PicConfig& c) { return smallestSolid*c.cellSize*(1 - 1e-6); }

//- A shape is as thick as the largest ball in it, whose centre lies between points of the lattice:
//  up to a step of it more than is found
void checkShapes(const PicConfig& c, const PicSolids& s)
{
    for (const DemClump& k : s.input.clumps)
        require(k.shape >= -1 && k.shape < int(s.shapes.size()),
            "a rigid body has a shape that is not there");
    for (const PicShape& shape : s.shapes)
    {
        require(!shape.distance.empty()
                && shape.distance.size() == std::size_t(shape.n[0])*shape.n[1]*shape.n[2]
                && shape.step > 0,
            "shape " + shape.name + " is not a lattice");
        for (int d = 0; d < c.dimensions; ++d)
            require(shape.n[c.axes[d]] > 1, "shape " + shape.name + " is a lattice of one point");
        const double thickness = -2
            *(*std::min_element(shape.distance.begin(), shape.distance.end()));
        require(thickness + shape.step >= smallest(c),
            "solids of shape " + shape.name + ", about " + std::to_string(thickness)
                + " m thick, are thinner than 4 cells of " + std::to_string(c.cellSize) + " m");
    }
}

//- So few are moved by a thread of the CPU in less time than the GPU takes to be told to: 0.1 us a
//  solid and step against some 15 us a step, and their state need not cross the bus
constexpr std::size_t fewSolids = 128;

void makeSolids(const PicConfig& c, DeviceKind device, bool water, PicInside& inside)
{
    if (!inside.solids) return;
    if (water && inside.solids->input.particles.size() <= fewSolids) device = DeviceKind::cpu;
    const PicSolids& s = *inside.solids;
    require(s.contactVelocity >= 0 && s.contactVelocity <= 1,
        "what water between solids that touch keeps of its velocity must lie in 0 .. 1");
    require(s.contactVelocityTime >= 0,
        "the time in which water between solids that touch loses of its velocity must not be "
        "negative");
    checkShapes(c, s);
    const std::vector<double>& r = s.input.particles.radius;
    const std::vector<std::int32_t>& clump = s.input.particles.clump;
    for (std::size_t i = 0; i < r.size(); ++i)
        require((!clump.empty() && clump[i] >= 0 && s.input.clumps[clump[i]].shape >= 0)
                || 2*r[i] >= smallest(c),
            "solid particle "
                + std::to_string(s.input.particles.id.empty() ? int(i) : s.input.particles.id[i])
                + " of radius " + std::to_string(r[i]) + " m is smaller than 4 cells of "
                + std::to_string(c.cellSize)
                + " m across; a rigid body "
                  "needs no such particles if it is a box, a cylinder or a sphere, in 3D a closed "
                  "surface, in 2D an outline (clumpsFromOutline), or a list with the entry "
                  "surface");
    inside.scene = createDemScene(onDeviceOf(c, device, s.config), s.input);
}

} // namespace

void checkPicRanks(const PicConfig& c, const LinearSolver* solver)
{
    if (!c.ranks || c.ranks->size() < 2) return;
    const auto need = [](bool condition, PicInput input, const std::string& what)
    { if (!condition) throw PicRefusal(input, what); };
    need(c.device != DeviceKind::gpu, PicInput::device, "several processes run on CPUs alone");
    need(!solver || solver->onDevice(), PicInput::solver,
        std::string("several processes need p solved by ") + ownSolver);
    need(c.slowInterval == 1, PicInput::multirate,
        "several processes step each particle in each step: remove multirate");
    // a particle must stay where the halo is right
    constexpr double farthest = 6;
    need(c.maxCourantEver <= farthest, PicInput::guards,
        "on several processes a particle may travel 6 cells a step at most, guards/Courant allows "
            + std::to_string(c.maxCourantEver));
}

std::unique_ptr<PicScene> createPicScene(const PicConfig& config, const FluidInput& fluid,
    const PicWalls& walls, LinearSolver* solver, PicInside inside)
{
    checkNumbers(config);
    checkFluid(config, fluid, bool(inside.solids));
    checkPicRanks(config, solver);
    fedisableexcept(FE_ALL_EXCEPT);         // a state that blows up is the guards' business
    const bool several = config.ranks && config.ranks->size() > 1;
    const DeviceChoice choice = chooseDevice(several ? DeviceKind::cpu : config.device,
        fluid.size() + (inside.solids ? inside.solids->input.particles.size() : 0),
        config.dimensions);
    require(!(config.noSlip && viscousSchemeOf(config.viscousScheme).limitsStep
                && (!inside.obstacles.empty() || inside.solids)),
        "water that sticks to solids inside the mesh needs implicit viscosity: take automatic or "
        "implicit for viscosity");
    const int openings = int(config.openings.size());
    for (const auto& of : walls.opening)
        for (const int number : of)
            require(number >= -1 && number < openings,
                "a face belongs to an opening that is not there");
    makeSolids(config, choice.device, fluid.size() > 0, inside);
    const bool two = config.dimensions == 2, mixed = config.precision == PrecisionKind::mixed;
#ifdef RIPRAP_CUDA
    if (choice.device == DeviceKind::gpu)
    {
        const PicMaker make = two ? (mixed ? picGpu2Mixed : picGpu2Double)
                                  : (mixed ? picGpu3Mixed : picGpu3Double);
        return make(config, fluid, walls, solver, std::move(inside));
    }
#endif
    const PicMaker make = two ? (mixed ? picCpu2Mixed : picCpu2Double)
                              : (mixed ? picCpu3Mixed : picCpu3Double);
    return make(config, fluid, walls, solver, std::move(inside));
}

} // namespace riprap
