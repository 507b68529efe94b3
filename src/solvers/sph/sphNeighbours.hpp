/*  SphSolver: the structures in which neighbours are found: sorting into cells, and on the GPU
    lists.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

//- Sort the fluid into cells and find neighbours
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::rebuild()
{
    FluidKeys<D, P> keys;
    keys.box = box_;
    keys.grid = grid_;
    keys.model = model_;
    for (int d = 0; d < D; ++d) keys.x[d] = fluid_.template data<std::int64_t>(xField_ + d);
    keys.keys = fluidSort_.keys();
    keys.indices = fluidSort_.indices();
    keys.id = fluid_.template data<std::int32_t>(idField_);
    keys.active = fluidSort_.active();
    keys.clock = clock_.data();
    forEach(context_, n_, keys);
    if (ranks_)
        ranks_->migrate([this](int n) { setCapacity(n); }, [this] { return fluidFields(); });
    fluidSort_.sort(context_, n_);
    fluid_.permute(context_, fluidSort_.order(), n_);
    if (ranks_) ranks_->settle(activeFluid());
    if constexpr (Backend::gpu) parts_.frames.clear(context_);
    forEach(context_, n_, mover<PlaceFluid<Backend, D, P>>());
    if (nBodies_) rebuildWalls();
    if (solids_) sortSolids();
    settleFrames();
    if (solids_) meetFluid();
    buildLists();
    // sorted walls need their pressures anew; and the symplectic scheme's density pass sees those
    // of the state at hand, so that a restart does too
    if (nBodies_ || config_.integrator == IntegratorKind::symplectic) wallPass(false);
    solidPressurePass(false);
    if (ranks_) ranks_->agree(*clock_.data(), interrupted_);
}

//- How far particles may go, now that they and the walls are in their places
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::settleFrames()
{
    if constexpr (Backend::gpu)
    {
        if (!parts_.frames.on()) return;
        const double support = grid_.radius - 2*double(allowedWay_),
                     alongWalls = double(parts_.wallRadius) - support;
        parts_.frames.settle(context_, 0.5*(parts_.frames.width() - support),
            nBodies_ ? 0.5*alongWalls : alongWalls);
    }
}

//- A rebuild between two calls of advance. Recorded cycles hold an even number of them: two, so
//  that pointers are as recorded
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::sortNow()
{
    rebuild();
    if constexpr (Backend::gpu) rebuild();
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::rebuildWalls()
{
    WallKeys<D, P> keys;
    keys.box = box_;
    keys.grid = grid_;
    for (int d = 0; d < D; ++d) keys.x[d] = wall_.template data<std::int64_t>(wallXField_ + d);
    keys.keys = wallSort_.keys();
    keys.indices = wallSort_.indices();
    forEach(context_, nWalls_, keys);
    wallSort_.sort(context_, nWalls_);
    wall_.permute(context_, wallSort_.order(), nWalls_);
    if (!nBodies_)
    {
        wall_.releaseSpare();
        wallSort_.releaseScratch();
    }
    PlaceWalls<Backend, D, P> place{};
    place.box = box_;
    place.records = wallRecords_.view();
    if constexpr (Backend::gpu)
    {
        parts_.frames.clearStill(context_);
        place.frames = parts_.frames.view();
    }
    for (int d = 0; d < D; ++d)
    {
        place.x[d] = wall_.template data<std::int64_t>(wallXField_ + d);
        place.reference[d] = nBodies_ ? wallReference_.data() + std::size_t(d)*nWalls_ : nullptr;
    }
    forEach(context_, nWalls_, place);
    if (config_.wallModel == WallKind::stationary)
        forEach(context_, nWalls_,
            StationaryWall<Backend, D, P>{wallRecords_.view(), wallFields(), model_});
}

//- Where h varies lists reach as far as the largest h there is, not as its limit: of two hundredths
//  more, so that they last
template<class Backend, int D, class P>
SearchReach<typename P::real> SphSolver<Backend, D, P>::fluidReach() const
{
    if (!config_.variableSmoothing) return {};
    return {&clock_.data()->foundH, ClockData::growthOfH, float(model_.hMax), pairReach(0),
        reachOfH<real>(config_)};
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::buildLists()
{
    if constexpr (Backend::gpu)
    {
        const auto fluid = fluidRecords_.view();
        int* overflow = clock_.data()->overflow;
        parts_.fluidFluid.build(context_, box_, grid_, grid_.radius, fluid, fluid,
            fluidSort_.start(), fluidSort_.active(), true, overflow, "listFluid", fluidReach());
        if (solidsMeet_)
        {
            const auto solid = solidRecords_.view();
            parts_.fluidSolid.build(context_, box_, grid_, grid_.radius, fluid, solid,
                solidSort_.start(), fluidSort_.active(), false, overflow + 3, "listFluidSolid");
            parts_.solidFluid.build(context_, box_, grid_, grid_.radius, solid, fluid,
                fluidSort_.start(), solidSort_.active(), false, overflow + 4, "listSolidFluid");
        }
        if (!nWalls_) return;
        const auto wall = wallRecords_.view();
        parts_.fluidWall.build(context_, box_, grid_, parts_.wallRadius, fluid, wall,
            wallSort_.start(), fluidSort_.active(), false, overflow + 1, "listFluidWall");
        if (config_.wallModel == WallKind::extrapolated || nBodies_)
            parts_.wallFluid.build(context_, box_, grid_, parts_.wallRadius, wall, fluid,
                fluidSort_.start(), wallSort_.active(), false, overflow + 2, "listWallFluid");
    }
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::allocateLists()
{
    if constexpr (Backend::gpu)
    {
        // threads a particle, so that small scenes fill the machine
        const auto shiftOf = [](int n)
        { return n <= 24000 ? 3 : (n <= 200000 ? 2 : (n <= 500000 ? 1 : 0)); };
        shift_ = shiftOf(n_);
        const double pi = 3.14159265358979323846,
                     h = std::min(1.5*double(ClockData::growthOfH)*model_.h0 + model_.h0,
                         double(model_.hMax));
        const double r = config_.variableSmoothing ? double(pairReach(float(h)))
                                                   : double(grid_.radius);
        const double sphere = D == 2 ? pi*r*r : 4*pi*r*r*r/3;
        const int lanes = 1 << shift_;
        const int fluidNeighbours = int(1.4*sphere/std::pow(config_.spacing, D)) + 8;
        const int capacity = (fluidNeighbours/lanes*(lanes > 1 ? 3 : 2)/2 + 7)/4 + 1;
        parts_.fluidFluid.allocate(context_, n_, shift_, false, capacity);
        if (solids_)
        {
            // grown when they do not fit
            parts_.solidShift = shiftOf(nSolids_);
            const long long warps = ((long long)nSolids_ << shift_)/32 + 1;
            parts_.fluidSolid.allocate(context_, n_, shift_, true, int(warps*capacity + 256));
            parts_.solidFluid.allocate(
                context_, nSolids_, parts_.solidShift, true, int(warps*capacity/2 + 256));
        }
        if (nWalls_)
        {
            const int wallBlocks = int(0.1*sphere*std::pow(parts_.wallRadius/r, D)
                                       /std::pow(config_.wallSpacing, D)/lanes)
                + 1;
            const long long warps = ((long long)n_ << shift_)/32 + 1,
                            wallWarps = ((long long)nWalls_ << shift_)/32 + 1;
            parts_.fluidWall.allocate(context_, n_, shift_, true,
                int(std::min(warps, 3*wallWarps)*wallBlocks/2 + 256));
            if (config_.wallModel == WallKind::extrapolated || nBodies_)
                parts_.wallFluid.allocate(
                    context_, nWalls_, shift_, true, int(wallWarps*capacity/4 + 256));
        }
    }
}

//- Room for the lists that did not fit, half as much again as was needed
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::growLists()
{
    if constexpr (Backend::gpu)
    {
        const auto grown = [](int needed) { return needed + needed/2 + 1; };
        if (host_.overflow[0])
            parts_.fluidFluid.allocate(context_, n_, shift_, false, grown(host_.overflow[0]));
        if (host_.overflow[1])
            parts_.fluidWall.allocate(context_, n_, shift_, true, grown(host_.overflow[1]));
        if (host_.overflow[2])
            parts_.wallFluid.allocate(context_, nWalls_, shift_, true, grown(host_.overflow[2]));
        if (host_.overflow[3])
            parts_.fluidSolid.allocate(context_, n_, shift_, true, grown(host_.overflow[3]));
        if (host_.overflow[4])
            parts_.solidFluid.allocate(
                context_, nSolids_, parts_.solidShift, true, grown(host_.overflow[4]));
        parts_.graphs.recorded = false;
        for (int& o : host_.overflow) o = 0;
        writeClock();
    }
}

} // namespace riprap
