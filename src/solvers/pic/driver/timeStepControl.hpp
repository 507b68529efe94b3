/*  How long the next step may be, and what says so.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/driver/particleAdvection.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class TimeStepControl
{
public:

    using real = typename P::real;

    TimeStepControl(PicParts<Backend, D, P>& parts, ParticleAdvection<Backend, D, P>& advection)
    :
        p_(parts), advection_(advection)
    {}

    //- speed: of the fastest particle that limits it. limit: what does
    double step(double speed, std::string& limit) const;
    double estimate(std::string& limit);

private:

    PicParts<Backend, D, P>& p_;
    ParticleAdvection<Backend, D, P>& advection_;
};

template<class Backend, int D, class P>
double TimeStepControl<Backend, D, P>::step(double speed, std::string& limit) const
{
    const UniformGrid<D>& grid = p_.set.grid;
    const PicConfig& config = p_.set.config;
    if (p_.set.clock.initial == 0) { limit = "solids"; return p_.inside.scene->plan().timeStep; }
    if (!config.adjustTimeStep) { limit = "fixed"; return config.fixedTimeStep; }
    double g2 = 0, slide = 0;               // a wall that slides will carry particles along
    for (int d = 0; d < D; ++d) g2 += p_.set.gravity[d]*p_.set.gravity[d];
    for (const auto& axis : p_.set.whole().slide)
        for (const auto& side : axis)
            for (const double v : side) slide = std::max(slide, std::abs(v));
    speed = std::max(slide, speed);
    if (p_.opens()) speed = std::max(speed, p_.openings.speed(p_.set.clock.time));
    double dt = courantStep(config.maxCourant, grid.h, speed, std::sqrt(g2));
    limit = "Courant";
    const double waves = waveStep(grid.h, std::sqrt(g2));
    if (waves < dt) { dt = waves; limit = "waves"; }
    if (p_.solids.bodies)
    {
        const double solid = courantStep(
            config.maxCourant, grid.h, p_.solids.bodies->table.fastest(), std::sqrt(g2));
        if (solid < dt) { dt = solid; limit = "solids"; }
    }
    const double viscous = viscousStep(grid.h, config.viscosity/config.density, D);
    if (viscous < dt && viscousSchemeOf(config.viscousScheme).limitsStep)
    {
        dt = viscous;
        limit = "viscous";
    }
    if (p_.particles.scheme.longestStep() < dt)
    {
        dt = p_.particles.scheme.longestStep();
        limit = "transfer";
    }
    if (config.maxTimeStep < dt) { dt = config.maxTimeStep; limit = "maximum"; }
    return dt;
}

template<class Backend, int D, class P>
double TimeStepControl<Backend, D, P>::estimate(std::string& limit)
{
    return step(p_.set.clock.initial && p_.set.config.adjustTimeStep
            ? advection_.fastestCarried(advection_.fastest())
            : 0,
        limit);
}

} // namespace riprap
