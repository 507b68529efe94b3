/*  The solids' part of a step of the fluid where the host does not look on: what the fluid's clock gives, and what becomes of it, stays on the device.

    A turn begins with the step that the fluid's clock has begun, takes as many steps of the solids as fit it, and ends. What only the host can do, such as new
    lists of the solids, it is left to: then the turn waits, the fluid's steps switch themselves off, and the host goes on from there.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/blocks.hpp"
#include "coupling/solidView.hpp"
#include "dem/motion/solidWays.hpp"
#include "dem/state/clock.hpp"

namespace riprap
{

//- What of the force at the step's beginning, and of the force one step before, solids get
struct ForceShares { double now, before; };

template<class R>
struct KeepForces
{
    static constexpr const char* name = "keepForces";

    const R* force;
    R* before;

    HD void operator()(int i) const { before[i] = force[i]; }
};

//- The force that solids are given over a step, by those of its beginning and of the beginning of the step before. The fluid gets that of each
//  instant half in the step before it and half in the one after it: the shares make the solids' impulse the same
template<int D, class P>
struct HoldForces
{
    using real = typename P::real;
    static constexpr const char* name = "holdForces";

    const real* force;
    const real* before;         // null: not needed
    real* external;
    double share, shareBefore;

    HD void operator()(int key) const
    {
        constexpr int width = D + spins<D>;
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = std::size_t(key)*D + d;
            external[std::size_t(key)*width + d] = real(share*force[at] + (before ? shareBefore*before[at] : 0));
        }
    }
};

//- Share of the force at the step's beginning where it is held over the step; 0 after steps that took none: the first one
HD double heldShare(double previousDt, double dt) { return 0.5*(1 + previousDt/dt); }

//- Steps of the solids in one of the fluid, by contacts and by the fastest of them
struct Subcycles
{
    int steps;
    bool check;                 // a blow since the last look may have spent the lists: ask them again
};

//- stableStep: of contacts; room: [m] that lists leave a step
HD Subcycles subcyclesOf(double dt, double stableStep, double speed, double room)
{
    const double fitting = ceil(dt/stableStep*(1 - 1e-9));
    const int contacts = fitting < 1 ? 1 : int(fitting);        // K of paper 2, section 2.3, rounded up; Eq. 25
    const double way = 1.25*dt*speed;
    if (!(way > 0.1*contacts*room)) return Subcycles{contacts, false};
    // fast ones, or a blow since the last look: a step stays within what new lists allow, and lists are new where too little is left
    if (!(way < 1e6*room)) return Subcycles{contacts, true};
    const int ways = int(ceil(way/room*(1 - 1e-9)));
    return Subcycles{ways > contacts ? ways : contacts, true};
}

//- The fluid's clock
struct FluidTurn
{
    const double* time;
    const double* dt;
    const double* previousDt;
    int* active;                // 0: the step is off
};

struct SolidTurn
{
    double share = 0;           // of the fluid's force
    std::int64_t begun = 0;     // step of the solids' clock at the beginning
    int subcycles = 0;
    int check = 0;              // do lists have to be asked again?
    int waiting = 0;            // for the host
    int padding = 0;
};

//- What a turn is launched with
template<int D, class P>
struct TurnLaunch
{
    FluidTurn fluid;
    SolidTurn* turn;
    const typename P::real* force;      // of the fluid, D a key
    bool impulse;                       // as two blows, at the beginning and the end of the step; else held
    int expected;                       // steps
};

template<int D, class P>
struct HoldInTurn
{
    static constexpr const char* name = HoldForces<D, P>::name;

    HoldForces<D, P> hold;
    const int* active;
    const double* share;        // null: hold has it

    HD void operator()(int key) const
    {
        if (!*active) return;
        if (share) holdShare(key, *share);
        else hold(key);
    }

    HD void holdShare(int key, double now) const { HoldForces<D, P>{hold.force, nullptr, hold.external, now, 0}(key); }
};

//- The fastest of a strided share of many
template<int D, class P>
struct SpeedShares
{
    static constexpr const char* name = SpeedOfSolids<D, P>::name;
    static constexpr int shares = 2048;
    static constexpr int from = 4096;   // with fewer, one block looks at each

    SpeedOfSolids<D, P> speed;
    int n;
    double* most;

    HD void operator()(int k) const
    {
        double found = 0;
        for (int i = k; i < n; i += shares)
        {
            const double v = speed.value(i);
            if (!(v <= found)) found = v;
        }
        most[k] = found;
    }
};

struct KnownSpeeds
{
    const double* speed;
    HD double value(int k) const { return speed[k]; }
};

//- The largest speeds.value(k), of all threads; `most` is theirs
template<class Speeds>
HD double fastest(const Team& team, double* most, int count, const Speeds& speeds)
{
    double found = 0;
    for (int k = team.index; k < count; k += team.size)
    {
        const double v = speeds.value(k);
        if (!(v <= found)) found = v;           // a NaN stays
    }
    most[team.index] = found;
    team.wait();
    for (int half = team.size/2; half > 0; half /= 2)
    {
        if (team.index < half && !(most[team.index + half] <= most[team.index])) most[team.index] = most[team.index + half];
        team.wait();
    }
    return most[0];
}

//- The solids' clock for the step of the fluid
struct BeginTurn
{
    FluidTurn fluid;
    SolidTurn* turn;
    DemClockData* clocks;
    double stableStep, room;
    bool impulse, verlet;

    HD void begin(double speed) const
    {
        const double dt = *fluid.dt;
        const Subcycles s = subcyclesOf(dt, stableStep, speed, room);
        DemClockData c = *clocks;
        // the sum of the kicks of these steps (dem/motion/mover.hpp): leapfrog's first one begins half a step before
        const double kicks = verlet ? dt : dt + 0.5*(c.dt - dt/s.steps);
        turn->share = impulse ? 0 : dt/kicks*heldShare(*fluid.previousDt, dt);
        turn->subcycles = s.steps;
        turn->check = s.check;
        turn->begun = c.step;
        c.target = *fluid.time;
        c.lastStep = std::int64_t(1) << 62;
        c.fullDt = dt/s.steps;
        clocks[0] = clocks[1] = c;
    }
};

//- The same as a launch
template<class Speeds>
struct BeginByBlock
{
    static constexpr const char* name = "beginSolids";
    static constexpr int threads = 256;
    struct Shared { double most[threads]; };

    BeginTurn begin;
    Speeds speeds;
    int count;

    HD void operator()(const Team& team, Shared& shared, int) const
    {
        if (!*begin.fluid.active) return;
        const double speed = fastest(team, shared.most, count, speeds);
        if (team.index == 0) begin.begin(speed);
    }
};

template<int D, class P>
struct CheckInTurn
{
    static constexpr const char* name = CheckWays<D, P>::name;

    CheckWays<D, P> check;
    const int* active;
    const SolidTurn* turn;

    HD void operator()(int i) const { if (*active && turn->check) check(i); }
};

//- Have the solids come to where the fluid's step ends?
struct EndTurn
{
    static constexpr const char* name = "endSolids";

    FluidTurn fluid;
    SolidTurn* turn;
    const DemClockData* clock;

    HD void operator()(int) const
    {
        if (!*fluid.active) return;
        turn->check = 0;
        if (clock->time >= clock->target && !clock->lost() && clock->halt == DemHalt::none) return;
        turn->waiting = 1;
        *fluid.active = 0;
    }
};

} // namespace riprap
