/*  DemSolver: fused steps (GPU). Between calls a scene is at rest with forces known; within a call its steps are

        kick and drift | forces, kick, drift | forces, kick, drift | ... | forces

    of which what stands between two bars is one kernel (two where there are walls, three with bonds), and recorded in graphs.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/demSolver.hpp"

namespace riprap
{

//- Clumps gather their members' forces first, and Verlet kicks twice
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::fuses() const
{ return Backend::gpu && !nClumps_ && config_.integrator == DemIntegratorKind::leapfrog; }

template<class Backend, int D, class P>
StepState<D, P> DemSolver<Backend, D, P>::stepState()
{
    StepState<D, P> s{};
    if constexpr (Backend::gpu)
    {
        s.from = parts_.current ? parts_.records.view() : records_.view();
        s.to = parts_.current ? records_.view() : parts_.records.view();
        for (int d = 0; d < D; ++d) s.low[d] = parts_.low.data() + std::size_t(d)*n_;
        s.own = parts_.own.data();
    }
    return s;
}

//- The fields' state, and the records', into what steps use
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::openSteps()
{
    if constexpr (Backend::gpu)
    {
        parts_.current = 0;
        if (parts_.own.size() == 0)
        {
            parts_.records.allocate(context_, n_);
            parts_.low.allocate(context_, std::size_t(n_)*D);
            parts_.own.allocate(context_, n_);
        }
        const bool walls = nWalls_ && wallMemory_.entries;
        forEach(context_, n_, OpenSteps<D, P>
        {stepState(), fields(), nBonds_ ? bondFirst_.data() : nullptr, walls ? wallMemory_.entryFirst.data() : nullptr, sort_.active()});
    }
}

//- Back into the fields; the records that everyone else reads are made anew where they are not those of the last step
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::closeSteps()
{
    if constexpr (Backend::gpu)
    {
        forEach(context_, n_, CloseSteps<D, P>{stepState(), fields(), sort_.active()});
        if (parts_.current) parts_.records.swap(records_);
        parts_.current = 0;
    }
}

template<class Backend, int D, class P>
template<class Law>
void DemSolver<Backend, D, P>::fusedStep()
{
    if constexpr (Backend::gpu)
    {
        const StepState<D, P> state = stepState();
        if (surfaces_ && wallMemory_.entries) wallPass<Law>(ForceTurn::ahead);
        if (nBonds_) bondPass(ForceTurn::ahead);
        FusedStep<Backend, D, P, Law> step{};
        setModel(step.contacts);
        step.contacts.solids = state.from;
        step.contacts.largestGap = real(largestGap_);
        step.mover = mover();
        step.state = state;
        step.now = clock_.data() + parts_.current;
        step.next = clock_.data() + 1 - parts_.current;
        if (nWalls_) step.walls = wallKernel<Law>(ForceTurn::ahead);
        step.bonds = bondTable();
        step.bondForce = bondForce_.data();
        step.sleeping = sleeps();
        forEach(context_, n_, step);
        if (wallMotions_) forEach(context_, nWalls_, wallMover(clock_.data() + 1 - parts_.current));
        parts_.current = 1 - parts_.current;
    }
}

//- What recorded launches hold on to
template<class Backend, int D, class P>
std::vector<const void*> DemSolver<Backend, D, P>::graphKey(int count)
{
    std::vector<const void*> key;
    if constexpr (Backend::gpu)
    {
        const auto list = list_.view();
        const auto walls = wallMemory(wallMemory_);
        key =
        {
            reinterpret_cast<const void*>(std::size_t(count)), reinterpret_cast<const void*>(std::size_t(parts_.current)),
            records_.view().a, parts_.records.view().a, list.entry, list.history, list.base, list.count, list.rest,
            reinterpret_cast<const void*>(list.stride), walls.entryFirst, walls.entry, walls.element, walls.on, walls.normal,
            walls.history, walls.force, reinterpret_cast<const void*>(std::size_t(wallMemory_.entries > 0)), parts_.wallList.data(),
            reinterpret_cast<const void*>(parts_.wallList.size()), external_.data()
        };
    }
    return key;
}

//- So many steps; those beyond the next rebuild, window or target switch themselves off
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::fusedSteps(int count)
{
    withLaw(laws_, [&](auto law)
    {
#ifdef __CUDACC__
        if constexpr (std::is_same<Backend, Gpu>::value)
        {
            // what is recorded must not change from batch to batch: motion tables do, and fields that are sorted
            const int together = stepsTogether;
            if (!context_.profile.timing && !groupMotions_ && !wallMotions_ && turnField_ < 0)
                for (; count >= together; count -= together)
                {
                    if (parts_.graphs.size() > 16) parts_.graphs.clear();
                    Graph& graph = parts_.graphs[graphKey(together)];
                    if (!graph.recorded())
                        graph.record(context_, [&] { for (int k = 0; k < together; ++k) fusedStep<decltype(law)>(); });
                    graph.replay(context_);
                }
        }
#endif
        for (; count > 0; --count) fusedStep<decltype(law)>();
    });
}

//- Steps until there is something for the host to do. Those beyond switch themselves off, but cost their launch: the device has the
//  next few in hand while the host looks at the last ones, unless new neighbours are due by then, as they were the last time
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::runAhead(std::int64_t count)
{
    if constexpr (Backend::gpu)
    {
        auto& glances = parts_.glances;
        std::int64_t launched = 0;
        bool over = false;
        while (!over)
        {
            const bool due = stepsSince_ + launched >= stepsExpected_;
            while (launched < count && glances.waiting() < (due ? 1 : glances.most))
            {
                const int batch = int(std::min<std::int64_t>(stepsTogether, count - launched));
                fusedSteps(batch);
                glances.ask(context_, clock_.data() + parts_.current);
                launched += batch;
            }
            host_ = glances.take(context_);
            host_.settleAge();
            over = !host_.active || host_.needRebuild || finished() || (launched == count && !glances.waiting());
        }
        while (glances.waiting()) host_ = glances.take(context_);
        host_.settleAge();
    }
}

//- Between two steps, of which the next begins with the forces
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::searchMoved()
{
    if constexpr (Backend::gpu)
    {
        adaptSkin();
        parts_.moved = true;
        rebuild();
        parts_.moved = false;
        forgetSearch();
    }
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::runFused(std::int64_t& rebuilds)
{
    if constexpr (Backend::gpu)
    {
        if (finished()) return;
        if (host_.needRebuild) { adaptSkin(); rebuild(); ++rebuilds; forgetSearch(); }
        setWindow();
        host_.needRebuild = 0;
        writeClock();
        forEach(context_, 1, DemTick{clock_.data()});
        if (wallMotions_) forEach(context_, nWalls_, wallMover(clock_.data()));
        forEach(context_, n_, mover());
        readClock();
        host_.settleAge();
        openSteps();
        if (sleeps()) checkSleep(true);
        while (!finished())
        {
            if (host_.needRebuild)
            {
                stepsExpected_ = stepsSince_;
                closeSteps();
                searchMoved();
                ++rebuilds;
                openSteps();
                if (sleeps()) checkSleep(true);
            }
            if (host_.needWindow || host_.time >= host_.windowEnd) setWindow();
            host_.needRebuild = 0;
            const std::int64_t before = host_.step;
            const int begin = parts_.current;
            const double left = std::min(double(host_.lastStep - host_.step), std::ceil((host_.target - host_.time)/host_.fullDt) + 1);
            const double most = sleeps() ? stepsPerCheck - host_.step % stepsPerCheck : left;
            writeClock();
            runAhead(std::int64_t(std::min(most, left)));
            const int taken = int(host_.step - before);
            parts_.current = int((begin + taken) % 2);
            stepsSince_ += taken;
            if (sleeps() && taken && host_.step % stepsPerCheck == 0) checkSleep(true);
        }
        closeSteps();
        if (host_.lost() && host_.halt == DemHalt::none) { searchMoved(); ++rebuilds; }
        writeClock();
        forces(ForceTurn::always);
        readClock();
    }
}

} // namespace riprap
