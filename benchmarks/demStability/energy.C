/*  What a step costs in energy where none may be lost.

    Gas: 125 elastic bodies without friction in a periodic box, 30 % of it solid, for some 100
    impacts a body. Speeds are such that an impact sinks in by 1 % of the radius. Largest difference
    of the total energy from its start, over that start; the step is a fraction of sqrt(m/k), of
    Hertz's at the depth of a head-on impact of two bodies at their mean speed. Impacts begin and
    end within a step: there energy is gained or lost, of either sign, so that the total does a
    random walk.

    Restitution: one body hits a floor with a dashpot of e = 0.5; over 40 places within the step at
    which it begins to touch, mean and largest error of e.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "demResults.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <random>

namespace riprap
{

namespace
{

constexpr double speed = 0.01;          // linear: overlap = v sqrt(m*/k)

//- A gas at mean square speed `speed`, and what sqrt(m/k) is
double gas(DemConfig& c, DemInput& in, const std::string& normal)
{
    singleScene(c, in);
    c.normal = normal;
    const int n = 5;
    const double spacing = std::cbrt(4.18879/0.3);
    c.domainMin = Vector3{{0, 0, 0}};
    c.domainMax = Vector3{{n*spacing, n*spacing, n*spacing}};
    for (bool& p : c.periodic) p = true;
    std::mt19937 random(7);
    std::normal_distribution<double> any(0, speed/std::sqrt(3.0));
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)
                addBody(in,
                    Vector3{{(i + 0.5)*spacing, (j + 0.5)*spacing, (k + 0.5)*spacing}},
                    Vector3{{any(random), any(random), any(random)}});
    if (normal != "hertz") return 1;
    // E* such that the tangent stiffness 2 E* sqrt(R* d) is 1 at the depth d of an impact at 2
    // speed: d = (15 m* v^2/(16 E* sqrt(R*)))^(2/5)
    const double reduced = 0.5, radius = 0.5, v = 2*speed;
    double effective = 1;
    for (int k = 0; k < 100; ++k)
    {
        const double depth = std::pow(15*reduced*v*v/(16*effective*std::sqrt(radius)), 0.4);
        effective = 1/(2*std::sqrt(radius*depth));
    }
    in.materials[0].poisson = 0;
    in.materials[0].young = 2*effective;
    PairProperties& p = in.pairs[0].properties;
    p.youngA = p.youngB = in.materials[0].young;
    p.poissonA = p.poissonB = 0;
    return 1;
}

void drift(DemResults& results, const std::string& normal, const char* name)
{
    for (const std::string& integrator : integrators)
        for (const double step : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0})
        {
            DemConfig c;
            DemInput in;
            gas(c, in, normal);
            c.integrator = integrator;
            c.timeStep = step;
            auto scene = createDemScene(c, in);
            const double before = scene->energy().total(), end = 20000;
            double worst = 0;
            for (int part = 1; part <= 100; ++part)
            {
                scene->advance(end*part/100);
                worst = std::max(worst, std::abs(scene->energy().total()/before - 1));
            }
            results.add({"drift", name, integrator,
                "largest change of energy at dt / sqrt(m/k) = " + std::to_string(step).substr(0, 4),
                worst, NAN, ""});
        }
}

void restitution(DemResults& results)
{
    for (const std::string& integrator : integrators)
        for (const double step : {0.02, 0.05, 0.1, 0.2, 0.5})
        {
            double mean = 0, worst = 0;
            const int places = 40;
            for (int k = 0; k < places; ++k)
            {
                DemConfig c;
                DemInput in;
                singleScene(c, in);
                addFloor(in);
                in.pairs[0].properties.restitution = 0.5;
                in.pairs[0].properties.attraction = true;
                c.integrator = integrator;
                c.timeStep = step;
                addBody(in, Vector3{{0, 0, 1 + speed*step*(3 + double(k)/places)}},
                    Vector3{{0, 0, -speed}});
                auto scene = createDemScene(c, in);
                scene->advance(10 + 4*step);
                const double error = scene->particles().velocity[2]/speed/0.5 - 1;
                mean += error/places;
                worst = std::max(worst, std::abs(error));
            }
            const std::string at = " error of e = 0.5 at dt / sqrt(m/k) = "
                + std::to_string(step).substr(0, 4);
            results.add({"restitution", "one body on a floor", integrator, "mean" + at,
                mean, 0, ""});
            results.add({"restitution", "one body on a floor", integrator, "largest" + at,
                worst, 0, ""});
        }
}

} // namespace

void energy(DemResults& results)
{
    drift(results, "linear", "gas, linear");
    drift(results, "hertz", "gas, Hertz");
    restitution(results);
}

} // namespace riprap
