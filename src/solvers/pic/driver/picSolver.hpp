/*  The PIC scene on one backend, in one dimension and precision: its parts (solvers/pic/parts), and
    classes that do one thing with them each.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/device.hpp"
#include "solvers/pic/driver/fluidSeeding.hpp"
#include "solvers/pic/driver/picCheckpoint.hpp"
#include "solvers/pic/driver/picStepper.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class PicSolver : public PicScene
{
public:

    PicSolver(const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);

    PicReport advance(double t, std::int64_t maxSteps) override;
    void interrupt() override
    {
        p_.interrupted = true;
        // in water they end the step in hand; ranks stop at the same one
        if (p_.inside.scene && !p_.halo && p_.set.clock.initial == 0)
            p_.inside.scene->interrupt();
    }
    double time() const override { return p_.set.clock.time; }
    FluidState fluid() override { return readings_.fluid(); }
    Later<FluidState> fluidLater() override { return readings_.fluidLater(); }
    PicGridState grid() override { return readings_.grid(); }
    void cellFields(const std::int32_t* cells, std::size_t n, const PicCellFields& to) override
    {
        readings_.cellFields(cells, n, to);
    }
    DemScene* solids() override { return p_.inside.scene.get(); }
    Coupling coupling() override
    {
        return p_.solids.bodies ? Coupling{p_.solids.bodies->forces.force(), p_.solids.subcycles}
                                : Coupling();
    }
    void watchMomentum(bool on) override
    {
        if (on && p_.halo) throw std::invalid_argument("momentum is balanced on one process");
        budget_.watch(on);
    }
    PicMomentum momentum() override { return budget_.last(); }
    std::vector<FluidForce> forcesOnWalls() override { return wallForces_.all(false); }
    std::vector<FluidForce> forcesOnWallsOfAll() override { return wallForces_.all(true); }
    std::vector<FluidForce> forcesOnSolids() override
    {
        return p_.solids.bodies ? p_.solids.bodies->forces.forces() : std::vector<FluidForce>();
    }
    FluidEnergy energy() override { return readings_.energy(); }
    FluidExtremes extremes() override { return readings_.extremes(); }
    FluidEnd farEnd(const Vector3& direction, double reach) override
    {
        return readings_.farEnd(direction, reach);
    }
    double particleSpacing() const override { return p_.set.particleSpacing(); }
    using FluidScene::sample;
    SampleResult sample(const std::vector<double>& points, const SightPlanes&) override
    {
        return readings_.sample(points);
    }
    Later<std::vector<std::int32_t>> savedState(bool later) override
    {
        return checkpoint_.save(later);
    }
    void loadState(const std::vector<std::int32_t>& words) override { checkpoint_.load(words); }
    double estimateTimeStep(std::string& limit) override { return control_.estimate(limit); }
    std::vector<ArrayInfo> arrays() const override { return readings_.arrays(); }
    std::vector<KernelInfo> kernels() const override { return readings_.kernels(); }
    void timeKernels(bool on) override { p_.set.context.profile.timing = on; }
    std::string deviceName() const override { return deviceLabel(Backend()); }
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

private:

    PicReport advanceDry(double t, std::int64_t maxSteps);
    void finish(PicReport&);

    PicParts<Backend, D, P> p_;
    PicTransfer<Backend, D, P> transfer_{p_};
    ParticleAdvection<Backend, D, P> advection_{p_};
    FreeSurface<Backend, D, P> surface_{p_, advection_};
    OpenBoundaries<Backend, D, P> openings_{p_};
    CellCutter<Backend, D, P> cutter_{p_, openings_};
    BodyCoupling<Backend, D, P> coupling_{p_, openings_};
    ForcesOnWalls<Backend, D, P> wallForces_{p_};
    ViscousStep<Backend, D, P> viscosity_{p_, coupling_, wallForces_};
    MomentumBudget<Backend, D, P> budget_{p_};
    Projection<Backend, D, P> projection_{p_, transfer_, openings_, coupling_, viscosity_, budget_};
    FluidSeeding<Backend, D, P> seeding_{p_, advection_, surface_};
    Multirate<Backend, D, P> multirate_{p_};
    PicReadings<Backend, D, P> readings_{p_, viscosity_};
    TimeStepControl<Backend, D, P> control_{p_, advection_};
    PicGuards<Backend, D, P> guards_{p_, readings_};
    PicStepper<Backend, D, P> stepper_{p_,
        {advection_, surface_, openings_, cutter_, coupling_, transfer_, budget_, projection_,
            multirate_, control_, guards_}};
    PicCheckpoint<Backend, D, P> checkpoint_{p_, advection_, surface_, openings_, cutter_};
};

template<class Backend, int D, class P>
PicSolver<Backend, D, P>::PicSolver(const PicConfig& config, const FluidInput& fluid,
    const PicWalls& walls, LinearSolver* solver, PicInside&& inside)
    : p_(config, fluid, solver, std::move(inside))
{
    p_.walls.sides = walls;
    if (!config.openings.empty()) openings_.set(p_.walls.sides);
    if (p_.cuts())
    {
        p_.cut.allocate(p_.sticksInside());
        coupling_.set(fluid.size() > 0);
        cutter_.cut(p_.set.clock.time, 1);
    }
    else cutter_.setWalls(p_.walls.sides);
    seeding_.fill(fluid);
    if (p_.opens())
    {
        openings_.start();
        surface_.markWater();
        openings_.takeUpPending();
    }
    multirate_.start();
    p_.set.context.synchronise();
}

template<class Backend, int D, class P>
PicReport PicSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    if (p_.set.clock.initial == 0) return advanceDry(t, maxSteps);
    PicReport report;
    report.minTimeStep = 1e300;
    if (p_.set.meter) p_.set.meter->begin();
    if (p_.isInterrupted()) maxSteps = 1;
    if (p_.solids.side) p_.solids.side->beginReport();
    while (p_.set.clock.time < t && p_.particles.all() > 0
        && (maxSteps <= 0 || report.steps < maxSteps))
        if (!stepper_.advance(t, report) || p_.isInterrupted()) break;
    p_.interrupted = false;
    finish(report);
    return report;
}

//- What the steps have led to
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::finish(PicReport& report)
{
    OpenSides<Backend, D, P>& sides = p_.openings;
    PicClock& clock = p_.set.clock;
    PicParticleFields<Backend, D, P>& particles = p_.particles;
    SurfaceFields<Backend, D, P>& surface = p_.surface;
    double sums[3];
    if (report.steps) surface.volume = surface_.waterVolume(sums);
    report.viscosityConverged = viscosity_.converged();
    if (p_.solids.side) p_.solids.side->endReport();
    if (!report.steps) report.minTimeStep = 0;
    report.time = clock.time;
    report.totalSteps = clock.steps;
    const double all = double(particles.all());
    report.fluid = std::size_t(particles.all());
    report.flying = std::size_t(surface.flying);
    report.slow = std::size_t(p_.slow.particles(p_.set.context, particles.sort.start()));
    const double particle = clock.particleVolume;
    report.volume = surface.volume*p_.set.grid.volume() + surface.flying*particle;
    report.volumeError = all > 0
        ? report.volume/(all*particle + (p_.opens() ? sides.balance() : 0)) - 1
        : 0;
    report.volumeDrift = clock.drift;
    for (std::size_t k = 0; k < sides.in.size(); ++k)
    {
        const double pending = sides.balance(int(k));
        report.passed.push_back(
            PicPassage{sides.in[k], sides.out[k], sides.volume[k] + pending, pending});
    }
    if (!p_.set.meter) return;
    const std::size_t owned = particles.own().size();
    report.rank = p_.set.meter->end(owned, std::size_t(particles.n) - owned);
}

//- Without water solids do what they do in a scene of their own, to the bit
template<class Backend, int D, class P>
PicReport PicSolver<Backend, D, P>::advanceDry(double t, std::int64_t maxSteps)
{
    PicReport report;
    if (p_.halo && p_.isInterrupted()) maxSteps = 1;
    const DemReport solids = p_.inside.scene->advance(t, maxSteps);
    p_.interrupted = false;
    p_.set.clock.time = report.time = solids.time;
    p_.set.clock.steps = report.totalSteps = solids.totalSteps;
    report.steps = solids.steps;
    report.lastTimeStep = report.minTimeStep = report.maxTimeStep = solids.lastTimeStep;
    report.limit = "solids";
    if (solids.stop != DemStop::none) report.stop = StopReason::solids;
    return report;
}

} // namespace riprap
