/*  The largest step of undamped springs, in units of sqrt(m/k), for both integrators.

    Bodies rest on each other in a periodic lattice (or are bonded) and get velocities of 1e-9 of an
    overlap a sqrt(m/k). The kinetic energy of a stable scene stays of that size; it is unstable
    when it has grown 1e6-fold within 3000 steps. Theory: 2/w of the lattice's fastest mode
    (normalModes.hpp). With dashpots, whose forces are taken at the half step: one body on a floor,
    x^2 + 4 zeta x/(1 + zeta x/2) = 4, x = dt sqrt(k/m); packings, dem/passes/packingLimit.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "demResults.hpp"
#include "normalModes.hpp"

#include "dem/contact/normal/linearSpring.hpp"
#include "dem/passes/packingLimit.hpp"

#include <random>

namespace riprap
{

namespace
{

constexpr double kick = 1e-12, growth = 1e6;
constexpr int steps = 3000;

bool stable(DemConfig c, DemInput in, const std::string& integrator, double step, bool alongXOnly)
{
    c.integrator = integrator;
    c.timeStep = step;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-kick, kick);
    DemParticles& p = in.particles;
    for (std::size_t i = 0; i < p.size(); ++i)
        for (int d = 0; d < (alongXOnly ? 1 : c.dimensions); ++d)
            p.velocity[3*i + d] += any(random);
    auto scene = createDemScene(c, in);
    const auto kinetic = [&]
    {
        const DemEnergy e = scene->energy();
        return e.translation + e.rotation;
    };
    const double before = kinetic();
    for (int part = 0; part < 10; ++part)
    {
        if (scene->advance(1e9, steps/10).stop != DemStop::none) return false;
        if (!(kinetic() < growth*before)) return false;
    }
    return true;
}

void lattice(DemResults& results, const char* name, const LatticeOptions& o)
{
    DemConfig c;
    DemInput in;
    latticeScene(o, c, in);
    Springs k;
    k.shear = o.tangential || o.bonded ? o.stiffnessRatio : 0;
    if (o.bonded)
    {
        // radius 1: I/A = 1/3 (plate), 1/4 (round), J = 2 I
        k.bending = c.dimensions == 2 ? 1/3.0 : 0.25;
        k.twist = 0.5*o.stiffnessRatio;
    }
    double theory = 2
        /fastestMode(latticePoints(o.lattice, o.bonded ? 0 : o.overlap), c.periodic, k);
    if (o.restitution < 1)
    {
        PackedContact packed;
        packed.dimensions = c.dimensions;
        packed.inertia = c.dimensions == 3 ? 0.4 : 0.5;
        packed.kappa = k.shear;
        packed.twoZeta = LinearSpring::make(in.pairs[0].properties).twoZeta;
        theory = packingLimit(packed);
    }
    for (const std::string& integrator : integrators)
    {
        const double found = bisect(0.5*theory, 1.3*theory, 2e-3*theory, [&](double step)
            { return stable(c, in, integrator, step, o.lattice == Lattice::chain && !o.bonded); });
        results.add(
            {"limits", name, integrator, "largest dt / sqrt(m/k)", found, theory, ""});
    }
}

void onFloor(DemResults& results, double restitution)
{
    DemConfig c;
    DemInput in;
    singleScene(c, in);
    addFloor(in);
    const double weight = 1e-3;
    c.gravity = Vector3{{0, 0, -weight}};
    in.pairs[0].properties.restitution = restitution;
    addBody(in, Vector3{{0, 0, 1 - weight}}, Vector3{{0, 0, 1e-12}});
    // where the dashpot may not pull, e is reached with less damping: take the law's own
    in.pairs[0].properties.attraction = true;
    const double ln = std::log(restitution),
                 zeta = restitution < 1 ? -ln/std::sqrt(ln*ln + 9.8696044) : 0;
    double theory = 0, above = 2;
    while (above - theory > 1e-9)
    {
        const double x = 0.5*(theory + above);
        (x*x + 4*zeta*x/(1 + 0.5*zeta*x) < 4 ? theory : above) = x;
    }
    for (const std::string& integrator : integrators)
    {
        const double found = bisect(0.5*theory, 1.5*theory, 1e-3,
            [&](double step) { return stable(c, in, integrator, step, true); });
        const std::string name = restitution < 1
            ? "one body on a floor, e = " + std::to_string(restitution).substr(0, 4)
            : "one body on a floor";
        results.add(
            {"limits", name, integrator, "largest dt / sqrt(m/k)", found, theory, ""});
    }
}

} // namespace

void contactLimits(DemResults& results)
{
    onFloor(results, 1);
    onFloor(results, 0.5);
    onFloor(results, 0.1);
    LatticeOptions o;
    lattice(results, "chain", o);
    o.normal = "hertz";
    lattice(results, "chain, Hertz (k at rest)", o);
    o.normal = "linear";
    for (const auto& [word, kind] : {std::pair<const char*, Lattice>{"square", Lattice::square},
             {"hexagonal", Lattice::hexagonal}, {"cubic", Lattice::cubic},
             {"close packing", Lattice::closePacked}})
        for (const double ratio : {0.0, 0.5, 1.0})
        {
            // without friction these two have no resistance to shear: nothing to be stable about
            if (ratio == 0 && (kind == Lattice::square || kind == Lattice::cubic)) continue;
            o.lattice = kind;
            o.tangential = ratio > 0;
            o.stiffnessRatio = ratio;
            lattice(results,
                (word
                    + (ratio > 0 ? ", kt/kn = " + std::to_string(ratio).substr(0, 3)
                                 : std::string(", smooth")))
                    .c_str(),
                o);
        }
    for (const auto& [word, kind] :
        {std::pair<const char*, Lattice>{"hexagonal", Lattice::hexagonal},
            {"close packing", Lattice::closePacked}})
        for (const double ratio : {0.0, 0.5})
            for (const double e : {0.9, 0.5, 0.1})
            {
                o.lattice = kind;
                o.tangential = ratio > 0;
                o.stiffnessRatio = ratio;
                o.restitution = e;
                lattice(results,
                    (std::string(word) + (ratio > 0 ? ", kt/kn = 0.5" : ", smooth")
                        + ", e = " + std::to_string(e).substr(0, 3))
                        .c_str(),
                    o);
            }
    o = LatticeOptions();
    o.lattice = Lattice::closePacked;
    o.normal = "hertz";
    o.tangential = true;
    o.stiffnessRatio = 0.8;
    lattice(results, "close packing, Hertz and Mindlin, 0.8", o);
    o = LatticeOptions();
    o.bonded = true;
    for (const double ratio : {0.01, 0.5, 1.0})
    {
        o.stiffnessRatio = ratio;
        o.lattice = Lattice::chain;
        lattice(
            results, ("bonded chain, ks/kn = " + std::to_string(ratio).substr(0, 4)).c_str(), o);
    }
    o.stiffnessRatio = 0.5;
    o.lattice = Lattice::hexagonal;
    lattice(results, "bonded hexagonal, ks/kn = 0.5", o);
    o.lattice = Lattice::closePacked;
    lattice(results, "bonded close packing, ks/kn = 0.5", o);
}

} // namespace riprap
