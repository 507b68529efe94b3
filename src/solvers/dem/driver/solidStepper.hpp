/*  Steps of solids, one by one or many in a launch, until the target of the clock.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/driver/fusedStepper.hpp"
#include "solvers/dem/parts/demBlockSteps.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SolidStepper
{
public:

    using real = typename P::real;
    static constexpr int stepsPerCheck = Sleepers<Backend, D, P>::stepsPerCheck;

    SolidStepper(DemParts<Backend, D, P>& parts, ContactForces<Backend, D, P>& forces,
        RankedSolids<Backend, D, P>& ranks, Neighbours<Backend, D, P>& neighbours,
        Sleepers<Backend, D, P>& sleepers)
        : p_(parts), forces_(forces), ranks_(ranks), neighbours_(neighbours), sleepers_(sleepers),
          fused_(parts, forces, ranks, neighbours, sleepers)
    {}

    //- To the clock's target; adds how often neighbours were sought
    void run(std::int64_t& rebuilds);

private:

    void step();
    void finishStep();
    void searchWithin();
    void finishLate();
    int stepsLeft() const;
    bool fitsBlock() const;
    template<class Law> BlockSteps<Backend, D, P, Law> blockSteps(int count);
    void steps(int count);

    DemParts<Backend, D, P>& p_;
    ContactForces<Backend, D, P>& forces_;
    RankedSolids<Backend, D, P>& ranks_;
    Neighbours<Backend, D, P>& neighbours_;
    Sleepers<Backend, D, P>& sleepers_;
    FusedStepper<Backend, D, P> fused_;
    std::int64_t searchesWithin_ = 0;       // steps
    int stepsPerBatch_ = 16;
};

template<class Backend, int D, class P>
void SolidStepper<Backend, D, P>::step()
{
    forEach(p_.set.context, 1, DemTick{p_.clock.data()});
    if constexpr (!Backend::gpu) if (!p_.clock.data()->active) return;
    if (p_.motion.walls())
        forEach(p_.set.context, p_.walls.count, forces_.wallMover(p_.clock.data()));
    const bool verlet = p_.set.integrator.kicksTwice;
    if (p_.clumps.any())
        forEach(p_.set.context, p_.clumps.count(),
            MoveClumps<D, P>{p_.clumps.data(), p_.clumps.kick(), verlet, p_.clock.data()});
    forces_.moveParticles();
    if (ranks_.others) ranks_.shareStep();
    if constexpr (!Backend::gpu)
        if (p_.clock.data()->lost() && p_.clock.data()->halt == DemHalt::none) searchWithin();
    finishStep();
}

//- What a step does where its particles have come to
template<class Backend, int D, class P>
void SolidStepper<Backend, D, P>::finishStep()
{
    forces_.evaluate();
    if (ranks_.others) ranks_.bonds.agree();
    if (!p_.set.integrator.kicksTwice) return;
    FinishVerlet<D, P> finish{};
    forces_.setMotion(finish);
    finish.clumps = p_.clumps.any();
    forEach(p_.set.context, p_.particles.n, finish);
    if (p_.clumps.any())
        forEach(p_.set.context, p_.clumps.count(),
            FinishClumps<D, P>{p_.clumps.data(), p_.clumps.kick(), p_.clock.data()});
}

//- A step has carried a particle farther than lists hold: new ones before its forces
template<class Backend, int D, class P>
void SolidStepper<Backend, D, P>::searchWithin()
{
    neighbours_.adaptSkin();
    neighbours_.rebuild();
    ++searchesWithin_;
}

//- On the GPU, whose steps follow one another without the host: the forces that the last one waits
//  with
template<class Backend, int D, class P>
void SolidStepper<Backend, D, P>::finishLate()
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
int SolidStepper<Backend, D, P>::stepsLeft() const
{
    const DemClockData& c = p_.clock.now;
    const double left = std::min(
        double(c.lastStep - c.step), std::ceil((c.target - c.time)/c.fullDt*(1 - 1e-9)));
    return int(std::max(1.0, std::min(left, double(p_.motion.windowSteps))));
}

//- On the GPU: is one block enough for a step?
template<class Backend, int D, class P>
bool SolidStepper<Backend, D, P>::fitsBlock() const
{
    if constexpr (!Backend::gpu) return false;
    else
        return p_.set.integrator.kicksTwice && !p_.clumps.any()
            && !p_.motion.walls() && p_.particles.n <= BlockLimits::particles
            && p_.bonds.count() <= BlockLimits::bonds
            && (!p_.walls.memory.entries
                || int(p_.memory.wallList.size()) <= BlockLimits::nearWalls);
}

template<class Backend, int D, class P>
template<class Law>
BlockSteps<Backend, D, P, Law> SolidStepper<Backend, D, P>::blockSteps(int count)
{
    BlockSteps<Backend, D, P, Law> b{};
    b.tick = DemTick{p_.clock.data()};
    b.move = forces_.mover();
    forces_.setModel(b.contacts);
    b.contacts.clock = forces_.forceClock(ForceTurn::inStep);
    b.contacts.fields = p_.particles.view();
    b.contacts.largestGap = real(p_.pairs.largestGap());
    b.n = p_.particles.n;
    if (p_.walls.count && p_.walls.memory.entries)
    {
        b.walls = forces_.template wallKernel<Law>(ForceTurn::inStep);
        if constexpr (Backend::gpu) b.nearWalls = int(p_.memory.wallList.size());
    }
    if (p_.bonds.count())
    {
        b.bonds = BondPass<D, P>{p_.bonds.view(p_.order.slotOf.data()), p_.set.box,
            p_.particles.view(), p_.order.records.view(), forces_.forceClock(ForceTurn::inStep),
            {}};
        b.gather = GatherBonds<D, P>{p_.bonds.table(), p_.bonds.force(), p_.particles.view(),
            forces_.forceClock(ForceTurn::inStep), p_.order.sort.active()};
        b.bondCount = p_.bonds.count();
    }
    forces_.setMotion(b.finish);
    b.steps = count;
    return b;
}

//- So many steps; those beyond the next rebuild, window or target switch themselves off. In small
//  scenes the host's launches would take longer than the steps: they are recorded, eight at a time,
//  and where one block is enough they are one launch
template<class Backend, int D, class P>
void SolidStepper<Backend, D, P>::steps(int count)
{
#ifdef __CUDACC__
    if constexpr (std::is_same<Backend, Gpu>::value)
    {
        if (fitsBlock() && !p_.set.context.profile.timing)
        {
            withLaw(p_.set.laws,
                [&](auto law) {
                    singleBlock<BlockLimits::threads>(
                        p_.set.context, blockSteps<decltype(law)>(count));
                });
            return;
        }
        const int together = 8;
        // motion tables change from window to window, and the fields of large scenes from sort to
        // sort
        if (!p_.set.context.profile.timing && !p_.motion.groups() && !p_.motion.walls()
            && p_.particles.values.alternates())
            for (; count >= together/2; count -= together)
            {
                if (p_.memory.graphs.size() > 16) p_.memory.graphs.clear();
                std::vector<const void*> key = fused_.graphKey(together);
                // fields alternate between two places
                key.push_back(p_.particles.view().x[0]);
                Graph& graph = p_.memory.graphs[key];
                if (!graph.recorded())
                    graph.record(p_.set.context,
                        [&]
                        {
                            for (int k = 0; k < together; ++k) step();
                        });
                graph.replay(p_.set.context);
            }
    }
#endif
    for (; count > 0; --count) step();
}

template<class Backend, int D, class P>
void SolidStepper<Backend, D, P>::run(std::int64_t& rebuilds)
{
    if (p_.fuses()) return fused_.run(rebuilds);
    const std::int64_t within = searchesWithin_;
    while (!ranks_.finished())
    {
        if (p_.clock.now.needRebuild)
        {
            neighbours_.adaptSkin();
            neighbours_.rebuild();
            ++rebuilds;
            p_.clock.read();
            if (p_.sleeps()) sleepers_.check(false);
        }
        if (p_.clock.now.needWindow || p_.clock.now.time >= p_.clock.now.windowEnd)
        {
            p_.motion.sample(p_.clock.now);
            p_.clock.write();
        }
        const std::int64_t before = p_.clock.now.step;
        if constexpr (!Backend::gpu)
        {
            do
            {
                step();
                if (p_.sleeps() && p_.clock.data()->active
                    && p_.clock.data()->step % stepsPerCheck == 0)
                    sleepers_.check(false);
            }
            while (p_.clock.data()->active && !ranks_.stopped());
        }
        else
        {
            steps(std::min(p_.sleeps() ? stepsPerCheck - int(p_.clock.now.step % stepsPerCheck)
                                       : stepsPerBatch_,
                stepsLeft()));
        }
        p_.clock.read();
        if (Backend::gpu && p_.clock.now.lost() && p_.clock.now.halt == DemHalt::none) finishLate();
        if (Backend::gpu && p_.sleeps() && p_.clock.now.step > before
            && p_.clock.now.step % stepsPerCheck == 0)
            sleepers_.check(false);
        if constexpr (Backend::gpu)
        {
            // as many steps as the last neighbours lasted: those beyond switch themselves off
            const int taken = int(p_.clock.now.step - before);
            if (taken == stepsPerBatch_ && !p_.clock.now.needRebuild)
                stepsPerBatch_ = std::min(p_.motion.windowSteps, 2*stepsPerBatch_);
            else if (p_.clock.now.needRebuild)
                stepsPerBatch_ = std::max(2, std::min(p_.motion.windowSteps, taken + 1));
        }
    }
    forces_.collectForces();
    rebuilds += searchesWithin_ - within;
}

} // namespace riprap
