/*  DemSolver: its part of a fluid's steps that follow one another on the device (coupling/solidTurn.hpp).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/solidTurn.hpp"
#include "solvers/dem/demSolver.hpp"

namespace riprap
{

//- Fused steps alternate between two clocks, and tables of motions are sampled by the host for each step
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::takesTurns() const { return Backend::gpu && !fuses() && !groupMotions_ && !wallMotions_; }

template<class Backend, int D, class P>
HoldInTurn<D, P> DemSolver<Backend, D, P>::holdInTurn(const TurnLaunch<D, P>& turn, const double* share)
{ return HoldInTurn<D, P>{HoldForces<D, P>{turn.force, nullptr, external(), 1, 0}, turn.fluid.active, share}; }

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::launchPush(const TurnLaunch<D, P>& turn)
{
    if (still_) return;
    forEach(context_, n_, holdInTurn(turn, nullptr));
    push(BlowTime{0, turn.fluid.dt, turn.fluid.active});
}

//- Are the solids' steps of a turn one launch? In the first turn, which leaves no room for blows before it has the first force, they are not
template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::turnsInBlock() const { return fitsBlock() && external_.size() && !context_.profile.timing; }

template<class Backend, int D, class P>
BeginTurn DemSolver<Backend, D, P>::turnBegin(const TurnLaunch<D, P>& turn)
{
    const double room = double(halfSkin_) - double(suddenWay_);
    return BeginTurn
    {turn.fluid, turn.turn, clock_.data(), plan_.timeStep, room, turn.impulse, config_.integrator == DemIntegratorKind::velocityVerlet};
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::beginTurn(const TurnLaunch<D, P>& turn)
{
    const SpeedOfSolids<D, P> speed{mover()};
    const auto begin = [&](const auto& speeds, int count)
    { forEachBlock(context_, 1, BeginByBlock<std::decay_t<decltype(speeds)>>{turnBegin(turn), speeds, count}); };
    if (n_ < SpeedShares<D, P>::from) begin(speed, n_);
    else
    {
        constexpr int shares = SpeedShares<D, P>::shares;
        if (speedShares_.size() == 0) speedShares_.allocate(context_, shares);
        forEach(context_, shares, SpeedShares<D, P>{speed, n_, speedShares_.data()});
        begin(KnownSpeeds{speedShares_.data()}, shares);
    }
    forEach(context_, n_, CheckInTurn<D, P>{CheckWays<D, P>{mover()}, turn.fluid.active, turn.turn});
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::launchTurn(const TurnLaunch<D, P>& turn)
{
    if (still_) return;
    if constexpr (Backend::gpu) if (turnsInBlock()) return turnInBlock(turn);
    if (turn.impulse) launchPush(turn);
    beginTurn(turn);
    forEach(context_, n_, holdInTurn(turn, &turn.turn->share));
    gatherClumps(nullptr, turn.fluid.active);
    // those beyond what is to be done switch themselves off
    if constexpr (Backend::gpu) for (int k = 0; k < turn.expected; ++k) step();
    else do step(); while (clock_.data()->active);
    forEach(context_, 1, EndTurn{turn.fluid, turn.turn, clock_.data()});
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::turnInBlock(const TurnLaunch<D, P>& turn)
{
    const BlowTime time{0, turn.fluid.dt, turn.fluid.active};
    OpenTurn<D, P> open{};
    open.begin = turnBegin(turn);
    open.hold = holdInTurn(turn, nullptr);
    open.push = pushSolids(time);
    if (nClumps_) open.pushBodies = pushClumps(time);
    open.move = mover();
    if (nClumps_) open.gatherBodies = clumpGather(nullptr, nullptr);
    open.n = n_;
    open.bodies = nClumps_;
    open.largestBody = largestClump_;
    forEachBlock(context_, 1, open);
    withLaw(laws_, [&](auto law)
    {
        constexpr int enough = 1 << 16;
        auto steps = blockSteps<decltype(law)>(enough);
        steps.end = EndTurn{turn.fluid, turn.turn, clock_.data()};
        forEachBlock(context_, 1, steps);
    });
}

template<class Backend, int D, class P>
std::vector<const void*> DemSolver<Backend, D, P>::turnKey(const TurnLaunch<D, P>& turn)
{
    if (!fields_.alternates()) return {};
    std::vector<const void*> key = graphKey(turnsInBlock() ? 0 : turn.expected);
    key.push_back(reinterpret_cast<const void*>(std::size_t(shapes_)));
    for (const void* p : std::initializer_list<const void*>{fields().x[0], sort_.active(), slotOf_.data(), clock_.data()}) key.push_back(p);
    return key;
}

template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::finishTurn(const SolidTurn& turn)
{
    readClock();
    // the last step waits with its forces, unless the lists were found to be spent before the first one
    if (Backend::gpu && host_.lost() && host_.step > turn.begun && host_.halt == DemHalt::none) finishLate();
    runToTarget(lastReport_.rebuilds);
    return host_.halt == DemHalt::none;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::endTurns(double t, double dt, double previousDt, std::int64_t steps)
{
    if (!still_) return readClock();
    if (steps == 0) return;
    host_.previousDt = steps > 1 ? previousDt : host_.dt;
    host_.dt = host_.fullDt = dt;
    host_.time = host_.target = t;
    host_.step += steps;
}

} // namespace riprap
