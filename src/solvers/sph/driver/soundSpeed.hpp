/*  Another speed of sound between two steps, and what speaks for it.

    With c' for c every particle keeps its pressure, d' = d'(p(d)), and so the forces at hand. The
    elastic energy, about p^2/(2 rho c^2) a unit volume, changes; the sum of these changes is kept
    beside the energies, as the work of moving walls is.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "core/loops/reduceMax.hpp"
#include "solvers/sph/driver/fluidPasses.hpp"
#include "solvers/sph/parts/sphReadBack.hpp"

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
class SoundSpeed
{
public:

    using real = typename P::real;
    using Counts = std::array<std::size_t, SphScene::speedClasses>;

    SoundSpeed(SphParts<Backend, D, P>& parts, FluidPasses<Backend, D, P>& fluid)
        : p_(parts), fluid_(fluid)
    {}

    // As SphScene has them
    Counts fasterThan(const std::array<double, SphScene::speedClasses>&);
    void setMaxVelocity(double maxVelocity, double soundSpeed);

private:

    SphParts<Backend, D, P>& p_;
    FluidPasses<Backend, D, P>& fluid_;
};

template<class Backend, int D, class P>
typename SoundSpeed<Backend, D, P>::Counts SoundSpeed<Backend, D, P>::fasterThan(
    const std::array<double, SphScene::speedClasses>& speeds)
{
    CountFaster<D, P, SphScene::speedClasses> count{p_.fluid.fields(), {}};
    for (int k = 0; k < SphScene::speedClasses; ++k) count.speed2[k] = speeds[k]*speeds[k];
    const auto sums = sumOver<SphScene::speedClasses>(
        p_.set.context, p_.fluid.active(), withoutGhosts(count, p_.ghosts()));
    Counts counts;
    for (int k = 0; k < SphScene::speedClasses; ++k) counts[k] = std::size_t(sums[k]);
    return counts;
}

template<class Backend, int D, class P>
void SoundSpeed<Backend, D, P>::setMaxVelocity(double maxVelocity, double soundSpeed)
{
    if (!(maxVelocity > 0 && soundSpeed > 0))
        throw std::invalid_argument("maxVelocity and the speed of sound must be positive");
    const EquationOfState<real> before = p_.set.model.eos;
    const auto elasticEnergy = [&]
    {
        return sumOver<3>(p_.set.context, p_.fluid.active(),
            withoutGhosts(
                EnergySums<D, P>{p_.set.box, p_.set.model, p_.fluid.fields()}, p_.ghosts()))[2];
    };
    const double elastic = elasticEnergy();
    p_.set.setMaxVelocity(maxVelocity, soundSpeed);
    real* deviation = p_.fluid.values.template data<real>(p_.fluid.at.deviation);
    const int n = p_.fluid.active();
    forEach(p_.set.context, n, KeepPressure<real>{before, p_.set.model.eos, deviation});
    p_.stiffening += elasticEnergy() - elastic;
    // the next step begins with the maxima of the last pass
    p_.clock.read();
    p_.clock.now.maxima[1] = float(reduceMax(p_.set.context, n,
        withoutGhosts(SignalSpeed<D, P>{p_.set.model, p_.fluid.fields()}, p_.ghosts())));
    p_.clock.now.maxima[2] = float(reduceMax(
        p_.set.context, n, withoutGhosts(AbsoluteDeviation<real>{deviation}, p_.ghosts())));
    p_.clock.write();
    if (p_.ranks) { p_.ranks->agree(p_.clock, p_.interrupted); p_.clock.read(); }
    fluid_.refreshRecords();
    if constexpr (Backend::gpu) p_.memory.graphs.forget();
}

} // namespace riprap
