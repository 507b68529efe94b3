/*  DemSolver: the loop over steps, and its guards.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include <sstream>
#include "solvers/dem/demFused.hpp"
#include "solvers/dem/demWindow.hpp"

namespace riprap
{

template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::finished() const
{
    return host_.halt != DemHalt::none || host_.time >= host_.target || host_.step >= host_.lastStep || stopped();
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::runToTarget(std::int64_t& rebuilds)
{
    if (fuses()) return runFused(rebuilds);
    const std::int64_t within = searchesWithin_;
    while (!finished())
    {
        if (host_.needRebuild)
        {
            adaptSkin();
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
            while (clock_.data()->active && !stopped());
        }
        else
        {
            steps(std::min(sleeps() ? stepsPerCheck - int(host_.step % stepsPerCheck) : stepsPerBatch_, stepsLeft()));
        }
        readClock();
        if (Backend::gpu && host_.lost() && host_.halt == DemHalt::none) finishLate();
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
    rebuilds += searchesWithin_ - within;
}

template<class Backend, int D, class P>
DemReport DemSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    interrupted_ = stopAgreed_ = false;
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
        adaptSkin();
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
    collectPassed(report);
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
    return largestOfRanks(std::sqrt(double(most)));
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
    const std::vector<double> x = positions(reported_);
    const auto key = field<std::int32_t>(idField_);
    for (int i = active; i < reported_; ++i)
    {
        report.escaped.push_back(Vector3{{x[3*i], x[3*i + 1], x[3*i + 2]}});
        report.escapedId.push_back(ids_[key[i]]);
    }
    reported_ = active;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::clearPassed()
{ if (surfaces_) passed_.upload(context_, std::vector<WallPassings>(1, WallPassings{0, n_, 0})); }

//- Particles that have gone through walls since the last report
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::collectPassed(DemReport& report)
{
    if (!surfaces_) return;
    const WallPassings passed = passed_.download()[0];
    const std::int64_t count = passed.count + passedBefore_;
    if (!count) return;
    report.passedWalls = std::size_t(count);
    report.passedId = passedBefore_ ? passedIdBefore_ : ids_[passed.key];
    passedBefore_ = 0;
    clearPassed();
}

//- The way of particle i in the last step, of its radius, which the guard tested. No number: infinity
template<class Backend, int D, class P>
std::vector<double> DemSolver<Backend, D, P>::offences(int n)
{
    std::vector<double> value(n, 0.0);
    const auto radius = field<real>(radiusField_);
    for (int d = 0; d < D; ++d)
    {
        const auto v = field<double>(vField_ + d);
        for (int i = 0; i < n; ++i)
        {
            const double way = v[i]*host_.dt/double(radius[i]);
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
    if (host_.halt == DemHalt::wallTooFar)
    {
        report.stop = DemStop::tooFast;
        std::ostringstream s;
        s.precision(6);
        s << "a wall goes farther in a step of " << host_.dt << " s than the radius of the smallest particle, " << radii_.smallest << " m" << passingCure;
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
    const std::vector<double> x = positions(worst + 1);
    double speed2 = 0;
    for (int d = 0; d < D; ++d) { const double v = field<double>(vField_ + d)[worst]; speed2 += v*v; }
    report.stopId = ids_[field<std::int32_t>(idField_)[worst]];
    report.stopPosition = Vector3{{x[3*worst], x[3*worst + 1], x[3*worst + 2]}};
    report.stopValue = std::isfinite(offence) ? std::sqrt(speed2) : std::numeric_limits<double>::infinity();
    report.stop = !std::isfinite(offence) ? DemStop::notANumber : DemStop::tooFast;
    if (report.stop == DemStop::notANumber) s << "has a velocity that is not a number";
    else
    {
        const double radius = double(field<real>(radiusField_)[worst]);
        s << "goes " << offence*radius << " m in a step of " << host_.dt << " s, at " << report.stopValue << " m/s, and ";
        if (driven_) s << "lists of neighbours reach " << double(halfSkin_) << " m: the fluid's blow on it is too hard for this time step";
        else s << "its radius is " << radius << " m" << passingCure;
    }
    report.stopMessage = s.str();
}

} // namespace riprap
