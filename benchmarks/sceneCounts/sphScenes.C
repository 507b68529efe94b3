// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>
#include "api/sphDemScene.hpp"
#include "countedScene.hpp"

namespace riprap
{

namespace
{

// of the water; a tank of two widths
constexpr double spacing = 0.01, width = 0.5, depth = 0.3;

struct Options
{
    int dimensions = 2;
    bool solids = true, bonds = true, moves = true, variableH = true, walls = true, noSlip = true,
         faces = true;
    bool diffusion = true, xsph = true, clumps = true, shifts = true, slides = true;
    const char* viscosity = "laminarAndArtificial";
    std::string integrator = "symplectic";
    double dry = 1;                         // the tank is so many times as long as it must be
    bool sampling = false, logging = false;
};

SphConfig configOf(const Options& o)
{
    SphConfig c;
    c.dimensions = o.dimensions;
    c.device = DeviceKind::cpu;
    c.spacing = c.wallSpacing = spacing;
    c.gravity = {{0, -9.81, 0}};
    c.viscosity = 1e-3;
    c.maxVelocity = std::sqrt(2*9.81*depth);
    c.soundSpeed = 10*c.maxVelocity;
    c.variableSmoothing = o.variableH;
    c.viscosityModel = o.viscosity;
    c.diffusion = o.diffusion ? "fourtakas" : "none";
    c.xsph = o.xsph ? 0.1 : 0;
    c.antiClump = o.clumps ? 0.01 : 0;
    c.shifting = o.shifts ? "fickian" : "none";
    c.noSlip = o.noSlip;
    c.integrator = o.integrator;
    c.acousticCourant = 0.2;
    const double margin = 4*spacing;
    c.domainMin = {{-margin, -margin, -margin}};
    c.domainMax = {{2*width*o.dry + margin, 2*depth + margin, 0.1 + margin}};
    return c;
}

FluidInput fluidOf(const SphConfig& c)
{
    FluidInput f;
    const int deep = c.dimensions == 3 ? 10 : 1;
    for (int k = 0; k < deep; ++k)
        for (double y = 0.5*spacing; y < depth; y += spacing)
            for (double x = 0.5*spacing; x < width; x += spacing)
            {
                f.position.insert(f.position.end(), {x, y, (k + 0.5)*spacing});
                f.velocity.insert(f.velocity.end(), {0.2*x, -0.2*y, 0});
                f.density.push_back(c.density*(1 + 9.81*(depth - y)/(c.soundSpeed*c.soundSpeed)));
            }
    return f;
}

//- Layers about the tank, and the floor's face
WallInput wallsOf(const SphConfig& c, const Options& o)
{
    WallInput w;
    if (!o.walls) return w;
    const double length = 2*width*o.dry;
    const int nx = int(std::lround(length/spacing)), ny = int(std::lround(2*depth/spacing)),
              layers = 4;
    const int nz = c.dimensions == 3 ? 10 : 1, beyond = c.dimensions == 3 ? layers : 0;
    for (int k = -beyond; k < nz + beyond; ++k)
        for (int j = -layers; j < ny; ++j)
            for (int i = -layers; i < nx + layers; ++i)
            {
                if (i >= 0 && i < nx && j >= 0 && k >= 0 && k < nz) continue;
                w.position.insert(w.position.end(),
                    {(i + 0.5)*spacing, (j + 0.5)*spacing, (k + 0.5)*spacing});
                w.body.push_back(o.slides && i >= nx ? 0 : -1);
            }
    w.normal.assign(w.position.size(), 0);
    w.nBodies = o.slides ? 1 : 0;
    if (!o.faces || c.dimensions == 3) return w;
    w.faces.point = {0, 0, 0, length, 0, 0};
    w.faces.vertex = {0, 1, 1};
    w.faces.normal = {0, 1, 0};
    w.faces.body = {-1};
    w.faces.part = {0};
    w.faces.halfThickness = {0};
    return w;
}

//- A plate beside the water, which stands on the floor
SolidInput solidsOf(const SphConfig& c, const Options& o)
{
    SolidInput s;
    DemConfig& d = s.config;
    d.domainMin = c.domainMin;
    d.domainMax = c.domainMax;
    d.normal = "linear";
    d.tangential = "none";
    DemInput& in = s.input;
    in.materials.push_back(DemMaterial{"rubber", 1e7, 0.25});
    in.pairs.resize(1);
    in.pairs[0].properties.normalStiffness = 1e4;
    in.pairs[0].properties.restitution = 0.5;
    const int high = int(std::lround(depth/spacing)), deep = c.dimensions == 3 ? 10 : 1;
    const double volume = std::pow(spacing, c.dimensions);
    DemGroup group;
    for (bool& held : group.held) held = !o.moves;
    group.heldSpin = !o.moves;
    in.groups.push_back(group);
    for (int k = 0; k < deep; ++k)
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < high; ++j)
            {
                in.particles.position.insert(in.particles.position.end(),
                    {width + (i + 0.5)*spacing, (j + 0.5)*spacing, (k + 0.5)*spacing});
                in.particles.radius.push_back(0.5*spacing);
                in.particles.mass.push_back(1100*volume);
                s.volume.push_back(volume);
            }
    if (o.bonds)
    {
        in.bondTypes.push_back(DemBondType{});
        in.bondTypes[0].normalStiffness = in.bondTypes[0].shearStiffness = 1e8;
        DemConfig e = d;
        if (configOf(o).dimensions == 2) e.dimensions = 2;
        in.bonds = bondsWithin(e, in.particles, 0, 0.1*spacing);
    }
    in.walls.push_back(plane(1, 0, false));
    return s;
}

CountedScene make(const Options& o)
{
    const SphConfig c = configOf(o);
    const FluidInput fluid = fluidOf(c);
    const WallInput walls = wallsOf(c, o);
    const WallMotion motion = [](int, double t)
    {
        WallPose p;
        p.translation = {{-0.05*t, 0, 0}};
        return p;
    };
    std::shared_ptr<SphScene> scene = o.solids
      ? createSphDemScene(c, fluid, walls, solidsOf(c, o), o.slides ? motion : WallMotion())
      : createSphScene(c, fluid, walls, o.slides ? motion : WallMotion());
    CountedScene s = CountedScene::of(scene, fluid.size());
    s.advance = [scene](int steps)
    {
        for (const std::int64_t end = steps; steps > 0;)
            steps -= int(scene->advance(scene->time() + 1, end).steps);
    };
    s.sample = [scene] { scene->sample({0.1, 0.1, 0, 0.2, 0.1, 0, 0.3, 0.1, 0}); };
    s.sampling = o.sampling;
    s.logging = o.logging;
    return s;
}

Row row(const char* without, const char* scene, const Options& o)
{
    Row r{"sphDem", without, scene, {"fluid"}, [o] { return make(o); }};
    const auto has = [&](bool there, const char* name) { if (there) r.has.insert(name); };
    has(o.solids, "solids");
    has(o.solids, "solids/contacts");
    has(o.solids, "solids/walls");
    has(o.solids && o.moves, "solids/motion");
    has(o.solids && o.bonds, "solids/bonds");
    has(o.walls, "walls");
    has(o.walls && o.slides, "movingWalls");
    has(o.walls && o.faces && o.dimensions == 2, "faces");
    has(o.xsph || o.shifts, "drift");
    has(o.integrator == "leapfrog", "leapfrog");
    has(o.integrator == "symplectic", "symplectic");
    has(o.sampling, "sampling");
    return r;
}

} // namespace

