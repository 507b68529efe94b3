/*  Steps until the target of the clock. On the GPU a rebuild, a step and several steps are recorded
    in graphs, each twice because a rebuild swaps the halves of double-buffered fields; steps switch
    themselves off when neighbours have aged or the target is reached, so the host looks on only
    after two cycles of a rebuild and a number of steps.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/driver/sphNeighbours.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SphStepper
{
public:
    SphStepper(SphParts<Backend, D, P>& parts, FluidPasses<Backend, D, P>& fluid,
        WallPasses<Backend, D, P>& walls, SolidCoupling<Backend, D, P>& solids,
        SphNeighbours<Backend, D, P>& neighbours)
        : p_(parts), fluid_(fluid), walls_(walls), solids_(solids), neighbours_(neighbours)
    {}

    //- To the clock's target; adds how often neighbours were sought
    void run(std::int64_t& rebuilds);

private:

    //- What integrators consist of (sph/time)
    struct Step
    {
        SphStepper& of;

        //- Particles, by the functor of an integrator
        template<template<class, int, class> class M>
        void move()
        {
            of.fluid_.template move<M<Backend, D, P>>();
            if (of.p_.ranks) of.p_.ranks->shareRecords();
        }

        //- Walls and solids to the middle of the step
        void moveToMiddle()
        {
            of.walls_.move(true);
            of.solids_.move(true);
        }

        //- Walls and solids to its end, with what the fluid, which is there, gives them
        void moveToEnd()
        {
            of.walls_.pushBodies();
            of.walls_.move(false);
            of.solids_.move(false);
            of.walls_.extrapolate(true);
            of.solids_.pressurePass(true);
        }

        //- Over the pairs
        template<Part part>
        void pass()
        {
            of.solids_.template pass<part>();
            of.fluid_.template pass<part>(Finish::close);
        }
    };

    void step();
    void passes();
    void passesAfterSolids();
    int stepsAhead() const;
    void runCycles(int steps, bool graphs);
    void runCyclesOfRanks(int steps);
    void rebuildOfRanks();
    void fitCycle(int taken);

    SphParts<Backend, D, P>& p_;
    FluidPasses<Backend, D, P>& fluid_;
    WallPasses<Backend, D, P>& walls_;
    SolidCoupling<Backend, D, P>& solids_;
    SphNeighbours<Backend, D, P>& neighbours_;
};

template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::step()
{
    forEach(p_.set.context, 1, p_.tick());
    if constexpr (!Backend::gpu) if (!p_.clock.data()->active) return;
    if (Backend::gpu && p_.ranks && !p_.ranks->particles().peers.there())
    {
        // hosts send each other nothing in a step that is off
        p_.clock.read();
        if (!p_.clock.now.active) return;
    }
    if (p_.solids.side)
    {
        if (Backend::gpu && !p_.solids.fluidForce().blows)
            p_.solids.side->measureSpeed();
        p_.clock.read();
        if (p_.clock.now.active) solids_.advance();
        if (!p_.clock.now.active) return;
        passesAfterSolids();
        if (p_.solids.fluidForce().blows) solids_.push();
    }
    else passes();
}

//- Passes of a step over fluid, walls and what solids and fluid do to each other
template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::passes()
{
    walls_.moveFaces();
    withIntegrator(p_.set.config, [this](auto integrator)
    {
        Step step{*this};
        decltype(integrator)::run(step);
    });
    walls_.force(nullptr);
    solids_.forcePass();
    if (p_.ranks) p_.ranks->agree(p_.clock, p_.interrupted);
}

//- On the GPU recorded, for each memory that fields of fluid, walls and solids alternate between:
//  the host, which has waited for the solids' steps, launches once
template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::passesAfterSolids()
{
#ifdef __CUDACC__
    if constexpr (std::is_same<Backend, Gpu>::value)
        if (!p_.ranks && !p_.set.context.profile.timing && p_.fluid.values.alternates()
            && (!p_.walls.bodies || p_.walls.values.alternates()))
        {
            std::string key;
            const auto add = [&](const auto& value)
            { key.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
            add(p_.solids.side->view());
            add(p_.solids.meetFluid);
            add(p_.fluid.values.bytes(0));
            if (p_.walls.bodies) add(p_.walls.values.bytes(0));
            auto& graphs = p_.memory.graphs.afterSolids;
            constexpr std::size_t most = 16;
            if (graphs.size() >= most && !graphs.count(key)) graphs.clear();
            Graph& graph = graphs[key];
            if (!graph.recorded()) graph.record(p_.set.context, [&] { passes(); });
            graph.replay(p_.set.context);
            return;
        }
#endif
    passes();
}

template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::run(std::int64_t& rebuilds)
{
    // solids are advanced by the host between the steps of the fluid: those follow one another one
    // by one
    if (!Backend::gpu || p_.solids.side)
    {
        while (!p_.clock.over())
        {
            rebuildOfRanks();
            ++rebuilds;
            // on the GPU a step with solids has read its clock by itself: the host waits once less
            do {
                step();
                if (!Backend::gpu) p_.clock.read();
            }
            while (p_.clock.now.active && !p_.stopAsked());
            if (Backend::gpu) p_.clock.read();
            if (p_.clock.now.overflows()) { neighbours_.growLists(); continue; }
            if (p_.stopAsked()) { p_.interrupted = false; break; }
        }
    }
    else if constexpr (Backend::gpu)
    {
        const bool wallsAlternate = !p_.walls.bodies || p_.walls.values.alternates();
        while (!p_.clock.over())
        {
            const std::int64_t before = p_.clock.now.step;
            // large sets rotate through spare memory, and do not need graphs; what ranks send
            // passes through the host
            const bool graphs = !p_.set.context.profile.timing && p_.fluid.values.alternates()
                && wallsAlternate && !p_.ranks;
            const int steps = stepsAhead();
            if (p_.ranks) runCyclesOfRanks(steps);
            else runCycles(steps, graphs);
            rebuilds += 2;
            p_.clock.read();
            if (p_.clock.now.overflows()) { neighbours_.growLists(); continue; }
            // heeded, whatever else ends the loop
            const bool interrupted = p_.ranks ? p_.stopAsked() : p_.interrupted.exchange(false);
            if (p_.ranks && interrupted) p_.interrupted = false;
            if (p_.clock.over() || interrupted) break;
            if (steps == p_.cycle.steps) fitCycle(int(p_.clock.now.step - before));
        }
    }
}

//- Steps of the next cycles: no more than could be wanted
template<class Backend, int D, class P>
int SphStepper<Backend, D, P>::stepsAhead() const
{
    double most = double(p_.clock.now.lastStep - p_.clock.now.step);
    // a step may turn out longer or shorter than the last: some more, and then again
    if (p_.clock.now.fullDt > 0)
        most = std::min(
            most, 1.05*(p_.clock.now.target - p_.clock.now.time)/p_.clock.now.fullDt + 2);
    return most < p_.cycle.steps ? std::max(1, int(most)) : p_.cycle.steps;
}

//- Twice: a rebuild, and steps of which those that find their neighbours too old switch themselves
//  off
template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::runCycles([[maybe_unused]] int steps, [[maybe_unused]] bool graphs)
{
    if constexpr (Backend::gpu)
    {
        auto& g = p_.memory.graphs;
        const auto several = [&] { for (int k = 0; k < g.together; ++k) step(); };
        for (int c = 0; graphs && !g.recorded && c < 2; ++c)
        {
            g.rebuild[c].record(p_.set.context, [&] { neighbours_.rebuild(); });
            g.step[c].record(p_.set.context, [&] { step(); });
            g.steps[c].record(p_.set.context, several);
        }
        g.recorded = g.recorded || graphs;
        for (int c = 0; c < 2; ++c)
        {
            if (graphs) g.rebuild[c].replay(p_.set.context); else neighbours_.rebuild();
            int k = 0;
            for (; k + g.together <= steps; k += g.together)
            {
                if (graphs) g.steps[c].replay(p_.set.context);
                else several();
            }
            for (; k < steps; ++k) { if (graphs) g.step[c].replay(p_.set.context); else step(); }
        }
    }
}

//- The same on several ranks. Where their hosts send, each sees when a step is off, as those after
//  it would be
template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::runCyclesOfRanks(int steps)
{
    const bool direct = p_.ranks->particles().peers.there();
    for (int c = 0; c < 2; ++c)
    {
        rebuildOfRanks();
        for (int k = 0; k < steps; ++k)
        {
            step();
            if (!direct && (!p_.clock.now.active || p_.stopAsked())) break;
        }
        if (p_.stopAsked()) break;
    }
}

//- Where hosts launch ahead ranks agree here whether somebody wants them to stop
template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::rebuildOfRanks()
{
    neighbours_.rebuild();
    if (p_.ranks && p_.ranks->particles().peers.there())
        p_.ranks->agreeToStop(p_.interrupted);
}

//- The length of a cycle after two of them took so many steps. Those that find nothing to do take
//  time, and so does a rebuild that came too early
template<class Backend, int D, class P>
void SphStepper<Backend, D, P>::fitCycle(int taken)
{
    constexpr int longest = 128, patience = 2;
    if (taken < 2*p_.cycle.steps)
    {
        // one that was cut short, as by a particle that left, says little
        p_.cycle.steps = std::max({2, taken/2, p_.cycle.fitted ? 7*p_.cycle.steps/8 : 2});
        p_.cycle.full = 0;
        p_.cycle.fitted = true;
    }
    else if (!p_.cycle.fitted)
        p_.cycle.steps = std::min(longest, p_.cycle.steps + p_.cycle.steps/2);
    else if (++p_.cycle.full >= patience)
    {
        p_.cycle.steps = std::min(longest, p_.cycle.steps + std::max(1, p_.cycle.steps/16));
        p_.cycle.full = 0;
    }
}

} // namespace riprap
