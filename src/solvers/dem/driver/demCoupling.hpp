/*  DemSolver: driven by a fluid, which gives forces and asks for the solids a step of its own later.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/largest.hpp"
#include "dem/motion/push.hpp"
#include "dem/motion/solidWays.hpp"
#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::vector<std::int32_t> DemSolver<Backend, D, P>::order()
{
    std::vector<std::int32_t> keys = particles_.template field<std::int32_t>(particles_.at.id);
    keys.resize(activeSolids());
    return keys;
}

template<class Backend, int D, class P>
typename P::real* DemSolver<Backend, D, P>::external()
{
    requireAlone("solids in a fluid");
    if (!particles_.external.size()) particles_.external.upload(set_.context, std::vector<real>(std::size_t(particles_.n)*(D + S), real(0)));
    driven_ = true;
    suddenWay_ = real(0.1)*halfSkin_;       // the fluid's blow of a step may be harder than any of the bodies' own
    return particles_.external.data();
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::measureSpeed()
{
#ifdef __CUDACC__
    if constexpr (Backend::gpu) if (!still_) parts_.speed.ask(set_.context, particles_.n, SpeedOfSolids<D, P>{mover()});
#endif
}

//- As measured, or now
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::speedAtHand()
{
#ifdef __CUDACC__
    if constexpr (Backend::gpu) if (parts_.speed.asked()) return parts_.speed.take();
#endif
    return largestOver(set_.context, particles_.n, SpeedOfSolids<D, P>{mover()});
}

template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::subcycles(double dt)
{
    if (still_) return 1;
    const int contacts = std::max(1, int(std::ceil(dt/set_.plan.timeStep*(1 - 1e-9))));     // K of paper 2, section 2.3, rounded up; Eq. 25
    const double way = 1.25*dt*speedAtHand(), room = double(halfSkin_) - double(suddenWay_);
    if (!(way > 0.1*contacts*room)) return contacts;
    // fast ones, or a blow since the last look: a step stays within what new lists allow, and lists are new where too little is left
    const int steps = way < 1e6*room ? std::max(contacts, int(std::ceil(way/room*(1 - 1e-9)))) : contacts;
    clock_.now.fullDt = dt/steps;
    clock_.write();
    forEach(set_.context, particles_.n, CheckWays<D, P>{mover()});
    clock_.read();
    clock_.now.settleAge();
    return steps;
}

//- The sum of the kicks of these steps (dem/motion/mover.hpp): leapfrog's first one begins half a step before
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::kickTime(double dt, int subcycles)
{
    if (set_.config.integrator == DemIntegratorKind::velocityVerlet) return dt;
    return dt + 0.5*(clock_.now.dt - dt/subcycles);
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::push(double dt)
{
    forEach(set_.context, particles_.n, PushSolids<D, P>{particles_.view(), groups_.data(), particles_.external.data(), clumps_.count() > 0, sort_.active(), dt});
    clumps_.push(dt, slotOf_.data());
}

template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::advanceTo(double t, double dt, int subcycles)
{
    if (still_)
    {
        clock_.now.previousDt = clock_.now.dt;
        clock_.now.dt = clock_.now.fullDt = dt;
        clock_.now.time = clock_.now.target = t;
        ++clock_.now.step;
        return true;
    }
    clumps_.gather(nullptr, slotOf_.data());      // they begin the step with forces that hold the fluid's of now
    clock_.now.target = t;
    clock_.now.lastStep = std::int64_t(1) << 62;
    clock_.now.fullDt = dt/subcycles;
    clock_.write();
    runToTarget(lastReport_.rebuilds);
    return clock_.now.halt == DemHalt::none;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::beginReport()
{
    clock_.read();
    lastReport_ = DemReport();
    reportFrom_ = clock_.now.step;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::endReport()
{
    if (still_)
    {
        clock_.write();
        forces(ForceTurn::always);      // to be read
    }
    clock_.read();
    finishReport(lastReport_, reportFrom_);
}

} // namespace riprap
