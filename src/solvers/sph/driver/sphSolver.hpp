/*  The SPH scene on one backend, in one dimension and precision: its parts (solvers/sph/parts), and
    classes that do one thing with them each. Several processes: solvers/sph/parts/fluidRanks.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/device.hpp"
#include "solvers/sph/driver/soundSpeed.hpp"
#include "solvers/sph/driver/sphCheckpoint.hpp"
#include "solvers/sph/driver/sphForces.hpp"
#include "solvers/sph/driver/sphReadings.hpp"
#include "solvers/sph/driver/sphReports.hpp"
#include "solvers/sph/driver/sphStepper.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class SphSolver : public SphScene
{
public:

    SphSolver(const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);

    SphReport advance(double t, std::int64_t maxSteps) override;
    void interrupt() override { p_.interrupted = true; }
    double time() const override { return p_.clock.now.time; }
    FluidState fluid() override { return readings_.fluid(); }
    Later<FluidState> fluidLater() override { return readings_.fluidLater(); }
    WallState walls() override { return readings_.walls(); }
    SphEnergy energy() override { return readings_.energy(); }
    FluidExtremes extremes() override { return readings_.extremes(); }
    FluidEnd farEnd(const Vector3& direction, double reach) override
    {
        return readings_.farEnd(direction, reach);
    }
    std::vector<Vector3> wallForces() override { return forces_.wallForces(); }
    std::vector<FluidForce> forcesOnWalls() override { return forces_.forcesOnWalls(); }
    std::vector<FluidForce> forcesOnSolids() override { return forces_.forcesOnSolids(); }
    FaceContacts faceContacts() override { return readings_.faceContacts(); }
    using FluidScene::sample;
    SampleResult sample(const std::vector<double>& points, const SightPlanes& planes) override
    {
        return readings_.sample(points, planes);
    }
    Later<std::vector<std::int32_t>> savedState(bool later) override
    {
        return checkpoint_.save(later);
    }
    void loadState(const std::vector<std::int32_t>& words) override { checkpoint_.load(words); }
    std::array<std::size_t, SphScene::speedClasses> fasterThan(
        const std::array<double, SphScene::speedClasses>& speeds) override
    { return soundSpeed_.fasterThan(speeds); }
    void setMaxVelocity(double maxVelocity, double soundSpeed) override
    {
        soundSpeed_.setMaxVelocity(maxVelocity, soundSpeed);
    }
    double estimateTimeStep(std::string& limit) override
    {
        return readings_.estimateTimeStep(limit);
    }
    std::vector<ArrayInfo> arrays() const override { return readings_.arrays(); }
    std::vector<KernelInfo> kernels() const override { return readings_.kernels(); }
    void timeKernels(bool on) override { p_.set.context.profile.timing = on; }
    double neighboursPerParticle() override { return readings_.neighboursPerParticle(); }
    NeighbourCounts countNeighbours() override { return readings_.countNeighbours(); }
    DemScene* solids() override { return p_.solids.scene.get(); }
    CouplingState coupling() override { return solids_.state(); }
    std::string deviceName() const override { return deviceLabel(Backend()); }
    DeviceKind device() const override { return Backend::gpu ? DeviceKind::gpu : DeviceKind::cpu; }

private:

    void prime();

    SphParts<Backend, D, P> p_;
    FluidPasses<Backend, D, P> fluid_{p_};
    WallPasses<Backend, D, P> walls_{p_};
    SolidCoupling<Backend, D, P> solids_{p_};
    SphNeighbours<Backend, D, P> neighbours_{p_, fluid_, walls_, solids_};
    SphStepper<Backend, D, P> stepper_{p_, fluid_, walls_, solids_, neighbours_};
    SphReports<Backend, D, P> reports_{p_, neighbours_};
    SphReadings<Backend, D, P> readings_{p_, fluid_, walls_, neighbours_};
    SphForces<Backend, D, P> forces_{p_, walls_, solids_, neighbours_};
    SoundSpeed<Backend, D, P> soundSpeed_{p_, fluid_};
    SphCheckpoint<Backend, D, P> checkpoint_{p_, solids_, neighbours_};
};

template<class Backend, int D, class P>
SphSolver<Backend, D, P>::SphSolver(const SphConfig& config, const FluidInput& fluid,
    const WallInput& walls, WallMotion motion, SolidPart solids)
    : p_(config, int(fluid.size()), std::move(motion))
{
    p_.fluid.set(fluid);
    p_.walls.set(walls);
    p_.faces.set(walls.faces, solids, p_.walls.bodies);
    p_.solids.set(std::move(solids), p_.fluid.n);
    neighbours_.setFrames();
    neighbours_.allocateLists();
    if (p_.walls.bodies)
    {
        p_.poses.allocate(p_.walls.bodies);
        p_.poses.set(config.startTime, config.startTime);
    }
    prime();
    if (p_.ranks) neighbours_.fitCapacity();
}

//- First forces, from the state as given
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::prime()
{
    p_.clock.now = ClockData();
    p_.clock.now.active = 1;
    p_.clock.now.time = p_.set.config.startTime;
    p_.clock.write();
    if constexpr (Backend::gpu) p_.memory.frames.clearStill(p_.set.context);
    if (p_.walls.count)
    {
        walls_.place();
        walls_.setStationary();
        walls_.move(false);       // to where they are at the start: neighbours are sought there
    }
    for (;;)
    {
        neighbours_.rebuild();
        p_.clock.read();
        if (!p_.clock.now.overflows()) break;
        neighbours_.growLists();
    }
    walls_.move(false);
    walls_.moveFaces();
    walls_.extrapolate(true);
    solids_.pressurePass(true);
    solids_.template pass<Part::all>();
    fluid_.template pass<Part::all>(Finish::store);
    solids_.forcePass();
    solids_.showForces();
    if (p_.ranks) p_.ranks->agree(p_.clock, p_.interrupted);
    p_.set.context.synchronise();
    p_.clock.read();
}

template<class Backend, int D, class P>
SphReport SphSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    SphReport report;
    ClockData& now = p_.clock.now;
    p_.clock.read();
    if (p_.walls.bodies)
    {
        p_.poses.set(now.time, std::max(t, now.time));
        // poses are part of the recorded launches
        if constexpr (Backend::gpu) p_.memory.graphs.forget();
    }
    if (p_.ranks)
    {
        p_.ranks->agreeToStop(p_.interrupted);
        p_.ranks->particles().work(true);
    }
    if (p_.stopAsked()) maxSteps = 1;
    const std::int64_t before = now.step;
    if (p_.solids.side) p_.solids.side->beginReport();
    now.target = t;
    now.lastStep = maxSteps > 0 ? before + maxSteps : std::int64_t(1) << 62;
    now.minDt = 1e300;
    now.maxDt = 0;
    now.needRebuild = now.aged[0] = now.aged[1] = 0;
    now.skinViolations = now.missed[0] = now.missed[1] = 0;
    // also before and after all steps: what the last one did is said in its own call, before anyone
    // writes it, and while the records are those that it saw (SphReports::finish)
    if (now.halt == Halt::none) now.halt = p_.set.limits.halt(now);
    p_.clock.write();
    stepper_.run(report.rebuilds);
    reports_.finish(report, before);
    if (p_.solids.side) p_.solids.side->endReport();
    solids_.showForces();
    return report;
}

} // namespace riprap
