/*  Fused steps (GPU). Between calls a scene is at rest with forces known; within a call its steps
    are

        kick and drift | forces, kick, drift | forces, kick, drift | ... | forces

    of which what stands between two bars is one kernel (two where there are walls, three with
    bonds), and recorded in graphs.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/driver/sleepers.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class FusedStepper
{
public:
    FusedStepper(DemParts<Backend, D, P>& parts, ContactForces<Backend, D, P>& forces,
        RankedSolids<Backend, D, P>& ranks, Neighbours<Backend, D, P>& neighbours,
        Sleepers<Backend, D, P>& sleepers)
        : p_(parts), forces_(forces), ranks_(ranks), neighbours_(neighbours), sleepers_(sleepers)
    {}

    //- To the clock's target
    void run(std::int64_t& rebuilds);

    //- What recorded launches hold on to
    std::vector<const void*> graphKey(int count);

private:

    using real = typename P::real;
    static constexpr int stepsTogether = 8;         // recorded

    void openSteps();
    void closeSteps();
    template<class Law> void fusedStep();
    void fusedSteps(int count);
    void runAhead(std::int64_t count);
    void begin(std::int64_t& rebuilds);
    std::int64_t stepsAhead() const;
    void searchMoved();
    void forgetSearch() { p_.clock.now.search(); stepsSince_ = 0; }

    DemParts<Backend, D, P>& p_;
    ContactForces<Backend, D, P>& forces_;
    RankedSolids<Backend, D, P>& ranks_;
    Neighbours<Backend, D, P>& neighbours_;
    Sleepers<Backend, D, P>& sleepers_;
    // between the last two searches, since the last one
    std::int64_t stepsExpected_ = 16, stepsSince_ = 0;
};

//- The fields' state, and the records', into what steps use
template<class Backend, int D, class P>
void FusedStepper<Backend, D, P>::openSteps()
{
    if constexpr (Backend::gpu)
    {
        p_.memory.current = 0;
        if (p_.memory.own.size() == 0)
        {
            p_.memory.records.allocate(p_.set.context, p_.particles.n);
            p_.memory.low.allocate(p_.set.context, std::size_t(p_.particles.n)*D);
            p_.memory.own.allocate(p_.set.context, p_.particles.n);
        }
        const bool walls = p_.walls.count && p_.walls.memory.entries;
        forEach(p_.set.context, p_.particles.n,
            OpenSteps<D, P>{forces_.stepState(), p_.particles.view(), p_.bonds.first(),
                walls ? p_.walls.memory.entryFirst.data() : nullptr, p_.order.sort.active()});
    }
}

//- Back into the fields; the records that everyone else reads are made anew where they are not
//  those of the last step
template<class Backend, int D, class P>
void FusedStepper<Backend, D, P>::closeSteps()
{
    if constexpr (Backend::gpu)
    {
        forEach(p_.set.context, p_.particles.n,
            CloseSteps<D, P>{forces_.stepState(), p_.particles.view(), p_.order.sort.active()});
        if (p_.memory.current) p_.memory.records.swap(p_.order.records);
        p_.memory.current = 0;
    }
}

template<class Backend, int D, class P>
template<class Law>
void FusedStepper<Backend, D, P>::fusedStep()
{
    if constexpr (Backend::gpu)
    {
        const StepState<D, P> state = forces_.stepState();
        if (p_.walls.surfaces && p_.walls.memory.entries)
            forces_.template wallPass<Law>(ForceTurn::ahead);
        if (p_.bonds.count()) forces_.bondPass(ForceTurn::ahead);
        FusedStep<Backend, D, P, Law> step{};
        forces_.setModel(step.contacts);
        step.contacts.solids = state.from;
        step.contacts.largestGap = real(p_.pairs.largestGap());
        step.mover = forces_.mover();
        step.state = state;
        step.now = p_.clock.data() + p_.memory.current;
        step.next = p_.clock.data() + 1 - p_.memory.current;
        if (p_.walls.count) step.walls = forces_.template wallKernel<Law>(ForceTurn::ahead);
        step.bonds = p_.bonds.table();
        step.bondForce = p_.bonds.force();
        step.sleeping = p_.sleeps();
        forEach(p_.set.context, p_.particles.n, step);
        if (p_.motion.walls())
            forEach(p_.set.context, p_.walls.count,
                forces_.wallMover(p_.clock.data() + 1 - p_.memory.current));
        p_.memory.current = 1 - p_.memory.current;
    }
}

template<class Backend, int D, class P>
std::vector<const void*> FusedStepper<Backend, D, P>::graphKey(int count)
{
    std::vector<const void*> key;
    if constexpr (Backend::gpu)
    {
        const auto list = p_.order.list.view();
        const auto walls = p_.walls.view();
        key = {reinterpret_cast<const void*>(std::size_t(count)),
            reinterpret_cast<const void*>(std::size_t(p_.memory.current)),
            p_.order.records.view().a, p_.memory.records.view().a, list.entry, list.history,
            list.base, list.count, list.rest, reinterpret_cast<const void*>(list.stride),
            walls.entryFirst, walls.entry, walls.element, walls.on, walls.normal, walls.history,
            walls.force, reinterpret_cast<const void*>(std::size_t(p_.walls.memory.entries > 0)),
            p_.memory.wallList.data(), reinterpret_cast<const void*>(p_.memory.wallList.size()),
            p_.particles.external.data()};
    }
    return key;
}

//- So many steps; those beyond the next rebuild, window or target switch themselves off
template<class Backend, int D, class P>
void FusedStepper<Backend, D, P>::fusedSteps(int count)
{
    withLaw(p_.set.laws, [&](auto law)
    {
#ifdef __CUDACC__
        if constexpr (std::is_same<Backend, Gpu>::value)
        {
            // what is recorded must not change from batch to batch: motion tables do, and fields
            // that are sorted
            const int together = stepsTogether;
            if (!p_.set.context.profile.timing && !p_.motion.groups() && !p_.motion.walls()
                && p_.particles.at.turn < 0)
                for (; count >= together; count -= together)
                {
                    if (p_.memory.graphs.size() > 16) p_.memory.graphs.clear();
                    Graph& graph = p_.memory.graphs[graphKey(together)];
                    if (!graph.recorded())
                        graph.record(p_.set.context,
                            [&]
                            {
                                for (int k = 0; k < together; ++k) fusedStep<decltype(law)>();
                            });
                    graph.replay(p_.set.context);
                }
        }
#endif
        for (; count > 0; --count) fusedStep<decltype(law)>();
    });
}

//- Steps until there is something for the host to do. Those beyond switch themselves off, but cost
//  their launch: the device has the next few in hand while the host looks at the last ones, unless
//  new neighbours are due by then, as they were the last time
template<class Backend, int D, class P>
void FusedStepper<Backend, D, P>::runAhead(std::int64_t count)
{
    if constexpr (Backend::gpu)
    {
        auto& readback = p_.memory.readback;
        std::int64_t launched = 0;
        bool over = false;
        while (!over)
        {
            const bool due = stepsSince_ + launched >= stepsExpected_;
            while (launched < count && readback.waiting() < (due ? 1 : readback.most))
            {
                const int batch = int(std::min<std::int64_t>(stepsTogether, count - launched));
                fusedSteps(batch);
                readback.ask(p_.set.context, p_.clock.data() + p_.memory.current);
                launched += batch;
            }
            p_.clock.now = readback.take(p_.set.context);
            p_.clock.now.settleAge();
            over = !p_.clock.now.active || p_.clock.now.needRebuild || ranks_.finished()
                || (launched == count && !readback.waiting());
        }
        while (readback.waiting()) p_.clock.now = readback.take(p_.set.context);
        p_.clock.now.settleAge();
    }
}

//- Between two steps, of which the next begins with the forces
template<class Backend, int D, class P>
void FusedStepper<Backend, D, P>::searchMoved()
{
    if constexpr (Backend::gpu)
    {
        neighbours_.adaptSkin();
        p_.memory.moved = true;
        neighbours_.rebuild();
        p_.memory.moved = false;
        forgetSearch();
    }
}

//- The first half step, with neighbours that are good for it
template<class Backend, int D, class P>
void FusedStepper<Backend, D, P>::begin(std::int64_t& rebuilds)
{
    if constexpr (Backend::gpu)
    {
        if (p_.clock.now.needRebuild)
        {
            neighbours_.adaptSkin();
            neighbours_.rebuild();
            ++rebuilds;
            forgetSearch();
        }
        p_.motion.sample(p_.clock.now);
        p_.clock.now.needRebuild = 0;
        p_.clock.write();
        forEach(p_.set.context, 1, DemTick{p_.clock.data()});
        if (p_.motion.walls())
            forEach(p_.set.context, p_.walls.count, forces_.wallMover(p_.clock.data()));
        forEach(p_.set.context, p_.particles.n, forces_.mover());
        p_.clock.read();
        p_.clock.now.settleAge();
        openSteps();
        if (p_.sleeps()) sleepers_.check(true);
    }
}

//- As many as are left, or up to where solids are looked at that may fall asleep
template<class Backend, int D, class P>
std::int64_t FusedStepper<Backend, D, P>::stepsAhead() const
{
    constexpr std::int64_t perCheck = Sleepers<Backend, D, P>::stepsPerCheck;
    const DemClockData& c = p_.clock.now;
    const double left =
        std::min(double(c.lastStep - c.step), std::ceil((c.target - c.time)/c.fullDt) + 1);
    const double most = p_.sleeps() ? perCheck - c.step % perCheck : left;
    return std::int64_t(std::min(most, left));
}

template<class Backend, int D, class P>
void FusedStepper<Backend, D, P>::run(std::int64_t& rebuilds)
{
    if constexpr (Backend::gpu)
    {
        if (ranks_.finished()) return;
        begin(rebuilds);
        while (!ranks_.finished())
        {
            if (p_.clock.now.needRebuild)
            {
                stepsExpected_ = stepsSince_;
                closeSteps();
                searchMoved();
                ++rebuilds;
                openSteps();
                if (p_.sleeps()) sleepers_.check(true);
            }
            if (p_.clock.now.needWindow || p_.clock.now.time >= p_.clock.now.windowEnd)
                p_.motion.sample(p_.clock.now);
            p_.clock.now.needRebuild = 0;
            const std::int64_t before = p_.clock.now.step;
            const int begin = p_.memory.current;
            const std::int64_t ahead = stepsAhead();
            p_.clock.write();
            runAhead(ahead);
            const int taken = int(p_.clock.now.step - before);
            p_.memory.current = int((begin + taken) % 2);
            stepsSince_ += taken;
            if (p_.sleeps() && taken
                && p_.clock.now.step % Sleepers<Backend, D, P>::stepsPerCheck == 0)
                sleepers_.check(true);
        }
        closeSteps();
        if (p_.clock.now.lost() && p_.clock.now.halt == DemHalt::none)
        {
            searchMoved();
            ++rebuilds;
        }
        p_.clock.write();
        forces_.evaluate(ForceTurn::always);
        p_.clock.read();
    }
}

} // namespace riprap
