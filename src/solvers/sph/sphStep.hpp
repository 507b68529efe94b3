/*  SphSolver: what kernels are given, and the parts of a step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
FluidFields<D, P> SphSolver<Backend, D, P>::fluidFields()
{
    FluidFields<D, P> f{};
    for (int d = 0; d < D; ++d)
    {
        f.x[d] = fluid_.template data<std::int64_t>(xField_ + d);
        f.v[d] = fluid_.template data<real>(vField_ + d);
        f.a[d] = fluid_.template data<real>(aField_ + d);
        f.drift[d] = driftField_ < 0 ? nullptr : fluid_.template data<real>(driftField_ + d);
    }
    f.deviation = fluid_.template data<real>(deviationField_);
    f.rate = fluid_.template data<real>(rateField_);
    f.id = fluid_.template data<std::int32_t>(idField_);
    return f;
}

template<class Backend, int D, class P>
WallFields<D, P> SphSolver<Backend, D, P>::wallFields()
{
    WallFields<D, P> f{};
    for (int d = 0; d < D; ++d)
    {
        f.x[d] = wall_.template data<std::int64_t>(wallXField_ + d);
        f.v[d] = wallVField_ < 0 ? nullptr : wall_.template data<real>(wallVField_ + d);
        f.a[d] = wallAField_ < 0 ? nullptr : wall_.template data<real>(wallAField_ + d);
    }
    f.id = wall_.template data<std::int32_t>(wallIdField_);
    f.body = wallBodyField_ < 0 ? nullptr : wall_.template data<std::int32_t>(wallBodyField_);
    return f;
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphSolver<Backend, D, P>::fluidSource([[maybe_unused]] bool forWalls)
{
    Source<Backend, D, P> s{};
    s.records = fluidRecords_.view();
    s.start = fluidSort_.start();
    if constexpr (Backend::gpu)
        s.list = forWalls ? parts_.wallFluid.view() : parts_.fluidFluid.view();
    return s;
}

template<class Backend, int D, class P>
Source<Backend, D, P> SphSolver<Backend, D, P>::wallSource()
{
    Source<Backend, D, P> s{};
    if (!nWalls_) return s;
    s.records = wallRecords_.view();
    s.start = wallSort_.start();
    if constexpr (Backend::gpu) s.list = parts_.fluidWall.view();
    return s;
}

template<class Backend, int D, class P>
template<class Kernel>
KernelConstants<D, typename P::real> SphSolver<Backend, D, P>::kernelConstants() const
{
    return KernelConstants<D, real>::template make<Kernel>(
        config_.smoothingRatio*config_.spacing, config_.spacing);
}

template<class Backend, int D, class P>
template<class M>
M SphSolver<Backend, D, P>::mover()
{
    M m{};
    m.box = box_;
    m.model = model_;
    m.fluid = fluidFields();
    m.records = fluidRecords_.view();
    for (int d = 0; d < D; ++d) m.reference[d] = fluidReference_.data() + std::size_t(d)*n_;
    m.allowedWay = allowedWay_;
    if constexpr (Backend::gpu) m.frames = parts_.frames.view();
    m.count = fluidSort_.active();
    m.clock = clock_.data();
    m.contact = faceContact();
    m.ghosts = ghosts();
    return m;
}

template<class Backend, int D, class P>
template<class Pass>
void SphSolver<Backend, D, P>::run(const Pass& pass, [[maybe_unused]] int targets)
{
    if constexpr (Backend::gpu) pairLoop(context_, pass, shift_, targets);
    else pairLoop(context_, pass);
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::moveWalls(bool half)
{
    if (!nBodies_) return;
    MoveWalls<Backend, D, P> m;
    m.box = box_;
    m.fields = wallFields();
    m.wall = wallRecords_.view();
    m.rest = wallRest_.data();
    for (int d = 0; d < D; ++d)
    {
        m.axes[d] = config_.axes[d];
        m.reference[d] = wallReference_.data() + std::size_t(d)*nWalls_;
    }
    m.table = PoseTable{poses_.data(), poseIntervals, poseBegin_, poseStep_};
    m.allowedWay = wallWay_;
    m.half = half;
    m.clock = clock_.data();
    forEach(context_, nWalls_, m);
    if (config_.wallModel == WallKind::stationary)
        forEach(context_, nWalls_,
            StationaryWall<Backend, D, P>{wallRecords_.view(), wallFields(), model_});
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::wallPass(bool inStep)
{
    if (!nWalls_ || config_.wallModel != WallKind::extrapolated) return;
    withKernel(config_, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        ExtrapolatedWallPass<Backend, D, P, Kernel, decltype(variable)::value> pass;
        pass.box = box_;
        pass.grid = grid_;
        pass.source[0] = fluidSource(true);
        pass.wall = wallRecords_.view();
        pass.fields = wallFields();
        pass.kernel = kernelConstants<Kernel>();
        pass.model = model_;
        pass.count = nWalls_;
        pass.clock = inStep ? clock_.data() : nullptr;
        if (ranks_) pass.ghosts = ranks_->wallMarks();
        run(pass, nWalls_);
    });
    if (ranks_) ranks_->shareWalls();
}

//- Force on the walls, or that of the pressure alone; without somewhere to put it, the work that
//  moving walls do in this step
template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::wallForcePass(real* force, bool viscous)
{
    if (!force && !nBodies_) return;
    withKernel(config_, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        terms_.withWallTerms(viscous, [&](const auto& terms)
        {
            using WallTerms = std::decay_t<decltype(terms)>;
            WallForcePass<Backend, D, P, Kernel, decltype(variable)::value, WallTerms> pass
            {
                box_, grid_, {fluidSource(true)}, wallRecords_.view(), terms,
                kernelConstants<Kernel>(), model_, nWalls_, force, nullptr, {}, nullptr, nullptr
            };
            for (int d = 0; nBodies_ && d < D; ++d)
                pass.wallVelocity[d] = wall_.template data<real>(wallVField_ + d);
            if (force) return directPairLoop(context_, pass, nWalls_);
            pass.clock = clock_.data();
            pass.work = wall_.template data<double>(wallWorkField_);
            pass.pressureWork = wall_.template data<double>(wallPressureWorkField_);
            run(pass, nWalls_);
        });
    });
}

template<class Backend, int D, class P>
template<Part part>
void SphSolver<Backend, D, P>::fluidPass(Finish mode)
{
    withKernel(config_, [&](auto kernel, auto variable)
    {
        using Kernel = decltype(kernel);
        // exact combinations where speed is sought
        constexpr bool specialised = Kernel::frequent && sizeof(real) == 4;
        terms_.template withFluidTerms<part, specialised>(
            [&](const auto& fluidTerms, const auto& wallTerms, auto shifts)
            {
                FluidPass<Backend, D, P, Kernel, decltype(variable)::value, part,
                    std::decay_t<decltype(fluidTerms)>, std::decay_t<decltype(wallTerms)>,
                    decltype(shifts)::value>
                    pass{box_, grid_, {fluidSource(false), wallSource()}, fluidTerms, wallTerms,
                        kernelConstants<Kernel>(), terms_.shifting, model_, fluidFields(), {},
                        fluidSort_.active(), clock_.data(), mode, solidAction(), ghosts()};
                for (int d = 0; d < D; ++d)
                    pass.wallVelocity[d] = wallVField_ < 0
                        ? nullptr
                        : wall_.template data<real>(wallVField_ + d);
                run(pass, n_);
            });
    });
}

template<class Backend, int D, class P>
Tick SphSolver<Backend, D, P>::tick() const
{
    return Tick{const_cast<ClockData*>(clock_.data()), limits_};
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::step()
{
    forEach(context_, 1, tick());
    if constexpr (!Backend::gpu) if (!clock_.data()->active) return;
    if (solids_)
    {
        if (Backend::gpu && coupling_.force != FluidForceKind::impulse) solids_->measureSpeed();
        readClock();
        if (host_.active) advanceSolids();
        if (!host_.active) return;
    }
    moveFaces();
    if (config_.integrator == IntegratorKind::leapfrog)
    {
        forEach(context_, n_, mover<LeapfrogDrift<Backend, D, P>>());
        if (ranks_) ranks_->shareRecords();
        blowBodies();
        moveWalls(false);
        moveSolids(false);
        wallPass(true);
        solidPressurePass(true);
        solidPass<Part::all>();
        fluidPass<Part::all>(Finish::close);
        wallForcePass(nullptr);
    }
    else
    {
        forEach(context_, n_, mover<SymplecticKick<Backend, D, P>>());
        if (ranks_) ranks_->shareRecords();
        moveWalls(true);
        moveSolids(true);
        solidPass<Part::density>();
        fluidPass<Part::density>(Finish::close);
        forEach(context_, n_, mover<SymplecticDrift<Backend, D, P>>());
        if (ranks_) ranks_->shareRecords();
        blowBodies();
        moveWalls(false);
        moveSolids(false);
        wallPass(true);
        solidPressurePass(true);
        solidPass<Part::momentum>();
        fluidPass<Part::momentum>(Finish::close);
        wallForcePass(nullptr);
    }
    solidForcePass();
    if (ranks_) ranks_->agree(*clock_.data(), interrupted_);
    if (solids_ && coupling_.force == FluidForceKind::impulse) pushSolids();
}

} // namespace riprap
