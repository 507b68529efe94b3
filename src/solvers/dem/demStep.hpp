/*  DemSolver: the parts of a step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstring>
#include "solvers/dem/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
SolidFields<D, P> DemSolver<Backend, D, P>::fields()
{
    SolidFields<D, P> s{};
    for (int d = 0; d < D; ++d)
    {
        s.x[d] = fields_.template data<std::int64_t>(xField_ + d);
        s.v[d] = fields_.template data<double>(vField_ + d);
        s.f[d] = fields_.template data<real>(fField_ + d);
    }
    for (int c = 0; c < S; ++c)
    {
        s.w[c] = fields_.template data<real>(wField_ + c);
        s.m[c] = fields_.template data<real>(mField_ + c);
    }
    s.radius = fields_.template data<real>(radiusField_);
    s.mass = fields_.template data<real>(massField_);
    s.inverseInertia = fields_.template data<real>(inertiaField_);
    s.material = fields_.template data<std::int32_t>(materialField_);
    s.group = fields_.template data<std::int32_t>(groupField_);
    s.clump = clumpField_ < 0 ? nullptr : fields_.template data<std::int32_t>(clumpField_);
    s.id = fields_.template data<std::int32_t>(idField_);
    s.calm = calmField_ < 0 ? nullptr : fields_.template data<std::int32_t>(calmField_);
    if (turnField_ >= 0)
        for (int k = 0; k < (D == 2 ? 1 : 4); ++k) s.turn[k] = fields_.template data<real>(turnField_ + k);
    return s;
}

template<class Backend, int D, class P>
BondFields<D, P> DemSolver<Backend, D, P>::bondFields()
{
    return BondFields<D, P>
    {
        nBonds_, {bondIds_[0].data(), bondIds_[1].data()}, bondType_.data(), bondRest_.data(), bondHistory_.data(),
        bondBroken_.data(), bondForce_.data(), bondTypes_.data(), slotOf_.data()
    };
}

template<class Backend, int D, class P>
BondTable DemSolver<Backend, D, P>::bondTable()
{
    if (!nBonds_) return BondTable{};
    return BondTable
    {
        bondFirst_.data(), bondReference_.data(), {bondIds_[0].data(), bondIds_[1].data()}, bondBroken_.data(),
        config_.contactWithinBonds
    };
}

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
MotionTable DemSolver<Backend, D, P>::groupMotions() const
{ return MotionTable{motions_.data(), samples, rigidMotionNumbers, windowBegin_, windowStep_}; }

template<class Backend, int D, class P>
MotionTable DemSolver<Backend, D, P>::wallPoses() const
{ return MotionTable{poses_.data(), samples, poseNumbers, windowBegin_, windowStep_}; }

template<class Backend, int D, class P>
template<class M>
void DemSolver<Backend, D, P>::setMotion(M& m)
{
    m.fields = fields();
    m.groups = groups_.data();
    for (int d = 0; d < D; ++d) m.gravity[d] = real(config_.gravity[config_.axes[d]]);
    m.external = external_.size() ? external_.data() : nullptr;
    m.clock = clock_.data();
    m.active = sort_.active();
}

template<class Backend, int D, class P>
MoveSolids<D, P> DemSolver<Backend, D, P>::mover()
{
    MoveSolids<D, P> m{};
    setMotion(m);
    m.box = box_;
    m.solids = records_.view();
    m.verlet = config_.integrator == DemIntegratorKind::velocityVerlet;
    for (int d = 0; d < D; ++d)
    {
        m.reference[d] = reference_.data() + std::size_t(d)*n_;
        m.domainMin[d] = domainMin_[d];
        m.domainMax[d] = domainMax_[d];
    }
    if constexpr (Backend::gpu) m.frames = parts_.frames.view();
    m.halfSkin = halfSkin_;
    m.suddenWay = suddenWay_;
    m.motions = groupMotions();
    m.clumps = nClumps_ ? clumps_.data() : nullptr;
    m.offset = offset_.data();
    // paper 2's spring goes with the mass of its particles
    NormalLaws::at(laws_.normal, [&](auto law) { m.sharesMass = nClumps_ && !decltype(law)::type::stiffnessByMass; });
    return m;
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::setModel(PairModel<Backend, D, P, Law>& m)
{
    m.box = box_;
    m.solids = records_.view();
    m.list = list_.view();
    m.parameters = reinterpret_cast<const typename Law::template Parameters<real>*>(parameters_.data());
    m.gap = gaps_.data();
    m.materials = int(input_.materials.size());
    std::memcpy(&m.sole, sole_.data(), sizeof(m.sole));
    m.soleGap = sole_.back();
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
        pass.fields = fields();
        pass.largestGap = real(largestGap_);
        forEach(context_, n_, pass);
    }
#ifndef __CUDACC__
    else
    {
        ScatterPass<D, P, Law> pass;
        setModel(pass);
        pass.clock = forceClock(turn);
        pass.deferred = &parts_.deferred;
        pass.sums = parts_.sums.data();
        pass.largestGap = real(largestGap_);
        forEachTask(context_, parts_.deferred.blocks, pass);
    }
#endif
}

template<class Backend, int D, class P>
template<class Law>
WallPass<D, P, Law> DemSolver<Backend, D, P>::wallKernel(ForceTurn turn)
{
    WallPass<D, P, Law> pass{};
    pass.box = box_;
    pass.fields = fields();
    pass.walls = walls_.data();
    pass.wallCount = nWalls_;
    pass.surface = surface();
    pass.reach = wallReach();
    pass.active = sort_.active();
    pass.solids = records_.view();
    pass.memory = wallMemory(wallMemory_);
    pass.parameters = reinterpret_cast<const typename Law::template Parameters<real>*>(parameters_.data());
    pass.gap = gaps_.data();
    pass.materials = int(input_.materials.size());
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
        pass.listedCount = parts_.wallListFirst.data() + n_;
    }
    return pass;
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::wallPass(ForceTurn turn)
{
    int near = n_;
    if constexpr (Backend::gpu) near = int(parts_.wallList.size());
    forEach(context_, near, wallKernel<Law>(turn));
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::bondPass(ForceTurn turn)
{
    BondPass<D, P> pass{bondFields(), box_, fields(), records_.view(), forceClock(turn), {}};
    if constexpr (Backend::gpu)
        if (turn == ForceTurn::ahead)
        {
            pass.state = stepState();
            pass.solids = pass.state.from;
        }
    if constexpr (Backend::gpu) forEachBlock(context_, (nBonds_ + BondBlocks<D, P>::threads - 1)/BondBlocks<D, P>::threads, BondBlocks<D, P>{pass});
    else forEach(context_, nBonds_, pass);
}

//- All forces at the positions at hand
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::forces(ForceTurn turn)
{
    withLaw(laws_, [&](auto law)
    {
        contactPass<decltype(law)>(turn);
        if (nWalls_ && wallMemory_.entries) wallPass<decltype(law)>(turn);
    });
    if (nBonds_)
    {
        bondPass(turn);
        if constexpr (Backend::gpu)
            forEach(context_, n_, GatherBonds<D, P>{bondTable(), bondForce_.data(), fields(), forceClock(turn), sort_.active()});
    }
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        parts_.uncollected = true;
        if (!movesAtOnce()) collectForces();
    }
#endif
    gatherClumps(clock_.data());
}

//- Forces of their members on clumps; in a step of the clock's, or now
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::gatherClumps(const DemClockData* clock)
{
    if (nClumps_) sumClumps(context_, nClumps_, largestClump_, GatherClumps<D, P>{clumpMembers(), {springs_.data(), springFirst_.data()}, clock});
}

template<class Backend, int D, class P>
ClumpMembers<D, P> DemSolver<Backend, D, P>::clumpMembers()
{
    return {clumps_.data(), box_, fields(), memberFirst_.data(), member_.data(), slotOf_.data(), external_.size() ? external_.data() : nullptr};
}

template<class Backend, int D, class P>
ClumpKick<D, P> DemSolver<Backend, D, P>::clumpKick() const
{
    ClumpKick<D, P> kick{groups_.data(), {}, box_, constraints()};
    for (int d = 0; d < D; ++d) kick.gravity[d] = config_.gravity[config_.axes[d]];
    return kick;
}

//- On the CPU: where a step moves particles as it adds up their forces
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::movesAtOnce() const
{ return !Backend::gpu && !nClumps_ && config_.integrator == DemIntegratorKind::leapfrog; }

#ifndef __CUDACC__
template<class Backend, int D, class P>
CollectedForce<D, P> DemSolver<Backend, D, P>::collected()
{
    const bool walls = nWalls_ && wallMemory_.entries;
    return CollectedForce<D, P>
    {
        &parts_.deferred, parts_.sums.data(), walls ? wallMemory_.entryFirst.data() : nullptr, wallMemory_.force.data(), bondTable(),
        bondForce_.data(), fields().id
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
        if (parts_.uncollected) forEach(context_, n_, CollectForces<D, P>{collected(), fields(), sort_.active()});
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
            forEach(context_, n_, MoveCollected<D, P>{collected(), mover()});
            parts_.uncollected = false;
            return;
        }
#endif
    forEach(context_, n_, mover());
}

template<class Backend, int D, class P>
MoveWalls DemSolver<Backend, D, P>::wallMover(DemClockData* clock)
{ return MoveWalls{walls_.data(), wallPoses(), clock, clock, double(halfSkin_), radii_.smallest}; }

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::step()
{
    forEach(context_, 1, DemTick{clock_.data()});
    if constexpr (!Backend::gpu) if (!clock_.data()->active) return;
    if (wallMotions_) forEach(context_, nWalls_, wallMover(clock_.data()));
    const bool verlet = config_.integrator == DemIntegratorKind::velocityVerlet;
    if (nClumps_) forEach(context_, nClumps_, MoveClumps<D, P>{clumps_.data(), clumpKick(), verlet, clock_.data()});
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
    if (config_.integrator != DemIntegratorKind::velocityVerlet) return;
    FinishVerlet<D, P> finish{};
    setMotion(finish);
    finish.clumps = nClumps_;
    forEach(context_, n_, finish);
    if (nClumps_) forEach(context_, nClumps_, FinishClumps<D, P>{clumps_.data(), clumpKick(), clock_.data()});
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
    readClock();
    host_.active = 1;
    writeClock();
    finishStep();
    readClock();
    host_.active = 0;
    writeClock();
}

//- To the target or the last step; one at least
template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::stepsLeft() const
{
    const double left = std::min(double(host_.lastStep - host_.step), std::ceil((host_.target - host_.time)/host_.fullDt*(1 - 1e-9)));
    return int(std::max(1.0, std::min(left, double(windowSteps))));
}

//- On the GPU: is one block enough for a step?
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::fitsBlock() const
{
    if constexpr (!Backend::gpu) return false;
    else return config_.integrator == DemIntegratorKind::velocityVerlet && !nClumps_ && !wallMotions_ && n_ <= BlockLimits::particles
      && nBonds_ <= BlockLimits::bonds && (!wallMemory_.entries || int(parts_.wallList.size()) <= BlockLimits::nearWalls);
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
    b.contacts.fields = fields();
    b.contacts.largestGap = real(largestGap_);
    b.n = n_;
    if (nWalls_ && wallMemory_.entries)
    {
        b.walls = wallKernel<Law>(ForceTurn::inStep);
        if constexpr (Backend::gpu) b.nearWalls = int(parts_.wallList.size());
    }
    if (nBonds_)
    {
        b.bonds = BondPass<D, P>{bondFields(), box_, fields(), records_.view(), forceClock(ForceTurn::inStep), {}};
        b.gather = GatherBonds<D, P>{bondTable(), bondForce_.data(), fields(), forceClock(ForceTurn::inStep), sort_.active()};
        b.bondCount = nBonds_;
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
        if (fitsBlock() && !context_.profile.timing)
        {
            withLaw(laws_, [&](auto law) { oneBlock<BlockLimits::threads>(context_, blockSteps<decltype(law)>(count)); });
            return;
        }
        const int together = 8;
        // motion tables change from window to window, and the fields of large scenes from sort to sort
        if (!context_.profile.timing && !groupMotions_ && !wallMotions_ && fields_.alternates())
            for (; count >= together/2; count -= together)
            {
                if (parts_.graphs.size() > 16) parts_.graphs.clear();
                std::vector<const void*> key = graphKey(together);
                key.push_back(fields().x[0]);       // fields alternate between two places
                Graph& graph = parts_.graphs[key];
                if (!graph.recorded()) graph.record(context_, [&] { for (int k = 0; k < together; ++k) step(); });
                graph.replay(context_);
            }
    }
#endif
    for (; count > 0; --count) step();
}

} // namespace riprap
