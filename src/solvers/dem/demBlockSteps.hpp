/*  Steps of a scene small enough for one block of the GPU: many in one launch, barriers where launches would follow one another. What is done for each
    particle, bond and rigid body, and so the bits, are those of a launch each.

    A step is two stretches of work between barriers, of which the second is three where there are rigid bodies:

        contacts, walls and bonds  |  sums of bonds, second kick; of the next step first kick and drift
        contacts, walls and bonds  |  sums of bonds  |  sums over bodies  |  their second kick, of the next step first kick and drift  |  particles

    Every thread works out the clock for itself, from the flags that all have raised: particles raise them in the second stretch, in the first clock, and all
    read them in the first; bonds raise theirs the other way round, in the second clock.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/solidTurn.hpp"
#include "dem/bond/bondPass.hpp"
#include "dem/motion/push.hpp"
#include "dem/passes/gatherPass.hpp"
#include "dem/motion/mover.hpp"
#include "dem/walls/wallPass.hpp"

namespace riprap
{

struct BlockLimits
{
    static constexpr int threads = 512;
    static constexpr int particles = 1024, bonds = 3072, nearWalls = 2048, bodies = 256;    // with more, launches that fill the device are faster
};

//- Velocity Verlet. Loops over what a team shares are written out: a body this large is inlined only where nothing but loops is around it
template<class Backend, int D, class P, class Law>
struct BlockSteps
{
    static constexpr const char* name = "blockSteps";
    static constexpr int threads = BlockLimits::threads, teams = threads/ClumpShares::threads;
    struct Shared { ClumpShares sums[teams]; };

    DemClockData* clocks;       // two
    MoveSolids<D, P> move;
    GatherPass<Backend, D, P, Law> contacts;
    WallPass<D, P, Law> walls;
    BondPass<D, P> bonds;
    GatherBonds<D, P> gather;
    FinishVerlet<D, P> finish;
    GatherClumps<D, P> gatherBodies;
    MoveClumps<D, P> moveBodies;
    FinishClumps<D, P> finishBodies;
    int n, bondCount, bodies, largestBody;
    bool nearWalls;
    int steps;
    EndTurn end;                // within a step of a fluid, which may be off; else empty

    HD void operator()(const Team& team, Shared& shared, int) const
    {
        if (end.turn && !*end.fluid.active) return;
        take(team, shared);
        if (end.turn && team.index == 0) end(0);
    }

private:

    HD void take(const Team& team, Shared& shared) const
    {
        DemClockData t{}, next = ticked(*clocks);
        team.wait();
        bool due = false, more = next.active;
        if (!more) return leave(team, next);
        begin(team, next, true);
        for (int k = 0;;)
        {
            if (bodies) moveOnBodies(team, shared, t, next, due, more);
            for (int i = team.index; i < n; i += team.size)
            {
                if (due) close(i, t.dt);
                if (more) drift(i, next);
            }
            team.wait();
            if (!more) return leave(team, k < steps ? next : t);
            t = next;
            readFlags(*clocks, t);
            due = t.forcesDue();                    // the same for all threads
            if (due) for (int w = team.index; w < n + bondCount; w += team.size) forces(w);
            team.wait();
            if (bondCount && clocks[1].needRebuild) t.needRebuild = 1;
            next = ticked(t);
            more = ++k < steps && next.active;
            if (more) begin(team, next, false);
        }
    }

    HD void drift(int i, const DemClockData& t) const
    {
        const SolidFields<D, P>& s = move.fields;
        if (i < *move.active && !s.asleep(i)) move.move(i, s.force(i), s.momentOn(i), t);
    }

    HD void forces(int w) const
    {
        if (w >= n) return bonds(w - n);
        contacts(w);
        if (nearWalls) walls(w);
    }

    HD void close(int i, double dt) const
    {
        if (i >= *move.active) return;
        if (bondCount && !bodies) gather.gather(i);
        finish.finish(i, dt);
    }

    //- Forces of their members on bodies end this step of theirs and begin the next one
    HD void moveOnBodies(const Team& team, Shared& shared, const DemClockData& t, const DemClockData& next, bool due, bool more) const
    {
        if (due && bondCount)
        {
            for (int i = team.index; i < n && i < *move.active; i += team.size) gather.gather(i);
            team.wait();
        }
        if (due) sumInTeam<teams>(team, shared.sums, bodies, largestBody, gatherBodies);
        for (int b = team.index; b < bodies; b += team.size)
        {
            if (due) finishBodies.finish(b, t.dt);
            if (more) moveBodies.move(b, next);
        }
        team.wait();
    }

    //- Of a step that is begun; flags are those of whoever raises them
    HD void begin(const Team& team, const DemClockData& t, bool first) const
    {
        if (team.index) return;
        clocks->active = 1;
        clocks->previousDt = t.previousDt;
        clocks->dt = t.dt;
        clocks->time = t.time;
        clocks->step = t.step;
        if (first) clocks[1].needRebuild = 0;
    }

    HD static void readFlags(const DemClockData& from, DemClockData& t)
    {
        t.needRebuild = from.needRebuild;
        t.halt = from.halt;
        for (int k = 0; k < 2; ++k)
        {
            t.aged[k] = from.aged[k];
            t.far[k] = from.far[k];
        }
    }

    HD void leave(const Team& team, const DemClockData& t) const { if (team.index == 0) *clocks = t; }
};

//- What the fluid gives at the beginning of its step, before the solids' own (coupling/solidTurn.hpp)
template<int D, class P>
struct OpenTurn
{
    static constexpr const char* name = "openTurn";
    static constexpr int threads = BlockLimits::threads, teams = threads/ClumpShares::threads;
    struct Shared { double most[threads]; ClumpShares sums[teams]; };

    BeginTurn begin;
    HoldInTurn<D, P> hold;          // the whole force, then the share of it that is held
    PushSolids<D, P> push;          // where there are blows,
    PushClumps<D, P> pushBodies;    // and bodies
    MoveSolids<D, P> move;
    GatherClumps<D, P> gatherBodies;
    int n, bodies, largestBody;

    HD void operator()(const Team& team, Shared& shared, int) const
    {
        if (!*begin.fluid.active) return;
        if (begin.impulse) blow(team, shared);
        const double speed = fastest(team, shared.most, n, Speeds{*this});
        if (team.index == 0) begin.begin(speed);
        team.wait();
        const bool check = begin.turn->check;
        const double share = begin.turn->share;
        for (int i = team.index; i < n; i += team.size)
        {
            if (check) checkWay(move, i);
            hold.holdShare(i, share);
        }
        team.wait();
        if (bodies) sumInTeam<teams>(team, shared.sums, bodies, largestBody, gatherBodies);
    }

private:

    struct Speeds
    {
        const OpenTurn& turn;
        HD double value(int i) const { return speedNow(turn.move, i); }
    };

    HD void blow(const Team& team, Shared& shared) const
    {
        for (int key = team.index; key < n; key += team.size) hold(key);
        team.wait();
        for (int i = team.index; i < n; i += team.size) push(i);
        team.wait();
        if (bodies) sumInTeam<teams>(team, shared.sums, bodies, largestBody, pushBodies);
    }
};

} // namespace riprap
