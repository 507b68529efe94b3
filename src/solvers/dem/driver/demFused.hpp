/*  DemSolver: fused steps (GPU). Between calls a scene is at rest with forces known; within a call its steps are

        kick and drift | forces, kick, drift | forces, kick, drift | ... | forces

    of which what stands between two bars is one kernel (two where there are walls, three with bonds), and recorded in graphs.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

//- Clumps gather their members' forces first, and Verlet kicks twice
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::fuses() const
{ return Backend::gpu && !clumps_.count() && set_.config.integrator == DemIntegratorKind::leapfrog; }

template<class Backend, int D, class P>
StepState<D, P> DemSolver<Backend, D, P>::stepState()
{
    StepState<D, P> s{};
    if constexpr (Backend::gpu)
    {
        s.from = parts_.current ? parts_.records.view() : records_.view();
        s.to = parts_.current ? records_.view() : parts_.records.view();
        for (int d = 0; d < D; ++d) s.low[d] = parts_.low.data() + std::size_t(d)*particles_.n;
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
            parts_.records.allocate(set_.context, particles_.n);
            parts_.low.allocate(set_.context, std::size_t(particles_.n)*D);
            parts_.own.allocate(set_.context, particles_.n);
        }
        const bool walls = nWalls_ && wallMemory_.entries;
        forEach(set_.context, particles_.n, OpenSteps<D, P>
        {stepState(), particles_.view(), bonds_.first(), walls ? wallMemory_.entryFirst.data() : nullptr, sort_.active()});
    }
}

//- Back into the fields; the records that everyone else reads are made anew where they are not those of the last step
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::closeSteps()
{
    if constexpr (Backend::gpu)
    {
        forEach(set_.context, particles_.n, CloseSteps<D, P>{stepState(), particles_.view(), sort_.active()});
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
        if (bonds_.count()) bondPass(ForceTurn::ahead);
        FusedStep<Backend, D, P, Law> step{};
        setModel(step.contacts);
        step.contacts.solids = state.from;
        step.contacts.largestGap = real(pairs_.largestGap());
        step.mover = mover();
        step.state = state;
        step.now = clock_.data() + parts_.current;
        step.next = clock_.data() + 1 - parts_.current;
        if (nWalls_) step.walls = wallKernel<Law>(ForceTurn::ahead);
        step.bonds = bonds_.table();
        step.bondForce = bonds_.force();
        step.sleeping = sleeps();
        forEach(set_.context, particles_.n, step);
        if (motion_.walls()) forEach(set_.context, nWalls_, wallMover(clock_.data() + 1 - parts_.current));
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
            reinterpret_cast<const void*>(parts_.wallList.size()), particles_.external.data()
        };
    }
    return key;
}

//- So many steps; those beyond the next rebuild, window or target switch themselves off
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::fusedSteps(int count)
{
    withLaw(set_.laws, [&](auto law)
    {
#ifdef __CUDACC__
        if constexpr (std::is_same<Backend, Gpu>::value)
        {
            // what is recorded must not change from batch to batch: motion tables do, and fields that are sorted
            const int together = stepsTogether;
            if (!set_.context.profile.timing && !motion_.groups() && !motion_.walls() && particles_.at.turn < 0)
                for (; count >= together; count -= together)
                {
                    if (parts_.graphs.size() > 16) parts_.graphs.clear();
                    Graph& graph = parts_.graphs[graphKey(together)];
                    if (!graph.recorded())
                        graph.record(set_.context, [&] { for (int k = 0; k < together; ++k) fusedStep<decltype(law)>(); });
                    graph.replay(set_.context);
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
                glances.ask(set_.context, clock_.data() + parts_.current);
                launched += batch;
            }
            clock_.now = glances.take(set_.context);
            clock_.now.settleAge();
            over = !clock_.now.active || clock_.now.needRebuild || finished() || (launched == count && !glances.waiting());
        }
        while (glances.waiting()) clock_.now = glances.take(set_.context);
        clock_.now.settleAge();
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
        if (clock_.now.needRebuild) { adaptSkin(); rebuild(); ++rebuilds; forgetSearch(); }
        motion_.sample(clock_.now);
        clock_.now.needRebuild = 0;
        clock_.write();
        forEach(set_.context, 1, DemTick{clock_.data()});
        if (motion_.walls()) forEach(set_.context, nWalls_, wallMover(clock_.data()));
        forEach(set_.context, particles_.n, mover());
        clock_.read();
        clock_.now.settleAge();
        openSteps();
        if (sleeps()) checkSleep(true);
        while (!finished())
        {
            if (clock_.now.needRebuild)
            {
                stepsExpected_ = stepsSince_;
                closeSteps();
                searchMoved();
                ++rebuilds;
                openSteps();
                if (sleeps()) checkSleep(true);
            }
            if (clock_.now.needWindow || clock_.now.time >= clock_.now.windowEnd) motion_.sample(clock_.now);
            clock_.now.needRebuild = 0;
            const std::int64_t before = clock_.now.step;
            const int begin = parts_.current;
            const double left = std::min(double(clock_.now.lastStep - clock_.now.step), std::ceil((clock_.now.target - clock_.now.time)/clock_.now.fullDt) + 1);
            const double most = sleeps() ? stepsPerCheck - clock_.now.step % stepsPerCheck : left;
            clock_.write();
            runAhead(std::int64_t(std::min(most, left)));
            const int taken = int(clock_.now.step - before);
            parts_.current = int((begin + taken) % 2);
            stepsSince_ += taken;
            if (sleeps() && taken && clock_.now.step % stepsPerCheck == 0) checkSleep(true);
        }
        closeSteps();
        if (clock_.now.lost() && clock_.now.halt == DemHalt::none) { searchMoved(); ++rebuilds; }
        clock_.write();
        forces(ForceTurn::always);
        clock_.read();
    }
}

} // namespace riprap
