/*  PicSolver: the loop over steps.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/picSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
double PicSolver<Backend, D, P>::timeStep(double speed, std::string& limit)
{
    if (clock_.initial == 0) { limit = "solids"; return inside_.scene->plan().timeStep; }
    if (!config_.adjustTimeStep) { limit = "fixed"; return config_.fixedTimeStep; }
    double g2 = 0, slide = 0;               // a wall that slides will carry particles along
    for (int d = 0; d < D; ++d) g2 += gravity_[d]*gravity_[d];
    for (const auto& axis : grid_.slide)
        for (const auto& side : axis)
            for (const double v : side) slide = std::max(slide, std::abs(v));
    speed = std::max(slide, speed);
    if (opens()) speed = std::max(speed, openingSpeed(clock_.time));
    double dt = courantStep(config_.maxCourant, grid_.h, speed, std::sqrt(g2));
    limit = "Courant";
    const double waves = waveStep(grid_.h, std::sqrt(g2));
    if (waves < dt) { dt = waves; limit = "waves"; }
    if (bodies_)
    {
        const double solid = courantStep(
            config_.maxCourant, grid_.h, bodies_->fastest(), std::sqrt(g2));
        if (solid < dt) { dt = solid; limit = "solids"; }
    }
    const double viscous = viscousStep(grid_.h, config_.viscosity/config_.density, D);
    if (viscous < dt && config_.viscousScheme == ViscousKind::explicitly)
    {
        dt = viscous;
        limit = "viscous";
    }
    if (fromFaces_.longestStep() < dt) { dt = fromFaces_.longestStep(); limit = "transfer"; }
    if (config_.maxTimeStep < dt) { dt = config_.maxTimeStep; limit = "maximum"; }
    return dt;
}

template<class Backend, int D, class P> double PicSolver<Backend, D, P>::fastest()
{
    return reduceMax(context_, n_, ParticleSpeed<D, real>{particles()});
}

//- Of particles that water carries, and of others as far as they limit the step. of: all
template<class Backend, int D, class P>
double PicSolver<Backend, D, P>::fastestCarried(double of)
{
    if (!(flying_ > 0) || !(config_.maxFlyingCourant > config_.maxCourant)) return of;
    return reduceMax(context_, n_,
        CarriedSpeed<D, real>{
            grid_, {particles()}, near_.data(), config_.maxCourant/config_.maxFlyingCourant});
}

template<class Backend, int D, class P>
double PicSolver<Backend, D, P>::estimateTimeStep(std::string& limit)
{
    return timeStep(
        clock_.initial && config_.adjustTimeStep ? fastestCarried(fastest()) : 0, limit);
}

//- Without water solids do what they do in a scene of their own, to the bit
template<class Backend, int D, class P>
PicReport PicSolver<Backend, D, P>::advanceDry(double t, std::int64_t maxSteps)
{
    PicReport report;
    const DemReport solids = inside_.scene->advance(t, maxSteps);
    interrupted_ = false;
    clock_.time = report.time = solids.time;
    clock_.steps = report.totalSteps = solids.totalSteps;
    report.steps = solids.steps;
    report.lastTimeStep = report.minTimeStep = report.maxTimeStep = solids.lastTimeStep;
    report.limit = "solids";
    if (solids.stop != DemStop::none) report.stop = StopReason::solids;
    return report;
}

template<class Backend, int D, class P>
PicReport PicSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    if (clock_.initial == 0) return advanceDry(t, maxSteps);
    PicReport report;
    report.minTimeStep = 1e300;
    if (interrupted_) maxSteps = 1;
    if (solidSide_) solidSide_->beginReport();
    while (clock_.time < t && n_ > 0 && (maxSteps <= 0 || report.steps < maxSteps))
    {
        const double speed = fastest(), carried = fastestCarried(speed);
        double dt = timeStep(carried, report.limit);
        const double courant = speed*dt/grid_.h;
        report.maxSpeed = std::max(report.maxSpeed, speed);
        if (!(speed < 1e30)) report.stop = StopReason::notANumber;
        else if (!(courant < config_.maxCourantEver)) report.stop = StopReason::speed;
        else if (!(speed <= speedLimit(speed))) stopTooFast(report, speed);
        else if (bodies_ && !(bodies_->fastest()*dt < config_.maxCourantEver*grid_.h))
            stopAtSolids(report,
                "would go " + std::to_string(bodies_->fastest()*dt/grid_.h)
                    + " cells in a step; guards/Courant allows "
                    + std::to_string(config_.maxCourantEver));
        else if (bodies_ && bodies_->acrossPeriodic(grid_))
            stopAtSolids(report, "reaches across a periodic side, where it cannot be followed");
        if (report.stop != StopReason::none) { findOffender(report, courant); break; }
        // equal steps to the target; the last one ends there to the bit
        const double left = t - clock_.time;
        const bool last = dt >= left*(1 - 1e-9);
        if (last) { dt = left; report.limit = "target"; }
        else if (config_.adjustTimeStep) dt = left/std::ceil(left/dt*(1 - 1e-9));
        toGrid();
        step(dt, report);
        if (report.stop != StopReason::none) break;
        if (last) clock_.time = t;
        ++report.steps;
        report.lastTimeStep = dt;
        report.minTimeStep = std::min(report.minTimeStep, dt);
        report.maxTimeStep = std::max(report.maxTimeStep, dt);
        report.maxCourant = std::max(report.maxCourant, carried*dt/grid_.h);
        if (interrupted_) break;
    }
    interrupted_ = false;
    double sums[3];
    if (report.steps) volume_ = waterVolume(sums);
    report.viscosityConverged = viscousConverged_;
    if (solidSide_) solidSide_->endReport();
    if (!report.steps) report.minTimeStep = 0;
    report.time = clock_.time;
    report.totalSteps = clock_.steps;
    report.fluid = n_;
    report.flying = std::size_t(flying_);
    const double particle = clock_.particleVolume;
    report.volume = volume_*grid_.volume() + flying_*particle;
    report.volumeError = n_ > 0
        ? report.volume/(n_*particle + (opens() ? openBalance() : 0)) - 1
        : 0;
    report.volumeDrift = clock_.drift;
    for (std::size_t k = 0; k < openings_.in.size(); ++k)
    {
        const double pending = openBalance(int(k));
        report.passed.push_back(
            PicPassage{openings_.in[k], openings_.out[k], openings_.volume[k] + pending, pending});
    }
    return report;
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::stopAtSolids(PicReport& report, const std::string& why)
{
    report.stop = StopReason::solids;
    report.stopMessage = "a solid " + why;
}

//- Steps that follow the Courant number shrink as fast as speeds grow: no other guard would end a
//  run that blows up. 0 at the first step: not known yet
template<class Backend, int D, class P>
double PicSolver<Backend, D, P>::speedLimit(double now)
{
    if (config_.maxSpeed > 0) return config_.maxSpeed;
    if (speedLimit_ == 0)
    {
        double fall = 0;
        for (int d = 0; d < 3; ++d)
            fall += 2*std::abs(config_.gravity[d])
                *(config_.domainMax[d] - config_.domainMin[d]);
        const double known = std::max(std::sqrt(fall), now);
        speedLimit_ = known > 0 ? PicConfig::fallSpeeds*known : 1e30;
    }
    return speedLimit_;
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::stopTooFast(PicReport& report, double speed)
{
    report.stop = StopReason::tooFast;
    report.stopMessage = "goes at " + std::to_string(speed) + " m/s; guards/maxSpeed allows "
        + std::to_string(speedLimit(speed)) + " m/s";
}

//- Which particle made a guard fire
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::findOffender(PicReport& report, double courant)
{
    const FluidState all = fluid();
    double worst = -1;
    for (std::size_t i = 0; i < all.id.size(); ++i)
    {
        const double* v = &all.velocity[3*i];
        const double speed = std::sqrt(v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
        const double value = std::isfinite(speed) ? speed : 1e300;
        if (value <= worst) continue;
        worst = value;
        report.stopId = all.id[i];
        report.stopPosition = Vector3{
            {all.position[3*i], all.position[3*i + 1], all.position[3*i + 2]}};
        report.stopValue = courant;
    }
}

} // namespace riprap
