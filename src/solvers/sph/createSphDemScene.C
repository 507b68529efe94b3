/*  A fluid with solids in it: checks what belongs to both, makes the solids' scene on the fluid's
    device, and couples them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/sph/sphInstances.hpp"
#include "coupling/couplings.hpp"
#include "coupling/fluidForces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace riprap
{

namespace
{

void require(bool condition, const std::string& what)
{
    if (!condition) throw std::invalid_argument(what);
}

void checkVolumes(const SolidInput& solids)
{
    require(solids.volume.size() == solids.input.particles.size(),
        "volumes of solids of another length");
    for (const double v : solids.volume)
        require(v > 0 && std::isfinite(v), "the volume of each solid particle must be positive");
}

//- What the fluid decides
DemConfig onDeviceOf(const SphConfig& fluid, DeviceKind device, DemConfig solids)
{
    solids.device = device;
    solids.precision = fluid.precision;
    solids.dimensions = fluid.dimensions;
    for (int d = 0; d < 3; ++d) solids.axes[d] = fluid.axes[d];
    solids.gravity = fluid.gravity;
    solids.startTime = fluid.startTime;
    // each process has all of them, and moves them by the same steps
    solids.ranks = nullptr;
    return solids;
}

//- 2 rho0 V h/R over m: a layer of h of water about a particle, or about a rigid body as if it were
//  round
std::vector<double> addedShares(const SphConfig& fluid, const SolidInput& solids)
{
    const DemParticles& p = solids.input.particles;
    const double layer = 2*fluid.density*fluid.smoothingRatio*fluid.spacing;
    std::vector<double> whole(solids.input.clumps.size(), 0.0), added(p.size());
    for (std::size_t i = 0; i < p.clump.size(); ++i)
        if (p.clump[i] >= 0) whole.at(p.clump[i]) += solids.volume[i];
    for (std::size_t i = 0; i < p.size(); ++i)
    {
        const int clump = p.clump.empty() ? -1 : p.clump[i];
        if (clump < 0) added[i] = layer*solids.volume[i]/(p.mass[i]*p.radius[i]);
        else
        {
            const double V = whole[clump], pi = std::acos(-1.0);
            const double R = fluid.dimensions == 2 ? std::sqrt(V/pi) : std::cbrt(0.75*V/pi);
            added[i] = layer*V/(solids.input.clumps[clump].mass*R);
        }
    }
    return added;
}

} // namespace

std::unique_ptr<SphScene> createSphDemScene(const SphConfig& config, const FluidInput& fluid,
    const WallInput& walls, const SolidInput& solids, WallMotion motion)
{
    checkVolumes(solids);
    for (const std::int32_t body : solids.faces.body)
        require(body >= 0 && body < int(solids.input.clumps.size()),
            "faces of a rigid body that does not exist");
    couplingOf(solids.coupling.kind);
    fluidForceOf(solids.coupling.force);
    require(!solids.coupling.xsph || config.xsph > 0,
        "XSPH between fluid and solids needs XSPH in the fluid");
    require(!solids.coupling.antiClump || config.antiClump > 0,
        "the anti-clump term between fluid and solids needs that of the fluid");
    require(!(solids.config.sleepAfter > 0),
        "solids in a fluid do not sleep: the fluid's force moves them at any time; leave out the "
        "entry sleep");
    SphConfig here(config);
    here.device = deviceOf(config, fluid.size());
    SolidPart part;
    part.scene = createDemScene(onDeviceOf(here, here.device, solids.config), solids.input);
    part.coupling = solids.coupling;
    part.volume = solids.volume;
    part.added = addedShares(config, solids);
    part.faces = solids.faces;
    part.clump = solids.input.particles.clump;
    part.clumps = int(solids.input.clumps.size());
    for (const double r : solids.input.particles.radius)
        part.largestRadius = std::max(part.largestRadius, r);
    return createSphScene(here, fluid, walls, std::move(motion), std::move(part));
}

SolidOverlap solidsInFluid(
    const SphConfig& c, const FluidInput& fluid, const DemParticles& solids, double tolerance)
{
    SolidOverlap overlap;
    if (solids.size() == 0) return overlap;
    const double largest = *std::max_element(solids.radius.begin(), solids.radius.end());
    const double cell = largest + 0.5*c.spacing;
    using Cell = std::array<long long, 3>;
    const auto cellOf = [&](const std::vector<double>& x, std::size_t i)
    {
        Cell r{{0, 0, 0}};
        for (int d = 0; d < c.dimensions; ++d)
            r[d] = (long long)std::floor(x[3*i + c.axes[d]]/cell);
        return r;
    };
    std::map<Cell, std::vector<std::size_t>> members;
    for (std::size_t s = 0; s < solids.size(); ++s)
        members[cellOf(solids.position, s)].push_back(s);
    double worst = 1e300;
    for (std::size_t f = 0; f < fluid.size(); ++f)
    {
        const Cell own = cellOf(fluid.position, f);
        bool inside = false;
        for (int k = 0; k < (c.dimensions == 2 ? 9 : 27); ++k)
        {
            const auto at = members.find(Cell{{own[0] + k % 3 - 1, own[1] + k/3 % 3 - 1,
                c.dimensions == 2 ? 0 : own[2] + k/9 - 1}});
            if (at == members.end()) continue;
            for (const std::size_t s : at->second)
            {
                double d2 = 0;
                for (int d = 0; d < c.dimensions; ++d)
                {
                    const double r = fluid.position[3*f + c.axes[d]]
                        - solids.position[3*s + c.axes[d]];
                    d2 += r*r;
                }
                const double gap = std::sqrt(d2) - solids.radius[s] - (0.5 - tolerance)*c.spacing;
                if (gap >= 0) continue;
                inside = true;
                if (gap >= worst) continue;
                worst = gap;
                overlap.fluid = f;
                overlap.solid = s;
                overlap.distance = std::sqrt(d2);
            }
        }
        overlap.count += inside;
    }
    return overlap;
}

} // namespace riprap
