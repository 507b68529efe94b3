/*  At which noise, speed and step the rule of wild particles takes the first one out (|rho/rho0 -
    1| > 0.5, |v| > 5 maxVelocity, |a| > 100 c0^2/h0),
    with riprap's default terms and steps.

    Noise: a periodic square lattice whose densities, velocity components or coordinates are changed
    at random by up to an amplitude, for 100 h/c0. Coordinates are of a lattice compressed by 1 %,
    the largest that maxVelocity is meant for: without pressure they push nobody. Theory: the
    amplitude at which the noise is beyond the limit by itself.
    Block: thrown on a flat impermeable wall, for the speed (theory: where the block itself is too
    fast), and at the design speed c0/10 for the Courant number (theory: sound, with density
    diffusion).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "periodicLattice.hpp"
#include "resultTable.hpp"
#include "thrownBlock.hpp"

#include <cmath>

namespace riprap
{

namespace
{

constexpr double speedLimit = 5, deviationLimit = 0.5;

using AddNoise = void (*)(PeriodicLattice&, double);

bool noisyLatticeKeepsAll(AddNoise add, double amplitude, double alpha, double deviation)
{
    LatticeModel l;
    l.deviation = deviation;
    l.stretch = 1/std::sqrt(1 + deviation);
    PeriodicLattice p = makeLattice(l, 16, "symplectic", 0);
    SphConfig& c = p.config;
    setDefaults(c, alpha);
    setWildRule(c);
    add(p, amplitude);
    const double length = c.domainMax[0];
    for (double& x : p.fluid.position) x -= length*std::floor(x/length);
    const auto scene = createSphScene(c, p.fluid, WallInput());
    const double end = 100*l.h()/l.soundSpeed;
    while (scene->time() < end)
    {
        const SphReport r = scene->advance(end, 50);
        if (!r.wild.empty() || r.stop != StopReason::none) return false;
    }
    return true;
}

bool blockKeepsAll(ThrownBlock b)
{
    b.defaults = b.impermeable = b.wildRule = true;
    b.artificial = 0.02;
    b.integrator = "symplectic";
    for (const double offset : {0.0, 0.2, 0.35, 0.5})
    {
        b.offset = offset;
        const auto scene = throwBlock(b);
        while (scene->time() < b.duration())
        {
            const SphReport r = scene->advance(b.duration(), 50);
            if (!r.wild.empty() || r.stop != StopReason::none) return false;
        }
    }
    return true;
}

Result row(double alpha, const char* walls)
{
    Result r;
    r.test = "wild";
    r.kernel = "wendlandC2";
    r.ratio = 1.25;
    r.integrator = "symplectic";
    char text[40];
    std::snprintf(text, sizeof text, "defaults alpha %g", alpha);
    r.terms = text;
    r.walls = walls;
    return r;
}

void reportNoise(ResultTable& table, double alpha, bool quick)
{
    const struct { const char* quantity; AddNoise add; double deviation, most, theory;
    } kinds[] = {
        {"noise of density that takes out [rho0]", addDensityNoise, 0, 0.6, deviationLimit},
        {"noise of velocity that takes out [c0]", addVelocityNoise, 0, 0.6,
            0.1*speedLimit/std::sqrt(2.0)},
        {"noise of coordinates that takes out [dp]", addPositionNoise, 0.01, 1, NAN},
    };
    for (const auto& k : kinds)
    {
        Result r = row(alpha, "none");
        r.quantity = k.quantity;
        r.measured = bisect(0.02, k.most, quick ? 0.05 : 0.01,
            [&](double a) { return noisyLatticeKeepsAll(k.add, a, alpha, k.deviation); });
        r.theory = k.theory;
        r.note = r.measured == k.most ? "none taken out" : "";
        table.add(r);
    }
}

} // namespace

void wildRule(ResultTable& table, bool quick)
{
    for (const double alpha : {0.0, 0.02, 0.05})
        if (!quick || alpha == 0.02) reportNoise(table, alpha, quick);
    Result r = row(0.02, "extrapolated dp impermeable");
    r.quantity = "block: speed that takes out / (c0/10)";
    const auto at = [](double speed, double courant)
    {
        ThrownBlock b;
        b.speed = speed*0.1*b.soundSpeed;
        b.courant = courant;
        return blockKeepsAll(b);
    };
    r.measured = bisect(0.5, 6, quick ? 0.2 : 0.05, [&](double speed) { return at(speed, 0.5); });
    r.theory = speedLimit;
    table.add(r);
    r.quantity = "block at c0/10: acousticCourant that takes out";
    const double most = 2;
    r.measured = bisect(
        0.3, most, quick ? 0.1 : 0.02, [&](double courant) { return at(1, courant); });
    r.theory = 1.6;
    r.note = r.measured == most ? "none taken out" : "theory: sound, with density diffusion";
    table.add(r);
}

} // namespace riprap
