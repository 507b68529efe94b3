/*  SphSolver: its solids. Nothing of this is called in a scene that has none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setSolids(SolidPart part)
{
    if (!part.scene) return;
    solidScene_ = std::move(part.scene);
    solids_ = dynamic_cast<SolidSide<D, P>*>(solidScene_.get());
    if (!solids_ || solidScene_->device() != device())
        throw std::invalid_argument(
            "solids of another device, dimension or precision than the fluid's");
    dynamic_cast<LaunchOrder<Backend>&>(*solidScene_).follow(context_);
    coupling_ = part.coupling;
    nSolids_ = solids_->keys();
    const std::size_t all = std::size_t(nSolids_)*D;
    solidRecords_.allocate(context_, nSolids_, model_.variableH);
    solidSort_.allocate(context_, nSolids_, grid_.cells);
    solidReference_.allocate(context_, all);
    solidLast_.allocate(context_, all);
    // packs may be loaded at the last point
    for (auto& u : solidOwn_) u.allocate(context_, std::size_t(nSolids_) + 16);
    solidMass_.allocate(context_, std::size_t(nSolids_) + 16);
    for (auto* a : {&solidVelocity_, &solidAcceleration_, &solidForce_}) a->allocate(context_, all);
    if (coupling_.force == FluidForceKind::interpolated) solidForceBefore_.allocate(context_, all);
    std::vector<real> mass(nSolids_);
    for (int k = 0; k < nSolids_; ++k) mass[k] = real(config_.density*part.volume[k]);
    solidMassOfKey_.upload(context_, mass);
    solidAddedOfKey_.upload(context_, std::vector<real>(part.added.begin(), part.added.end()));
    allocateAction();
    forEach(context_, nSolids_, FirstVelocities<D, P>{solids_->view(), solidPoints()});
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::allocateAction()
{
    for (int d = 0; d < D; ++d) actionA_[d].allocate(context_, n_);
    actionRate_.allocate(context_, n_);
    if (coupling_.xsph) for (int d = 0; d < D; ++d) actionDrift_[d].allocate(context_, n_);
}

template<class Backend, int D, class P>
SolidPoints<D, P> SphSolver<Backend, D, P>::solidPoints()
{
    SolidPoints<D, P> p{};
    p.key = solidSort_.order();
    p.active = solidSort_.active();
    p.mass = solidMass_.data();
    p.massOfKey = solidMassOfKey_.data();
    p.addedOfKey = solidAddedOfKey_.data();
    for (int d = 0; d < D; ++d)
    {
        p.last[d] = solidLast_.data() + std::size_t(d)*nSolids_;
        p.own[d] = solidOwn_[d].data();
    }
    p.velocity = solidVelocity_.data();
    p.acceleration = solidAcceleration_.data();
    p.force = solidForce_.data();
    return p;
}

template<class Backend, int D, class P>
SolidAction<D, typename P::real> SphSolver<Backend, D, P>::solidAction()
{
    SolidAction<D, real> a{};
    if (!solidsMeet_) return a;
    for (int d = 0; d < D; ++d)
    {
        a.a[d] = actionA_[d].data();
        a.drift[d] = coupling_.xsph ? actionDrift_[d].data() : nullptr;
    }
    a.rate = actionRate_.data();
    return a;
}

template<class Backend, int D, class P>
template<class F>
void SphSolver<Backend, D, P>::withSolidTerms(bool viscous, const F& f) const
{
    SolidPressure pressure{};
    pressure.gradient = coupling_.kind == CouplingKind::pressureGradient;
    const auto antiClump = terms_.template get<AntiClump<real>>();
    const auto xsph = terms_.template get<Xsph<real>>();
    terms_.withSolidTerms(viscous && coupling_.viscosity, [&](const auto& viscousTerms)
    {
        f(SolidTerms<std::decay_t<decltype(viscousTerms)>, real>
        {
            pressure, Continuity{}, viscousTerms,
            Switchable<AntiClump<real>>(antiClump, coupling_.antiClump),
            coupling_.xsph ? real(2)*xsph.epsilon : real(0)
        });
    });
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphSolver<Backend, D, P>::solidSource()
{
    Source<Backend, D, P> s{};
    s.records = solidRecords_.view();
    s.start = solidSort_.start();
    if constexpr (Backend::gpu) s.list = parts_.fluidSolid.view();
    return s;
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphSolver<Backend, D, P>::fluidAboutSolids()
{
    Source<Backend, D, P> s{};
    s.records = fluidRecords_.view();
    s.start = fluidSort_.start();
    if constexpr (Backend::gpu) s.list = parts_.solidFluid.view();
    return s;
}

//- Sorted by key within a cell: the order does not depend on how the scene came here
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::sortSolids()
{
    forEach(context_, nSolids_,
        PointKeys<D, P>{box_, grid_, solids_->view(), solidSort_.keys(), solidSort_.indices()});
    solidSort_.sort(context_, nSolids_);
    PlacePoints<Backend, D, P> place{
        box_, solids_->view(), solidPoints(), solidRecords_.view(), {}, model_, {}};
    for (int d = 0; d < D; ++d)
        place.reference[d] = solidReference_.data() + std::size_t(d)*nSolids_;
    if constexpr (Backend::gpu) place.frames = parts_.frames.view();
    forEach(context_, nSolids_, place);
}

//- Half a step's impulse of the fluid at once, as the fluid gets it
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::pushSolids()
{
    if (solids_->still()) return;
    forEach(context_, nSolids_,
        HoldForces<D, P>{solidForce_.data(), nullptr, solids_->external(), 1, 0});
    solids_->push(0.5*host_.dt);
}

//- Until the next sort: without fluid near any of them nothing passes between the two, and nothing
//  is computed
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::meetFluid()
{
    meets_.upload(context_, std::vector<int>(1, 0));
    forEach(context_, nSolids_,
        MeetFluid<D, P>{box_, grid_, solids_->view(), solidSort_.order(), solidSort_.active(),
            fluidSort_.start(), meets_.data(),
            Backend::gpu ? grid_.radius : grid_.radius + allowedWay_});
    solidsMeet_ = meets_.download()[0] != 0;
    if (!solidsMeet_) forEach(context_, nSolids_*D, ClearForces<real>{solidForce_.data()});
    else if (Backend::gpu) forEach(context_, n_, ClearAction<D, real>{solidAction()});
}

//- What of the last two forces solids get at a fraction of the step, so that the impulse of whole
//  steps is what docs/coupling.md has
inline ForceShares sharesOfForces(const ClockData& clock, FluidForceKind kind, double fraction)
{
    const double ratio = clock.previousDt/clock.dt;     // 0 in the first step
    if (kind != FluidForceKind::interpolated) return ForceShares{0.5*(1 + ratio), 0};
    const double slope = 0.5*ratio + (ratio > 0 ? (fraction - 0.5)/ratio : 0);
    return ForceShares{1 + slope, -slope};
}

//- Solids over the step that the clock has begun; the fluid's force of its start acts on them
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::advanceSolids()
{
    const auto forceShares = [&](double fraction)
    { return sharesOfForces(host_, coupling_.force, fraction); };
    const auto advance = [&](double t, double dt, int steps, const ForceShares& shares)
    {
        const double scale = dt/solids_->kickTime(dt, steps);
        forEach(context_, nSolids_,
            HoldForces<D, P>{solidForce_.data(), solidForceBefore_.data(), solids_->external(),
                scale*shares.now, scale*shares.before});
        return solids_->advanceTo(t, dt, steps);
    };
    if (solids_->still()) { solids_->advanceTo(host_.time, host_.dt, subcycles_ = 1); return; }
    if (coupling_.force == FluidForceKind::impulse) pushSolids();
    const int steps = subcycles_ = solids_->subcycles(host_.dt);
    const double begin = host_.time - host_.dt, part = host_.dt/steps;
    const auto end = [&](int k) { return k == steps ? host_.time : begin + k*part; };
    bool good = true;
    if (coupling_.force == FluidForceKind::interpolated)
    {
        for (int k = 0; k < steps && good; ++k)
            good = advance(end(k + 1), part, 1, forceShares((k + 0.5)/steps));
        forEach(
            context_, nSolids_*D, KeepForces<real>{solidForce_.data(), solidForceBefore_.data()});
    }
    else if (coupling_.force == FluidForceKind::held)
        good = advance(host_.time, host_.dt, steps, forceShares(0.5));
    else good = advance(host_.time, host_.dt, steps, ForceShares{0, 0});
    if (good) return;
    host_.halt = Halt::solids;
    host_.active = 0;
    writeClock();
}

//- Between two calls of advance solids are read: with the fluid's force of now
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::showForces()
{
    if (!solids_) return;
    forEach(context_, nSolids_,
        HoldForces<D, P>{solidForce_.data(), nullptr, solids_->external(), 1, 0});
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::moveSolids(bool half)
{
    if (!solids_ || (half && solids_->still())) return;
    MovePoints<Backend, D, P> move{box_, solids_->view(), solidPoints(), solidRecords_.view(), {},
        allowedWay_, config_.smoothingRatio*config_.spacing/config_.soundSpeed, half,
        clock_.data(), {}};
    for (int d = 0; d < D; ++d)
        move.reference[d] = solidReference_.data() + std::size_t(d)*nSolids_;
    if constexpr (Backend::gpu) move.frames = parts_.frames.view();
    forEach(context_, nSolids_, move);
}

template<class Backend, int D, class P>
template<class Pass>
void SphSolver<Backend, D, P>::runOverSolids(const Pass& pass)
{
    if constexpr (Backend::gpu) pairLoop(context_, pass, parts_.solidShift, nSolids_);
    else pairLoop(context_, pass);
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::solidPressurePass(bool inStep)
{
    const bool extrapolated = coupling_.kind == CouplingKind::extrapolated;
    if (!solidsMeet_ || (!extrapolated && coupling_.kind != CouplingKind::pressureApproximation))
        return;
    withKernel(config_, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        runOverSolids(SolidPressurePass<Backend, D, P, Kernel, decltype(variable)::value>{box_,
            grid_, {fluidAboutSolids()}, solidRecords_.view(), kernelConstants<Kernel>(), model_,
            solidPoints(), extrapolated, inStep ? clock_.data() : nullptr});
    });
}

template<class Backend, int D, class P>
template<Part part>
void SphSolver<Backend, D, P>::solidPass()
{
    if (!solidsMeet_) return;
    withKernel(config_, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        withSolidTerms(true, [&](const auto& terms)
        {
            using SolidTerms = std::decay_t<decltype(terms)>;
            constexpr bool variableH = decltype(variable)::value;
            SolidToFluidPass<Backend, D, P, Kernel, variableH, part, SolidTerms> pass
            {
                box_, grid_, {solidSource()}, fluidRecords_.view(), terms,
                kernelConstants<Kernel>(), model_, solidAction(), solidMass_.data(), {},
                fluidSort_.active(), clock_.data()
            };
            for (int d = 0; d < D; ++d) pass.own[d] = solidOwn_[d].data();
            run(pass, n_);
        });
    });
}

//- pressureForce: where that of the pressure alone is put, between two steps
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::solidForcePass(real* pressureForce)
{
    if (!solidsMeet_) return;
    SolidPoints<D, P> points = solidPoints();
    if (pressureForce) points.force = pressureForce;
    withKernel(config_, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        withSolidTerms(!pressureForce, [&](const auto& terms)
        {
            using SolidTerms = std::decay_t<decltype(terms)>;
            constexpr bool variableH = decltype(variable)::value;
            runOverSolids(FluidToSolidPass<Backend, D, P, Kernel, variableH, SolidTerms>
            {
                box_, grid_, {fluidAboutSolids()}, solidRecords_.view(), terms,
                kernelConstants<Kernel>(), model_, points, pressureForce ? nullptr : clock_.data()
            });
        });
    });
}

template<class Backend, int D, class P>
CouplingState SphSolver<Backend, D, P>::coupling()
{
    CouplingState s;
    if (!solids_) return s;
    readClock();
    s.subcycles = subcycles_;
    const std::vector<real> force = solidForce_.download();
    const std::vector<real> before = solidForceBefore_.size()
        ? solidForceBefore_.download()
        : std::vector<real>(force.size(), real(0));
    const std::vector<std::int32_t> keys = solids_->order();
    s.force.assign(3*keys.size(), 0.0);
    for (std::size_t i = 0; i < keys.size(); ++i)
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = std::size_t(keys[i])*D + d;
            const double f = force[at];
            s.force[3*i + config_.axes[d]] = f;
            s.total[config_.axes[d]] += f;
            if (coupling_.force != FluidForceKind::impulse)
                s.pending[config_.axes[d]] += 0.5*host_.dt*(f - before[at]);
        }
    return s;
}

} // namespace riprap
