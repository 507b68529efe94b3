/*  DemSolver: driven by a fluid, which gives forces and asks for the solids a step of its own later.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/largest.hpp"
#include "dem/motion/push.hpp"
#include "dem/motion/solidWays.hpp"
#include "solvers/dem/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::vector<std::int32_t> DemSolver<Backend, D, P>::order()
{
    std::vector<std::int32_t> keys = field<std::int32_t>(idField_);
    keys.resize(activeSolids());
    return keys;
}

template<class Backend, int D, class P>
typename P::real* DemSolver<Backend, D, P>::external()
{
    requireAlone("solids in a fluid");
    if (!external_.size()) external_.upload(context_, std::vector<real>(std::size_t(n_)*(D + S), real(0)));
    driven_ = true;
    suddenWay_ = real(0.1)*halfSkin_;       // the fluid's blow of a step may be harder than any of the bodies' own
    return external_.data();
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::measureSpeed()
{
#ifdef __CUDACC__
    if constexpr (Backend::gpu) if (!still_) parts_.speed.ask(context_, n_, SpeedOfSolids<D, P>{mover()});
#endif
}

//- As measured, or now
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::speedAtHand()
{
#ifdef __CUDACC__
    if constexpr (Backend::gpu) if (parts_.speed.asked()) return parts_.speed.take();
#endif
    return largestOver(context_, n_, SpeedOfSolids<D, P>{mover()});
}

template<class Backend, int D, class P>
int DemSolver<Backend, D, P>::subcycles(double dt)
{
    if (still_) return 1;
    const int contacts = std::max(1, int(std::ceil(dt/plan_.timeStep*(1 - 1e-9))));     // K of paper 2, section 2.3, rounded up; Eq. 25
    const double way = 1.25*dt*speedAtHand(), room = double(halfSkin_) - double(suddenWay_);
    if (!(way > 0.1*contacts*room)) return contacts;
    // fast ones, or a blow since the last look: a step stays within what new lists allow, and lists are new where too little is left
    const int steps = way < 1e6*room ? std::max(contacts, int(std::ceil(way/room*(1 - 1e-9)))) : contacts;
    host_.fullDt = dt/steps;
    writeClock();
    forEach(context_, n_, CheckWays<D, P>{mover()});
    readClock();
    host_.settleAge();
    return steps;
}

//- The sum of the kicks of these steps (dem/motion/mover.hpp): leapfrog's first one begins half a step before
template<class Backend, int D, class P>
double DemSolver<Backend, D, P>::kickTime(double dt, int subcycles)
{
    if (config_.integrator == DemIntegratorKind::velocityVerlet) return dt;
    return dt + 0.5*(host_.dt - dt/subcycles);
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::push(double dt)
{
    forEach(context_, n_, PushSolids<D, P>{fields(), groups_.data(), external_.data(), nClumps_ > 0, sort_.active(), dt});
    if (nClumps_) sumClumps(context_, nClumps_, largestClump_, PushClumps<D, P>{clumpMembers(), groups_.data(), constraints(), dt});
}

template<class Backend, int D, class P>
bool DemSolver<Backend, D, P>::advanceTo(double t, double dt, int subcycles)
{
    if (still_)
    {
        host_.previousDt = host_.dt;
        host_.dt = host_.fullDt = dt;
        host_.time = host_.target = t;
        ++host_.step;
        return true;
    }
    gatherClumps(nullptr);      // they begin the step with forces that hold the fluid's of now
    host_.target = t;
    host_.lastStep = std::int64_t(1) << 62;
    host_.fullDt = dt/subcycles;
    writeClock();
    runToTarget(lastReport_.rebuilds);
    return host_.halt == DemHalt::none;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::beginReport()
{
    readClock();
    lastReport_ = DemReport();
    reportFrom_ = host_.step;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::endReport()
{
    if (still_)
    {
        writeClock();
        forces(ForceTurn::always);      // to be read
    }
    readClock();
    finishReport(lastReport_, reportFrom_);
}

} // namespace riprap
