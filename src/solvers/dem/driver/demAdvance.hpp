/*  DemSolver: the loop over steps, and its guards.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include <sstream>
#include "solvers/dem/driver/demFused.hpp"

namespace riprap
{

template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::finished() const
{
    return clock_.now.halt != DemHalt::none || clock_.now.time >= clock_.now.target || clock_.now.step >= clock_.now.lastStep || stopped();
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::runToTarget(std::int64_t& rebuilds)
{
    if (fuses()) return runFused(rebuilds);
    const std::int64_t within = searchesWithin_;
    while (!finished())
    {
        if (clock_.now.needRebuild)
        {
            adaptSkin();
            rebuild();
            ++rebuilds;
            clock_.read();
            if (sleeps()) checkSleep(false);
        }
        if (clock_.now.needWindow || clock_.now.time >= clock_.now.windowEnd) { motion_.sample(clock_.now); clock_.write(); }
        const std::int64_t before = clock_.now.step;
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
            while (clock_.data()->active && !stopped());
        }
        else
        {
            steps(std::min(sleeps() ? stepsPerCheck - int(clock_.now.step % stepsPerCheck) : stepsPerBatch_, stepsLeft()));
        }
        clock_.read();
        if (Backend::gpu && clock_.now.lost() && clock_.now.halt == DemHalt::none) finishLate();
        if (Backend::gpu && sleeps() && clock_.now.step > before && clock_.now.step % stepsPerCheck == 0) checkSleep(false);
        if constexpr (Backend::gpu)
        {
            // as many steps as the last neighbours lasted: those beyond switch themselves off
            const int taken = int(clock_.now.step - before);
            if (taken == stepsPerBatch_ && !clock_.now.needRebuild) stepsPerBatch_ = std::min(motion_.windowSteps, 2*stepsPerBatch_);
            else if (clock_.now.needRebuild) stepsPerBatch_ = std::max(2, std::min(motion_.windowSteps, taken + 1));
        }
    }
    collectForces();
    rebuilds += searchesWithin_ - within;
}

template<class Backend, int D, class P>
DemReport DemSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    interrupted_ = stopAgreed_ = false;
    DemReport report;
    clock_.read();
    const std::int64_t before = clock_.now.step;
    clock_.now.target = t;
    clock_.now.lastStep = maxSteps > 0 ? before + maxSteps : std::int64_t(1) << 62;
    clock_.write();
    runToTarget(report.rebuilds);
    finishReport(report, before);
    lastReport_ = report;
    return report;
}

//- What was done since a step, after the last one
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::finishReport(DemReport& report, std::int64_t before)
{
    if (clock_.now.needRebuild && clock_.now.halt == DemHalt::none)
    {
        adaptSkin();
        rebuild();
        ++report.rebuilds;
        clock_.read();
        if (sleeps()) checkSleep(false);
    }
    report.time = clock_.now.time;
    report.lastTimeStep = clock_.now.dt;
    report.steps = clock_.now.step - before;
    report.totalSteps = clock_.now.step;
    report.maxSpeed = largestSpeed();
    report.brokenBonds = bonds_.broken();
    report.asleep = sleeps() ? asleepNow() : 0;
    collectEscaped(report);
    collectPassed(report);
    if (clock_.now.halt != DemHalt::none) findOffender(report);
}

template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::largestSpeed()
{
    using Kernel = LargestSpeed<D, P>;
    Array<Backend, float> largest;
    largest.allocate(set_.context, Kernel::shares);
    forEach(set_.context, Kernel::shares, Kernel{particles_.view(), sort_.active(), largest.data()});
    float most = 0;
    for (const float v2 : largest.download()) most = v2 > most || v2 != v2 ? v2 : most;
    return largestOfRanks(std::sqrt(double(most)));
}

//- Particles that left: sorted to the end by the last rebuild, reported once
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::collectEscaped(DemReport& report)
{
    if (others_)
    {
        report.particles = std::size_t(others_->total());
        report.escaped.swap(escaped_);
        report.escapedId.swap(escapedId_);
        const ParticleExchange::Counts& c = others_->counts();
        report.rank = DemRankReport
        {
            std::size_t(others_->ownedHere()), std::size_t(others_->ghostsHere()), c.arrivals, c.divisions, c.bytesShared, c.bytesMigrating
        };
        return;
    }
    const int active = activeSolids();
    report.particles = active;
    if (active >= reported_) return;
    const std::vector<double> x = particles_.positions(reported_);
    const auto key = particles_.template field<std::int32_t>(particles_.at.id);
    for (int i = active; i < reported_; ++i)
    {
        report.escaped.push_back(Vector3{{x[3*i], x[3*i + 1], x[3*i + 2]}});
        report.escapedId.push_back(particles_.ids[key[i]]);
    }
    reported_ = active;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::clearPassed()
{ if (surfaces_) passed_.upload(set_.context, std::vector<WallPassings>(1, WallPassings{0, particles_.n, 0})); }

//- Particles that have gone through walls since the last report
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::collectPassed(DemReport& report)
{
    if (!surfaces_) return;
    const WallPassings passed = passed_.download()[0];
    const std::int64_t count = passed.count + passedBefore_;
    if (!count) return;
    report.passedWalls = std::size_t(count);
    report.passedId = passedBefore_ ? passedIdBefore_ : particles_.ids[passed.key];
    passedBefore_ = 0;
    clearPassed();
}

//- The way of particle i in the last step, of its radius, which the guard tested. No number: infinity
template<class Backend, int D, class P>
std::vector<double> DemSolver<Backend, D, P>::offences(int n)
{
    std::vector<double> value(n, 0.0);
    const auto radius = particles_.template field<real>(particles_.at.radius);
    for (int d = 0; d < D; ++d)
    {
        const auto v = particles_.template field<double>(particles_.at.v + d);
        for (int i = 0; i < n; ++i)
        {
            const double way = v[i]*clock_.now.dt/double(radius[i]);
            value[i] += std::isfinite(v[i]) ? way*way : std::numeric_limits<double>::infinity();
        }
    }
    for (double& w : value) w = std::sqrt(w);
    return value;
}

static constexpr const char* passingCure =
    ": it passes through what it meets; take a shorter step, and contacts that are stiff enough for this speed";

//- Which particle made a guard fire, and why: "particle 7 at .. " goes before it
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::findOffender(DemReport& report)
{
    if (clock_.now.halt == DemHalt::wallTooFar)
    {
        report.stop = DemStop::tooFast;
        std::ostringstream s;
        s.precision(6);
        s << "a wall goes farther in a step of " << clock_.now.dt << " s than the radius of the smallest particle, " << radii_.smallest << " m" << passingCure;
        report.stopMessage = s.str();
        return;
    }
    if (others_) return findOffenderOfRanks(report);
    const int n = activeSolids();
    const std::vector<double> offence = offences(n);
    if (n == 0) return;
    const int worst = int(std::max_element(offence.begin(), offence.end()) - offence.begin());
    describeOffender(report, worst, offence[worst]);
}

//- offence: as offences() has it
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::describeOffender(DemReport& report, int worst, double offence)
{
    std::ostringstream s;
    s.precision(6);
    const std::vector<double> x = particles_.positions(worst + 1);
    double speed2 = 0;
    for (int d = 0; d < D; ++d) { const double v = particles_.template field<double>(particles_.at.v + d)[worst]; speed2 += v*v; }
    report.stopId = particles_.ids[particles_.template field<std::int32_t>(particles_.at.id)[worst]];
    report.stopPosition = Vector3{{x[3*worst], x[3*worst + 1], x[3*worst + 2]}};
    report.stopValue = std::isfinite(offence) ? std::sqrt(speed2) : std::numeric_limits<double>::infinity();
    report.stop = !std::isfinite(offence) ? DemStop::notANumber : DemStop::tooFast;
    if (report.stop == DemStop::notANumber) s << "has a velocity that is not a number";
    else
    {
        const double radius = double(particles_.template field<real>(particles_.at.radius)[worst]);
        s << "goes " << offence*radius << " m in a step of " << clock_.now.dt << " s, at " << report.stopValue << " m/s, and ";
        if (driven_) s << "lists of neighbours reach " << double(halfSkin_) << " m: the fluid's blow on it is too hard for this time step";
        else s << "its radius is " << radius << " m" << passingCure;
    }
    report.stopMessage = s.str();
}

} // namespace riprap
