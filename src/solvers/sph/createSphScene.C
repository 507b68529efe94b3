/*  Chooses device, dimension and precision, checks consistency, and builds the scene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/sph/sphInstances.hpp"
#include "solvers/sph/sphModels.hpp"
#include "core/backend/device.hpp"
#include "core/ranks/transport.hpp"
#include "api/particleLimit.hpp"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <stdexcept>

namespace riprap
{

namespace
{

void require(bool condition, const std::string& what)
{
    if (!condition) throw std::invalid_argument(what);
}

std::string at(const std::vector<double>& x, std::size_t i)
{
    return std::to_string(i) + " at (" + std::to_string(x[3*i]) + " "
        + std::to_string(x[3*i + 1]) + " " + std::to_string(x[3*i + 2]) + ")";
}

//- Comparisons are written so that a NaN fails them
void checkNumbers(const SphConfig& c)
{
    require(c.dimensions == 2 || c.dimensions == 3, "dimensions must be 2 or 3");
    int axes = 0;
    for (const int a : c.axes) if (a >= 0 && a < 3) axes |= 1 << a;
    require(axes == 7, "the axes must be 0, 1 and 2 in any order");
    require(c.spacing > 0, "the fluid's spacing must be positive");
    require(c.density > 0, "the density must be positive");
    require(c.viscosity >= 0, "the viscosity must not be negative");
    require(c.soundSpeed > 0, "the speed of sound must be positive");
    require(c.maxVelocity > 0, "the maximum velocity must be positive");
    require(c.smoothingRatio >= 0.8 && c.smoothingRatio <= 4,
        "the ratio of smoothing length to spacing must lie in 0.8 .. 4");
    require(c.maxSmoothingGrowth >= 1, "the smoothing length's growth limit must be at least 1");
    checkModels(c);
    require(c.shiftingCoefficient >= 0, "a coefficient must not be negative");
    require(c.shiftingSurfaceThreshold != 0 && c.shiftingSurfaceThreshold < c.dimensions,
        "the surface threshold of shifting must lie between 0 and the number of dimensions");
    for (const double g : c.gravity) require(std::isfinite(g), "gravity must be a number");
    require(c.adjustTimeStep || c.fixedTimeStep > 0, "a fixed time step must be positive");
    require(c.maxTimeStep > 0, "the largest time step must be positive");
    for (const double k : {c.acousticCourant, c.forceCourant, c.viscousCourant})
        require(k > 0, "Courant numbers must be positive");
    require(c.maxDensityDeviation > 0, "the largest density deviation must be positive");
    require(c.maxSpeedRatio > 0, "the largest speed ratio must be positive");
    for (int d = 0; d < c.dimensions; ++d)
    {
        const double length = c.domainMax[c.axes[d]] - c.domainMin[c.axes[d]];
        require(length > (c.periodic[c.axes[d]] ? 0 : 2*c.escapeInset), "the domain is empty");
    }
}

void checkFluid(const SphConfig& c, const FluidInput& f)
{
    require(f.velocity.size() == f.position.size() && 3*f.density.size() == f.position.size(),
        "fluid arrays of different lengths");
    require(f.id.empty() || f.id.size() == f.size(), "fluid ids of another length");
    requireCountable(double(f.size()), mostFluidParticles, "fluid particles");
    require(f.size() > 0, "there are no fluid particles");
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        bool inside = true, finite = f.density[i] > 0 && std::isfinite(f.density[i]);
        for (int d = 0; d < c.dimensions; ++d)
        {
            const int axis = c.axes[d];
            const double x = f.position[3*i + axis], inset = c.periodic[axis] ? 0 : c.escapeInset;
            inside = inside && x >= c.domainMin[axis] + inset && x <= c.domainMax[axis] - inset;
            finite = finite && std::isfinite(f.velocity[3*i + axis]);
        }
        if (!inside)
            throw std::invalid_argument(
                "fluid particle " + at(f.position, i) + " is outside the domain");
        if (!finite)
            throw std::invalid_argument(
                "fluid particle " + at(f.position, i) + " has no proper density or velocity");
    }
}

void checkWalls(const SphConfig& c, const WallInput& w, const WallMotion& motion)
{
    require(w.size() == 0 || c.wallSpacing > 0, "the walls' spacing must be positive");
    require(w.body.empty() || w.body.size() == w.size(), "wall body indices of another length");
    require(w.nBodies == 0 || bool(motion), "moving walls without a motion");
    // a little beyond does no harm: the fluid stays away from the edge of the domain by the support
    // of the kernel
    const double margin = supportOf(c);
    for (std::size_t i = 0; i < w.size(); ++i)
    {
        const std::int32_t body = w.body.empty() ? -1 : w.body[i];
        if (body < -1 || body >= w.nBodies)
            throw std::invalid_argument("wall point " + at(w.position, i) + " is of body "
                + std::to_string(body) + " of " + std::to_string(w.nBodies));
        for (int d = 0; d < c.dimensions; ++d)
        {
            const int axis = c.axes[d];
            const double x = w.position[3*i + axis];
            const bool free = c.periodic[axis] || body >= 0;
            if (std::isfinite(x)
                && (free || (x >= c.domainMin[axis] - margin && x <= c.domainMax[axis] + margin)))
                continue;
            throw std::invalid_argument(
                "wall point " + at(w.position, i) + " is outside the domain");
        }
    }
}

bool onSeveral(const SphConfig& c) { return c.ranks && c.ranks->size() > 1; }

void checkRanks(const SphConfig& c)
{
    if (!onSeveral(c)) return;
    require(c.imbalance > 0, "the imbalance that bricks may have must be positive");
}

} // namespace

//- Below this many particles one GPU is no faster than a few CPU cores (docs/performance); the log
//  quotes it
static constexpr std::size_t gpuThreshold = 1000;

DeviceChoice chooseDevice(DeviceKind asked, std::size_t particles, int)
{
    DeviceChoice choice;
    std::string why;
    const int gpus = gpuCount(why);
    if (asked == DeviceKind::cpu) { choice.reason = "asked for"; return choice; }
    if (asked == DeviceKind::gpu)
    {
        if (!gpus) throw std::invalid_argument("device gpu was asked for, but " + why);
        choice.device = DeviceKind::gpu;
        choice.reason = "asked for";
        return choice;
    }
    if (!gpus) { choice.reason = why; return choice; }
    if (particles < gpuThreshold)
    {
        choice.reason = std::to_string(particles) + " particles are fewer than "
            + std::to_string(gpuThreshold) + ", where a GPU begins to win";
        return choice;
    }
    choice.device = DeviceKind::gpu;
    choice.reason = "a GPU is there and the scene has " + std::to_string(particles) + " particles";
    return choice;
}

//- Several processes share a GPU where they are told to
DeviceKind deviceOf(const SphConfig& config, std::size_t particles)
{
    const bool asked = config.device == DeviceKind::gpu || !onSeveral(config);
    return chooseDevice(asked ? config.device : DeviceKind::cpu, particles, config.dimensions)
        .device;
}

std::unique_ptr<SphScene> createSphScene
(const SphConfig& config, const FluidInput& fluid, const WallInput& walls, WallMotion motion)
{
    return createSphScene(config, fluid, walls, std::move(motion), SolidPart());
}

std::unique_ptr<SphScene> createSphScene(const SphConfig& config, const FluidInput& fluid,
    const WallInput& walls, WallMotion motion, SolidPart solids)
{
    checkNumbers(config);
    checkFluid(config, fluid);
    checkWalls(config, walls, motion);
    checkRanks(config);
    // unused lanes of packs may divide by zero, and a state that blows up is the guards' business
    fedisableexcept(FE_ALL_EXCEPT);
    const bool two = config.dimensions == 2, mixed = config.precision == PrecisionKind::mixed;
#ifdef RIPRAP_CUDA
    if (deviceOf(config, fluid.size()) == DeviceKind::gpu)
    {
        const SphMaker make = two ? (mixed ? sphGpu2Mixed : sphGpu2Double)
                                  : (mixed ? sphGpu3Mixed : sphGpu3Double);
        return make(config, fluid, walls, std::move(motion), std::move(solids));
    }
#endif
    const SphMaker make = two ? (mixed ? sphCpu2Mixed : sphCpu2Double)
                              : (mixed ? sphCpu3Mixed : sphCpu3Double);
    return make(config, fluid, walls, std::move(motion), std::move(solids));
}

} // namespace riprap
