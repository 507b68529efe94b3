/*  DemSolver: the parts of a step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
template<class M>
void DemSolver<Backend, D, P>::setMotion(M& m)
{
    m.fields = p_.particles.view();
    m.groups = p_.groups.data();
    for (int d = 0; d < D; ++d) m.gravity[d] = real(p_.set.config.gravity[p_.set.config.axes[d]]);
    m.external = p_.particles.externalForces();
    m.clock = p_.clock.data();
    m.active = p_.order.sort.active();
}

template<class Backend, int D, class P>
MoveSolids<D, P> DemSolver<Backend, D, P>::mover()
{
    MoveSolids<D, P> m{};
    setMotion(m);
    m.box = p_.set.box;
    m.solids = p_.order.records.view();
    m.verlet = p_.set.config.integrator == DemIntegratorKind::velocityVerlet;
    for (int d = 0; d < D; ++d)
    {
        m.reference[d] = p_.order.reference.data() + std::size_t(d)*p_.particles.n;
        m.domainMin[d] = p_.reach.domainMin[d];
        m.domainMax[d] = p_.reach.domainMax[d];
    }
    if constexpr (Backend::gpu) m.frames = p_.memory.frames.view();
    m.halfSkin = p_.reach.halfSkin;
    m.suddenWay = p_.reach.suddenWay;
    m.motions = p_.motion.groupTable();
    m.clumps = p_.clumps.count() ? p_.clumps.data() : nullptr;
    m.offset = p_.clumps.offset().data();
    // paper 2's spring goes with the mass of its particles
    NormalLaws::at(p_.set.laws.normal, [&](auto law) { m.sharesMass = p_.clumps.count() && !decltype(law)::type::stiffnessByMass; });
    return m;
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::setModel(PairModel<Backend, D, P, Law>& m)
{
    m.box = p_.set.box;
    m.solids = p_.order.records.view();
    m.list = p_.order.list.view();
    p_.pairs.give(m);
    m.clock = forceClock(ForceTurn::always);
    m.active = p_.order.sort.active();
}

template<class Backend, int D, class P>
ForceClock DemSolver<Backend, D, P>::forceClock(ForceTurn turn)
{
    if constexpr (Backend::gpu)
        if (turn == ForceTurn::ahead) return ForceClock{p_.clock.data() + p_.memory.current, p_.clock.data() + 1 - p_.memory.current, turn};
    return ForceClock{p_.clock.data(), p_.clock.data(), turn};
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::contactPass(ForceTurn turn)
{
    if constexpr (Backend::gpu)
    {
        GatherPass<Backend, D, P, Law> pass;
        setModel(pass);
        pass.clock = forceClock(turn);
        pass.fields = p_.particles.view();
        pass.largestGap = real(p_.pairs.largestGap());
        forEach(p_.set.context, p_.particles.n, pass);
    }
#ifndef __CUDACC__
    else
    {
        ScatterPass<D, P, Law> pass;
        setModel(pass);
        pass.clock = forceClock(turn);
        pass.deferred = &p_.memory.deferred;
        pass.sums = p_.memory.sums.data();
        pass.largestGap = real(p_.pairs.largestGap());
        forEachTask(p_.set.context, p_.memory.deferred.blocks, pass);
    }
#endif
}

template<class Backend, int D, class P>
template<class Law>
WallPass<D, P, Law> DemSolver<Backend, D, P>::wallKernel(ForceTurn turn)
{
    WallPass<D, P, Law> pass{};
    pass.box = p_.set.box;
    pass.fields = p_.particles.view();
    pass.walls = p_.walls.walls.data();
    pass.wallCount = p_.walls.count;
    pass.surface = p_.walls.surface();
    pass.reach = wallReach();
    pass.active = p_.order.sort.active();
    pass.solids = p_.order.records.view();
    pass.memory = p_.walls.view();
    pass.parameters = p_.pairs.template parameters<Law>();
    pass.gap = p_.pairs.gaps();
    pass.materials = p_.pairs.materials();
    pass.clock = forceClock(turn);
    pass.adds = Backend::gpu && turn != ForceTurn::ahead;
    pass.skipsAsleep = !Backend::gpu;
    pass.passed = p_.walls.passed.data();
    if constexpr (Backend::gpu)
    {
        if (turn == ForceTurn::ahead)
        {
            pass.state = stepState();
            pass.solids = pass.state.from;
        }
        // as many threads as there is room for: recorded launches stay what they are while numbers change
        pass.listed = p_.memory.wallList.data();
        pass.listedCount = p_.memory.wallListFirst.data() + p_.particles.n;
    }
    return pass;
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::wallPass(ForceTurn turn)
{
    int near = p_.particles.n;
    if constexpr (Backend::gpu) near = int(p_.memory.wallList.size());
    forEach(p_.set.context, near, wallKernel<Law>(turn));
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::bondPass(ForceTurn turn)
{
    BondPass<D, P> pass{p_.bonds.view(p_.order.slotOf.data()), p_.set.box, p_.particles.view(), p_.order.records.view(), forceClock(turn), {}};
    if constexpr (Backend::gpu)
        if (turn == ForceTurn::ahead)
        {
            pass.state = stepState();
            pass.solids = pass.state.from;
        }
    if constexpr (Backend::gpu) forEachBlock(p_.set.context, (p_.bonds.count() + BondBlocks<D, P>::threads - 1)/BondBlocks<D, P>::threads, BondBlocks<D, P>{pass});
    else forEach(p_.set.context, p_.bonds.count(), pass);
}

//- All forces at the positions at hand
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::forces(ForceTurn turn)
{
    withLaw(p_.set.laws, [&](auto law)
    {
        contactPass<decltype(law)>(turn);
        if (p_.walls.count && p_.walls.memory.entries) wallPass<decltype(law)>(turn);
    });
    if (p_.bonds.count())
    {
        bondPass(turn);
        if constexpr (Backend::gpu)
            forEach(p_.set.context, p_.particles.n, GatherBonds<D, P>{p_.bonds.table(), p_.bonds.force(), p_.particles.view(), forceClock(turn), p_.order.sort.active()});
    }
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        p_.memory.uncollected = true;
        if (!movesAtOnce()) collectForces();
    }
#endif
    p_.clumps.gather(p_.clock.data(), p_.order.slotOf.data());
}

//- On the CPU: where a step moves particles as it adds up their forces
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::movesAtOnce() const
{ return !Backend::gpu && !p_.clumps.count() && p_.set.config.integrator == DemIntegratorKind::leapfrog; }

#ifndef __CUDACC__
template<class Backend, int D, class P>
CollectedForce<D, P> DemSolver<Backend, D, P>::collected()
{
    const bool walls = p_.walls.count && p_.walls.memory.entries;
    return CollectedForce<D, P>
    {
        &p_.memory.deferred, p_.memory.sums.data(), walls ? p_.walls.memory.entryFirst.data() : nullptr, p_.walls.memory.force.data(), p_.bonds.table(),
        p_.bonds.force(), p_.particles.view().id
    };
}
#endif

//- On the CPU: forces into the fields, where they are not yet
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::collectForces()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        if (p_.memory.uncollected) forEach(p_.set.context, p_.particles.n, CollectForces<D, P>{collected(), p_.particles.view(), p_.order.sort.active()});
        p_.memory.uncollected = false;
    }
#endif
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::moveParticles()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
        if (p_.memory.uncollected)
        {
            forEach(p_.set.context, p_.particles.n, MoveCollected<D, P>{collected(), mover()});
            p_.memory.uncollected = false;
            return;
        }
#endif
    forEach(p_.set.context, p_.particles.n, mover());
}

template<class Backend, int D, class P>
MoveWalls DemSolver<Backend, D, P>::wallMover(DemClockData* clock)
{ return MoveWalls{p_.walls.walls.data(), p_.motion.wallTable(), clock, clock, double(p_.reach.halfSkin), p_.reach.radii.smallest}; }

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::step()
{
    forEach(p_.set.context, 1, DemTick{p_.clock.data()});
    if constexpr (!Backend::gpu) if (!p_.clock.data()->active) return;
    if (p_.motion.walls()) forEach(p_.set.context, p_.walls.count, wallMover(p_.clock.data()));
    const bool verlet = p_.set.config.integrator == DemIntegratorKind::velocityVerlet;
    if (p_.clumps.count()) forEach(p_.set.context, p_.clumps.count(), MoveClumps<D, P>{p_.clumps.data(), p_.clumps.kick(), verlet, p_.clock.data()});
    moveParticles();
    if (others_) shareStep();
    if constexpr (!Backend::gpu) if (p_.clock.data()->lost() && p_.clock.data()->halt == DemHalt::none) searchWithin();
    finishStep();
}

//- What a step does where its particles have come to
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::finishStep()
{
    forces();
    if (p_.set.config.integrator != DemIntegratorKind::velocityVerlet) return;
    FinishVerlet<D, P> finish{};
    setMotion(finish);
    finish.clumps = p_.clumps.count();
    forEach(p_.set.context, p_.particles.n, finish);
    if (p_.clumps.count()) forEach(p_.set.context, p_.clumps.count(), FinishClumps<D, P>{p_.clumps.data(), p_.clumps.kick(), p_.clock.data()});
}

//- A step has carried a particle farther than lists hold: new ones before its forces
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::searchWithin()
{
    adaptSkin();
    rebuild();
    ++searchesWithin_;
}

//- On the GPU, whose steps follow one another without the host: the forces that the last one waits with
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::finishLate()
{
    searchWithin();
    p_.clock.read();
    p_.clock.now.active = 1;
    p_.clock.write();
    finishStep();
    p_.clock.read();
    p_.clock.now.active = 0;
    p_.clock.write();
}

//- To the target or the last step; one at least
template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::stepsLeft() const
{
    const double left = std::min(double(p_.clock.now.lastStep - p_.clock.now.step), std::ceil((p_.clock.now.target - p_.clock.now.time)/p_.clock.now.fullDt*(1 - 1e-9)));
    return int(std::max(1.0, std::min(left, double(p_.motion.windowSteps))));
}

//- On the GPU: is one block enough for a step?
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::fitsBlock() const
{
    if constexpr (!Backend::gpu) return false;
    else return p_.set.config.integrator == DemIntegratorKind::velocityVerlet && !p_.clumps.count() && !p_.motion.walls() && p_.particles.n <= BlockLimits::particles
      && p_.bonds.count() <= BlockLimits::bonds && (!p_.walls.memory.entries || int(p_.memory.wallList.size()) <= BlockLimits::nearWalls);
}

template<class Backend, int D, class P>
template<class Law>
BlockSteps<Backend, D, P, Law> DemSolver<Backend, D, P>::blockSteps(int count)
{
    BlockSteps<Backend, D, P, Law> b{};
    b.tick = DemTick{p_.clock.data()};
    b.move = mover();
    setModel(b.contacts);
    b.contacts.clock = forceClock(ForceTurn::inStep);
    b.contacts.fields = p_.particles.view();
    b.contacts.largestGap = real(p_.pairs.largestGap());
    b.n = p_.particles.n;
    if (p_.walls.count && p_.walls.memory.entries)
    {
        b.walls = wallKernel<Law>(ForceTurn::inStep);
        if constexpr (Backend::gpu) b.nearWalls = int(p_.memory.wallList.size());
    }
    if (p_.bonds.count())
    {
        b.bonds = BondPass<D, P>{p_.bonds.view(p_.order.slotOf.data()), p_.set.box, p_.particles.view(), p_.order.records.view(), forceClock(ForceTurn::inStep), {}};
        b.gather = GatherBonds<D, P>{p_.bonds.table(), p_.bonds.force(), p_.particles.view(), forceClock(ForceTurn::inStep), p_.order.sort.active()};
        b.bondCount = p_.bonds.count();
    }
    setMotion(b.finish);
    b.steps = count;
    return b;
}

//- So many steps; those beyond the next rebuild, window or target switch themselves off. In small scenes the host's launches would take longer than the
//  steps: they are recorded, eight at a time, and where one block is enough they are one launch
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::steps(int count)
{
#ifdef __CUDACC__
    if constexpr (std::is_same<Backend, Gpu>::value)
    {
        if (fitsBlock() && !p_.set.context.profile.timing)
        {
            withLaw(p_.set.laws, [&](auto law) { oneBlock<BlockLimits::threads>(p_.set.context, blockSteps<decltype(law)>(count)); });
            return;
        }
        const int together = 8;
        // motion tables change from window to window, and the fields of large scenes from sort to sort
        if (!p_.set.context.profile.timing && !p_.motion.groups() && !p_.motion.walls() && p_.particles.values.alternates())
            for (; count >= together/2; count -= together)
            {
                if (p_.memory.graphs.size() > 16) p_.memory.graphs.clear();
                std::vector<const void*> key = graphKey(together);
                key.push_back(p_.particles.view().x[0]);       // fields alternate between two places
                Graph& graph = p_.memory.graphs[key];
                if (!graph.recorded()) graph.record(p_.set.context, [&] { for (int k = 0; k < together; ++k) step(); });
                graph.replay(p_.set.context);
            }
    }
#endif
    for (; count > 0; --count) step();
}

} // namespace riprap
