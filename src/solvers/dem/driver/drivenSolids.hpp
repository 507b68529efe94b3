/*  Solids driven by a fluid, which gives forces and asks for the solids a step of its own later.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/reduceMax.hpp"
#include "coupling/solidView.hpp"
#include "dem/motion/push.hpp"
#include "dem/motion/solidWays.hpp"
#include "solvers/dem/driver/sceneReports.hpp"
#include "solvers/dem/driver/solidStepper.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class DrivenSolids : public SolidSide<D, P>
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    DrivenSolids(DemParts<Backend, D, P>& parts, ContactForces<Backend, D, P>& forces,
        RankedSolids<Backend, D, P>& ranks, SolidStepper<Backend, D, P>& stepper,
        SceneReports<Backend, D, P>& reports)
        : p_(parts), forces_(forces), ranks_(ranks), stepper_(stepper), reports_(reports)
    {}

    int keys() const override { return p_.particles.n; }
    bool still() const override { return p_.still; }
    SolidView<D, P> view() override
    {
        return SolidView<D, P>{p_.set.box, p_.particles.view(), p_.order.slotOf.data()};
    }
    BodyView<D, P> bodies() override
    {
        return BodyView<D, P>{p_.clumps.data(), p_.groups.data(), p_.clumps.constraints(),
            p_.set.box, p_.clumps.count()};
    }
    std::vector<std::int32_t> order() override;
    real* external() override;
    void measureSpeed() override;
    int subcycles(double dt) override;
    double kickTime(double dt, int subcycles) override;
    void push(double dt) override;
    bool advanceTo(double t, double dt, int subcycles) override;
    void beginReport() override;
    void endReport() override;

private:

    double speedAtHand();

    DemParts<Backend, D, P>& p_;
    ContactForces<Backend, D, P>& forces_;
    RankedSolids<Backend, D, P>& ranks_;
    SolidStepper<Backend, D, P>& stepper_;
    SceneReports<Backend, D, P>& reports_;
    std::int64_t reportFrom_ = 0;           // step at which an interval began
};

template<class Backend, int D, class P>
std::vector<std::int32_t> DrivenSolids<Backend, D, P>::order()
{
    std::vector<std::int32_t> keys = p_.particles.template field<std::int32_t>(p_.particles.at.id);
    keys.resize(p_.order.active());
    return keys;
}

template<class Backend, int D, class P>
typename P::real* DrivenSolids<Backend, D, P>::external()
{
    ranks_.requireAlone("solids in a fluid");
    if (!p_.particles.external.size())
        p_.particles.external.upload(
            p_.set.context, std::vector<real>(std::size_t(p_.particles.n)*(D + S), real(0)));
    p_.reach.driven = true;
    // the fluid's blow of a step may be harder than any of the bodies' own
    p_.reach.suddenDisplacement = real(0.1)*p_.reach.halfSkin;
    return p_.particles.external.data();
}

template<class Backend, int D, class P>
void DrivenSolids<Backend, D, P>::measureSpeed()
{
#ifdef __CUDACC__
    if constexpr (Backend::gpu)
        if (!p_.still)
            p_.memory.speed.ask(
                p_.set.context, p_.particles.n, SpeedOfSolids<D, P>{forces_.mover()});
#endif
}

//- As measured, or now
template<class Backend, int D, class P>
double DrivenSolids<Backend, D, P>::speedAtHand()
{
#ifdef __CUDACC__
    if constexpr (Backend::gpu) if (p_.memory.speed.asked()) return p_.memory.speed.take();
#endif
    return reduceMax(p_.set.context, p_.particles.n, SpeedOfSolids<D, P>{forces_.mover()});
}

template<class Backend, int D, class P>
int DrivenSolids<Backend, D, P>::subcycles(double dt)
{
    if (p_.still) return 1;
    // K of paper 2, section 2.3, rounded up; Eq. 25
    const int contacts = std::max(1, int(std::ceil(dt/p_.set.plan.timeStep*(1 - 1e-9))));
    const double way = 1.25*dt*speedAtHand(),
                 room = double(p_.reach.halfSkin) - double(p_.reach.suddenDisplacement);
    if (!(way > 0.1*contacts*room)) return contacts;
    // fast ones, or a blow since the last look: a step stays within what new lists allow, and lists
    // are new where too little is left
    const int steps = way < 1e6*room ? std::max(contacts, int(std::ceil(way/room*(1 - 1e-9))))
                                       : contacts;
    p_.clock.now.fullDt = dt/steps;
    p_.clock.write();
    forEach(p_.set.context, p_.particles.n, CheckWays<D, P>{forces_.mover()});
    p_.clock.read();
    p_.clock.now.settleAge();
    return steps;
}

//- The sum of the kicks of these steps (dem/motion/mover.hpp): leapfrog's first one begins half a
//  step before
template<class Backend, int D, class P>
double DrivenSolids<Backend, D, P>::kickTime(double dt, int subcycles)
{
    return p_.set.integrator.kickTime(dt, subcycles, p_.clock.now.dt);
}

template<class Backend, int D, class P>
void DrivenSolids<Backend, D, P>::push(double dt)
{
    forEach(p_.set.context, p_.particles.n,
        PushSolids<D, P>{p_.particles.view(), p_.groups.data(), p_.particles.external.data(),
            p_.clumps.any(), p_.order.sort.active(), dt});
    p_.clumps.push(dt, p_.order.slotOf.data());
}

template<class Backend, int D, class P>
bool DrivenSolids<Backend, D, P>::advanceTo(double t, double dt, int subcycles)
{
    if (p_.still)
    {
        p_.clock.now.previousDt = p_.clock.now.dt;
        p_.clock.now.dt = p_.clock.now.fullDt = dt;
        p_.clock.now.time = p_.clock.now.target = t;
        ++p_.clock.now.step;
        return true;
    }
    // they begin the step with forces that hold the fluid's of now
    p_.clumps.gather(nullptr, p_.order.slotOf.data());
    p_.clock.now.target = t;
    p_.clock.now.lastStep = std::int64_t(1) << 62;
    p_.clock.now.fullDt = dt/subcycles;
    p_.clock.write();
    stepper_.run(reports_.last.rebuilds);
    return p_.clock.now.halt == DemHalt::none;
}

template<class Backend, int D, class P>
void DrivenSolids<Backend, D, P>::beginReport()
{
    p_.clock.read();
    reports_.last = DemReport();
    reportFrom_ = p_.clock.now.step;
}

template<class Backend, int D, class P>
void DrivenSolids<Backend, D, P>::endReport()
{
    if (p_.still)
    {
        p_.clock.write();
        forces_.evaluate(ForceTurn::always);      // to be read
    }
    p_.clock.read();
    reports_.finish(reports_.last, reportFrom_);
}

} // namespace riprap
