// SPDX-License-Identifier: GPL-3.0-or-later

#include "periodicLattice.hpp"

#include <cmath>
#include <random>

namespace riprap
{

namespace
{

//- The same numbers in every run
double random(std::mt19937& generator) { return 2.0*generator()/4294967295.0 - 1; }

} // namespace

PeriodicLattice makeLattice(
    const LatticeModel& l, int sites, const std::string& integrator, double timeStep)
{
    PeriodicLattice p;
    SphConfig& c = p.config;
    c.device = DeviceKind::cpu;
    c.precision = PrecisionKind::doubled;
    c.spacing = l.spacing;
    c.smoothingRatio = l.ratio;
    c.kernel = l.kernel;
    c.density = l.density;
    c.gamma = l.gamma;
    c.soundSpeed = l.soundSpeed;
    c.maxVelocity = 0.1*l.soundSpeed;
    c.viscosity = l.viscosity*l.density;
    c.viscosityModel = l.viscosity > 0 ? "laminar" : "none";
    if (l.artificial > 0) { c.viscosityModel = "artificial"; c.artificialAlpha = l.artificial; }
    c.antiClump = l.antiClump;
    c.xsph = l.xsph;
    if (l.diffusion > 0) { c.diffusion = "molteni"; c.diffusionDelta = l.diffusion; }
    c.integrator = integrator;
    c.adjustTimeStep = false;
    c.fixedTimeStep = timeStep;
    c.maxDensityDeviation = 0.5;
    c.maxSpeedRatio = 1e6;
    const double d = l.spacing*l.stretch, length = sites*d;
    c.domainMin = {{0, 0, 0}};
    c.domainMax = {{length, length, 1}};
    c.periodic[0] = c.periodic[1] = true;
    for (int j = 0; j < sites; ++j)
        for (int i = 0; i < sites; ++i)
        {
            p.fluid.position.insert(p.fluid.position.end(), {(i + 0.5)*d, (j + 0.5)*d, 0});
            p.fluid.density.push_back(l.density*(1 + l.deviation));
        }
    p.fluid.velocity.assign(p.fluid.position.size(), 0);
    return p;
}

void addDensityWave(PeriodicLattice& p, const Wave& k, double amplitude)
{
    for (std::size_t i = 0; i < p.fluid.size(); ++i)
        p.fluid.density[i] *= 1
            + amplitude
                *std::cos(
                    k[0]*p.fluid.position[3*i] + k[1]*p.fluid.position[3*i + 1] + 0.3);
}

void addDensityNoise(PeriodicLattice& p, double amplitude)
{
    std::mt19937 generator(1);
    for (double& rho : p.fluid.density) rho *= 1 + amplitude*random(generator);
}

void addVelocityNoise(PeriodicLattice& p, double amplitude)
{
    std::mt19937 generator(2);
    for (std::size_t i = 0; i < p.fluid.size(); ++i)
        for (int d = 0; d < 2; ++d)
            p.fluid.velocity[3*i + d] += amplitude*p.config.soundSpeed*random(generator);
}

void addPositionNoise(PeriodicLattice& p, double amplitude)
{
    std::mt19937 generator(3);
    for (std::size_t i = 0; i < p.fluid.size(); ++i)
        for (int d = 0; d < 2; ++d)
            p.fluid.position[3*i + d] += amplitude*p.config.spacing*random(generator);
}

double disturbance(SphScene& scene, const SphConfig& c)
{
    const FluidState s = scene.fluid();
    double sum = 0;
    for (const double v : s.velocity) sum += v*v/(c.soundSpeed*c.soundSpeed);
    for (const double rho : s.density) sum += (rho/c.density - 1)*(rho/c.density - 1);
    return std::sqrt(sum/s.density.size());
}

bool take(SphScene& scene, int steps)
{
    return scene.advance(1e30, steps).stop == StopReason::none;
}

} // namespace riprap
