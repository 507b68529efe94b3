/*  What all parts of a scene of fluid refer to: its case, and the model, box and cells that follow
    from it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/launch.hpp"
#include "core/neighbours/cellGrid.hpp"
#include "solvers/sph/sphFamilies.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

//- How far pairs reach, in h
template<class R>
R reachOfH(const SphConfig& c) { return R(kernelOf(c.kernel).support); }

//- What is added to the support: half of it may be travelled by a particle before neighbours are
//  sought anew
template<class Backend, int D>
double skinRatio(const SphConfig& config, int n)
{
    if (config.skin >= 0) return config.skin;
    if (!Backend::gpu) return D == 2 ? 0.2 : 0.15;
    // small scenes are bound by launches, of which a rebuild has many
    if (n <= 24000) return D == 2 || integratorOf(config).passes > 1 ? 0.5 : 0.35;
    return n > 200000 ? 0.07 : (D == 2 ? 0.2 : 0.12);
}

template<class Backend, int D, class P>
class SphSetting
{
public:

    using real = typename P::real;

    SphConfig config;
    Context<Backend> context;
    Box<D, P> box;
    CellGrid<D, P> grid;
    FluidModel<D, P> model;
    StepLimits limits;
    TermParameters<D, real> terms;
    // [m] way of a particle (GPU: against those near it) for which neighbours hold
    real allowedWay = 0;
    double emptyCoordinate = 0; // [m] along the axis that 2D does not solve

    //- For so many particles of fluid
    SphSetting(const SphConfig&, int particles);
    SphSetting(const SphSetting&) = delete;

    //- Do walls take their pressures from the fluid in each step?
    bool wallsFollowFluid() const { return wallModelOf(config).followsFluid; }

    //- Model, limits and terms of another speed of sound
    void setMaxVelocity(double maxVelocity, double soundSpeed);

    //- From a particle to those it must find, whose h and own are at most `h` [m]
    real pairReach(float h) const { return grid.radius - reachOfH<real>(config)*(model.hMax - h); }

    template<class Kernel> KernelConstants<D, real> kernelConstants() const;

    //- Coordinates of n particles, three each
    void toMetres(
        const std::vector<std::int64_t>* x, std::size_t n, std::vector<double>& out) const;

private:

    void setModel();
    void setBox(int particles);
};

template<class Backend, int D, class P>
SphSetting<Backend, D, P>::SphSetting(const SphConfig& c, int particles) : config(c), terms(c)
{
    setModel();
    setBox(particles);
    if (D == 2)
        emptyCoordinate = 0.5
            *(config.domainMin[config.axes[2]] + config.domainMax[config.axes[2]]);
}

template<class Backend, int D, class P>
void SphSetting<Backend, D, P>::setMaxVelocity(double maxVelocity, double soundSpeed)
{
    config.maxVelocity = maxVelocity;
    config.soundSpeed = soundSpeed;
    terms = TermParameters<D, real>(config);
    setModel();
}

template<class Backend, int D, class P>
void SphSetting<Backend, D, P>::setModel()
{
    const SphConfig& c = config;
    model.eos = EquationOfState<real>::make(c, c.soundSpeed, c.density);
    for (int d = 0; d < D; ++d) model.gravity.c[d] = real(c.gravity[c.axes[d]]);
    const double h0 = c.smoothingRatio*c.spacing;
    model.rho0 = real(c.density);
    model.h0 = real(h0);
    model.hMin = real(h0/c.maxSmoothingGrowth);
    model.hMax = real(h0*c.maxSmoothingGrowth);
    model.mass = real(c.density*std::pow(c.spacing, D));
    model.wallMass = real(c.density*std::pow(c.wallSpacing, D));
    model.spacing = real(c.spacing);
    model.variableH = c.variableSmoothing;
    model.drifts = terms.drifts();

    const double nu = terms.viscosity(c);
    limits.adjust = c.adjustTimeStep;
    limits.fixedDt = c.fixedTimeStep;
    limits.maxDt = c.maxTimeStep;
    limits.acoustic = c.acousticCourant;
    limits.force = c.forceCourant;
    limits.h0 = h0;
    limits.leastH = c.variableSmoothing ? h0/c.maxSmoothingGrowth : h0;
    limits.dimensions = D;
    limits.viscousDt = nu > 0 ? c.viscousCourant*h0*h0/nu : 1e30;
    limits.maxDeviation = c.removeWild ? 1e30 : c.maxDensityDeviation;
    limits.maxSpeed = c.removeWild ? 1e30 : c.maxSpeedRatio*c.maxVelocity;
    model.removesWild = c.removeWild;
    model.maxDeviation = real(c.maxDensityDeviation);
    model.maxSpeed2 = real(std::pow(c.maxSpeedRatio*c.maxVelocity, 2));
    // its step would be a twentieth of what sound allows, a hundred times what a density twice as
    // high brings about
    model.maxAcceleration2 = real(std::min(1e36, std::pow(100*c.soundSpeed*c.soundSpeed/h0, 2)));
    limits.growth = 1.1;
}

template<class Backend, int D, class P>
void SphSetting<Backend, D, P>::setBox(int particles)
{
    const SphConfig& c = config;
    const double support = supportOf(c)*(c.variableSmoothing ? c.maxSmoothingGrowth : 1);
    // each row of cells must be its own neighbour at most once: a short period leaves room for a
    // thinner skin only
    double skin = skinRatio<Backend, D>(config, particles)*support;
    for (int d = 0; d < D; ++d)
    {
        const double period = c.domainMax[c.axes[d]] - c.domainMin[c.axes[d]], least = 1.05*support;
        if (!c.periodic[c.axes[d]] || period >= 3*(support + skin)) continue;
        if (period < 3*least)
            throw std::invalid_argument("the periodic domain is " + std::to_string(period)
                + " m long; it must be at least three search radii, " + std::to_string(3*least)
                + " m");
        skin = period*(1 - 1e-9)/3 - support;       // so that rounding does not cost a row
    }
    const double radius = support + skin;
    // on the CPU a hair less, for rounding
    allowedWay = real(Backend::gpu ? 0.5*skin : 0.4995*skin);
    for (int d = 0; d < D; ++d)
    {
        const int axis = c.axes[d];
        const double lo = c.domainMin[axis], hi = c.domainMax[axis];
        if (c.periodic[axis])
        {
            box.set(d, lo, hi - lo, true);
            model.domainMin[d] = -1e300;
            model.domainMax[d] = 1e300;
        }
        else
        {
            // a margin of two radii: fixed-point differences across it are never mistaken for near
            // ones
            box.set(d, lo - radius, hi - lo + 2*radius, false);
            model.domainMin[d] = radius*(1 - 1e-9) + c.escapeInset;
            model.domainMax[d] = radius + (hi - lo)*(1 + 1e-9) - c.escapeInset;
        }
    }
    const int reach = Backend::gpu ? 2 : 1;
    const double volume = [&]
    {
        double v = 1;
        for (int d = 0; d < D; ++d) v *= box.length[d];
        return v;
    }();
    const double cells = std::max(1e3, std::min(4e8, 2*volume/std::pow(c.spacing, D)));
    grid.set(box, radius, reach, Backend::gpu ? 4 : 6, cells);
}

template<class Backend, int D, class P>
template<class Kernel>
KernelConstants<D, typename P::real> SphSetting<Backend, D, P>::kernelConstants() const
{
    return KernelConstants<D, real>::template make<Kernel>(
        config.smoothingRatio*config.spacing, config.spacing);
}

template<class Backend, int D, class P>
void SphSetting<Backend, D, P>::toMetres(
    const std::vector<std::int64_t>* x, std::size_t n, std::vector<double>& out) const
{
    out.assign(3*n, emptyCoordinate);
    for (int d = 0; d < D; ++d)
        #pragma omp parallel for schedule(static) if (n > 10000)
        for (std::size_t i = 0; i < n; ++i) out[3*i + config.axes[d]] = box.toMetres(d, x[d][i]);
}

} // namespace riprap
