/*  DemSolver: the parts of a step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
WallMemory<D, typename P::real> DemSolver<Backend, D, P>::wallMemory(WallMemoryArrays<Backend, real>& m)
{
    return WallMemory<D, real>
    {
        m.entryFirst.data(), m.entry.data(), m.element.data(), m.on.data(), m.normal.data(), m.history.data(), m.force.data()
    };
}

template<class Backend, int D, class P>
SurfaceView<D> DemSolver<Backend, D, P>::surface()
{
    return SurfaceView<D>
    {vertices_.data(), elements_.data(), sharedFirst_.data(), shared_.data(), cellFirst_.data(), cellElement_.data()};
}

template<class Backend, int D, class P>
template<class M>
void DemSolver<Backend, D, P>::setMotion(M& m)
{
    m.fields = particles_.view();
    m.groups = groups_.data();
    for (int d = 0; d < D; ++d) m.gravity[d] = real(set_.config.gravity[set_.config.axes[d]]);
    m.external = particles_.externalForces();
    m.clock = clock_.data();
    m.active = sort_.active();
}

template<class Backend, int D, class P>
MoveSolids<D, P> DemSolver<Backend, D, P>::mover()
{
    MoveSolids<D, P> m{};
    setMotion(m);
    m.box = set_.box;
    m.solids = records_.view();
    m.verlet = set_.config.integrator == DemIntegratorKind::velocityVerlet;
    for (int d = 0; d < D; ++d)
    {
        m.reference[d] = reference_.data() + std::size_t(d)*particles_.n;
        m.domainMin[d] = domainMin_[d];
        m.domainMax[d] = domainMax_[d];
    }
    if constexpr (Backend::gpu) m.frames = parts_.frames.view();
    m.halfSkin = halfSkin_;
    m.suddenWay = suddenWay_;
    m.motions = motion_.groupTable();
    m.clumps = clumps_.count() ? clumps_.data() : nullptr;
    m.offset = clumps_.offset().data();
    // paper 2's spring goes with the mass of its particles
    NormalLaws::at(set_.laws.normal, [&](auto law) { m.sharesMass = clumps_.count() && !decltype(law)::type::stiffnessByMass; });
    return m;
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::setModel(PairModel<Backend, D, P, Law>& m)
{
    m.box = set_.box;
    m.solids = records_.view();
    m.list = list_.view();
    pairs_.give(m);
    m.clock = forceClock(ForceTurn::always);
    m.active = sort_.active();
}

template<class Backend, int D, class P>
ForceClock DemSolver<Backend, D, P>::forceClock(ForceTurn turn)
{
    if constexpr (Backend::gpu)
        if (turn == ForceTurn::ahead) return ForceClock{clock_.data() + parts_.current, clock_.data() + 1 - parts_.current, turn};
    return ForceClock{clock_.data(), clock_.data(), turn};
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
        pass.fields = particles_.view();
        pass.largestGap = real(pairs_.largestGap());
        forEach(set_.context, particles_.n, pass);
    }
#ifndef __CUDACC__
    else
    {
        ScatterPass<D, P, Law> pass;
        setModel(pass);
        pass.clock = forceClock(turn);
        pass.deferred = &parts_.deferred;
        pass.sums = parts_.sums.data();
        pass.largestGap = real(pairs_.largestGap());
        forEachTask(set_.context, parts_.deferred.blocks, pass);
    }
#endif
}

template<class Backend, int D, class P>
template<class Law>
WallPass<D, P, Law> DemSolver<Backend, D, P>::wallKernel(ForceTurn turn)
{
    WallPass<D, P, Law> pass{};
    pass.box = set_.box;
    pass.fields = particles_.view();
    pass.walls = walls_.data();
    pass.wallCount = nWalls_;
    pass.surface = surface();
    pass.reach = wallReach();
    pass.active = sort_.active();
    pass.solids = records_.view();
    pass.memory = wallMemory(wallMemory_);
    pass.parameters = pairs_.template parameters<Law>();
    pass.gap = pairs_.gaps();
    pass.materials = pairs_.materials();
    pass.clock = forceClock(turn);
    pass.adds = Backend::gpu && turn != ForceTurn::ahead;
    pass.skipsAsleep = !Backend::gpu;
    pass.passed = passed_.data();
    if constexpr (Backend::gpu)
    {
        if (turn == ForceTurn::ahead)
        {
            pass.state = stepState();
            pass.solids = pass.state.from;
        }
        // as many threads as there is room for: recorded launches stay what they are while numbers change
        pass.listed = parts_.wallList.data();
        pass.listedCount = parts_.wallListFirst.data() + particles_.n;
    }
    return pass;
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::wallPass(ForceTurn turn)
{
    int near = particles_.n;
    if constexpr (Backend::gpu) near = int(parts_.wallList.size());
    forEach(set_.context, near, wallKernel<Law>(turn));
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::bondPass(ForceTurn turn)
{
    BondPass<D, P> pass{bonds_.view(slotOf_.data()), set_.box, particles_.view(), records_.view(), forceClock(turn), {}};
    if constexpr (Backend::gpu)
        if (turn == ForceTurn::ahead)
        {
            pass.state = stepState();
            pass.solids = pass.state.from;
        }
    if constexpr (Backend::gpu) forEachBlock(set_.context, (bonds_.count() + BondBlocks<D, P>::threads - 1)/BondBlocks<D, P>::threads, BondBlocks<D, P>{pass});
    else forEach(set_.context, bonds_.count(), pass);
}

//- All forces at the positions at hand
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::forces(ForceTurn turn)
{
    withLaw(set_.laws, [&](auto law)
    {
        contactPass<decltype(law)>(turn);
        if (nWalls_ && wallMemory_.entries) wallPass<decltype(law)>(turn);
    });
    if (bonds_.count())
    {
        bondPass(turn);
        if constexpr (Backend::gpu)
            forEach(set_.context, particles_.n, GatherBonds<D, P>{bonds_.table(), bonds_.force(), particles_.view(), forceClock(turn), sort_.active()});
    }
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        parts_.uncollected = true;
        if (!movesAtOnce()) collectForces();
    }
#endif
    clumps_.gather(clock_.data(), slotOf_.data());
}

//- On the CPU: where a step moves particles as it adds up their forces
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::movesAtOnce() const
{ return !Backend::gpu && !clumps_.count() && set_.config.integrator == DemIntegratorKind::leapfrog; }

#ifndef __CUDACC__
template<class Backend, int D, class P>
CollectedForce<D, P> DemSolver<Backend, D, P>::collected()
{
    const bool walls = nWalls_ && wallMemory_.entries;
    return CollectedForce<D, P>
    {
        &parts_.deferred, parts_.sums.data(), walls ? wallMemory_.entryFirst.data() : nullptr, wallMemory_.force.data(), bonds_.table(),
        bonds_.force(), particles_.view().id
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
        if (parts_.uncollected) forEach(set_.context, particles_.n, CollectForces<D, P>{collected(), particles_.view(), sort_.active()});
        parts_.uncollected = false;
    }
#endif
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::moveParticles()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
        if (parts_.uncollected)
        {
            forEach(set_.context, particles_.n, MoveCollected<D, P>{collected(), mover()});
            parts_.uncollected = false;
            return;
        }
#endif
    forEach(set_.context, particles_.n, mover());
}

template<class Backend, int D, class P>
MoveWalls DemSolver<Backend, D, P>::wallMover(DemClockData* clock)
{ return MoveWalls{walls_.data(), motion_.wallTable(), clock, clock, double(halfSkin_), radii_.smallest}; }

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::step()
{
    forEach(set_.context, 1, DemTick{clock_.data()});
    if constexpr (!Backend::gpu) if (!clock_.data()->active) return;
    if (motion_.walls()) forEach(set_.context, nWalls_, wallMover(clock_.data()));
    const bool verlet = set_.config.integrator == DemIntegratorKind::velocityVerlet;
    if (clumps_.count()) forEach(set_.context, clumps_.count(), MoveClumps<D, P>{clumps_.data(), clumps_.kick(), verlet, clock_.data()});
    moveParticles();
    if (others_) shareStep();
    if constexpr (!Backend::gpu) if (clock_.data()->lost() && clock_.data()->halt == DemHalt::none) searchWithin();
    finishStep();
}

//- What a step does where its particles have come to
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::finishStep()
{
    forces();
    if (set_.config.integrator != DemIntegratorKind::velocityVerlet) return;
    FinishVerlet<D, P> finish{};
    setMotion(finish);
    finish.clumps = clumps_.count();
    forEach(set_.context, particles_.n, finish);
    if (clumps_.count()) forEach(set_.context, clumps_.count(), FinishClumps<D, P>{clumps_.data(), clumps_.kick(), clock_.data()});
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
    clock_.read();
    clock_.now.active = 1;
    clock_.write();
    finishStep();
    clock_.read();
    clock_.now.active = 0;
    clock_.write();
}

//- To the target or the last step; one at least
template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::stepsLeft() const
{
    const double left = std::min(double(clock_.now.lastStep - clock_.now.step), std::ceil((clock_.now.target - clock_.now.time)/clock_.now.fullDt*(1 - 1e-9)));
    return int(std::max(1.0, std::min(left, double(motion_.windowSteps))));
}

//- On the GPU: is one block enough for a step?
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::fitsBlock() const
{
    if constexpr (!Backend::gpu) return false;
    else return set_.config.integrator == DemIntegratorKind::velocityVerlet && !clumps_.count() && !motion_.walls() && particles_.n <= BlockLimits::particles
      && bonds_.count() <= BlockLimits::bonds && (!wallMemory_.entries || int(parts_.wallList.size()) <= BlockLimits::nearWalls);
}

template<class Backend, int D, class P>
template<class Law>
BlockSteps<Backend, D, P, Law> DemSolver<Backend, D, P>::blockSteps(int count)
{
    BlockSteps<Backend, D, P, Law> b{};
    b.tick = DemTick{clock_.data()};
    b.move = mover();
    setModel(b.contacts);
    b.contacts.clock = forceClock(ForceTurn::inStep);
    b.contacts.fields = particles_.view();
    b.contacts.largestGap = real(pairs_.largestGap());
    b.n = particles_.n;
    if (nWalls_ && wallMemory_.entries)
    {
        b.walls = wallKernel<Law>(ForceTurn::inStep);
        if constexpr (Backend::gpu) b.nearWalls = int(parts_.wallList.size());
    }
    if (bonds_.count())
    {
        b.bonds = BondPass<D, P>{bonds_.view(slotOf_.data()), set_.box, particles_.view(), records_.view(), forceClock(ForceTurn::inStep), {}};
        b.gather = GatherBonds<D, P>{bonds_.table(), bonds_.force(), particles_.view(), forceClock(ForceTurn::inStep), sort_.active()};
        b.bondCount = bonds_.count();
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
        if (fitsBlock() && !set_.context.profile.timing)
        {
            withLaw(set_.laws, [&](auto law) { oneBlock<BlockLimits::threads>(set_.context, blockSteps<decltype(law)>(count)); });
            return;
        }
        const int together = 8;
        // motion tables change from window to window, and the fields of large scenes from sort to sort
        if (!set_.context.profile.timing && !motion_.groups() && !motion_.walls() && particles_.values.alternates())
            for (; count >= together/2; count -= together)
            {
                if (parts_.graphs.size() > 16) parts_.graphs.clear();
                std::vector<const void*> key = graphKey(together);
                key.push_back(particles_.view().x[0]);       // fields alternate between two places
                Graph& graph = parts_.graphs[key];
                if (!graph.recorded()) graph.record(set_.context, [&] { for (int k = 0; k < together; ++k) step(); });
                graph.replay(set_.context);
            }
    }
#endif
    for (; count > 0; --count) step();
}

} // namespace riprap
