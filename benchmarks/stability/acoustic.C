/*  The largest time step for sound: a density wave, or noise of all waves, in a periodic box at
    rest.

    Theory: omega dt < 2 for the symplectic scheme; the leapfrog with predicted velocity and density
    grows by (omega dt)^4/4 a step whatever the step is, unless something damps. omega is that of
    the fastest wave of the lattice.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "periodicLattice.hpp"
#include "resultTable.hpp"

#include <algorithm>
#include <cmath>

namespace riprap
{

namespace
{

constexpr int sites = 16;
constexpr double amplitude = 1e-6;
constexpr double tolerated = 1e-3;          // growth a step: e-fold in a thousand

//- Growth of a wave's amplitude a step, from means over two windows of the run
double measuredGrowth(
    const LatticeModel& l, const std::string& integrator, const Wave& k, double dt, int steps)
{
    PeriodicLattice p = makeLattice(l, sites, integrator, dt);
    addDensityWave(p, k, amplitude);
    const auto scene = createSphScene(p.config, p.fluid, WallInput());
    constexpr int window = 40;
    double early = 0, late = 0;
    take(*scene, 20);
    for (int n = 0; n < window; ++n)
    {
        take(*scene, 1);
        early += std::log(disturbance(*scene, p.config));
    }
    if (!take(*scene, steps - window)) return NAN;
    for (int n = 0; n < window; ++n)
    {
        take(*scene, 1);
        late += std::log(disturbance(*scene, p.config));
    }
    return std::expm1((late - early)/(window*double(steps)));
}

//- Does noise of all waves stay? Its growth between the middle and the end of the run tells, a step
bool staysQuiet(
    const LatticeModel& l, const std::string& integrator, double dt, int steps, double growth)
{
    PeriodicLattice p = makeLattice(l, sites, integrator, dt);
    addDensityNoise(p, amplitude);
    const auto scene = createSphScene(p.config, p.fluid, WallInput());
    if (!take(*scene, steps/2)) return false;
    double middle = 0, end = 0;
    for (int n = 0; n < 40; ++n) { take(*scene, 1); middle += disturbance(*scene, p.config); }
    if (!take(*scene, steps/2)) return false;
    for (int n = 0; n < 40; ++n) { take(*scene, 1); end += disturbance(*scene, p.config); }
    const int halfway = steps/2 + 40;
    // a NaN is not quiet
    return end < middle*std::exp(growth*halfway) && end < 40*1e4*amplitude;
}

//- Growth a step of the wave that grows fastest, by theory
double theoreticalGrowth(const LatticeModel& l, const std::string& integrator, double dt)
{
    return reduceMax(l, sites,
        [&](const LatticeModel& m, const Wave& k)
        {
            const double w = soundFrequency(m, k)*dt, d = diffusionRate(m, k)*dt,
                         a = 0.5*artificialRate(m, k)*dt;
            if (integrator == "symplectic") return symplecticGrowth(w, d, a);
            // v' = -a v - w r, r' = w v - d r
            const std::complex<double> root = std::sqrt(
                std::complex<double>((a - d)*(a - d) - 4*w*w));
            return std::max(
                leapfrogGrowth(0.5*(-a - d + root)), leapfrogGrowth(0.5*(-a - d - root)));
        })
        .value;
}

void limits(ResultTable& table, const LatticeModel& l, const std::string& integrator, bool quick)
{
    const bool symplectic = integrator == "symplectic";
    const Largest fastest = reduceMax(l, sites, soundFrequency);
    const double unit = 1/fastest.value, courant = l.soundSpeed*unit/l.h();
    // round-off of theory; a criterion that a finite run can see
    const bool damped = l.diffusion + l.artificial > 0;
    const double growth = symplectic || damped ? 1e-7 : tolerated, seen = std::max(growth, 2e-5);
    const int steps = damped ? 2000 : 800;
    const double tolerance = quick ? 0.02 : 0.004;
    const double theory = bisect(0.01, 3, 1e-4,
        [&](double z) { return theoreticalGrowth(l, integrator, z*unit) < growth; });
    double measured;
    if (!symplectic && !damped)
    {
        const Wave k = waveOf(l, sites, fastest.m, fastest.n);
        measured = bisect(0.1, 1, tolerance,
            [&](double z) { return measuredGrowth(l, integrator, k, z*unit, 600) < tolerated; });
    }
    else
        measured = bisect(0.1, 3, tolerance,
            [&](double z) { return staysQuiet(l, integrator, z*unit, steps, seen); });
    Result r;
    r.test = "acoustic";
    r.kernel = l.kernel;
    r.ratio = l.ratio;
    r.integrator = integrator;
    r.terms = l.diffusion > 0 ? "densityDiffusion"
                              : (l.artificial > 0 ? "artificial 0.02" : "none");
    r.note = l.artificial > 0 ? "theory: damping half of the time"
                              : (symplectic || damped ? "" : "growth of 1e-3 a step");
    r.quantity = "largest omega dt";
    r.measured = measured;
    r.theory = theory;
    table.add(r);
    r.quantity = "largest c0 dt/h";
    r.measured *= courant;
    r.theory *= courant;
    table.add(r);
}

void growths(ResultTable& table, const LatticeModel& l, bool quick)
{
    const Largest fastest = reduceMax(l, sites, soundFrequency);
    const Wave k = waveOf(l, sites, fastest.m, fastest.n);
    for (const double z : {0.2, 0.3, 0.4, 0.5, 0.6})
    {
        if (quick && z != 0.4) continue;
        Result r;
        r.test = "acoustic";
        r.kernel = l.kernel;
        r.ratio = l.ratio;
        r.integrator = "leapfrog";
        r.terms = "none";
        r.theory = leapfrogGrowth({0, z});
        const int steps = int(std::min(4000.0, 5/r.theory));
        r.measured = measuredGrowth(l, "leapfrog", k, z/fastest.value, steps);
        char text[64];
        std::snprintf(text, sizeof text, "growth a step at omega dt = %.1f", z);
        r.quantity = text;
        std::snprintf(text, sizeof text, "(omega dt)^4/4 = %.3g", std::pow(z, 4)/4);
        r.note = text;
        table.add(r);
    }
}

} // namespace

void acoustic(ResultTable& table, bool quick)
{
    LatticeModel l;
    l.spacing = 0.01;
    l.soundSpeed = 10;
    l.density = 1000;
    for (const std::string& kernel : kernelWords())
        for (const double ratio : {1.25, 1.5})
        {
            if (quick && (ratio != 1.25 || kernel != "wendlandC2")) continue;
            l.kernel = kernel;
            l.ratio = ratio;
            for (const int damping : {0, 1, 2})
            {
                l.diffusion = damping == 1 ? 0.1 : 0;
                l.artificial = damping == 2 ? 0.02 : 0;
                for (const std::string i : {"leapfrog", "symplectic"})
                    limits(table, l, i, quick);
            }
            l.artificial = 0;
            if (ratio == 1.25) growths(table, l, quick);
        }
}

} // namespace riprap