std::vector<Row> sphRows()
{
    std::vector<Row> rows;
    const Options whole;
    rows.push_back(row("", "dam with a plate", whole));
    const auto add = [&](const char* without, void (*less)(Options&))
    {
        Options o = whole;
        less(o);
        rows.push_back(row(without, "dam with a plate", o));
    };
    add("solids", [](Options& o) { o.solids = false; });
    add("motion of the solids (held)", [](Options& o) { o.moves = false; });
    add("bonds", [](Options& o) { o.bonds = false; });
    add("variable h", [](Options& o) { o.variableH = false; });
    add("viscosity", [](Options& o) { o.viscosity = "none"; });
    add("friction at walls (slip)", [](Options& o) { o.noSlip = false; });
    add("walls", [](Options& o) { o.walls = o.slides = o.faces = false; });
    add("moving walls", [](Options& o) { o.slides = false; });
    add("faces of walls", [](Options& o) { o.faces = false; });
    add("density diffusion", [](Options& o) { o.diffusion = false; });
    add("XSPH and shifting", [](Options& o) { o.xsph = o.shifts = false; });
    add("anti-clump term", [](Options& o) { o.clumps = false; });
    add("half of the passes (leapfrog)",
        [](Options& o) { o.integrator = "leapfrog"; });
    add("all of these but walls",
        [](Options& o)
        {
            o.solids = o.variableH = o.slides = o.faces = o.diffusion = o.xsph = o.shifts =
                o.clumps = o.noSlip = false;
            o.viscosity = "none";
        });

    Options three;
    three.dimensions = 3;
    rows.push_back(row("", "dam with a plate in 3D", three));
    rows.push_back(row("the third dimension", "dam with a plate in 3D", whole));

    Options wide;
    wide.dry = 4;
    wide.walls = wide.slides = wide.faces = false;
    rows.push_back(row("", "water in a wide box", wide));
    wide.dry = 1;
    rows.push_back(row("the dry part of the box", "water in a wide box", wide));

    Options sampled;
    sampled.sampling = sampled.logging = true;
    rows.push_back(row("", "sampled each step", sampled));
    sampled.sampling = false;
    rows.push_back(row("sampling", "sampled each step", sampled));
    rows.push_back(row("sampling and log", "sampled each step", whole));
    return rows;
}

} // namespace riprap
