/*  The speed at which particles pass a wall: a block of fluid, or a single particle, is thrown on a
    flat wall with as many layers of points as the kernel's support needs, in short fixed steps
    (symplectic scheme) and in those that riprap chooses (leapfrog, with an artificial viscosity of
    0.02); and with riprap's defaults, with and without the wall's face. Passed is what gets deeper
    than half of the wall's layers: from there on the wall pushes it out at the other side. Of four
    positions relative to the wall's points the worst counts.

    Speeds in units of c0/10, for which the fluid's stiffness is meant. Beside the speed stand the
    density deviation that the block shows just below it, and at the design speed: what a guard may
    let through, and what it need not.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "resultTable.hpp"
#include "thrownBlock.hpp"

#include <algorithm>
#include <cmath>

namespace riprap
{

namespace
{

constexpr double most = 100;                // times c0/10

struct Outcome { double depth = 0, deviation = 0; bool failed = false; };

Outcome thrown(ThrownBlock b, bool shortSteps)
{
    b.timeStep = shortSteps ? 0.1*b.h()/(b.soundSpeed + 3*b.speed) : 0;
    const auto scene = throwBlock(b);
    Outcome o;
    while (scene->time() < b.duration() && o.depth < b.thickness())
    {
        const SphReport r = scene->advance(1e30, 2);
        if (r.stop != StopReason::none) { o.failed = true; break; }
        o.deviation = std::max(o.deviation, r.maxDensityDeviation);

            for (const Vector3& x : r.escaped) if (x[1] < 0) o.depth = 1e30;
        o.depth = std::max(o.depth, depth(*scene, r, b));
    }
    return o;
}

//- The worst over positions along the wall
Outcome worst(ThrownBlock b, bool shortSteps)
{
    Outcome w;
    for (const double offset : {0.0, 0.2, 0.35, 0.5})
    {
        b.offset = offset;
        const Outcome o = thrown(b, shortSteps);
        w.depth = std::max(w.depth, o.depth);
        w.deviation = std::max(w.deviation, o.deviation);
        w.failed = w.failed || o.failed;
    }
    return w;
}

void report(ResultTable& table, ThrownBlock b, bool shortSteps, bool quick)
{
    const double unit = 0.1*b.soundSpeed;
    const auto run = [&](double multiple) { b.speed = multiple*unit; return worst(b, shortSteps); };
    const auto stays = [&](double logarithm)
    {
        const Outcome o = run(std::pow(10, logarithm));
        return !o.failed && o.depth < 0.5*b.thickness();
    };
    const double limit = bisect(-0.5, std::log10(most), quick ? 0.1 : 0.02, stays);
    Result r;
    r.test = "passage";
    r.kernel = b.kernel;
    r.ratio = b.ratio;
    r.integrator = b.integrator;
    r.terms = b.defaults ? "defaults" : shortSteps ? "short steps" : "adaptive steps";
    r.walls = b.walls + (b.wallRatio == 1 ? " dp" : " dp/2")
        + (b.impermeable ? " impermeable" : "");
    const std::string what = b.side == 1 ? "particle: " : "block: ";
    r.quantity = what + "speed that passes / (c0/10)";
    r.measured = std::pow(10, limit);
    const Outcome above = run(1.05*r.measured), below = run(0.95*r.measured);
    r.note = r.measured > 0.99*most
        ? "none passed"
        : (above.failed ? "blew up" : (r.measured < 0.32 ? "or slower" : ""));
    table.add(r);
    r.note = "";
    r.quantity = what + "density deviation just below it";
    r.measured = below.deviation;
    table.add(r);
    if (!shortSteps) return;
    for (const double multiple : {1.0, 2.0, 5.0})
    {
        const Outcome o = run(multiple);
        char text[80];
        std::snprintf(text, sizeof text, "density deviation at %g c0/10", multiple);
        r.quantity = what + text;
        r.measured = o.deviation;
        // water hammer: a wave that stops the fluid, p = rho c v, by Tait's law with gamma 7
        r.theory = std::pow(1 + 7*0.1*multiple, 1.0/7) - 1;
        std::snprintf(text, sizeof text, "deepest %.2f dp below the surface", o.depth/b.spacing);
        r.note = text;
        table.add(r);
    }
}

} // namespace

void passage(ResultTable& table, bool quick)
{
    for (const std::string walls : {"stationary", "extrapolated"})
        for (const double wallRatio : {1.0, 0.5})
            for (const int side : {1, 12})
                for (const bool shortSteps : {true, false})
                {
                    if (quick && (side == 12 || wallRatio == 0.5)) continue;
                    ThrownBlock b;
                    b.walls = walls;
                    b.wallRatio = wallRatio;
                    b.side = side;
                    b.integrator = shortSteps ? "symplectic" : "leapfrog";
                    b.artificial = shortSteps ? 0 : 0.02;
                    report(table, b, shortSteps, quick);
                }
    for (const bool impermeable : {false, true})
        for (const int side : {1, 12})
        {
            if (quick && side == 12) continue;
            ThrownBlock b;
            b.defaults = true;
            b.impermeable = impermeable;
            b.side = side;
            b.integrator = "symplectic";
            b.artificial = 0.02;
            report(table, b, false, quick);
        }
}

} // namespace riprap
