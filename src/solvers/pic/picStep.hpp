/*  PicSolver: the parts of a step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/picSolver.hpp"

namespace riprap
{

//- f(std::integral_constant<int, order of the splines>, are there places around which the nodes are
//  no block?)
template<class Backend, int D, class P>
template<class F>
void PicSolver<Backend, D, P>::withWindows(const F& f)
{
    withSpline(config_.splineOrder, [&](auto order)
    {
        if (needsAround(grid_, config_.splineOrder)) f(order, std::true_type());
        else f(order, std::false_type());
    });
}

//- spare: those that a sort fills
template<class Backend, int D, class P>
PicParticles<D, typename P::real> PicSolver<Backend, D, P>::particles(bool spare)
{
    const auto field = [&](auto type, int k)
    {
        using T = decltype(type);
        return spare ? set_.template spare<T>(k) : set_.template data<T>(k);
    };
    PicParticles<D, real> p{};
    p.count = n_;
    for (int d = 0; d < D; ++d)
    {
        p.x[d] = field(double(), xField_ + d);
        p.v[d] = field(real(), vField_ + d);
    }
    for (int k = 0; k < D*D; ++k)
        p.affine[k] = affineField_ >= 0 ? field(real(), affineField_ + k) : nullptr;
    for (int k = 0; k < fromFaces_.memory(); ++k) p.memory[k] = field(real(), memoryField_ + k);
    p.id = field(std::int32_t(), idField_);
    p.place = place_.data();
    p.start = sort_.start();
    return p;
}

template<class Backend, int D, class P>
PressureFields<D, typename P::real> PicSolver<Backend, D, P>::pressureFields(
    double dt, bool reflected)
{
    PressureFields<D, real> f{};
    f.grid = grid_;
    f.phi = phi_.data();
    for (int d = 0; d < D; ++d)
    {
        f.aperture[d] = aperture_[d].data();
        f.wallVelocity[d] = wallsMove_ ? wallVelocity_[d].data() : nullptr;
        f.u[d] = u_[d].data();
    }
    f.p = (reflected ? reflected_ : pressure_).data();
    f.timeStep = dt;
    f.density = config_.density;
    return f;
}

//- f.add(cell, sums) over the cells about the water; over all before these are known
template<class Backend, int D, class P>
template<int N, class F>
std::array<double, N> PicSolver<Backend, D, P>::sumOverWater(const F& f)
{
    return rows_.found() ? rows_.template sum<N>(context_, f)
                         : sumOver<N>(context_, grid_.cells(), f);
}

//- By cells; those that have left the block come last and are dropped
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::sortParticles(PicReport* report, bool keysKnown)
{
    const int before = n_;
    if (!keysKnown)
        forEach(
            context_, n_, PicCellKeys<D, real>{grid_, particles(), sort_.keys(), sort_.indices()});
    sort_.sort(context_, n_);
    forEach(context_, n_,
        PutInOrder<D, real>{
            1/grid_.h, sort_.order(), particles(), particles(true), place_.data()});
    set_.takeSpares();
    context_.toHost(&n_, sort_.active(), sizeof(int));
    if (!report || n_ == before) return;
    const int left = before - n_;
    std::vector<std::int32_t> id(left);
    std::vector<double> x[D];
    context_.toHost(
        id.data(), set_.template data<std::int32_t>(idField_) + n_, left*sizeof(std::int32_t));
    for (int d = 0; d < D; ++d)
    {
        x[d].resize(left);
        context_.toHost(
            x[d].data(), set_.template data<double>(xField_ + d) + n_, left*sizeof(double));
    }
    for (int i = 0; i < left; ++i)
    {
        Vector3 at{{emptyCoordinate_, emptyCoordinate_, emptyCoordinate_}};
        Vec<D, double> place;
        for (int d = 0; d < D; ++d)
        {
            place.c[d] = x[d][i];
            at[config_.axes[d]] = grid_.origin[d] + x[d][i];
        }
        const int through = opens() ? leftThrough(place) : -1;
        if (through >= 0)
        {
            ++openings_.out[through];
            openings_.volume[through] -= clock_.particleVolume;
            openings_.owed[through] -= clock_.particleVolume;
            continue;
        }
        report->escaped.push_back(at);
        report->escapedId.push_back(id[i]);
    }
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::markWater()
{
    const MarkWetCells<D, real> wet{pressureFields(0), wet_.data()};
    const MarkNearWater<D> near{grid_, wet_.data(), near_.data()};
    if (rows_.found())
    {
        rows_.eachCell(context_, wet);
        rows_.eachCell(context_, near);
        return;
    }
    forEach(context_, grid_.cells(), wet);
    forEach(context_, grid_.cells(), near);
}

//- Velocities of the particles on all faces about the water
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::toGrid()
{
    toFaces_.prepare(context_, grid_, sort_);
    rows_.find(context_, grid_, toFaces_.occupied(), phi_.data(), sort_);
    for (int d = 0; d < D; ++d)
    {
        const int faces = grid_.faces(d);
        withSpline(config_.splineOrder,
            [&](auto order)
            {
                toFaces_.template map<decltype(order)::value>(context_, grid_, rows_, particles(),
                    d, affineField_ >= 0, opens() ? u_[d].data() : nullptr, before_[d].data(),
                    mass_[d].data());
            });
        if (grid_.periodic[d])
        {
            forEach(context_, faces, CopyPeriodic<D, real>{grid_, d, before_[d].data()});
            forEach(context_, faces, CopyPeriodic<D, real>{grid_, d, mass_[d].data()});
        }
        rows_.eachFaceOfBoth(context_, d,
            MarkByMass<D, real>{grid_, d, mass_[d].data(), aperture_[d].data(), layer_[d].data()});
    }
    extrapolate({before_}, 3);
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::extrapolate(
    std::initializer_list<Array<Backend, real>*> fields, int passes)
{
    Extrapolate<D, real> f{};
    f.grid = grid_;
    for (Array<Backend, real>* a : fields)
    {
        for (int d = 0; d < D; ++d) f.field[f.fields][d] = a[d].data();
        ++f.fields;
    }
    for (int d = 0; d < D; ++d) f.layer[d] = layer_[d].data();
    for (int pass = 1; pass <= passes; ++pass)
    {
        f.pass = static_cast<unsigned char>(pass);
        rows_.each(context_, f);
    }
}

//- Forces, then the pressure; the velocity, its change and what carries particles, extended past
//  the surface.
//
//  Particles bring the velocity of half a step ago to where they are now. Two errors of the order
//  of dt follow, which the last drift tells how to mend.
//  Over a drift u.grad u has a part G that is the gradient of a pressure, and a rest S. Particles,
//  which move at the middle of the coming drift, must be ahead of the projected velocity by dt/2 G:
//  a plain projection (`reflection no`) takes that away and dissipates. The advection-reflection of
//  Zehnder, Narain
//  & Thomaszewski (2018, ACM Trans. Graph. 37) gives G dt and nothing by turns; here it is half of
//  what the last drift's divergence was, each step.
//  And the projected velocity lags by dt/2 S where it carries particles. Both come from one more
//  solution: that of the velocity as particles bring it, less what they were left ahead by, with
//  bodies free from the velocity that they had, less the same impulse's. What is added is then a
//  gradient about the surface and bodies as they are now, and momentum balances. Were bodies moved
//  as given there, the half that is added back would hold work which they never did.
//  The second solution's pressure then lacks what lies in `after`, half of the dynamic pressure:
//  wholePressure() has it.
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::project(double dt, double drift)
{
    const bool reflects = config_.reflection > 0;
    const auto force = [&](Array<Backend, real>* from, bool gravity)
    {
        rows_.eachFace(context_,
            [&](int d)
            {
                return ApplyForces<D, real>{aperture_[d].data(),
                    wallsMove_ ? wallVelocity_[d].data() : nullptr, from[d].data(), u_[d].data(),
                    gravity ? real(gravity_[d]*dt) : real(0),
                    gravity && absorb_[d].size() ? absorb_[d].data() : nullptr, real(dt)};
            });
    };
    if (reflects)
    {
        // after a step that was much shorter (it ended at a target) the little that its drift did
        // says nothing of a long one
        constexpr double longest = 2;
        const real part = clock_.steps ? real(0.5*std::min(drift/clock_.lastStep, longest))
                                       : real(0);
        rows_.eachFace(context_,
            [&](int d) {
                return KeepLast<real>{
                    u_[d].data(), before_[d].data(), after_[d].data(), carrier_[d].data()};
            });
        if (bodies_) useBodyVelocities(false);
        force(after_, false);
        const MultigridControls* own = linearSolver_.onDevice();
        solveWithBodies(pressureFields(dt, true), false, own ? own->reflectionTolerance : 0);
        rows_.eachCellOfBoth(
            context_, HalfImpulse{reflected_.data(), ahead_.data(), dt*double(part)});
        rows_.eachFace(context_,
            [&](int d) {
                return HalfDrift<real>{u_[d].data(), after_[d].data(), carrier_[d].data(), part};
            });
    }
    if (config_.viscosity > 0) diffuse(dt);
    force(config_.viscosity > 0 ? u_ : before_, true);
    if (opens()) pushOpenFaces(dt);
    if (watches_) keepForced();
    if (bodies_) projectWithBodies(dt, reflects);
    else
        lastPressure_ = pressureStep_.project(
            context_, pressureFields(dt), linearSolver_, nullptr, reflects, &rows_);
    if (reflects)
        rows_.eachCellOfBoth(context_,
            WholePressure{pressureStep_.wet(), pressure_.data(), ahead_.data(), whole_.data(), dt});
    if (bodies_) bodies_->act(bodyCut_.gather(context_, wholePressure().data()));
    rows_.eachFace(context_,
        [&](int d)
        {
            return VelocityChange<real>{u_[d].data(), before_[d].data(), change_[d].data(),
                reflects ? after_[d].data() : nullptr, reflects ? carrier_[d].data() : nullptr};
        });
    if (watches_) weighMomentum(dt);
    rows_.eachFace(context_,
        [&](int d)
        {
            return MarkByWetCells<D, real>{grid_, wet_.data(), aperture_[d].data(),
                sticksInside() ? faceDistance_[d].data() : nullptr, d, layer_[d].data()};
        });
    if (reflects) extrapolate({u_, change_, after_, carrier_}, extrapolationPasses);
    else extrapolate({u_, change_}, extrapolationPasses);
}

template<class Backend, int D, class P>
GridVelocities<D, typename P::real> PicSolver<Backend, D, P>::gridVelocities(double dt)
{
    GridVelocities<D, real> v{};
    v.grid = grid_;
    v.particles = particles();
    for (int d = 0; d < D; ++d)
    {
        v.u[d] = (config_.reflection > 0 ? after_ : u_)[d].data();
        v.du[d] = change_[d].data();
        v.fall[d] = real(gravity_[d]*dt);
    }
    v.nearWater = near_.data();
    return v;
}

template<class Backend, int D, class P> void PicSolver<Backend, D, P>::toParticles(double dt)
{
    fromFaces_.take(context_, gridVelocities(dt), toFaces_.occupied(), dt);
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::moveParticles(double dt)
{
    const bool corrected = config_.positionCorrection > 0;
    if (corrected)
    {
        CorrectPositions<D, real, !Backend::gpu> f{};
        f.grid = grid_;
        f.inverse = 1/grid_.h;
        f.particles = particles();
        f.phi = phi_.data();
        f.nearWater = near_.data();
        for (int d = 0; d < D; ++d) f.shift[d] = shift_[d].data();
        f.strength = real(config_.positionCorrection*dt);
        f.spacing = real(particleSpacing());
        forEach(context_, n_, f);
    }
    withWindows([&](auto order, auto around)
    {
        MoveParticles<decltype(order)::value, D, real, decltype(around)::value> f{};
        f.grid = grid_;
        f.inverse = 1/grid_.h;
        f.particles = particles();
        for (int d = 0; d < D; ++d)
        {
            f.u[d] = carrier()[d].data();
            f.aperture[d] = aperture_[d].data();
            f.shift[d] = corrected ? shift_[d].data() : nullptr;
            f.gate[d] = opens() ? openings_.gate[d].data() : nullptr;
        }
        f.nearWater = near_.data();
        f.timeStep = dt;
        f.order = config_.advectionOrder;
        f.inside = cuts();
        f.margin = wallMargin*grid_.h;
        f.keys = cuts() || opens() ? nullptr : sort_.keys();
        f.indices = sort_.indices();
        if constexpr (!Backend::gpu && D == 2 && decltype(order)::value == 2)
            forEachRow(context_, toFaces_.occupied().count(),
                MoveCells<real, decltype(around)::value>{
                    f, toFaces_.occupied().tiles(), toFaces_.occupied().list()});
        else forEach(context_, n_, f);
    });
}

//- The surface goes with the water; then the particles, sorted, have their say
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::moveSurface(double dt, PicReport& report)
{
    const real band = real(bandCells*grid_.h);
    withWindows([&](auto order, auto around)
    {
        AdvectLevelSet<decltype(order)::value, D, real, decltype(around)::value> f{};
        f.grid = grid_;
        for (int d = 0; d < D; ++d) f.u[d] = carrier()[d].data();
        f.from = phi_.data();
        f.to = carried_.data();
        f.timeStep = dt;
        f.band = band;
        rows_.eachCellOfBoth(context_, f);
    });
    // else solids have moved particles since, or others have come in
    sortParticles(&report, !cuts() && !opens());
    rows_.eachCell(context_,
        HoldSurface<D, real>{grid_, particles(), real(clock_.particleVolume/grid_.volume()),
            cuts() ? open_.data() : nullptr, cuts() ? openWeight_.data() : nullptr, carried_.data(),
            band});
    if (cuts()) extendSurface(carried_);
    redistance();
    markWater();
}

//- phi of the carried one, which changes in the rows about the water alone
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::redistance()
{
    const real band = real(bandCells*grid_.h);
    rows_.eachCellOfBoth(
        context_, StartDistance<D, real>{grid_, carried_.data(), phi_.data(), band, spare_.data()});
    for (int pass = 0; pass <= int(bandCells); ++pass)
    {
        rows_.each(context_,
            SpreadDistance<D, real>{grid_, carried_.data(), phi_.data(), spare_.data(), band});
        phi_.swap(spare_);
    }
}

//- Volume under phi [cells]; sums: also with phi a little higher and lower
template<class Backend, int D, class P>
double PicSolver<Backend, D, P>::waterVolume(double* sums)
{
    const auto s = sumOverWater<3>(
        WaterVolume<D, real>{grid_, phi_.data(), cuts() ? open_.data() : nullptr, 0.05*grid_.h});
    for (int k = 0; k < 3; ++k) sums[k] = s[k];
    return s[0];
}

//- The surface moved by what the water under it lacks
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::holdVolume()
{
    constexpr double largestShift = 0.1;        // of a cell, a step
    flying_ = sumOverWater<1>(CountFlying<D, real>{grid_, particles(), near_.data()})[0];
    const double particle = clock_.particleVolume/grid_.volume();
    const double target = (n_ - flying_)*particle + (opens() ? openBalance()/grid_.volume() : 0);
    double sums[3];
    // until the loop over steps ends and asks again
    volume_ = waterVolume(sums);
    const double slope = (sums[2] - sums[1])/(0.1*grid_.h);         // dV/d(-phi)
    if (!(slope > 0) || !(target > 0)) return;
    clock_.drift += (volume_ - target)/target;
    double shift = (volume_ - target)/slope;
    shift = std::max(-largestShift*grid_.h, std::min(shift, largestShift*grid_.h));
    if (std::abs(volume_ - target) < 1e-9*target) return;           // round-off is no loss
    rows_.eachCell(
        context_, ShiftSurface<D, real>{phi_.data(), real(shift), real(bandCells*grid_.h)});
    markWater();
}

//- Velocities stand between the times of positions (leapfrog): half a step behind the first time,
//  then the mean of the steps on either side, so that a step that changes with the flow feeds no
//  energy in or out of waves
template<class Backend, int D, class P> double PicSolver<Backend, D, P>::kick(double dt) const
{
    return clock_.steps ? 0.5*(clock_.lastStep + dt) : 0.5*dt;
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::step(double dt, PicReport& report)
{
    const double before = clock_.steps ? clock_.lastStep : 0;
    if (insideMoves_ && !cutForStep_) cutGrid(clock_.time, dt);
    if (bodies_) cutToWater();
    if (opens()) setOpenFaces(clock_.time);
    if (bodies_) bodies_->predict(dt, before);
    clock_.lastKick = kick(dt);
    project(clock_.lastKick, dt);
    const Vec<D, double> held = watches_ ? particleMomentum() : Vec<D, double>{};
    toParticles(clock_.lastKick);
    if (watches_)
    {
        const Vec<D, double> now = particleMomentum();
        for (int d = 0; d < D; ++d) momentum_.particles[config_.axes[d]] = now[d] - held[d];
    }
    if (bodies_ && bodies_->contactVelocity() < 1) slowBetweenSolids(dt);
    moveParticles(dt);
    if (opens()) letIn(dt);
    if (!moveInside(dt, before))
    {
        stopAtSolids(report,
            bodies_ && !bodies_->finite() ? "has a force of the water that is not a number"
                                          : "was stopped by a guard of its contacts");
        return;
    }
    moveSurface(dt, report);
    holdVolume();
    clock_.time += dt;
    clock_.lastStep = dt;
    ++clock_.steps;
    report.pressureIterations += lastPressure_.iterations;
    report.largestResidual = std::max(report.largestResidual, lastPressure_.finalResidual);
    report.pressureConverged = report.pressureConverged && lastPressure_.converged;
}

} // namespace riprap
