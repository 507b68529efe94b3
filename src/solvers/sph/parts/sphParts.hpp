/*  What a scene of fluid consists of. Its parts know what they are made from; what the solver does
    with them is in solvers/sph/driver.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <atomic>
#include <map>
#include <string>
#include "core/neighbours/pairLoop.hpp"
#include "core/neighbours/searchReach.hpp"
#ifdef __CUDACC__
    #include "core/backend/graph.hpp"
    #include "core/neighbours/neighbourList.hpp"
#endif
#include "solvers/sph/parts/fluidRanks.hpp"
#include "solvers/sph/parts/faceArrays.hpp"
#include "solvers/sph/parts/solidRanks.hpp"
#include "solvers/sph/parts/sphClock.hpp"
#include "solvers/sph/parts/sphParticles.hpp"
#include "solvers/sph/parts/wallPoints.hpp"
#include "solvers/sph/parts/wallPoses.hpp"
#include "solvers/sph/parts/wallRanks.hpp"

namespace riprap
{

//- GPU: steps launched between two rebuilds
struct CycleLength
{
    int steps = 8;
    bool fitted = false;        // it was too long once: lengthen in small strides
    int full = 0;               // since it was, pairs of cycles all of whose steps were wanted
};

//- What only one backend has
template<class Backend, int D, class P> struct BackendParts;

#ifndef __CUDACC__
//- What a search has found; of fluid and solids only where they may meet
template<int D, class P>
struct BackendParts<Cpu, D, P>
{
    FoundRanges fluidFluid, fluidWall, wallFluid, fluidSolid, solidFluid;
};
#endif

#ifdef __CUDACC__
//- Recorded launches, for either half of the double-buffered fields
struct StepGraphs
{
    static constexpr int together = 4;
    Graph rebuild[2], step[2], steps[2];
    bool recorded = false;      // and as things are now
    // of a step with solids what follows their own: by the memory that it reads, as bytes
    std::map<std::string, Graph> afterSolids;

    //- Things are no longer as they were
    void forget() { recorded = false; afterSolids.clear(); }
};

template<int D, class P>
struct BackendParts<Gpu, D, P>
{
    using real = typename P::real;

    NeighbourList<D, P> fluidFluid, fluidWall, wallFluid, fluidSolid, solidFluid;
    LocalFrameMemory<Gpu, D, P> frames;
    // lists of walls and about walls reach farther than the grid's: fluid slides along them
    real wallRadius = 0;
    StepGraphs graphs;
    int solidShift = 0;         // log2 of the lanes a solid
};
#endif

template<class Backend, int D, class P>
struct SphParts
{
    using real = typename P::real;

    SphSetting<Backend, D, P> set;
    SphClock<Backend> clock{set.context};
    SphParticles<Backend, D, P> fluid;
    WallPoints<Backend, D, P> walls{set};
    WallPoses<Backend> poses;
    CoupledSolids<Backend, D, P> solids{set};
    FaceArrays<Backend, D, P> faces{set};
    BackendParts<Backend, D, P> memory;
    int shift = 0;              // log2 of the lanes a particle
    CycleLength cycle;
    double stiffening = 0;      // [J] that changes of the speed of sound have added
    std::atomic<bool> interrupted{false};                   // until a call of advance has heeded it
    // null: there is one
    std::unique_ptr<FluidRanks<Backend, D, P>> ranks;
    std::unique_ptr<WallRanks<Backend, D, P>> wallRanks;
    std::unique_ptr<SolidRanks<Backend, D, P>> solidRanks;

    SphParts(const SphConfig&, int particles, WallMotion);
    SphParts(const SphParts&) = delete;

    GhostMarks<Backend> ghosts() const { return ranks ? ranks->marks() : GhostMarks<Backend>(); }
    GhostMarks<Backend> wallGhosts() const
    {
        return wallRanks ? wallRanks->marks() : GhostMarks<Backend>();
    }
    GhostMarks<Backend> solidGhosts() const
    {
        return solidRanks ? solidRanks->marks() : GhostMarks<Backend>();
    }
    //- The same for the host: is it worked out by another rank?
    bool ghost(int i) const { return ranks && ranks->ghost(i); }
    bool wallGhost(int i) const { return wallRanks && wallRanks->ghost(i); }
    bool solidGhost(int i) const { return solidRanks && solidRanks->ghost(i); }
    bool stopAsked() const { return ranks ? ranks->stopAgreed() : bool(interrupted); }
    Tick tick() { return Tick{clock.data(), set.limits}; }

    //- What passes find about particles of the fluid, of walls, of solids
    Source<Backend, D, P> fluidSource(bool forWalls);
    Source<Backend, D, P> wallSource();
    Source<Backend, D, P> solidSource();
    Source<Backend, D, P> fluidAboutSolids();

    template<class Pass> void run(const Pass&, int targets);
    template<class Pass> void runOverSolids(const Pass&);
};

template<class Backend, int D, class P>
SphParts<Backend, D, P>::SphParts(const SphConfig& config, int particles, WallMotion motion)
:
    set(config, particles), fluid(set, particles), poses(set.context, std::move(motion))
{
    if (!config.ranks || config.ranks->size() == 1) return;
    ranks = std::make_unique<FluidRanks<Backend, D, P>>(
        typename FluidRanks<Backend, D, P>::Scene{set.context, set.config, set.box, set.grid,
            fluid.values, fluid.records, fluid.sort, fluid.n, set.emptyCoordinate, fluid.at});
    wallRanks = std::make_unique<WallRanks<Backend, D, P>>(*ranks, walls);
    solidRanks = std::make_unique<SolidRanks<Backend, D, P>>(*ranks, solids);
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphParts<Backend, D, P>::fluidSource([[maybe_unused]] bool forWalls)
{
    Source<Backend, D, P> s{};
    s.records = fluid.records.view();
    s.start = fluid.sort.start();
    if constexpr (Backend::gpu)
        s.list = forWalls ? memory.wallFluid.view() : memory.fluidFluid.view();
#ifndef __CUDACC__
    else s.ranges = forWalls ? memory.wallFluid.view() : memory.fluidFluid.view();
#endif
    return s;
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphParts<Backend, D, P>::wallSource()
{
    Source<Backend, D, P> s{};
    if (!walls.count) return s;
    s.records = walls.records.view();
    s.start = walls.sort.start();
    if constexpr (Backend::gpu) s.list = memory.fluidWall.view();
#ifndef __CUDACC__
    else s.ranges = memory.fluidWall.view();
#endif
    return s;
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphParts<Backend, D, P>::solidSource()
{
    Source<Backend, D, P> s{};
    s.records = solids.records.view();
    s.start = solids.sort.start();
    if constexpr (Backend::gpu) s.list = memory.fluidSolid.view();
#ifndef __CUDACC__
    else if (solids.meetFluid) s.ranges = memory.fluidSolid.view();
#endif
    return s;
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphParts<Backend, D, P>::fluidAboutSolids()
{
    Source<Backend, D, P> s{};
    s.records = fluid.records.view();
    s.start = fluid.sort.start();
    if constexpr (Backend::gpu) s.list = memory.solidFluid.view();
#ifndef __CUDACC__
    else if (solids.meetFluid) s.ranges = memory.solidFluid.view();
#endif
    return s;
}

template<class Backend, int D, class P>
template<class Pass>
void SphParts<Backend, D, P>::run(const Pass& pass, [[maybe_unused]] int targets)
{
    if constexpr (Backend::gpu) pairLoop(set.context, pass, shift, targets);
    else pairLoop(set.context, pass);
}

template<class Backend, int D, class P>
template<class Pass>
void SphParts<Backend, D, P>::runOverSolids(const Pass& pass)
{
    if constexpr (Backend::gpu) pairLoop(set.context, pass, memory.solidShift, solids.count);
    else pairLoop(set.context, pass);
}

} // namespace riprap
