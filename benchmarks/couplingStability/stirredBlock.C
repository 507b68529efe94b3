/*  SPDX-License-Identifier: GPL-3.0-or-later  */
#include "stirredBlock.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace riprap
{

namespace
{

// where the water shears: the block is pushed and turned
constexpr double centreX = 0.5, centreY = 0.75;

SphConfig water(const StirredBlock& b)
{
    SphConfig c;
    c.dimensions = 2;
    c.device = DeviceKind::cpu;
    c.precision = b.precision;
    c.periodic[0] = c.periodic[1] = c.periodic[2] = true;
    c.spacing = c.wallSpacing = b.spacing;
    c.smoothingRatio = b.smoothing;
    c.soundSpeed = b.soundSpeed;
    c.maxVelocity = 0.1*b.soundSpeed;
    c.density = b.density;
    c.integrator = "symplectic";
    c.acousticCourant = b.courant;
    c.viscosityModel = "none";
    c.diffusion = "none";
    return c;
}

double side(const StirredBlock& b) { return b.across*b.sizeRatio*b.spacing; }

FluidInput stirred(const StirredBlock& b)
{
    FluidInput f;
    const int n = int(std::lround(1/b.spacing));
    std::mt19937 engine(1);
    const auto shift = [&] { return b.disorder*b.spacing*(2*(engine()/4294967296.0) - 1); };
    const double pi = std::acos(-1.0), clear = 0.5*side(b) + 0.499*b.spacing;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
        {
            const double x = (i + 0.5)*b.spacing + shift(), y = (j + 0.5)*b.spacing + shift();
            if (std::abs(x - centreX) < clear && std::abs(y - centreY) < clear) continue;
            f.position.insert(f.position.end(), {x, y, 0});
            f.velocity.insert(f.velocity.end(),
                {b.speed*std::sin(2*pi*y), b.speed*std::sin(2*pi*x), 0});
            f.density.push_back((1 + b.compression)*b.density);
        }
    return f;
}

SolidInput block(const StirredBlock& b, const SphConfig& c)
{
    SolidInput s;
    s.coupling.kind = b.kind;
    s.coupling.force = b.force;
    s.config.domainMin = c.domainMin;
    s.config.domainMax = c.domainMax;
    for (int d = 0; d < 3; ++d) s.config.periodic[d] = c.periodic[d];
    s.config.normal = "linear";
    s.config.tangential = "none";
    s.config.integrator = "velocityVerlet";
    s.config.stepFraction = b.solidStep;
    DemInput& in = s.input;
    in.materials.push_back(DemMaterial{"rubber", b.young, 0.3});
    DemPair p;
    p.properties.normalStiffness = 1e4;
    in.pairs.push_back(p);

    const double size = b.sizeRatio*b.spacing, left = centreX - 0.5*side(b),
                 low = centreY - 0.5*side(b), mass = b.densityRatio*b.density*size*size;
    double inertia = 0;
    for (int j = 0; j < b.across; ++j)
        for (int i = 0; i < b.across; ++i)
        {
            const double x = left + (i + 0.5)*size, y = low + (j + 0.5)*size;
            in.particles.position.insert(in.particles.position.end(), {x, y, 0});
            in.particles.radius.push_back(0.5*size);
            in.particles.mass.push_back(mass);
            s.volume.push_back(size*size);
            inertia += mass
                *((x - centreX)*(x - centreX) + (y - centreY)*(y - centreY) + size*size/6);
        }
    if (b.rigid)
    {
        in.particles.clump.assign(in.particles.size(), 0);
        DemClump clump;
        clump.position = {{centreX, centreY, 0}};
        clump.mass = mass*double(in.particles.size());
        clump.inertia[2] = inertia;
        in.clumps.push_back(clump);
        return s;
    }
    DemBondType cement;
    cement.normalStiffness = b.young/size;
    cement.shearStiffness = 0.4*b.young/size;
    cement.dampingRatio = b.dampingRatio;
    in.bondTypes.push_back(cement);
    DemConfig known(s.config);
    known.dimensions = 2;
    if (b.across > 1) in.bonds = bondsWithin(known, in.particles, 0, 1e-3*size);
    return s;
}

//- Water particles nearer to a solid's centre than half its size
int within(SphScene& scene, double size)
{
    const FluidState f = scene.fluid();
    const DemState q = scene.solids()->particles();
    int count = 0;
    for (std::size_t i = 0; i < f.id.size(); ++i)
    {
        bool in = false;
        for (std::size_t k = 0; k < q.id.size() && !in; ++k)
        {
            double r2 = 0;
            for (int d = 0; d < 2; ++d)
            {
                double r = f.position[3*i + d] - q.position[3*k + d];
                r -= std::round(r);
                r2 += r*r;
            }
            in = r2 < 0.25*size*size;
        }
        count += in;
    }
    return count;
}

} // namespace

StirredResult stir(const StirredBlock& b)
{
    const SphConfig c = water(b);
    const auto scene = createSphDemScene(c, stirred(b), {}, block(b, c));
    const auto total = [&]
    {
        const SphEnergy e = scene->energy();
        return e.kinetic + e.elastic + scene->solids()->energy().total();
    };
    if (b.settle > 0) scene->advance(b.settle);
    const double before = total(), kinetic = scene->energy().kinetic;
    StirredResult r;
    constexpr int looks = 20;
    for (int k = 1; k <= looks && !r.stopped; ++k)
    {
        const SphReport report = scene->advance(b.settle + b.duration*k/looks);
        r.steps = report.totalSteps;
        r.end = (total() - before)/kinetic;
        r.stopped = report.stop != StopReason::none || !std::isfinite(r.end);
        if (!(std::abs(r.end) < std::abs(r.energy))) r.energy = r.end;
    }
    r.solids = scene->solids()->energy().total()/kinetic;
    r.subcycles = scene->coupling().subcycles;
    if (!r.stopped) r.inside = within(*scene, b.sizeRatio*b.spacing);
    return r;
}

} // namespace riprap
