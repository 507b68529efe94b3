/*  What laws cannot do, whatever the step.

    Creep: a body on a slope of 10 degrees on the one-step spring of paper 2, Eq. 8, which holds k_t
    V_s dt and nothing more: m g sin/(k_t dt). Paper 2's stiffness k = m g/(theta dx): a body of
    speed v sinks into a wall by v sqrt(theta dx/g), so that the gap of 2 dx at which contact begins
    is used up at v = 2 dx/sqrt(theta dx/g) (two equal bodies: sqrt(2) times that). With alpha the
    dashpot holds it longer. Local damping (paper 1, Eq. 25) in free flight: a body falls at (1 -
    alpha) g and rises against (1 + alpha) g.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "demResults.hpp"
#include "scenes.hpp"

#include <algorithm>

namespace riprap
{

namespace
{

constexpr double gravity = 1e-3;

void creep(DemResults& results)
{
    const double slope = 10*3.14159265358979323846/180;
    for (const double step : {0.01, 0.02, 0.05, 0.1, 0.2})
    {
        DemConfig c;
        DemInput in;
        singleScene(c, in);
        addFloor(in);
        c.tangential = "oneStep";
        c.gravity = Vector3{{gravity*std::sin(slope), 0, -gravity*std::cos(slope)}};
        c.timeStep = step;
        PairProperties& p = in.pairs[0].properties;
        p.friction = 0.5;
        p.stiffnessRatio = 0.4;
        p.tangentialDamping = false;
        in.groups.resize(1);
        in.groups[0].heldSpin = true;
        addBody(in, Vector3{{0, 0, 1 - gravity*std::cos(slope)}});
        auto scene = createDemScene(c, in);
        const double settled = 10/(0.4*step);           // it is approached within m/(k_t dt)
        scene->advance(settled);
        results.add({"creep", "one-step spring, 10 degrees", "leapfrog",
            "speed / (g sqrt(m/k)) at dt / sqrt(m/k) = " + std::to_string(step).substr(0, 4),
            scene->particles().velocity[0]/gravity, std::sin(slope)/(0.4*step),
            "history spring: 0"});
    }
}

//- Nearest approach of the surfaces / gap of 2 dx; negative: they have met
double gapLeft(double v, bool pair, double alpha)
{
    const double dx = 0.1, theta = 0.01;
    DemConfig c;
    DemInput in;
    singleScene(c, in);
    c.normal = "cellSpring";
    c.stepFraction = 0.01;
    c.gravity = Vector3{{0, 0, 0}};
    PairProperties& p = in.pairs[0].properties;
    p.theta = theta;
    p.alpha = alpha;
    p.cellSize = dx;
    p.gravity = gravity;
    p.gap = 2*dx;
    c.timeStep = 0.01*std::sqrt(theta*dx/gravity);
    addBody(in, Vector3{{0, 0, 1 + 2*dx + 1e-9}}, Vector3{{0, 0, -v}});
    if (pair) addBody(in, Vector3{{0, 0, -1}});
    else addFloor(in);
    auto scene = createDemScene(c, in);
    double least = 1;
    for (int k = 0; k < 400; ++k)
    {
        scene->advance(1e9, 1);
        const DemState s = scene->particles();
        const double gap = pair ? std::abs(s.position[2] - s.position[5]) - 2 : s.position[2] - 1;
        least = std::min(least, gap/(2*dx));
        if (least < 0) break;
    }
    return least;
}

void cellSpring(DemResults& results)
{
    const double dx = 0.1, theory = 2*dx/std::sqrt(0.01*dx/gravity);
    for (const double alpha : {0.0, 0.5})
        for (const bool pair : {false, true})
            results.add({"cellSpring",
                std::string(pair ? "two bodies" : "body and wall")
                    + (alpha > 0 ? ", alpha 0.5" : ""),
                "leapfrog", "speed that uses up the gap / (2 dx/sqrt(theta dx/g))",
                bisect(
                    0.2, 10, 1e-3, [&](double v) { return gapLeft(v*theory, pair, alpha) >= 0; }),
                alpha > 0 ? NAN : (pair ? std::sqrt(2.0) : 1), ""});
    for (const bool pair : {false, true})
        for (const double v : {0.2, 0.4, 0.6, 0.8, 0.95})
            results.add({"gapLeft", pair ? "two bodies" : "body and wall", "leapfrog",
                "gap left / (2 dx) at v / (2 dx/sqrt(theta dx/g)) = "
                    + std::to_string(v).substr(0, 4),
                gapLeft(v*theory, pair, 0), 1 - v/(pair ? std::sqrt(2.0) : 1), ""});
}

void localDamping(DemResults& results)
{
    for (const double alpha : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9})
        for (const bool up : {false, true})
        {
            DemConfig c;
            DemInput in;
            singleScene(c, in);
            c.gravity = Vector3{{0, 0, -gravity}};
            c.timeStep = 0.1;
            in.groups.resize(1);
            in.groups[0].localDamping = alpha;
            const double v0 = up ? 0.2 : 0, t = 50;
            addBody(in, Vector3{{0, 0, 0}}, Vector3{{0, 0, v0}});
            auto scene = createDemScene(c, in);
            scene->advance(t);
            results.add({"localDamping", up ? "rising" : "falling", "leapfrog",
                "acceleration / g, alpha = " + std::to_string(alpha).substr(0, 3),
                (v0 - scene->particles().velocity[2])/(gravity*t), up ? 1 + alpha : 1 - alpha,
                "without damping: 1"});
        }
}

} // namespace

void laws(DemResults& results)
{
    creep(results);
    cellSpring(results);
    localDamping(results);
}

} // namespace riprap
