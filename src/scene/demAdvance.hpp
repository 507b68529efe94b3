/*  DemSolver: the loop over steps, and its guards.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include <sstream>
#include "scene/demFused.hpp"
#include "scene/demWindow.hpp"

namespace riprap
{

template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::finished() const
{
    return host_.halt != DemHalt::none || host_.time >= host_.target || host_.step >= host_.lastStep || interrupted_;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::runToTarget(std::int64_t& rebuilds)
{
    if (fuses()) return runFused(rebuilds);
    while (!finished())
    {
        if (host_.needRebuild)
        {
            rebuild();
            ++rebuilds;
            readClock();
            if (sleeps()) checkSleep(false);
        }
        if (host_.needWindow || host_.time >= host_.windowEnd) { setWindow(); writeClock(); }
        const std::int64_t before = host_.step;
        if constexpr (!Backend::gpu)
        {
            do
            {
                step();
                if (sleeps() && clock_.data()->active && clock_.data()->step % stepsPerCheck == 0)
                {
                    collectForces();
                    checkSleep(false);
                }
            }
            while (clock_.data()->active && !interrupted_);
        }
        else
        {
            steps(std::min(sleeps() ? stepsPerCheck - int(host_.step % stepsPerCheck) : stepsPerBatch_, stepsLeft()));
        }
        readClock();
        if (Backend::gpu && sleeps() && host_.step > before && host_.step % stepsPerCheck == 0) checkSleep(false);
        if constexpr (Backend::gpu)
        {
            // as many steps as the last neighbours lasted: those beyond switch themselves off
            const int taken = int(host_.step - before);
            if (taken == stepsPerBatch_ && !host_.needRebuild) stepsPerBatch_ = std::min(windowSteps, 2*stepsPerBatch_);
            else if (host_.needRebuild) stepsPerBatch_ = std::max(2, std::min(windowSteps, taken + 1));
        }
    }
    collectForces();
}

template<class Backend, int D, class P>
DemReport DemSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    interrupted_ = false;
    DemReport report;
    readClock();
    const std::int64_t before = host_.step;
    host_.target = t;
    host_.lastStep = maxSteps > 0 ? before + maxSteps : std::int64_t(1) << 62;
    writeClock();
    runToTarget(report.rebuilds);
    finishReport(report, before);
    lastReport_ = report;
    return report;
}

//- What was done since a step, after the last one
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::finishReport(DemReport& report, std::int64_t before)
{
    if (host_.needRebuild && host_.halt == DemHalt::none)
    {
        rebuild();
        ++report.rebuilds;
        readClock();
        if (sleeps()) checkSleep(false);
    }
    report.time = host_.time;
    report.lastTimeStep = host_.dt;
    report.steps = host_.step - before;
    report.totalSteps = host_.step;
    report.maxSpeed = largestSpeed();
    report.brokenBonds = brokenBonds();
    report.asleep = sleeps() ? asleepNow() : 0;
    collectEscaped(report);
    if (host_.halt != DemHalt::none) findOffender(report);
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::largestSpeed()
{
    using Kernel = LargestSpeed<D, P>;
    Array<Backend, float> largest;
    largest.allocate(context_, Kernel::shares);
    forEach(context_, Kernel::shares, Kernel{fields(), sort_.active(), largest.data()});
    float most = 0;
    for (const float v2 : largest.download()) most = v2 > most || v2 != v2 ? v2 : most;
    return std::sqrt(double(most));
}

template<class Backend, int D, class P>
std::size_t DemSolver<Backend, D, P>::brokenBonds()
{
    std::size_t count = 0;
    if (nBonds_) for (const std::int32_t b : bondBroken_.download()) count += b != 0;
    return count;
}

//- Particles that left: sorted to the end by the last rebuild, reported once
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::collectEscaped(DemReport& report)
{
    const int active = activeSolids();
    report.particles = active;
    if (active >= reported_) return;
    const std::vector<double> x = positions(reported_);
    const auto key = field<std::int32_t>(idField_);
    for (int i = active; i < reported_; ++i)
    {
        report.escaped.push_back(Vector3{{x[3*i], x[3*i + 1], x[3*i + 2]}});
        report.escapedId.push_back(ids_[key[i]]);
    }
    reported_ = active;
}

//- Which particle made a guard fire
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::findOffender(DemReport& report)
{
    const int n = activeSolids();
    std::ostringstream s;
    s.precision(6);
    if (host_.halt == DemHalt::wallTooFar)
    {
        report.stop = DemStop::tooFast;
        s << "at t = " << host_.time << " s a wall moved by more than " << double(halfSkin_) << " m in a step of " << host_.dt
          << " s, farther than contacts are detected: take a smaller step or a larger skin";
        report.stopMessage = s.str();
        return;
    }
    std::vector<double> v[D];
    for (int d = 0; d < D; ++d) v[d] = field<double>(vField_ + d);
    const std::vector<double> x = positions(n);
    const auto key = field<std::int32_t>(idField_);
    double worst = -1;
    for (int i = 0; i < n; ++i)
    {
        double speed2 = 0;
        for (int d = 0; d < D; ++d) speed2 += v[d][i]*v[d][i];
        const double value = std::isfinite(speed2) ? std::sqrt(speed2) : std::numeric_limits<double>::infinity();
        if (value <= worst) continue;
        worst = value;
        report.stopId = ids_[key[i]];
        report.stopPosition = Vector3{{x[3*i], x[3*i + 1], x[3*i + 2]}};
    }
    report.stopValue = worst;
    report.stop = !std::isfinite(worst) ? DemStop::notANumber
        : (host_.halt == DemHalt::clumpEscaped ? DemStop::clumpEscaped : DemStop::tooFast);
    s << "at t = " << host_.time << " s ";
    if (report.stop == DemStop::clumpEscaped) s << "a member of a clump left the domain; the fastest particle is ";
    s << "particle " << report.stopId << " at (" << report.stopPosition[0] << " " << report.stopPosition[1] << " "
      << report.stopPosition[2] << ")";
    if (report.stop == DemStop::notANumber) s << " has a velocity that is not a number";
    else s << ", " << worst << " m/s";
    if (report.stop == DemStop::tooFast)
        s << ", moved by more than " << double(halfSkin_) << " m in a step of " << host_.dt
          << " s, farther than contacts are detected: take a smaller step or a larger skin";
    report.stopMessage = s.str();
}

} // namespace riprap
