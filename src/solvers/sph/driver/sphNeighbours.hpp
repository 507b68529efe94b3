/*  Who is near whom: the fluid in the order of cells, and on the GPU lists of neighbours.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/driver/fluidPasses.hpp"
#include "solvers/sph/driver/solidCoupling.hpp"
#include "solvers/sph/driver/wallPasses.hpp"
#include "solvers/sph/parts/sphRebuild.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SphNeighbours
{
public:

    using real = typename P::real;

    SphNeighbours(SphParts<Backend, D, P>& parts, FluidPasses<Backend, D, P>& fluid,
        WallPasses<Backend, D, P>& walls, SolidCoupling<Backend, D, P>& solids)
        : p_(parts), fluid_(fluid), walls_(walls), solids_(solids)
    {}

    //- Sort the fluid into cells and find neighbours
    void rebuild();

    //- A rebuild between two calls of advance. Recorded cycles hold an even number of them: two, so
    //  that pointers are as recorded
    void sortNow();

    //- On the GPU fluid's way is measured against what is around it, and walls are listed from
    //  farther away
    void setFrames();
    void allocateLists();

    //- Room for the lists that did not fit, half as much again as was needed
    void growLists();

    //- Several ranks: memory for what is here, and some more
    void fitCapacity();

    //- Several ranks: memory for so many
    void setCapacity(int n);

private:

    void agreeOnSearch();
    void settleFrames();
    void allocateListMemory();
    template<class List> int roomFor(const List&, int capacity) const;
    SearchReach<real> fluidReach() const;
    void buildLists();
    void findRanges();

    // GPU: what lists of walls reach beyond the support, of it
    static constexpr double wallSkin = D == 2 ? 0.5 : 0.2;

    SphParts<Backend, D, P>& p_;
    FluidPasses<Backend, D, P>& fluid_;
    WallPasses<Backend, D, P>& walls_;
    SolidCoupling<Backend, D, P>& solids_;
};

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::rebuild()
{
    FluidKeys<D, P> keys;
    keys.box = p_.set.box;
    keys.grid = p_.set.grid;
    keys.model = p_.set.model;
    for (int d = 0; d < D; ++d)
        keys.x[d] = p_.fluid.values.template data<std::int64_t>(p_.fluid.at.x + d);
    keys.keys = p_.fluid.sort.keys();
    keys.indices = p_.fluid.sort.indices();
    keys.id = p_.fluid.values.template data<std::int32_t>(p_.fluid.at.id);
    keys.active = p_.fluid.sort.active();
    keys.clock = p_.clock.data();
    forEach(p_.set.context, p_.fluid.n, keys);
    if (p_.ranks)
        p_.ranks->migrate([this](int n) { setCapacity(n); });
    p_.fluid.sort.sort(p_.set.context, p_.fluid.n);
    p_.fluid.values.permute(p_.set.context, p_.fluid.sort.order(), p_.fluid.n);
    if (p_.ranks) p_.ranks->settle(p_.fluid.active());
    if constexpr (Backend::gpu) p_.memory.frames.clear(p_.set.context);
    forEach(p_.set.context, p_.fluid.n, fluid_.template mover<PlaceFluid<Backend, D, P>>());
    if (p_.walls.bodies) walls_.place();
    if (p_.wallRanks) p_.wallRanks->settle();
    if (p_.solids.side) solids_.sort();
    if (p_.ranks) agreeOnSearch();
    settleFrames();
    if (p_.solids.side) solids_.findFluid();
    buildLists();
    // sorted walls need their pressures anew; and a first pass that sees them has those of the
    // state at hand, so that a restart does too
    if (p_.walls.bodies || integratorOf(p_.set.config).seesWallsFirst)
        walls_.extrapolate(false);
    solids_.pressurePass(false);
    if (p_.ranks) p_.ranks->agree(p_.clock, p_.interrupted);
}

//- On the GPU: how far lists reach, and how fast water is about each place, of all ranks
template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::agreeOnSearch()
{
    if constexpr (Backend::gpu)
    {
        if (p_.set.config.variableSmoothing) p_.ranks->agreeOnH(p_.clock);
        if (!p_.memory.frames.on()) return;
        std::vector<int> bounds = p_.memory.frames.bounds();
        leastOfRanks(*p_.set.config.ranks, bounds, 2*D, LocalFrames<D, P>::unset);
        p_.memory.frames.setBounds(p_.set.context, bounds);
    }
}

//- How far particles may go, now that they and the walls are in their places
template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::settleFrames()
{
    if constexpr (Backend::gpu)
    {
        if (!p_.memory.frames.on()) return;
        const double support = p_.set.grid.radius - 2*double(p_.set.allowedWay),
                     alongWalls = double(p_.memory.wallRadius) - support;
        p_.memory.frames.settle(p_.set.context, 0.5*(p_.memory.frames.width() - support),
            p_.walls.bodies ? 0.5*alongWalls : alongWalls);
    }
}

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::sortNow()
{
    rebuild();
    if constexpr (Backend::gpu) rebuild();
}

//- Where h varies lists reach as far as the largest h there is, not as its limit: of two hundredths
//  more, so that they last
template<class Backend, int D, class P>
SearchReach<typename P::real> SphNeighbours<Backend, D, P>::fluidReach() const
{
    if (!p_.set.config.variableSmoothing) return {};
    return {&p_.clock.data()->foundH, ClockData::growthOfH, float(p_.set.model.hMax),
        p_.set.pairReach(0), reachOfH<real>(p_.set.config)};
}

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::buildLists()
{
    if constexpr (Backend::gpu)
    {
        const auto fluid = p_.fluid.records.view();
        const Box<D, P>& box = p_.set.box;
        const CellGrid<D, P>& grid = p_.set.grid;
        int* overflow = p_.clock.data()->overflow;
        p_.memory.fluidFluid.build(p_.set.context, box, grid, grid.radius, fluid, fluid,
            p_.fluid.sort.start(), p_.fluid.sort.active(), true, overflow, "listFluid",
            fluidReach(), p_.ghosts());
        if (p_.solids.meetFluid)
        {
            const auto solid = p_.solids.records.view();
            p_.memory.fluidSolid.build(p_.set.context, box, grid, grid.radius, fluid, solid,
                p_.solids.sort.start(), p_.fluid.sort.active(), false, overflow + 3,
                "listFluidSolid", {}, p_.ghosts());
            p_.memory.solidFluid.build(p_.set.context, box, grid, grid.radius, solid, fluid,
                p_.fluid.sort.start(), p_.solids.sort.active(), false, overflow + 4,
                "listSolidFluid", {}, p_.solidGhosts());
        }
        if (!p_.walls.count) return;
        const auto wall = p_.walls.records.view();
        p_.memory.fluidWall.build(p_.set.context, box, grid, p_.memory.wallRadius, fluid, wall,
            p_.walls.sort.start(), p_.fluid.sort.active(), false, overflow + 1, "listFluidWall",
            {}, p_.ghosts());
        if (p_.set.wallsFollowFluid() || p_.walls.bodies)
            p_.memory.wallFluid.build(p_.set.context, box, grid, p_.memory.wallRadius, wall, fluid,
                p_.fluid.sort.start(), p_.walls.sort.active(), false, overflow + 2,
                "listWallFluid", {}, p_.wallGhosts());
    }
#ifndef __CUDACC__
    else findRanges();
#endif
}

#ifndef __CUDACC__
template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::findRanges()
{
    const auto find = [this](FoundRanges& to, const auto& targets, int n, const auto& set,
                          const GhostMarks<Backend>& ghosts)
    {
        to.find(p_.set.context, p_.set.box, p_.set.grid, targets, n, set.start(), ghosts);
    };
    const auto fluid = p_.fluid.records.view();
    const int n = *p_.fluid.sort.active();
    find(p_.memory.fluidFluid, fluid, n, p_.fluid.sort, p_.ghosts());
    if (p_.walls.count)
    {
        find(p_.memory.fluidWall, fluid, n, p_.walls.sort, p_.ghosts());
        if (p_.set.wallsFollowFluid() || p_.walls.bodies)
            find(p_.memory.wallFluid, p_.walls.records.view(), p_.walls.count, p_.fluid.sort,
                p_.wallGhosts());
    }
    if (!p_.solids.meetFluid) return;
    find(p_.memory.fluidSolid, fluid, n, p_.solids.sort, p_.ghosts());
    find(p_.memory.solidFluid, p_.solids.records.view(), *p_.solids.sort.active(), p_.fluid.sort,
        p_.solidGhosts());
}
#endif

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::allocateLists()
{
    if constexpr (Backend::gpu)
    {
        // threads a particle, so that small scenes fill the machine
        const auto shiftOf = [](int n)
        { return n <= 24000 ? 3 : (n <= 200000 ? 2 : (n <= 500000 ? 1 : 0)); };
        p_.shift = shiftOf(p_.fluid.n);
        if (p_.solids.side) p_.memory.solidShift = shiftOf(p_.solids.count);
        allocateListMemory();
    }
}

//- Memory of lists, for particles that there is memory for
template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::allocateListMemory()
{
    if constexpr (Backend::gpu)
    {
        const FluidModel<D, P>& model = p_.set.model;
        const double pi = 3.14159265358979323846,
                     h = std::min(1.5*double(ClockData::growthOfH)*model.h0 + model.h0,
                         double(model.hMax));
        const double r = p_.set.config.variableSmoothing ? double(p_.set.pairReach(float(h)))
                                                         : double(p_.set.grid.radius);
        const double sphere = D == 2 ? pi*r*r : 4*pi*r*r*r/3;
        const int lanes = 1 << p_.shift;
        const int fluidNeighbours = int(1.4*sphere/std::pow(p_.set.config.spacing, D)) + 8;
        const int capacity = (fluidNeighbours/lanes*(lanes > 1 ? 3 : 2)/2 + 7)/4 + 1;
        p_.memory.fluidFluid.allocate(p_.set.context, p_.fluid.n, p_.shift, false,
            roomFor(p_.memory.fluidFluid, capacity));
        if (p_.solids.side)
        {
            // grown when they do not fit
            const long long warps = ((long long)p_.solids.count << p_.shift)/32 + 1;
            p_.memory.fluidSolid.allocate(
                p_.set.context, p_.fluid.n, p_.shift, true,
                roomFor(p_.memory.fluidSolid, int(warps*capacity + 256)));
            p_.memory.solidFluid.allocate(p_.set.context, p_.solids.count, p_.memory.solidShift,
                true, roomFor(p_.memory.solidFluid, int(warps*capacity/2 + 256)));
        }
        if (p_.walls.count)
        {
            const int wallBlocks = int(0.1*sphere*std::pow(p_.memory.wallRadius/r, D)
                                       /std::pow(p_.set.config.wallSpacing, D)/lanes)
                + 1;
            const long long warps = ((long long)p_.fluid.n << p_.shift)/32 + 1,
                            wallWarps = ((long long)p_.walls.count << p_.shift)/32 + 1;
            p_.memory.fluidWall.allocate(p_.set.context, p_.fluid.n, p_.shift, true,
                roomFor(p_.memory.fluidWall,
                    int(std::min(warps, 3*wallWarps)*wallBlocks/2 + 256)));
            if (p_.set.wallsFollowFluid() || p_.walls.bodies)
                p_.memory.wallFluid.allocate(p_.set.context, p_.walls.count, p_.shift, true,
                    roomFor(p_.memory.wallFluid, int(wallWarps*capacity/4 + 256)));
        }
    }
}

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::growLists()
{
    if constexpr (Backend::gpu)
    {
        ClockData& now = p_.clock.now;
        const auto grown = [](int needed) { return needed + needed/2 + 1; };
        if (now.overflow[0])
            p_.memory.fluidFluid.allocate(
                p_.set.context, p_.fluid.n, p_.shift, false, grown(now.overflow[0]));
        if (now.overflow[1])
            p_.memory.fluidWall.allocate(
                p_.set.context, p_.fluid.n, p_.shift, true, grown(now.overflow[1]));
        if (now.overflow[2])
            p_.memory.wallFluid.allocate(
                p_.set.context, p_.walls.count, p_.shift, true, grown(now.overflow[2]));
        if (now.overflow[3])
            p_.memory.fluidSolid.allocate(
                p_.set.context, p_.fluid.n, p_.shift, true, grown(now.overflow[3]));
        if (now.overflow[4])
            p_.memory.solidFluid.allocate(p_.set.context, p_.solids.count, p_.memory.solidShift,
                true, grown(now.overflow[4]));
        p_.memory.graphs.forget();
        for (int& o : now.overflow) o = 0;
        p_.clock.write();
    }
}

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::setFrames()
{
    p_.walls.allowedWay = p_.set.allowedWay;
    double farthest = p_.set.grid.radius;
    if constexpr (Backend::gpu)
    {
        const double skin = 2*double(p_.set.allowedWay), radius = p_.set.grid.radius,
                     support = radius - skin;
        p_.memory.wallRadius = p_.set.grid.radius;
        double reach = support + std::max(skin, wallSkin*support);
        for (int d = 0; d < D; ++d)
            if (p_.set.box.periodic[d] && p_.set.box.length[d] < 4*reach) reach = radius;
        p_.memory.wallRadius = real(reach);
        if (p_.walls.bodies) p_.walls.allowedWay = real(0.5*(reach - support));
        p_.memory.frames.set(p_.set.context, p_.set.box, 2*radius, 2e6);
        farthest = std::max(farthest, reach);
    }
    if (p_.ranks) p_.ranks->setReach(farthest, double(p_.set.allowedWay));
}

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::fitCapacity()
{
    if constexpr (Backend::gpu)
        for (auto* list : {&p_.memory.fluidFluid, &p_.memory.fluidWall, &p_.memory.wallFluid,
                 &p_.memory.fluidSolid, &p_.memory.solidFluid})
            *list = std::decay_t<decltype(*list)>();
    setCapacity(p_.ranks->room());
    rebuild();
}

template<class Backend, int D, class P>
void SphNeighbours<Backend, D, P>::setCapacity(int n)
{
    p_.fluid.setCapacity(n, p_.ranks->particles().residents());
    if (p_.solids.side) p_.solids.allocateAction(p_.fluid.n);
    allocateListMemory();
}

//- Of a list that has grown; on several ranks what it has grown to holds
template<class Backend, int D, class P>
template<class List>
int SphNeighbours<Backend, D, P>::roomFor(const List& list, int capacity) const
{
    return p_.ranks ? std::max(capacity, list.capacity()) : capacity;
}

} // namespace riprap
