/*  Chooses device, dimension and precision, checks consistency, and builds the scene. */
#include "scene/sphInstances.hpp"
#include "core/device.hpp"

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

void check(const SphConfig& c, const FluidInput& f, const WallInput& w, const WallMotion& motion)
{
    require(c.dimensions == 2 || c.dimensions == 3, "dimensions must be 2 or 3");
    require(c.spacing > 0, "the fluid's spacing must be positive");
    require(c.density > 0, "the density must be positive");
    require(c.viscosity >= 0, "the viscosity must not be negative");
    require(c.soundSpeed > 0, "the speed of sound must be positive");
    require(c.smoothingRatio >= 0.8 && c.smoothingRatio <= 4, "the ratio of smoothing length to spacing must lie in 0.8 .. 4");
    require(c.adjustTimeStep || c.fixedTimeStep > 0, "a fixed time step must be positive");
    require(c.maxSmoothingGrowth >= 1, "the smoothing length's growth limit must be at least 1");
    require(f.velocity.size() == f.position.size() && 3*f.density.size() == f.position.size(), "fluid arrays of different lengths");
    require(f.id.empty() || f.id.size() == f.size(), "fluid ids of another length");
    require(f.size() < 2000000000u, "more than 2e9 particles");
    require(f.size() > 0, "there are no fluid particles");
    require(w.size() == 0 || c.wallSpacing > 0, "the walls' spacing must be positive");
    require(w.body.empty() || w.body.size() == w.size(), "wall body indices of another length");
    require(w.nBodies == 0 || bool(motion), "moving walls without a motion");
    for (int d = 0; d < c.dimensions; ++d)
        require(c.periodic[c.axes[d]] || c.domainMax[c.axes[d]] - c.domainMin[c.axes[d]] > 2*c.escapeInset,
            "the domain is empty");
    for (std::size_t i = 0; i < f.size(); ++i)
        for (int d = 0; d < c.dimensions; ++d)
        {
            const int axis = c.axes[d];
            const double x = f.position[3*i + axis], inset = c.periodic[axis] ? 0 : c.escapeInset;
            if (!(x >= c.domainMin[axis] + inset && x <= c.domainMax[axis] - inset))
                throw std::invalid_argument("fluid particle " + std::to_string(i) + " at (" + std::to_string(f.position[3*i])
                  + " " + std::to_string(f.position[3*i + 1]) + " " + std::to_string(f.position[3*i + 2]) + ") is outside the domain");
        }
}

} // namespace

//- Below this many particles one GPU is no faster than a few CPU cores (docs/performance); the log quotes it
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
        choice.reason = std::to_string(particles) + " particles are fewer than " + std::to_string(gpuThreshold)
          + ", where a GPU begins to win";
        return choice;
    }
    choice.device = DeviceKind::gpu;
    choice.reason = "a GPU is there and the scene has " + std::to_string(particles) + " particles";
    return choice;
}

std::unique_ptr<SphScene> createSphScene
(const SphConfig& config, const FluidInput& fluid, const WallInput& walls, WallMotion motion)
{
    check(config, fluid, walls, motion);
    // unused lanes of packs may divide by zero, and a state that blows up is the guards' business
    fedisableexcept(FE_ALL_EXCEPT);
    const DeviceChoice choice = chooseDevice(config.device, fluid.size(), config.dimensions);
    const bool two = config.dimensions == 2, mixed = config.precision == PrecisionKind::mixed;
#ifdef RIPRAP_CUDA
    if (choice.device == DeviceKind::gpu)
    {
        const SphMaker make = two ? (mixed ? sphGpu2Mixed : sphGpu2Double) : (mixed ? sphGpu3Mixed : sphGpu3Double);
        return make(config, fluid, walls, std::move(motion));
    }
#endif
    const SphMaker make = two ? (mixed ? sphCpu2Mixed : sphCpu2Double) : (mixed ? sphCpu3Mixed : sphCpu3Double);
    return make(config, fluid, walls, std::move(motion));
}

} // namespace riprap
