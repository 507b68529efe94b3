/*  The DEM scene on one backend, in one dimension and precision: its parts (solvers/dem/parts), and
    classes that do one thing with them each.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/device.hpp"
#include "solvers/dem/driver/checkpoint.hpp"
#include "solvers/dem/driver/drivenSolids.hpp"
#include "solvers/dem/driver/sceneReadings.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class DemSolver : public DemScene, public DrivenSolids<Backend, D, P>, public LaunchOrder<Backend>
{
public:

    using real = typename P::real;
    static constexpr int S = spins<D>;

    DemSolver(const DemConfig&, const DemInput&, const DemPlan&);

    DemReport advance(double t, std::int64_t maxSteps) override;
    void interrupt() override { p_.interrupted = true; }
    double time() const override { return p_.clock.now.time; }
    const DemReport& lastReport() const override { return reports_.last; }
    DemState particles() override { return readings_.particles(); }
    Later<DemState> particlesLater() override { return readings_.particlesLater(); }
    DemState motion() override { return readings_.motion(); }
    DemContacts contacts() override { return readings_.contacts(); }
    DemBondState bonds() override
    { return ranks_.others ? ranks_.bonds.state() : p_.bonds.state(p_.order.slotOf); }
    DemClumpState clumps() override { return readings_.clumps(); }
    std::vector<DemSpringState> springs() override { return readings_.springs(); }
    DemEnergy energy() override { return readings_.energy(); }
    DemGroupSums groupSums(int group) override { return readings_.groupSums(group); }
    DemMomentum momentum() override { return readings_.momentum(); }
    double deepestOverlap() override { return readings_.deepestOverlap(); }
    std::vector<DemWallForce> wallForces() override { return readings_.wallForces(); }
    void setExternalForces(
        const std::vector<double>& force, const std::vector<double>& moment) override;
    Later<std::vector<std::int32_t>> savedState(bool later) override
    {
        return checkpoint_.save(later);
    }
    void loadState(const std::vector<std::int32_t>& words) override { checkpoint_.load(words); }
    DemPlan plan() const override { return p_.set.plan; }
    std::vector<ArrayInfo> arrays() const override { return readings_.arrays(); }
    std::vector<KernelInfo> kernels() const override { return readings_.kernels(); }
    void timeKernels(bool on) override { p_.set.context.profile.timing = on; }
    double neighboursPerParticle() override { return readings_.neighboursPerParticle(); }
    double contactsPerParticle() override { return readings_.contactsPerParticle(); }
    std::string deviceName() const override { return deviceLabel(Backend()); }
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

    void follow(const Context<Backend>& fluid) override { p_.set.context.follow(fluid); }

private:

    void prime();

    DemParts<Backend, D, P> p_;
    ContactForces<Backend, D, P> forces_{p_};
    RankedSolids<Backend, D, P> ranks_{p_};
    Neighbours<Backend, D, P> neighbours_{p_, forces_, ranks_};
    Sleepers<Backend, D, P> sleepers_{p_, forces_, neighbours_};
    SolidStepper<Backend, D, P> stepper_{p_, forces_, ranks_, neighbours_, sleepers_};
    SceneReports<Backend, D, P> reports_{p_, ranks_, neighbours_, sleepers_};
    SceneReadings<Backend, D, P> readings_{p_, forces_, ranks_};
    Checkpoint<Backend, D, P> checkpoint_{p_, ranks_, neighbours_};
};

template<class Backend, int D, class P>
DemSolver<Backend, D, P>::DemSolver(
    const DemConfig& config, const DemInput& input, const DemPlan& plan)
    : DrivenSolids<Backend, D, P>(p_, forces_, ranks_, stepper_, reports_), p_(config, input, plan)
{
    p_.pairs.set(input.particles);
    p_.reach.setBox(input.particles.radius);
    if (config.ranks && config.ranks->size() > 1) ranks_.begin();
    p_.particles.add(p_.sleeps() || ranks_.others);
    p_.particles.fill(input.particles);
    p_.order.allocate(p_.particles.n, p_.reach.classes.cells());
    sleepers_.allocate();
    p_.motion.holdGroups(p_.groups.motions());
    p_.bonds.set(input.bonds, input.particles);
    if (ranks_.others) ranks_.bonds.begin();
    p_.clumps.set(input.particles);
    if (ranks_.others) ranks_.bodies.begin();
    p_.motion.holdWalls(p_.walls.set(p_.reach.wallCell(), p_.particles.n));
    neighbours_.setFrames();
    prime();
    if (ranks_.others)
    {
        // from now on there is memory for what is here
        ranks_.setCapacity();
        neighbours_.rebuild();
    }
}

//- First neighbours and forces, with a step of no length
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::prime()
{
    const int all = p_.particles.n;
    p_.set.context.toDevice(const_cast<int*>(p_.order.sort.active()), &all, sizeof(int));
    p_.clock.now.time = p_.set.config.startTime;
    p_.clock.now.fullDt = p_.set.plan.timeStep;
    p_.motion.sample(p_.clock.now);
    p_.clock.now.active = 1;
    p_.clock.write();
    // moving walls take their places; no step has any length yet
    if (p_.motion.walls())
        forEach(p_.set.context, p_.walls.count,
            MoveWalls{p_.walls.walls.data(), p_.motion.wallTable(), p_.clock.data(),
                p_.clock.data(), 1e300, 1e300});
    neighbours_.rebuild(true);
    forces_.evaluate();
    if (ranks_.others) ranks_.bonds.agree();
    forces_.collectForces();
    p_.clock.read();
    p_.clock.now.active = 0;
    p_.clock.write();
    // on the GPU once more: what a rebuild needs besides is loaded and has its memory before the
    // first step
    if (Backend::gpu || p_.clock.now.needRebuild) neighbours_.rebuild();
    p_.set.context.synchronise();
}

template<class Backend, int D, class P>
DemReport DemSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    ranks_.start();
    DemReport report;
    p_.clock.read();
    const std::int64_t before = p_.clock.now.step;
    p_.clock.now.target = t;
    p_.clock.now.lastStep = maxSteps > 0 ? before + maxSteps : std::int64_t(1) << 62;
    p_.clock.write();
    stepper_.run(report.rebuilds);
    reports_.finish(report, before);
    reports_.last = report;
    return report;
}

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setExternalForces(
    const std::vector<double>& force, const std::vector<double>& moment)
{
    ranks_.requireAlone("forces from outside");
    std::vector<real> all(std::size_t(p_.particles.n)*(D + S), real(0));
    for (int i = 0; i < p_.particles.n; ++i)
    {
        const std::size_t at = 3*std::size_t(p_.particles.ids[i]);
        if (!force.empty() && at + 3 > force.size())
            throw std::invalid_argument("external forces: too few for the ids");
        if (!moment.empty() && at + 3 > moment.size())
            throw std::invalid_argument("external moments: too few for the ids");
        real* to = &all[std::size_t(i)*(D + S)];
        if (!force.empty())
            for (int d = 0; d < D; ++d) to[d] = real(force[at + p_.set.config.axes[d]]);
        if (!moment.empty())
            for (int c = 0; c < S; ++c)
                to[D + c] = real(D == 2 ? p_.set.spinSign()*moment[at + p_.set.config.axes[2]]
                                        : moment[at + c]);
    }
    if (p_.sleeps()) sleepers_.wakeChanged(p_.particles.external.download(), all);
    p_.particles.external.upload(p_.set.context, all);
    p_.clumps.gather(nullptr, p_.order.slotOf.data());
}

} // namespace riprap
