/*  SphSolver: the loop over steps. On the GPU a rebuild, a step and several steps are recorded in
    graphs, each twice because a rebuild swaps the halves of double-buffered fields; steps switch
    themselves off when neighbours have aged or the target is reached, so the host looks on only
    after two cycles of a rebuild and a number of steps.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "solvers/sph/sphReadBack.hpp"
#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P> void SphSolver<Backend, D, P>::readClock()
{
    context_.toHost(&host_, clock_.data(), sizeof(ClockData));
}

template<class Backend, int D, class P> void SphSolver<Backend, D, P>::writeClock()
{
    context_.toDevice(clock_.data(), &host_, sizeof(ClockData));
}

template<class Backend, int D, class P>
bool SphSolver<Backend, D, P>::finished() const
{
    return host_.halt != Halt::none || host_.time >= host_.target || host_.step >= host_.lastStep;
}

//- Poses of the moving groups over the interval that is about to be advanced. None is asked for
//  before it or, unless it is shorter than a millisecond, after it: a table may begin and end there
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setPoses(double begin, double end)
{
    poseBegin_ = begin;
    // second differences of instants that are closer drown in round-off
    poseStep_ = std::max(end - begin, 1e-3)/poseIntervals;
    std::vector<PoseSample> samples(std::size_t(nBodies_)*(poseIntervals + 1));
    const auto pose = [&](int body, double t)
    {
        const WallPose p = motion_(body, t);
        std::array<double, 12> r;
        for (int k = 0; k < 9; ++k) r[k] = p.rotation[k];
        for (int k = 0; k < 3; ++k) r[9 + k] = p.translation[k];
        return r;
    };
    const double dt = 0.02*poseStep_;
    for (int b = 0; b < nBodies_; ++b)
        for (int k = 0; k <= poseIntervals; ++k)
        {
            const bool first = k == 0, last = k == poseIntervals;
            const double t = last ? begin + std::max(end - begin, 1e-3) : begin + k*poseStep_;
            const auto now = pose(b, t);
            // three instants, all on one side at the ends
            const auto p = pose(b, first ? t + dt : t - dt),
                       q = pose(b, first ? t + 2*dt : (last ? t - 2*dt : t + dt));
            PoseSample& s = samples[std::size_t(b)*(poseIntervals + 1) + k];
            for (int e = 0; e < 12; ++e)
            {
                s.value[e] = now[e];
                s.rate[e] = first || last
                    ? (first ? 1 : -1)*(4*p[e] - 3*now[e] - q[e])/(2*dt)
                    : (q[e] - p[e])/(2*dt);
            }
        }
    context_.toDevice(poses_.data(), samples.data(), samples.size()*sizeof(PoseSample));
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::runToTarget(std::int64_t& rebuilds)
{
    // solids are advanced by the host between the steps of the fluid: those follow one another one
    // by one
    if (!Backend::gpu || solids_)
    {
        while (!finished())
        {
            rebuild();
            ++rebuilds;
            // on the GPU a step with solids has read its clock by itself: the host waits once less
            do { step(); if (!Backend::gpu) readClock(); } while (host_.active && !stopAsked());
            if (Backend::gpu) readClock();
            if (host_.overflows()) { growLists(); continue; }
            if (stopAsked()) { interrupted_ = false; break; }
        }
    }
    else if constexpr (Backend::gpu)
    {
        const bool wallsAlternate = !nBodies_ || wall_.alternates();
        while (!finished())
        {
            const std::int64_t before = host_.step;
            // large sets rotate through spare memory, and do not need graphs
            const bool graphs = !context_.profile.timing && fluid_.alternates() && wallsAlternate;
            const int steps = stepsAhead();
            runCycles(steps, graphs);
            rebuilds += 2;
            readClock();
            if (host_.overflows()) { growLists(); continue; }
            // heeded, whatever else ends the loop
            const bool interrupted = interrupted_.exchange(false);
            if (finished() || interrupted) break;
            if (steps == cycle_.steps) fitCycle(int(host_.step - before));
        }
    }
}

//- Steps of the next cycles: no more than could be wanted
template<class Backend, int D, class P>
int SphSolver<Backend, D, P>::stepsAhead() const
{
    double most = double(host_.lastStep - host_.step);
    // a step may turn out longer or shorter than the last: some more, and then again
    if (host_.fullDt > 0) most = std::min(most, 1.05*(host_.target - host_.time)/host_.fullDt + 2);
    return most < cycle_.steps ? std::max(1, int(most)) : cycle_.steps;
}

//- Twice: a rebuild, and steps of which those that find their neighbours too old switch themselves
//  off
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::runCycles([[maybe_unused]] int steps, [[maybe_unused]] bool graphs)
{
    if constexpr (Backend::gpu)
    {
        auto& g = parts_.graphs;
        const auto several = [&] { for (int k = 0; k < g.together; ++k) step(); };
        for (int c = 0; graphs && !g.recorded && c < 2; ++c)
        {
            g.rebuild[c].record(context_, [&] { rebuild(); });
            g.step[c].record(context_, [&] { step(); });
            g.steps[c].record(context_, several);
        }
        g.recorded = g.recorded || graphs;
        for (int c = 0; c < 2; ++c)
        {
            if (graphs) g.rebuild[c].replay(context_); else rebuild();
            int k = 0;
            for (; k + g.together <= steps; k += g.together)
            {
                if (graphs) g.steps[c].replay(context_);
                else several();
            }
            for (; k < steps; ++k) { if (graphs) g.step[c].replay(context_); else step(); }
        }
    }
}

//- The length of a cycle after two of them took so many steps. Those that find nothing to do take
//  time, and so does a rebuild that came too early
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::fitCycle(int taken)
{
    constexpr int longest = 128, patience = 2;
    if (taken < 2*cycle_.steps)
    {
        // one that was cut short, as by a particle that left, says little
        cycle_.steps = std::max({2, taken/2, cycle_.fitted ? 7*cycle_.steps/8 : 2});
        cycle_.full = 0;
        cycle_.fitted = true;
    }
    else if (!cycle_.fitted) cycle_.steps = std::min(longest, cycle_.steps + cycle_.steps/2);
    else if (++cycle_.full >= patience)
    {
        cycle_.steps = std::min(longest, cycle_.steps + std::max(1, cycle_.steps/16));
        cycle_.full = 0;
    }
}

template<class Backend, int D, class P>
SphReport SphSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    SphReport report;
    readClock();
    if (nBodies_)
    {
        setPoses(host_.time, std::max(t, host_.time));
        // poses are part of the recorded launches
        if constexpr (Backend::gpu) parts_.graphs.recorded = false;
    }
    if (ranks_) ranks_->agreeToStop(interrupted_);
    if (stopAsked()) maxSteps = 1;
    const std::int64_t before = host_.step;
    if (solids_) solids_->beginReport();
    host_.target = t;
    host_.lastStep = maxSteps > 0 ? before + maxSteps : std::int64_t(1) << 62;
    host_.minDt = 1e300;
    host_.maxDt = 0;
    host_.needRebuild = host_.aged[0] = host_.aged[1] = 0;
    host_.skinViolations = host_.missed[0] = host_.missed[1] = 0;
    // also before and after all steps: what the last one did is said in its own call, before anyone
    // writes it, and while the records are those that it saw
    if (host_.halt == Halt::none) host_.halt = limits_.halt(host_);
    writeClock();
    runToTarget(report.rebuilds);
    host_.settleAge();
    if (host_.halt == Halt::none)
    {
        host_.halt = limits_.halt(host_);
        if (host_.halt != Halt::none) writeClock();
    }

    report.time = host_.time;
    report.lastTimeStep = host_.dt;
    report.steps = host_.step - before;
    report.totalSteps = host_.step;
    report.minTimeStep = report.steps ? host_.minDt : 0;
    report.maxTimeStep = host_.maxDt;
    static const char* names[] = {
        "none", "acoustic", "force", "viscous", "fixed", "target", "maximum", "growth"};
    report.limit = names[int(host_.limit)];
    report.maxDensityDeviation = host_.maxima[2];
    report.maxSpeed = host_.maxima[3];
    report.skinExceeded = host_.skinViolations;
    if (host_.halt != Halt::none) findOffender(report);
    // the last step may have carried particles out: a sort now says so in this call. The next one
    // sorts to the same order
    else if (report.steps && host_.needRebuild) sortNow();
    collectEscaped(report);
    if (solids_) solids_->endReport();
    showForces();
    return report;
}

//- Particles that left: sorted to the end by the last rebuild, reported once
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::collectEscaped(SphReport& report)
{
    if (ranks_) return ranks_->report(report);
    const int active = activeFluid();
    report.fluid = active;
    if (active >= reported_) return;
    std::vector<std::int64_t> x[D];
    std::vector<double> metres;
    for (int d = 0; d < D; ++d)
        x[d] = fluid_.template download<std::int64_t>(context_, xField_ + d);
    const auto id = fluid_.template download<std::int32_t>(context_, idField_);
    toMetres(x, n_, metres);
    const auto deviation = fluid_.template download<real>(context_, deviationField_);
    std::vector<real> v[D];
    for (int d = 0; d < D; ++d) v[d] = fluid_.template download<real>(context_, vField_ + d);
    for (int i = active; i < reported_; ++i)
    {
        if (id[i] < 0)
        {
            double speed2 = 0;
            for (int d = 0; d < D; ++d) speed2 += double(v[d][i])*v[d][i];
            report.wild.push_back(WildParticle{-1 - id[i],
                Vector3{{metres[3*i], metres[3*i + 1], metres[3*i + 2]}}, deviation[i],
                std::sqrt(speed2)});
            continue;
        }
        report.escaped.push_back(Vector3{{metres[3*i], metres[3*i + 1], metres[3*i + 2]}});
        report.escapedId.push_back(id[i]);
    }
    reported_ = active;
}

//- What pairs saw of each particle in the last pass, in units of what is usual. A number that is
//  none makes those that it meets so too, within the pass: what it was made of tells the one that
//  began from the others
template<class Backend, int D, class P>
std::vector<double> SphSolver<Backend, D, P>::suspicion(int n)
{
    Array<Backend, double> result;
    result.allocate(context_, n);
    forEach(context_, n,
        Suspicion<Backend, D, P>{
            fluidRecords_.view(), config_.soundSpeed, config_.density, result.data()});
    return result.download();
}

//- Which particle made a guard fire
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::findOffender(SphReport& report)
{
    // DemScene::lastReport has more
    if (host_.halt == Halt::solids) { report.stop = StopReason::solids; return; }
    report.stop = host_.halt == Halt::notANumber ? StopReason::notANumber
        : (host_.halt == Halt::density ? StopReason::density : StopReason::speed);
    const double worst = findWorst(report);
    if (ranks_) ranks_->agreeOnOffender(report, worst);
}

//- Of those of this rank. \return what it was found by
template<class Backend, int D, class P>
double SphSolver<Backend, D, P>::findWorst(SphReport& report)
{
    const int n = activeFluid();
    const auto deviation = fluid_.template download<real>(context_, deviationField_);
    std::vector<real> v[D], a[D];
    std::vector<std::int64_t> x[D];
    for (int d = 0; d < D; ++d)
    {
        v[d] = fluid_.template download<real>(context_, vField_ + d);
        a[d] = fluid_.template download<real>(context_, aField_ + d);
        x[d] = fluid_.template download<std::int64_t>(context_, xField_ + d);
    }
    const auto id = fluid_.template download<std::int32_t>(context_, idField_);
    std::vector<double> metres, suspect;
    toMetres(x, n, metres);
    if (report.stop == StopReason::notANumber) suspect = suspicion(n);
    double worst = -1;
    for (int i = 0; i < n; ++i)
    {
        if (ranks_ && ranks_->ghost(i)) continue;
        real speed2 = 0, a2 = 0;
        for (int d = 0; d < D; ++d) { speed2 += v[d][i]*v[d][i]; a2 += a[d][i]*a[d][i]; }
        double value = report.stop == StopReason::density ? std::abs(double(deviation[i]))
                                                          : std::sqrt(double(speed2));
        if (report.stop == StopReason::notANumber)
        {
            // the bounds are the clock's; speed^2 may overflow where the speed does not
            const bool fine = a2 < 1e30 && std::sqrt(speed2) < 1e30 && std::abs(deviation[i]) < 1e30
                && deviation[i] > -1;
            value = fine ? -0.5
                         : (std::isfinite(suspect[i]) ? suspect[i]
                                                      : std::numeric_limits<double>::infinity());
        }
        if (value <= worst) continue;
        worst = value;
        report.stopId = id[i];
        report.stopPosition = Vector3{{metres[3*i], metres[3*i + 1], metres[3*i + 2]}};
        report.stopValue = report.stop == StopReason::notANumber ? std::sqrt(double(speed2))
                                                                 : value;
    }
    return worst;
}

} // namespace riprap
