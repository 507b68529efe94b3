/*  Forces at the positions at hand: kernels of contacts, walls and bonds with all that they read,
    and of the motion that follows.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/parts/demParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class ContactForces
{
public:

    using real = typename P::real;

    explicit ContactForces(DemParts<Backend, D, P>& parts) : p_(parts) {}

    //- What kernels of motion, and passes over contacts, read
    template<class M> void setMotion(M&);
    MoveSolids<D, P> mover();
    MoveWalls wallMover(DemClockData*);
    template<class Law> void setModel(PairModel<Backend, D, P, Law>&);
    ForceClock forceClock(ForceTurn);
    StepState<D, P> stepState();
    double wallReach() const;
    template<class Law> WallPass<D, P, Law> wallKernel(ForceTurn);

    template<class Law> void contactPass(ForceTurn);
    template<class Law> void wallPass(ForceTurn);
    void bondPass(ForceTurn);

    //- All of them
    void evaluate(ForceTurn = ForceTurn::inStep);

    //- On the CPU a step may move particles as it adds up their forces; else forces go into the
    //  fields, where they are not yet
    void moveParticles();
    void collectForces();

private:

    // what does not depend on the law: once for all of them
    [[gnu::noinline]] void setPairs(PairSetting<Backend, D, P>&);
    [[gnu::noinline]] void setWalls(WallTouching<D, P>&, ForceTurn);
    bool movesAtOnce() const;
    bool movesPlainly() const;
#ifndef __CUDACC__
    CollectedForce<D, P> collected();
    //- Over those who are awake
    template<class Kernel> void ofAwake(const Kernel&);
#endif

    DemParts<Backend, D, P>& p_;
};

template<class Backend, int D, class P>
template<class M>
void ContactForces<Backend, D, P>::setMotion(M& m)
{
    m.fields = p_.particles.view();
    // bodies are counted among those that are here
    if (p_.clumps.share.some) m.fields.clump = p_.clumps.share.place.data();
    m.groups = p_.groups.data();
    for (int d = 0; d < D; ++d) m.gravity[d] = real(p_.set.config.gravity[p_.set.config.axes[d]]);
    m.external = p_.particles.externalForces();
    m.clock = p_.clock.data();
    m.active = p_.order.sort.active();
}

template<class Backend, int D, class P>
MoveSolids<D, P> ContactForces<Backend, D, P>::mover()
{
    MoveSolids<D, P> m{};
    setMotion(m);
    m.box = p_.set.box;
    m.solids = p_.order.records.view();
    m.verlet = p_.set.integrator.kicksTwice;
    for (int d = 0; d < D; ++d)
    {
        m.reference[d] = p_.order.reference.data() + std::size_t(d)*p_.particles.n;
        m.domainMin[d] = p_.reach.domainMin[d];
        m.domainMax[d] = p_.reach.domainMax[d];
    }
    if constexpr (Backend::gpu) m.frames = p_.memory.frames.view();
    m.halfSkin = p_.reach.halfSkin;
    m.suddenDisplacement = p_.reach.suddenDisplacement;
    m.motions = p_.motion.groupTable();
    m.clumps = p_.clumps.any() ? p_.clumps.data() : nullptr;
    m.offset = p_.clumps.offset().data();
    m.sharesMass = p_.sharesMass();
    return m;
}

template<class Backend, int D, class P>
template<class Law>
void ContactForces<Backend, D, P>::setModel(PairModel<Backend, D, P, Law>& m)
{
    setPairs(m);
    p_.pairs.giveNumbers(m);
}

template<class Backend, int D, class P>
void ContactForces<Backend, D, P>::setPairs(PairSetting<Backend, D, P>& m)
{
    m.box = p_.set.box;
    m.solids = p_.order.records.view();
    m.list = p_.order.list.view();
    p_.pairs.give(m);
    m.clock = forceClock(ForceTurn::always);
    m.active = p_.order.sort.active();
}

template<class Backend, int D, class P>
ForceClock ContactForces<Backend, D, P>::forceClock(ForceTurn turn)
{
    if constexpr (Backend::gpu)
        if (turn == ForceTurn::ahead)
            return ForceClock{
                p_.clock.data() + p_.memory.current, p_.clock.data() + 1 - p_.memory.current, turn};
    return ForceClock{p_.clock.data(), p_.clock.data(), turn};
}

template<class Backend, int D, class P>
StepState<D, P> ContactForces<Backend, D, P>::stepState()
{
    StepState<D, P> s{};
    if constexpr (Backend::gpu)
    {
        s.from = p_.memory.current ? p_.memory.records.view() : p_.order.records.view();
        s.to = p_.memory.current ? p_.order.records.view() : p_.memory.records.view();
        for (int d = 0; d < D; ++d) s.low[d] = p_.memory.low.data() + std::size_t(d)*p_.particles.n;
        s.own = p_.memory.own.data();
    }
    return s;
}

//- Walls are listed from farther away where a particle's way is measured against others that move
//  with it: walls do not
template<class Backend, int D, class P>
double ContactForces<Backend, D, P>::wallReach() const
{
    if constexpr (Backend::gpu)
        if (p_.memory.frames.on())
            return p_.reach.reach
                + (SearchReach<Backend, D, P>::wallSkins - 1)*2*double(p_.reach.halfSkin);
    return p_.reach.reach;
}

template<class Backend, int D, class P>
template<class Law>
void ContactForces<Backend, D, P>::contactPass(ForceTurn turn)
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
void ContactForces<Backend, D, P>::setWalls(WallTouching<D, P>& pass, ForceTurn turn)
{
    pass.box = p_.set.box;
    pass.fields = p_.particles.view();
    pass.walls = p_.walls.walls.data();
    pass.wallCount = p_.walls.count;
    pass.surface = p_.walls.surface();
    pass.reach = wallReach();
    pass.active = p_.order.sort.active();
    pass.solids = p_.order.records.view();
    pass.memory = p_.walls.view();
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
        // as many threads as there is room for: recorded launches stay what they are while numbers
        // change
        pass.listed = p_.memory.wallList.data();
        pass.listedCount = p_.memory.wallListFirst.data() + p_.particles.n;
    }
#ifndef __CUDACC__
    else
    {
        pass.listed = p_.memory.deferred.awake.walls.data();
        pass.listedCount = &p_.memory.deferred.awake.wallCount;
    }
#endif
}

template<class Backend, int D, class P>
template<class Law>
WallPass<D, P, Law> ContactForces<Backend, D, P>::wallKernel(ForceTurn turn)
{
    WallPass<D, P, Law> pass{};
    setWalls(pass, turn);
    pass.parameters = p_.pairs.template parameters<Law>();
    return pass;
}

template<class Backend, int D, class P>
template<class Law>
void ContactForces<Backend, D, P>::wallPass(ForceTurn turn)
{
    int near = 0;
    if constexpr (Backend::gpu) near = int(p_.memory.wallList.size());
#ifndef __CUDACC__
    else near = p_.memory.deferred.awake.wallCount;
#endif
    forEach(p_.set.context, near, wallKernel<Law>(turn));
}

template<class Backend, int D, class P>
void ContactForces<Backend, D, P>::bondPass(ForceTurn turn)
{
    BondPass<D, P> pass{p_.bonds.view(p_.order.slotOf.data()), p_.set.box, p_.particles.view(),
        p_.order.records.view(), forceClock(turn), {}};
    if constexpr (Backend::gpu)
        if (turn == ForceTurn::ahead)
        {
            pass.state = stepState();
            pass.solids = pass.state.from;
        }
    constexpr int threads = BondBlocks<D, P>::threads;
    if constexpr (Backend::gpu)
        forEachBlock(
            p_.set.context, (p_.bonds.count() + threads - 1)/threads, BondBlocks<D, P>{pass});
    else forEach(p_.set.context, p_.bonds.count(), pass);
}

template<class Backend, int D, class P>
void ContactForces<Backend, D, P>::evaluate(ForceTurn turn)
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
            forEach(p_.set.context, p_.particles.n,
                GatherBonds<D, P>{p_.bonds.table(), p_.bonds.force(), p_.particles.view(),
                    forceClock(turn), p_.order.sort.active()});
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
bool ContactForces<Backend, D, P>::movesAtOnce() const
{
    return !Backend::gpu && !p_.clumps.any() && !p_.set.integrator.kicksTwice;
}

//- As MoveCollected::isPlain has it
template<class Backend, int D, class P>
bool ContactForces<Backend, D, P>::movesPlainly() const
{
    return movesAtOnce() && (!p_.particles.view().calm || p_.sleeps())
        && !p_.particles.externalForces()
        && !p_.groups.damped() && !p_.groups.motions();
}

//- On the CPU: forces into the fields, where they are not yet
template<class Backend, int D, class P>
void ContactForces<Backend, D, P>::collectForces()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
    {
        if (p_.memory.uncollected)
            ofAwake(CollectForces<D, P>{collected(), p_.particles.view(), p_.order.sort.active()});
        p_.memory.uncollected = false;
    }
#endif
}

template<class Backend, int D, class P>
void ContactForces<Backend, D, P>::moveParticles()
{
#ifndef __CUDACC__
    if constexpr (!Backend::gpu)
        if (p_.memory.uncollected)
        {
            if (movesPlainly())
            {
                MoveCollected<D, P, true> plain{collected(), mover()};
                plain.mover.fields.calm = nullptr;
                ofAwake(plain);
            }
            else ofAwake(MoveCollected<D, P, false>{collected(), mover()});
            p_.memory.uncollected = false;
            return;
        }
#endif
    forEach(p_.set.context, p_.particles.n, mover());
}

template<class Backend, int D, class P>
MoveWalls ContactForces<Backend, D, P>::wallMover(DemClockData* clock)
{
    return MoveWalls{p_.walls.walls.data(), p_.motion.wallTable(), clock, clock,
        double(p_.reach.halfSkin), p_.reach.radii.smallest};
}

#ifndef __CUDACC__
template<class Backend, int D, class P>
template<class Kernel>
void ContactForces<Backend, D, P>::ofAwake(const Kernel& kernel)
{
    const AwakeLists& awake = p_.memory.deferred.awake;
    using Runs = OverRuns<Kernel>;
    if (awake.some)
        forEach(p_.set.context, int(awake.runs.size()), Runs{kernel, awake.runs.data()},
            Runs::few);
    else forEach(p_.set.context, p_.particles.n, kernel);
}

template<class Backend, int D, class P>
CollectedForce<D, P> ContactForces<Backend, D, P>::collected()
{
    const bool walls = p_.walls.count && p_.walls.memory.entries;
    return CollectedForce<D, P>{&p_.memory.deferred, p_.memory.sums.data(),
        walls ? p_.walls.memory.entryFirst.data() : nullptr, p_.walls.memory.force.data(),
        p_.bonds.table(), p_.bonds.force(), p_.particles.view().id};
}
#endif

} // namespace riprap
