// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>
#include "api/picScene.hpp"
#include "countedScene.hpp"

namespace riprap
{

namespace
{

constexpr double edge = 1.0/40, radius = 4*edge;

struct Options
{
    int dimensions = 2;
    bool solids = true, moves = true, obstacle = true, viscosity = true, noSlip = true,
         reflection = true, correction = true, absorbs = true, opens = true;
    int dry = 1;                            // the box is so many times as long as it must be
    bool sampling = false, logging = false;
};

PicConfig configOf(const Options& o)
{
    PicConfig c;
    c.dimensions = o.dimensions;
    c.device = DeviceKind::cpu;
    c.cells[0] = 40*o.dry;
    c.cells[1] = 40;
    c.cells[2] = o.dimensions == 3 ? 16 : 1;
    c.cellSize = edge;
    c.domainMin = {{0, 0, 0}};
    for (int d = 0; d < 3; ++d) c.domainMax[d] = c.cells[d]*edge;
    c.spacing = 0.5*edge;
    c.gravity = {{0, -9.81, 0}};
    c.viscosity = o.viscosity ? 1e-3 : 0;
    c.noSlip = o.noSlip;
    c.reflection = o.reflection ? 1 : 0;
    c.positionCorrection = o.correction ? 0.05 : 0;
    c.pressureTolerance = 1e-6;
    c.adjustTimeStep = false;
    c.fixedTimeStep = 2e-3;
    if (o.absorbs)
    {
        PicAbsorber zone;
        zone.from = {{0.7, 0, 0}};
        zone.to = {{1, 0, 0}};
        zone.rate = 1;
        c.absorbers.push_back(zone);
    }
    if (o.opens)
    {
        PicOpening opening;
        opening.kind = "velocity";
        opening.velocity = [](double) { return Vector3{{0.1, 0, 0}}; };
        c.openings.push_back(opening);
    }
    return c;
}

FluidInput waterOf(const PicConfig& c)
{
    FluidInput water;
    const double s = c.spacing, deep = c.dimensions == 3 ? c.domainMax[2] : s;
    for (double z = 0.5*s; z < deep; z += s)
        for (double y = 0.5*s; y < 0.5; y += s)
            for (double x = 0.5*s; x < 1; x += s)
            {
                water.position.insert(water.position.end(), {x, y, z});
                water.velocity.insert(water.velocity.end(), {0.1*std::sin(M_PI*x), 0, 0});
            }
    return water;
}

//- The left side's lower half is open
PicWalls wallsOf(const PicConfig& c, const Options& o)
{
    PicWalls w;
    if (!o.opens) return w;
    for (int d = 0; d < c.dimensions; ++d)
    {
        int n[3] = {c.cells[0], c.cells[1], c.cells[2]};
        ++n[d];
        const int faces = n[0]*n[1]*n[2];
        w.aperture[d].assign(faces, 1);
        w.opening[d].assign(faces, -1);
        for (int i = 0; i < faces; ++i)
        {
            const int at[3] = {i % n[0], i/n[0] % n[1], i/(n[0]*n[1])};
            if (at[d] > 0 && at[d] < c.cells[d]) continue;
            const bool open = d == 0 && at[0] == 0 && at[1] < c.cells[1]/2;
            w.aperture[d][i] = open;
            if (open) w.opening[d][i] = 0;
        }
    }
    return w;
}

std::shared_ptr<PicSolids> solidsOf(const PicConfig& c, const Options& o)
{
    auto solids = std::make_shared<PicSolids>();
    DemConfig& d = solids->config;
    d.domainMin = c.domainMin;
    d.domainMax = c.domainMax;
    d.normal = "linear";
    d.tangential = "history";
    DemInput& in = solids->input;
    in.materials.resize(1);
    in.pairs.resize(1);
    in.pairs[0].properties.normalStiffness = 1e5;
    in.pairs[0].properties.restitution = 0.3;
    in.pairs[0].properties.friction = 0.3;
    in.pairs[0].properties.gap = 2*edge;
    DemGroup group;
    for (bool& held : group.held) held = !o.moves;
    group.heldSpin = !o.moves;
    in.groups.push_back(group);
    for (const double x : {0.3, 0.7})
    {
        in.particles.position.insert(in.particles.position.end(), {x, 0.3, 0.5*c.domainMax[2]});
        in.particles.velocity.insert(in.particles.velocity.end(), {0, 0, 0});
        in.particles.radius.push_back(radius);
        in.particles.mass.push_back(1500
            *(c.dimensions == 3 ? 4.0/3*M_PI*std::pow(radius, 3) : M_PI*radius*radius));
    }
    in.walls.push_back(plane(1, 0, false));
    return solids;
}

//- A triangle on the floor
PicObstacle obstacle()
{
    PicObstacle o;
    o.name = "sill";
    o.vertices = {0.45, -0.05, 0, 0.55, -0.05, 0, 0.5, 0.12, 0};
    o.elements = {0, 1, 1, 2, 2, 0};
    return o;
}

CountedScene make(const Options& o)
{
    const PicConfig c = configOf(o);
    PicInside inside;
    if (o.solids) inside.solids = solidsOf(c, o);
    if (o.obstacle && o.dimensions == 2) inside.obstacles.push_back(obstacle());
    std::shared_ptr<PicScene> scene = createPicScene(
        c, waterOf(c), wallsOf(c, o), nullptr, std::move(inside));
    CountedScene s = CountedScene::of(scene, std::size_t(c.cells[0])*c.cells[1]*c.cells[2]);
    s.kernels = [scene]
    {
        std::vector<KernelInfo> all = scene->kernels();
        if (scene->solids())
            for (const KernelInfo& k : scene->solids()->kernels())
                all.push_back({"solids: " + k.name, k.launches, k.seconds});
        return all;
    };
    s.sample = [scene] { scene->sample({0.1, 0.1, 0.1, 0.2, 0.1, 0.1, 0.3, 0.1, 0.1}); };
    s.sampling = o.sampling;
    s.logging = o.logging;
    return s;
}

Row row(const char* without, const char* scene, const Options& o)
{
    Row r{"picDem", without, scene, {"fluid"}, [o] { return make(o); }};
    const auto has = [&](bool there, const char* name) { if (there) r.has.insert(name); };
    const bool obstacle = o.obstacle && o.dimensions == 2;
    has(o.solids, "solids");
    has(o.solids, "solids/contacts");
    has(o.solids, "solids/walls");
    has(o.solids && o.moves, "solids/motion");
    has(o.solids || obstacle, "cuts");
    has(o.viscosity, "viscosity");
    has(o.viscosity && o.noSlip && (o.solids || obstacle), "sticksInside");
    has(o.reflection, "reflection");
    has(o.correction, "positionCorrection");
    has(o.absorbs, "absorb");
    has(o.opens, "openings");
    has(o.sampling, "sampling");
    return r;
}

} // namespace

std::vector<Row> picRows()
{
    std::vector<Row> rows;
    const Options whole;
    rows.push_back(row("", "tank with disks", whole));
    const auto add = [&](const char* without, void (*less)(Options&))
    {
        Options o = whole;
        less(o);
        rows.push_back(row(without, "tank with disks", o));
    };
    add("solids", [](Options& o) { o.solids = false; });
    add("motion of the solids (held)", [](Options& o) { o.moves = false; });
    add("solids and obstacles", [](Options& o) { o.solids = o.obstacle = false; });
    add("viscosity", [](Options& o) { o.viscosity = false; });
    add("friction at walls (slip)", [](Options& o) { o.noSlip = false; });
    add("reflection", [](Options& o) { o.reflection = false; });
    add("position correction", [](Options& o) { o.correction = false; });
    add("zones that absorb", [](Options& o) { o.absorbs = false; });
    add("openings", [](Options& o) { o.opens = false; });
    add("all of these",
        [](Options& o)
        {
            o.solids = o.obstacle = o.viscosity = o.noSlip = o.reflection = o.correction =
                o.absorbs = o.opens = false;
        });

    Options three;
    three.dimensions = 3;
    three.obstacle = false;
    rows.push_back(row("", "tank with spheres in 3D", three));
    three.dimensions = 2;
    rows.push_back(row("the third dimension", "tank with spheres in 3D", three));

    Options wide;
    wide.dry = 4;
    wide.solids = wide.obstacle = wide.opens = false;
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
