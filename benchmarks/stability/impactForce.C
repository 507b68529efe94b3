/*  The largest time step for forces: a block of fluid is thrown on a flat wall. A step is too long
    when a guard would see NaN or the energy (kinetic and elastic) exceeds what the block brought by
    more than a tenth of it, beyond what it does with short steps.

    Reported in three units: h/c0, h/(c0 + v) (acoustic limit) and sqrt(h/a), a the largest
    acceleration of a run with short steps (force limit). Theory, for comparison: the acoustic limit
    of the fluid at rest, omega dt = 2. Where the measured step in units of h/(c0 + v) falls below
    it, it is the force (and the compression, which raises the speed of sound) that binds.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "latticeModes.hpp"
#include "resultTable.hpp"
#include "thrownBlock.hpp"

#include <algorithm>
#include <cmath>

namespace riprap
{

namespace
{

//- Largest energy of the run over that at its start; huge when it failed
double largestEnergy(ThrownBlock b, double dt)
{
    b.timeStep = dt;
    const auto scene = throwBlock(b);
    const double start = scene->energy().kinetic;
    double largest = 0;
    while (scene->time() < b.duration())
    {
        const SphReport r = scene->advance(1e30, std::max(1, int(0.2*b.h()/b.soundSpeed/dt)));
        const SphEnergy e = scene->energy();
        const double total = (e.kinetic + e.elastic)/start;
        if (r.stop != StopReason::none || !(total < 1e6)) return 1e6;
        largest = std::max(largest, total);
    }
    return largest;
}

//- Shortest sqrt(h/a) of a run with short steps
double shortestForceTime(ThrownBlock b)
{
    b.timeStep = 0;
    b.forceLimit = true;
    const double dt = 0.05*b.h()/(b.soundSpeed + b.speed);
    const auto scene = throwBlock(b);
    double shortest = 1e30;
    std::string limit;
    while (scene->time() < b.duration())
    {
        if (scene->advance(scene->time() + dt).stop != StopReason::none) return NAN;
        shortest = std::min(shortest, scene->estimateTimeStep(limit));
    }
    return shortest;
}

void report(ResultTable& table, const ThrownBlock& b, bool quick)
{
    const double acoustic = b.h()/(b.soundSpeed + b.speed), mach = b.speed/b.soundSpeed;
    const double bound = largestEnergy(b, 0.05*acoustic) + 0.1;
    const double dt = acoustic
        *bisect(0.1, 4, quick ? 0.1 : 0.02,
            [&](double c) { return largestEnergy(b, c*acoustic) < bound; });
    LatticeModel l;
    l.ratio = b.ratio;
    Result r;
    r.test = "force";
    r.kernel = b.kernel;
    r.ratio = b.ratio;
    r.integrator = b.integrator;
    r.terms = b.artificial > 0 ? "artificial 0.1" : "none";
    r.walls = b.walls;
    char text[80];
    std::snprintf(text, sizeof text, "largest dt (c0 + v)/h; impact at %.1f c0", mach);
    r.quantity = text;
    r.measured = dt/acoustic;
    r.theory = 2/(reduceMax(l, 16, soundFrequency).value*l.h());
    std::snprintf(text, sizeof text, "theory: acoustic; energy %.2f with short steps", bound - 0.1);
    r.note = text;
    table.add(r);
    std::snprintf(text, sizeof text, "largest dt/sqrt(h/a); impact at %.1f c0", mach);
    r.quantity = text;
    r.measured = dt/shortestForceTime(b);
    r.theory = NAN;
    r.note = "";
    table.add(r);
}

} // namespace

void impactForce(ResultTable& table, bool quick)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
        for (const std::string walls : {"stationary", "extrapolated"})
            for (const double mach : {0.1, 0.3, 0.5})
                for (const double alpha : {0.0, 0.1})
                {
                    if (quick
                        && (mach != 0.3 || alpha > 0 || integrator == "leapfrog"))
                        continue;
                    ThrownBlock b;
                    b.integrator = integrator;
                    b.walls = walls;
                    b.artificial = alpha;
                    b.speed = mach*b.soundSpeed;
                    report(table, b, quick);
                }
}

} // namespace riprap
