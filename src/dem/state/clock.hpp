/*  The clock of a DEM scene, on the device: steps follow one another without the host, and switch
    themselves off when neighbours have aged, a motion table ends, the target is reached or a guard
    fires.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/simd/macros.hpp"

namespace riprap
{

enum class DemHalt : int {none = 0, tooFar, wallTooFar};

struct DemClockData
{
    double time = 0, target = 0;
    double dt = 0, previousDt = 0;          // of this step and the one before [s]
    double windowEnd = 1e300;               // motion tables reach so far
    double fullDt = 0;                      // of a step that no target shortens
    double searched = 0;                    // when neighbours were sought
    std::int64_t step = 0, lastStep = 0;
    int active = 0;
    int needRebuild = 0;
    int needWindow = 0;
    DemHalt halt = DemHalt::none;
    // neighbours, by the ways of particles against those near them; by the ways alone
    int aged[2] = {0, 0};
    int far[2] = {0, 0};                    // farther than that was foreseen, likewise

    //- May pairs of the positions at hand be missing? Then forces wait for new neighbours
    HD bool lost() const { return far[0] && far[1]; }

    //- Lists hold as long as one of the two says so
    HD void settleAge() { if ((aged[0] && aged[1]) || lost()) needRebuild = 1; }

    //- Does this step come to its forces?
    HD bool forcesDue() const { return active && !lost(); }

    //- Neighbours are new
    HD void search()
    {
        needRebuild = aged[0] = aged[1] = far[0] = far[1] = 0;
        searched = time;
    }
};

static_assert(sizeof(DemClockData) == 9*8 + 8*4, "DemClockData has padding");

//- The clock of the next step; active 0: there is none for now
HD DemClockData ticked(DemClockData c)
{
    c.active = 0;
    c.settleAge();
    if (c.halt != DemHalt::none || c.needRebuild || c.time >= c.target || c.step >= c.lastStep)
        return c;
    const double remaining = c.target - c.time;
    double dt = c.fullDt;
    bool last = false;
    // the last two steps share what is left, so that none is tiny
    if (dt >= remaining*(1 - 1e-9)) { last = true; dt = remaining; }
    else if (2*dt > remaining*(1 + 1e-9)) dt = 0.5*remaining;
    if (c.time + 0.5*dt > c.windowEnd) { c.needWindow = 1; return c; }
    c.previousDt = c.dt;
    c.dt = dt;
    c.time = last ? c.target : c.time + dt;
    c.step += 1;
    c.active = 1;
    return c;
}

struct DemTick
{
    static constexpr const char* name = "clock";

    DemClockData* clock;

    HD void operator()(int) const { *clock = ticked(*clock); }
};

//- The clock as the host has it, without a copy that the host would wait for
struct SetDemClock
{
    static constexpr const char* name = "setClock";

    DemClockData value;
    DemClockData* clocks;

    HD void operator()(int k) const { clocks[k] = value; }
};

//- When a pass over forces takes place. In fused steps forces are those at the start of a step that
//  the clock has not yet come to, and what is raised is for the one after it
enum class ForceTurn : int {inStep, ahead, always};

struct ForceClock
{
    const DemClockData* clock;
    DemClockData* raised;       // where flags go: the clock itself, or the next one
    ForceTurn turn;

    HD bool active() const
    {
        if (turn == ForceTurn::always) return true;
        return turn == ForceTurn::inStep ? clock->forcesDue() : ticked(*clock).active != 0;
    }
    //- The step that led to the positions at hand
    HD double dt() const { return clock->dt; }
};

} // namespace riprap
