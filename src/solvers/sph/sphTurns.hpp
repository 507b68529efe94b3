/*  SphSolver: steps with solids in them that follow one another on the GPU without the host (coupling/solidTurn.hpp). It looks on after as many steps as the
    last neighbours lasted, seeks new ones, and goes on with steps that wait for it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/solidTurn.hpp"
#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setTurns()
{
    // interpolated: each step of the solids has a force of its own
    turns_ = solids_->takesTurns() && coupling_.force != FluidForceKind::interpolated;
    turn_.upload(context_, std::vector<SolidTurn>(1));
}

template<class Backend, int D, class P>
TurnLaunch<D, P> SphSolver<Backend, D, P>::turnLaunch()
{
    ClockData* clock = clock_.data();
    return TurnLaunch<D, P>
    {
        FluidTurn{&clock->time, &clock->dt, &clock->previousDt, &clock->active}, turn_.data(), solidForce_.data(),
        coupling_.force == FluidForceKind::impulse, subcyclesExpected_
    };
}

//- What the launches of a step hold on to besides what stays as it is; empty: they are not to be recorded
template<class Backend, int D, class P>
std::vector<const void*> SphSolver<Backend, D, P>::stepKey()
{
    if (context_.profile.timing || !fluid_.alternates() || (nBodies_ && !wall_.alternates())) return {};
    std::vector<const void*> key = solids_->turnKey(turnLaunch());
    if (key.empty()) return key;
    const auto number = [](std::size_t n) { return reinterpret_cast<const void*>(n); };
    for (const void* p : std::initializer_list<const void*>
    {
        fluid_.template data<std::int64_t>(xField_), fluidSort_.order(), fluidSort_.active(), solidSort_.order(), solidSort_.active(),
        nWalls_ ? wall_.template data<std::int64_t>(wallXField_) : nullptr, number(solidsMeet_)
    }) key.push_back(p);
    return key;
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::forgetGraphs()
{
    if constexpr (Backend::gpu)
    {
        parts_.graphs.recorded = false;
        parts_.turnGraphs.clear();
    }
}

//- Several together, as far as that goes, then one by one
template<class Backend, int D, class P>
template<class Graphs>
void SphSolver<Backend, D, P>::replaySteps(Graphs& graphs, int& count)
{
    const auto replay = [&](auto& graph, int together)
    {
        if (count < together) return;
        if (!graph.recorded()) graph.record(context_, [&] { for (int k = 0; k < together; ++k) step(); }, &solids_->launches());
        for (; count >= together; count -= together) graph.replay(context_);
    };
    replay(graphs.several, Graphs::together);
    replay(graphs.one, 1);
}

//- Recorded when they are launched for the second time: where solids get new lists again and again, they will not be
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::launchSteps(int count)
{
#ifdef __CUDACC__
    if constexpr (std::is_same<Backend, Gpu>::value)
    {
        constexpr std::size_t most = 16;
        const std::vector<const void*> key = stepKey();
        auto& graphs = parts_.turnGraphs;
        const auto known = graphs.find(key);
        if (known != graphs.end()) replaySteps(known->second, count);
        else if (!key.empty())
        {
            if (graphs.size() >= most) graphs.clear();
            graphs[key];
        }
    }
#endif
    for (; count > 0; --count) step();
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::readTurn()
{
#ifdef __CUDACC__
    if constexpr (std::is_same<Backend, Gpu>::value)
    {
        parts_.clocks.ask(context_, clock_.data());
        parts_.turns.ask(context_, turn_.data());
        host_ = parts_.clocks.take(context_);
        hostTurn_ = parts_.turns.take(context_);
    }
    else
#endif
    {
        readClock();
        context_.toHost(&hostTurn_, turn_.data(), sizeof(SolidTurn));
    }
    subcycles_ = solids_->still() ? 1 : hostTurn_.subcycles;
    // the most of the last looks: a step that needs more than are launched waits for the host, and others cost little
    constexpr int looks = 32;
    subcyclesSeen_ = std::max(subcyclesSeen_, subcycles_);
    if (subcycles_ <= subcyclesExpected_ && ++looksSince_ < looks) return;
    subcyclesExpected_ = std::max(1, subcyclesSeen_);
    subcyclesSeen_ = looksSince_ = 0;
}

//- A step whose solids wait: they go on, and so does the fluid
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::finishTurn()
{
    const bool good = solids_->finishTurn(hostTurn_);
    hostTurn_.waiting = 0;
    context_.toDevice(turn_.data(), &hostTurn_, sizeof(SolidTurn));
    host_.active = good;
    if (!good) host_.halt = Halt::solids;
    writeClock();
    if (!good) return;
    moveFluid();
    readClock();
}

//- Steps to launch before the host looks on: what is expected of lists, then a few
template<class Backend, int D, class P>
int SphSolver<Backend, D, P>::stepsOfBatch(std::int64_t taken) const
{
    double most = double(taken < stepsOfLists_ ? stepsOfLists_ - taken : std::max<std::int64_t>(1, stepsOfLists_/8));
    most = std::min(most, double(host_.lastStep - host_.step));
    if (host_.fullDt > 0) most = std::min(most, std::ceil((host_.target - host_.time)/host_.fullDt));
    return std::max(1, int(most));
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::runTurns(std::int64_t& rebuilds)
{
    const std::int64_t before = host_.step;
    while (!finished())
    {
        rebuild();
        ++rebuilds;
        const std::int64_t begin = host_.step;
        do
        {
            launchSteps(stepsOfBatch(host_.step - begin));
            readTurn();
            if (hostTurn_.waiting) finishTurn();
        }
        while (host_.active && !interrupted_);
        if (host_.overflows()) { growLists(); continue; }
        constexpr std::int64_t longest = 256;
        if (!finished()) stepsOfLists_ = std::max<std::int64_t>(1, std::min(longest, host_.step - begin));
        if (interrupted_.exchange(false)) break;
    }
    solids_->endTurns(host_.time, host_.dt, host_.previousDt, host_.step - before);
}

} // namespace riprap
