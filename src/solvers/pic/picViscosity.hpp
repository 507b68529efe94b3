/*  PicSolver: what viscosity does in a step. The equations: pic/terms/viscosity.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/picSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
bool PicSolver<Backend, D, P>::diffusesImplicitly(double dt) const
{
    // a face close to a solid would limit an explicit step
    if (sticksInside()) return true;
    if (config_.viscousScheme != ViscousKind::automatic)
        return config_.viscousScheme == ViscousKind::implicitly;
    return dt > viscousStep(grid_.h, config_.viscosity/config_.density, D);
}

template<class Backend, int D, class P>
ViscousFaces<D, typename P::real> PicSolver<Backend, D, P>::viscousFaces(int d, bool homogeneous)
{
    return {grid_, d, layer_[d].data(), wallsMove_ ? wallVelocity_[d].data() : nullptr, homogeneous,
        sticksInside() ? faceDistance_[d].data() : nullptr,
        sticksInside() && wallsMove_ ? solidVelocity_[d].data() : nullptr};
}

//- From before_ to u_
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::diffuse(double dt)
{
    if (sticksInside() && wallsMove_) setSolidVelocity();
    const double number = config_.viscosity/config_.density*dt/(grid_.h*grid_.h);
    if (diffusesImplicitly(dt)) { diffuseImplicitly(dt, number); return; }
    const real k = real(number), half = real(0.5);
    rows_.eachFace(context_,
        [&](int d)
        {
            return Diffuse<D, real>{viscousFaces(d), before_[d].data(), before_[d].data(),
                change_[d].data(), real(0), real(1), k};
        });
    rows_.eachFace(context_,
        [&](int d)
        {
            return Diffuse<D, real>{viscousFaces(d), before_[d].data(), change_[d].data(),
                u_[d].data(), half, half, half*k};
        });
}

template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::diffuseImplicitly(double dt, double number)
{
    const real c = real(1 - std::sqrt(0.5)), k = real(c*number);
    for (int d = 0; d < D; ++d)
        for (auto* a : {&viscous_.force[d], &viscous_.source[d], &viscous_.r[d], &viscous_.p[d],
                 &viscous_.q[d]})
            if (a->size() == 0) a->allocate(context_, grid_.faces(d));

    // beyond the surface there is no stress: gravity, which nothing balances there, must not drag
    // the water along
    for (int d = 0; d < D; ++d)
        forEach(context_, grid_.faces(d),
            MarkByWetCells<D, real>{grid_, wet_.data(), aperture_[d].data(),
                sticksInside() ? faceDistance_[d].data() : nullptr, d, layer_[d].data()});

    // what acts beside viscosity, as far as it is known: in a first step nothing
    PressureFields<D, real> f = pressureFields(dt);
    f.p = wholePressure().data();
    if (clock_.steps) pressureStep_.markWet(context_, f);
    if (clock_.steps && insideMoves_)
    {
        if (viscous_.pressure.size() == 0) viscous_.pressure.allocate(context_, grid_.cells());
        PressureOfNewCells<D> fill{grid_, pressureStep_.wet(), f.p, viscous_.pressure.data(), {}};
        for (int d = 0; d < D; ++d) fill.weight[d] = config_.density*gravity_[d]*grid_.h;
        forEach(context_, grid_.cells(), fill);
        f.p = viscous_.pressure.data();
    }
    for (int d = 0; d < D; ++d)
    {
        forEach(context_, grid_.faces(d),
            SetFaces<real>{nullptr, viscous_.force[d].data(),
                clock_.steps ? real(gravity_[d]*dt) : real(0)});
        f.u[d] = viscous_.force[d].data();
        if (clock_.steps)
            forEach(context_, grid_.faces(d), CorrectVelocity<D, real>{f, pressureStep_.wet(), d});
    }
    for (int stage = 1; stage <= 2; ++stage)
    {
        for (int d = 0; d < D; ++d)
            forEach(context_, grid_.faces(d),
                ViscousSource<real>{before_[d].data(), stage == 1 ? nullptr : u_[d].data(),
                    viscous_.force[d].data(), viscous_.source[d].data(), c});
        if (stage == 1)
            for (int d = 0; d < D; ++d)
                forEach(context_, grid_.faces(d),
                    SetFaces<real>{before_[d].data(), u_[d].data(), real(0)});
        solveViscous(k);
    }
    if (sticksInside() && bodies_) dragBodies(dt);
    if (sticksInside() && shearAsked_) keepSheared();
    for (int d = 0; d < D; ++d)
    {
        // the pressure's part off again; gravity's comes with the other forces
        forEach(context_, grid_.faces(d),
            FaceAdd<real>{viscous_.force[d].data(), u_[d].data(), real(-1), false});
    }
    if (sticksInside())
    {
        for (int d = 0; d < D; ++d)
            forEach(
                context_, grid_.faces(d), StickToSolids<D, real>{viscousFaces(d), u_[d].data()});
    }
}

//- (1 - k L) u = source by conjugate gradients, from u_
template<class Backend, int D, class P>
void PicSolver<Backend, D, P>::solveViscous(real k)
{
    constexpr int most = 2000;
    // of the source or the first residual
    const double tolerance = sizeof(real) == 4 ? 1e-6 : 1e-10;
    const auto dot = [&](Array<Backend, real>* a, Array<Backend, real>* b)
    {
        double sum = 0;
        for (int d = 0; d < D; ++d)
            sum += sumOver<1>(context_, grid_.faces(d),
                FaceDot<D, real>{viscousFaces(d), a[d].data(), b[d].data()})[0];
        return sum;
    };
    const auto copies = [&](Array<Backend, real>* a)
    {
        for (int d = 0; d < D; ++d)
            if (grid_.periodic[d])
                forEach(context_, grid_.faces(d), CopyPeriodic<D, real>{grid_, d, a[d].data()});
    };
    for (int d = 0; d < D; ++d)
        forEach(context_, grid_.faces(d),
            ViscousResidual<D, real>{viscousFaces(d), viscous_.source[d].data(), u_[d].data(),
                viscous_.r[d].data(), viscous_.p[d].data(), k});
    double rr = dot(viscous_.r, viscous_.r);
    // from rest walls that slide are all there is
    const double enough = tolerance*tolerance*std::max(dot(viscous_.source, viscous_.source), rr);
    for (int iteration = 0; rr > enough; ++iteration)
    {
        if (iteration == most) { viscousConverged_ = false; break; }
        copies(viscous_.p);
        for (int d = 0; d < D; ++d)
            forEach(context_, grid_.faces(d),
                ViscousProduct<D, real>{
                    viscousFaces(d, true), viscous_.p[d].data(), viscous_.q[d].data(), k});
        const real alpha = real(rr/dot(viscous_.p, viscous_.q));
        for (int d = 0; d < D; ++d)
        {
            forEach(context_, grid_.faces(d),
                FaceAdd<real>{viscous_.p[d].data(), u_[d].data(), alpha, false});
            forEach(context_, grid_.faces(d),
                FaceAdd<real>{viscous_.q[d].data(), viscous_.r[d].data(), -alpha, false});
        }
        const double next = dot(viscous_.r, viscous_.r);
        for (int d = 0; d < D; ++d)
            forEach(context_, grid_.faces(d),
                FaceAdd<real>{viscous_.r[d].data(), viscous_.p[d].data(), real(next/rr), true});
        rr = next;
    }
    copies(u_);
}

} // namespace riprap
