/*  What a scene of solids consists of. Its parts know what they are made from; what the solver does
    with them is in solvers/dem/driver.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <atomic>
#include <map>
#include "core/backend/asyncReadback.hpp"
#include "core/backend/graph.hpp"
#include "core/loops/reduceMax.hpp"
#include "dem/lists/sortByWork.hpp"
#include "dem/passes/collectPass.hpp"
#include "dem/passes/fusedStep.hpp"
#include "solvers/dem/demStill.hpp"
#include "solvers/dem/parts/bonds.hpp"
#include "solvers/dem/parts/clumps.hpp"
#include "solvers/dem/parts/pairTable.hpp"
#include "solvers/dem/parts/prescribedMotion.hpp"
#include "solvers/dem/parts/searchReach.hpp"
#include "solvers/dem/parts/solidOrder.hpp"
#include "solvers/dem/parts/walls.hpp"

namespace riprap
{

//- What only one backend has: for GPUs what fused steps and their rebuilds need
template<class Backend, int D, class P>
struct BackendMemory
{
    using real = typename P::real;

    SolidRecordMemory<Backend, D, P> records;       // the second ones
    Array<Backend, LowWords<P>> low;
    Array<Backend, OwnWords<real>> own;
    // of particles in the order of cells
    Array<Backend, int> place, found, foundNear, foundWalls, foundElements, cost;
    Array<Backend, std::uint32_t> order;
    Array<Backend, int> nearCount, keptFirst, keptPartner, wallListFirst, wallList, totals;
    Array<Backend, real> keptHistory;
    LocalFrameMemory<Backend, D, P> frames;         // of fused steps
    // records and clock that the next step begins with
    int current = 0;
    AsyncReadback<Backend, DemClockData> readback;
    // forces are not yet those of the positions at hand
    bool moved = false;

#ifdef __CUDACC__
    LargestAhead speed;
    std::map<std::vector<const void*>, Graph> graphs;
#endif
};

#ifndef __CUDACC__
template<int D, class P>
struct BackendMemory<Cpu, D, P>
{
    DeferredForces<D, typename P::real> deferred;
    Array<Cpu, typename P::real> sums;
    bool uncollected = false;                       // forces are not yet in the fields
};
#endif

template<class Backend, int D, class P>
struct DemParts
{
    DemSetting<Backend, D, P> set;
    SceneClock<Backend> clock{set.context};
    ParticleFields<Backend, D, P> particles;
    PairTable<Backend, D, P> pairs{set};
    SolidGroups<Backend, D, P> groups{set};
    PrescribedMotion<Backend, D, P> motion{set};
    Bonds<Backend, D, P> bonds{set, particles};
    Clumps<Backend, D, P> clumps{set, particles, groups};
    Walls<Backend, D, P> walls{set};
    SearchReach<Backend, D, P> reach{set, pairs};
    SolidOrder<Backend, D, P> order{set};
    BackendMemory<Backend, D, P> memory;
    bool still;                 // nothing can move
    std::atomic<bool> interrupted{false};

    DemParts(const DemConfig& config, const DemInput& in, const DemPlan& plan)
    :
        set(config, in, plan), particles(set, int(in.particles.size())), still(isStill(in))
    {}

    DemParts(const DemParts&) = delete;

    bool sleeps() const { return set.config.sleepSpeed > 0; }

    //- Do dashpots of members of bodies take the body's mass (clumpState.hpp)? Paper 2's spring
    //  goes with the mass of its particles
    bool sharesMass() const
    {
        bool shares = false;
        NormalLaws::at(set.laws.normal,
            [&](auto law) { shares = clumps.any() && !decltype(law)::type::stiffnessByMass; });
        return shares;
    }

    //- Are steps fused (GPU)? Clumps gather their members' forces first, and Verlet kicks twice
    bool fuses() const
    {
        return Backend::gpu && !clumps.any() && !set.integrator.kicksTwice;
    }

    //- Has the device come to the target, the last step, or to a guard?
    bool over() const
    {
        return clock.now.halt != DemHalt::none || clock.now.time >= clock.now.target
            || clock.now.step >= clock.now.lastStep;
    }

    //- Which particle goes where in a rebuild
    const std::uint32_t* newOrder() const
    {
        if constexpr (Backend::gpu) return memory.order.data();
        else return order.sort.order();
    }
};

} // namespace riprap
