/*  Tensile instability: a square lattice under tension (stretched, p < 0) or compression, its sites
    displaced at random by a little.

    Measured: the rate at which displacements grow while they are small, beside the fastest wave of
    linear theory; and the tension at which the lattice clumps: from displacements of 1e-3 dp, two
    particles come nearer than half their distance within a time of 500 h/c0 (an eighth of a second
    of the paper's dam break). Any tension makes displacements grow; under a small one they end in
    another order, since rearranging raises the density. A square lattice is unstable under
    compression as well, more slowly: it is not the densest.

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
constexpr double period = 500;              // h/c0

void setDeviation(LatticeModel& l, double deviation)
{
    l.deviation = deviation;
    l.stretch = 1/std::sqrt(1 + deviation);
}

//- Displacements from the lattice, without their mean [m]: root mean square
double displacement(const FluidState& s, const FluidInput& lattice, double length)
{
    double sum = 0, mean[2] = {0, 0};
    const std::size_t n = s.id.size();
    std::vector<double> u(2*n);
    for (std::size_t i = 0; i < n; ++i)
        for (int d = 0; d < 2; ++d)
        {
            const double x = s.position[3*i + d] - lattice.position[3*std::size_t(s.id[i]) + d];
            mean[d] += (u[2*i + d] = x - length*std::round(x/length))/n;
        }
    for (std::size_t i = 0; i < n; ++i)
        for (int d = 0; d < 2; ++d) sum += std::pow(u[2*i + d] - mean[d], 2);
    return std::sqrt(sum/n);
}

double nearestPair(const FluidState& s, double length)
{
    double least = 1e30;
    const std::size_t n = s.id.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
            double r2 = 0;
            for (int d = 0; d < 2; ++d)
            {
                const double x = s.position[3*i + d] - s.position[3*j + d],
                             y = x - length*std::round(x/length);
                r2 += y*y;
            }
            least = std::min(least, r2);
        }
    return std::sqrt(least);
}

//- Rate of growth between displacements of 1e-6 and 1e-4 dp, in c0/h; 0 if they do not grow that
//  far within 10 periods
double measuredRate(const LatticeModel& l)
{
    const double unit = l.h()/l.soundSpeed, dt = 0.2*unit;
    PeriodicLattice p = makeLattice(l, sites, "symplectic", dt);
    const FluidInput lattice = p.fluid;
    addPositionNoise(p, 1e-8);
    const auto scene = createSphScene(p.config, p.fluid, WallInput());
    double begin = -1;
    for (int n = 0; n < int(10*period/0.2); n += 5)
    {
        if (!take(*scene, 5)) break;
        const double u = displacement(scene->fluid(), lattice, p.config.domainMax[0])/l.spacing;
        const double t = scene->time()/unit;
        if (begin < 0) { if (u > 1e-6) begin = t; }
        else if (u > 1e-4) return std::log(1e-4/1e-6)/(t - begin);
    }
    return 0;
}

bool holds(const LatticeModel& l)
{
    const double unit = l.h()/l.soundSpeed, dt = 0.25*unit;
    PeriodicLattice p = makeLattice(l, sites, "symplectic", dt);
    addPositionNoise(p, 1e-3);
    const auto scene = createSphScene(p.config, p.fluid, WallInput());
    while (scene->time() < period*unit)
    {
        if (!take(*scene, 50)) return false;
        if (nearestPair(scene->fluid(), p.config.domainMax[0]) < 0.5*l.spacing*l.stretch)
            return false;
    }
    return true;
}

double theoreticalRate(const LatticeModel& l)
{
    return std::max(0.0, reduceMax(l, sites, growthRate).value*l.h()/l.soundSpeed);
}

struct TermSet { const char* name; double antiClump, xsph, diffusion; };

void rates(ResultTable& table, LatticeModel l, const TermSet& terms, bool quick)
{
    for (const double deviation : {-0.05, -0.01, -0.001, 0.01})
    {
        if (quick && deviation != -0.01) continue;
        setDeviation(l, deviation);
        Result r;
        r.test = "tensile";
        r.kernel = l.kernel;
        r.ratio = l.ratio;
        r.integrator = "symplectic";
        r.terms = terms.name;
        char text[64];
        std::snprintf(text, sizeof text, "growth rate h/c0 at rho/rho0 - 1 = %g", deviation);
        r.quantity = text;
        r.theory = theoreticalRate(l);
        r.measured = measuredRate(l);
        table.add(r);
    }
}

void tension(ResultTable& table, LatticeModel l, const TermSet& terms, bool quick)
{
    const double least = -4, most = std::log10(0.3);
    Result r;
    r.test = "tensile";
    r.kernel = l.kernel;
    r.ratio = l.ratio;
    r.integrator = "symplectic";
    r.terms = terms.name;
    const auto held = [&](double logarithm)
    {
        setDeviation(l, -std::pow(10, logarithm));
        return holds(l);
    };
    r.quantity = "1 - rho/rho0 that clumps in 500 h/c0";
    r.measured = std::pow(10, bisect(least, most, quick ? 0.2 : 0.05, held));
    table.add(r);
}

} // namespace

void tensile(ResultTable& table, bool quick)
{
    const std::vector<TermSet> all{{"none", 0, 0, 0}, {"antiClump 0.01", 0.01, 0, 0},
        {"antiClump 0.2", 0.2, 0, 0}, {"densityDiffusion", 0, 0, 0.1}, {"XSPH 0.5", 0, 0.5, 0},
        {"paper", 0.01, 0.5, 0}};
    LatticeModel l;
    l.spacing = 0.01;
    l.soundSpeed = 10;
    l.density = 1000;
    for (const std::string& kernel : kernelWords())
        for (const double ratio : {1.25, 1.5})
            for (const TermSet& terms : all)
            {
                const bool first = ratio == 1.25 && kernel == "wendlandC2";
                if (quick && (!first || &terms > &all[1])) continue;
                if (!first && terms.diffusion + terms.xsph > 0 && terms.antiClump == 0) continue;
                l.kernel = kernel;
                l.ratio = ratio;
                l.antiClump = terms.antiClump;
                l.xsph = terms.xsph;
                l.diffusion = terms.diffusion;
                if (first || terms.antiClump + terms.xsph + terms.diffusion == 0)
                    rates(table, l, terms, quick);
                tension(table, l, terms, quick);
            }
}

} // namespace riprap
