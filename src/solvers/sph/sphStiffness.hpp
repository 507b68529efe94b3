/*  SphSolver: another speed of sound between two steps, and what speaks for it.

    With c' for c every particle keeps its pressure, d' = d'(p(d)), and so the forces at hand. The
    elastic energy, about p^2/(2 rho c^2) a unit volume, changes; the sum of these changes is kept
    beside the energies, as the work of moving walls is.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/reduceMax.hpp"
#include "solvers/sph/sphReadBack.hpp"
#include "solvers/sph/sphSolver.hpp"

namespace riprap
{

//- Particles faster than each of some speeds
template<int D, class P, int N>
struct CountFaster
{
    static constexpr const char* name = "countFaster";
    FluidFields<D, P> fluid;
    double speed2[N];

    HD void add(int i, double* sums) const
    {
        double v2 = 0;
        for (int d = 0; d < D; ++d) v2 += double(fluid.v[d][i])*fluid.v[d][i];
        for (int k = 0; k < N; ++k) sums[k] += v2 > speed2[k] ? 1 : 0;
    }
};

//- Densities that give the pressures of before
template<class R>
struct KeepPressure
{
    static constexpr const char* name = "keepPressure";
    EquationOfState<R> before, now;
    R* deviation;

    HD void operator()(int i) const { deviation[i] = now.deviation(before.pressure(deviation[i])); }
};

//- c + |v|, as FluidPass reports it
template<int D, class P>
struct SignalSpeed
{
    using real = typename P::real;
    static constexpr const char* name = "signalSpeed";
    FluidModel<D, P> model;
    FluidFields<D, P> fluid;

    HD double value(int i) const
    {
        real v2 = 0;
        for (int d = 0; d < D; ++d) v2 += fluid.v[d][i]*fluid.v[d][i];
        return double(model.eos.soundSpeed(fluid.deviation[i]) + squareRoot(v2));
    }
};

template<class R>
struct AbsoluteDeviation
{
    static constexpr const char* name = "absoluteDeviation";
    const R* deviation;

    HD double value(int i) const { return double(absolute(deviation[i])); }
};

template<class Backend, int D, class P>
std::array<std::size_t, SphScene::speedClasses> SphSolver<Backend, D, P>::fasterThan(
    const std::array<double, SphScene::speedClasses>& speeds)
{
    CountFaster<D, P, SphScene::speedClasses> count{fluidFields(), {}};
    for (int k = 0; k < SphScene::speedClasses; ++k) count.speed2[k] = speeds[k]*speeds[k];
    const auto sums = sumOver<SphScene::speedClasses>(
        context_, activeFluid(), withoutGhosts(count, ghosts()));
    std::array<std::size_t, SphScene::speedClasses> counts;
    for (int k = 0; k < SphScene::speedClasses; ++k) counts[k] = std::size_t(sums[k]);
    return counts;
}

template<class Backend, int D, class P>
void SphSolver<Backend, D, P>::setMaxVelocity(double maxVelocity, double soundSpeed)
{
    if (!(maxVelocity > 0 && soundSpeed > 0))
        throw std::invalid_argument("maxVelocity and the speed of sound must be positive");
    const EquationOfState<real> before = model_.eos;
    const auto elasticEnergy = [&]
    {
        return sumOver<3>(context_, activeFluid(),
            withoutGhosts(EnergySums<D, P>{box_, model_, fluidFields()}, ghosts()))[2];
    };
    const double elastic = elasticEnergy();
    config_.maxVelocity = maxVelocity;
    config_.soundSpeed = soundSpeed;
    terms_ = TermParameters<D, real>(config_);
    setModel();
    real* deviation = fluid_.template data<real>(deviationField_);
    const int n = activeFluid();
    forEach(context_, n, KeepPressure<real>{before, model_.eos, deviation});
    stiffening_ += elasticEnergy() - elastic;
    // the next step begins with the maxima of the last pass
    readClock();
    host_.maxima[1] = float(
        reduceMax(context_, n, withoutGhosts(SignalSpeed<D, P>{model_, fluidFields()}, ghosts())));
    host_.maxima[2] = float(
        reduceMax(context_, n, withoutGhosts(AbsoluteDeviation<real>{deviation}, ghosts())));
    writeClock();
    if (ranks_) { ranks_->agree(*clock_.data(), interrupted_); readClock(); }
    refreshRecords();
    if constexpr (Backend::gpu) parts_.graphs.recorded = false;
}

} // namespace riprap
