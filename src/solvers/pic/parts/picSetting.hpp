/*  What all parts of a scene of water in cells refer to: its configuration, device, grid and clock.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <memory>
#include "api/picScene.hpp"
#include "core/backend/launch.hpp"
#include "core/simd/precision.hpp"
#include "pic/grid/mirror.hpp"
#include "pic/grid/uniformGrid.hpp"
#include "core/ranks/joinRanks.hpp"
#include "pic/ranks/gridBricks.hpp"
#include "pic/ranks/rankMeter.hpp"
#include "pic/terms/viscousSchemes.hpp"
#include "solvers/pic/transfer/picSplines.hpp"

namespace riprap
{

//- Part of a saved state, as bytes: no pointers, no padding
struct PicClock
{
    double time = 0, lastStep = 0, lastKick = 0;
    double particleVolume = 0;              // [m^D]
    double drift = 0;                       // of the volume, put right so far, relative
    std::int64_t steps = 0;
    std::int64_t initial = 0;               // particles at the very start
    std::int64_t nextId = 0;                // of the next one that comes in
};

template<class Backend, int D, class P>
struct PicSetting
{
    using real = typename P::real;

    //- Layers of faces beyond the water that get a velocity: a particle's way in a step, its
    //  stencil, and a corner
    static constexpr int extrapolationPasses = 5;
    static constexpr double bandCells = 4;      // of phi on either side of the surface
    static constexpr double wallMargin = 1e-3;  // of a cell: particles stay that far inside
    static constexpr double nearSolid = 1.9;    // cells: distances are known a little farther

    PicConfig config;
    Context<Backend> context{};
    UniformGrid<D> grid;                        // of several ranks: this one's part
    std::unique_ptr<RankMeter> meter;           // null: one rank has all
    std::unique_ptr<GridBricks<D>> bricks;      // the same
    double gravity[D];
    double emptyCoordinate = 0;
    PicClock clock;

    //- water: that a run begins with, whose places decide who has which cells
    explicit PicSetting(const PicConfig&, const FluidInput& water = FluidInput());
    PicSetting(const PicSetting&) = delete;

    const UniformGrid<D>& whole() const { return bricks ? bricks->whole() : grid; }
    //- Does each of several ranks solve for p of the whole block?
    bool gathersPressure() const
    {
        return bricks && whole().cells() <= config.gatheredCells;
    }
    double largest(double value) const
    {
        return bricks ? largestOfRanks(bricks->ranks(), value) : value;
    }
    double particleSpacing() const { return std::pow(clock.particleVolume, 1.0/D); }
    double kick(double dt) const;
    int steepest() const;
    std::vector<double> solved(const std::vector<double>& xyz, bool position) const;
    template<class F> void withWindows(const F&) const;
};

template<class Backend, int D, class P>
PicSetting<Backend, D, P>::PicSetting(const PicConfig& c, const FluidInput& water)
:
    config(c)
{
    grid.h = config.cellSize;
    for (int d = 0; d < D; ++d)
    {
        const int axis = config.axes[d];
        grid.origin[d] = config.domainMin[axis];
        grid.n[d] = config.cells[axis];
        grid.periodic[d] = config.periodic[axis];
        gravity[d] = config.gravity[axis];
    }
    const int empty = config.axes[2];
    emptyCoordinate = 0.5*(config.domainMin[empty] + config.domainMax[empty]);
    clock.time = config.startTime;
    if (!config.ranks || config.ranks->size() < 2) return;
    meter = std::make_unique<RankMeter>(*config.ranks);
    bricks = std::make_unique<GridBricks<D>>(*meter, grid, solved(water.position, true),
        std::pow(config.spacing/config.cellSize, D));
    grid = bricks->partGrid();
}

//- Velocities stand between the times of positions (leapfrog): half a step behind the first time,
//  then the mean of the steps on either side, so that a step that changes with the flow feeds no
//  energy in or out of waves
template<class Backend, int D, class P> double PicSetting<Backend, D, P>::kick(double dt) const
{
    return clock.steps ? 0.5*(clock.lastStep + dt) : 0.5*dt;
}

//- The direction in which gravity is largest; -1: there is none
template<class Backend, int D, class P>
int PicSetting<Backend, D, P>::steepest() const
{
    int up = 0;
    for (int d = 1; d < D; ++d) if (std::abs(gravity[d]) > std::abs(gravity[up])) up = d;
    return gravity[up] != 0 ? up : -1;
}

//- The solved components of points, above the block's corner, or of vectors
template<class Backend, int D, class P>
std::vector<double> PicSetting<Backend, D, P>::solved(
    const std::vector<double>& xyz, bool position) const
{
    std::vector<double> x(xyz.size()/3*D);
    for (std::size_t i = 0; i < xyz.size()/3; ++i)
        for (int d = 0; d < D; ++d)
            x[i*D + d] = xyz[3*i + config.axes[d]] - (position ? grid.origin[d] : 0.0);
    return x;
}

//- f(std::integral_constant<int, order of the splines>, are there places around which the nodes are
//  no block?)
template<class Backend, int D, class P>
template<class F>
void PicSetting<Backend, D, P>::withWindows(const F& f) const
{
    withSpline(config.splineOrder, [&](auto order)
    {
        if (needsAround(grid, config.splineOrder)) f(order, std::true_type());
        else f(order, std::false_type());
    });
}

} // namespace riprap
