/*  Steps of the water, and of the solids in it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/pushOut.hpp"
#include "solvers/pic/driver/cellCutter.hpp"
#include "solvers/pic/driver/freeSurface.hpp"
#include "solvers/pic/driver/multirate.hpp"
#include "solvers/pic/driver/picGuards.hpp"
#include "solvers/pic/driver/projection.hpp"
#include "solvers/pic/driver/timeStepControl.hpp"

namespace riprap
{

//- What steps are done with
template<class Backend, int D, class P>
struct PicStepTools
{
    ParticleAdvection<Backend, D, P>& advection;
    FreeSurface<Backend, D, P>& surface;
    OpenBoundaries<Backend, D, P>& openings;
    CellCutter<Backend, D, P>& cutter;
    BodyCoupling<Backend, D, P>& coupling;
    PicTransfer<Backend, D, P>& transfer;
    MomentumBudget<Backend, D, P>& budget;
    Projection<Backend, D, P>& projection;
    Multirate<Backend, D, P>& multirate;
    TimeStepControl<Backend, D, P>& control;
    PicGuards<Backend, D, P>& guards;
};

template<class Backend, int D, class P>
class PicStepper
{
public:

    using real = typename P::real;

    PicStepper(PicParts<Backend, D, P>& parts, const PicStepTools<Backend, D, P>& tools)
        : p_(parts), with_(tools)
    {}

    //- One step, no farther than t. \return false when a guard has fired
    bool advance(double t, PicReport&);

private:

    void step(double dt, PicReport&);
    bool moveInside(double dt, double before, int moved);

    PicParts<Backend, D, P>& p_;
    PicStepTools<Backend, D, P> with_;
};

template<class Backend, int D, class P>
bool PicStepper<Backend, D, P>::advance(double t, PicReport& report)
{
    const double speed = with_.advection.fastest(), carried = with_.advection.fastestCarried(speed);
    double dt = with_.control.step(carried, report.limit);
    if (!with_.guards.pass(report, speed, dt)) return false;
    // equal steps to the target; the last one ends there to the bit
    const double left = t - p_.set.clock.time;
    const bool last = dt >= left*(1 - 1e-9);
    if (last) { dt = left; report.limit = "target"; }
    else if (p_.set.config.adjustTimeStep) dt = left/std::ceil(left/dt*(1 - 1e-9));
    with_.transfer.toGrid();
    step(dt, report);
    if (report.stop != StopReason::none) return false;
    if (last) p_.set.clock.time = t;
    ++report.steps;
    report.lastTimeStep = dt;
    report.minTimeStep = std::min(report.minTimeStep, dt);
    report.maxTimeStep = std::max(report.maxTimeStep, dt);
    report.maxCourant = std::max(report.maxCourant, carried*dt/p_.set.grid.h);
    return true;
}

template<class Backend, int D, class P>
void PicStepper<Backend, D, P>::step(double dt, PicReport& report)
{
    PicClock& clock = p_.set.clock;
    SolidsInWater<Backend, D, P>& solids = p_.solids;
    PressureOfWater<Backend, D, P>& pressure = p_.pressure;
    const double before = clock.steps ? clock.lastStep : 0;
    if (p_.cut.moves && !p_.cut.forStep) with_.cutter.cut(clock.time, dt);
    if (solids.bodies) with_.coupling.cutToWater();
    if (p_.opens()) with_.openings.setFaces(clock.time);
    if (solids.bodies) solids.bodies->forces.predict(dt, before);
    clock.lastKick = p_.set.kick(dt);
    with_.projection.project(clock.lastKick, dt);
    with_.budget.holdParticles();
    with_.multirate.addStep(dt);
    with_.transfer.toParticles(clock.lastKick);
    with_.budget.compareParticles();
    if (solids.bodies && solids.bodies->set.contactVelocity < 1) with_.coupling.slowBetween(dt);
    with_.advection.move(dt);
    const int moved = p_.particles.n;
    if (p_.opens()) with_.openings.inject(dt);
    if (!moveInside(dt, before, moved))
    {
        const bool finite = !solids.bodies || solids.bodies->forces.finite();
        with_.guards.stopAtSolids(report,
            finite ? "was stopped by a guard of its contacts"
                   : "has a force of the water that is not a number");
        return;
    }
    with_.multirate.enterSlow();
    with_.surface.move(dt, report);
    with_.surface.holdVolume();
    with_.multirate.endStep(dt);
    clock.time += dt;
    clock.lastStep = dt;
    ++clock.steps;
    report.pressureIterations += pressure.last.iterations;
    report.largestResidual = std::max(report.largestResidual, pressure.last.finalResidual);
    report.pressureConverged = report.pressureConverged && pressure.last.converged;
}

//- Solids to where they are at the end of the step; particles that they have run over come out,
//  of which the first ones have been moved in this step.
//  \return false when a guard has fired
template<class Backend, int D, class P>
bool PicStepper<Backend, D, P>::moveInside(double dt, double before, int moved)
{
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    if (!p_.cuts()) return true;
    if (p_.solids.bodies && !with_.coupling.advance(dt, before)) return false;
    if (p_.cut.moves)
    {
        with_.cutter.cut(p_.set.clock.time + dt, dt);
        p_.cut.forStep = true;
    }
    PushOut<D, real> out{p_.solidField(), particles.view(), p_.set.wallMargin*p_.set.grid.h, {},
        {}, nullptr, 0};
    if (p_.slow.any())
    {
        out.waiting = p_.slow.in(slowTile);
        out.from = particles.sort.sortedKeys();
        out.first = moved;
    }
    for (int d = 0; d < D; ++d)
        out.shift[d] = p_.set.config.positionCorrection > 0 ? particles.shift[d].data() : nullptr;
    forEach(p_.set.context, particles.n, out);
    return true;
}

} // namespace riprap
