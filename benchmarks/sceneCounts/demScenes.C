// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>
#include <stdexcept>
#include "countedScene.hpp"

namespace riprap
{

namespace
{

constexpr double radius = 0.005, density = 2500;

struct Options
{
    int dimensions = 3;
    bool bonds = true, clumps = true, friction = true, rolling = true, walls = true, moves = true,
         sleeps = false, turns = true,
         oneMaterial = false;                // else another, which nobody is of
    bool rest = false;                      // a block that lies on the floor, else it falls apart
    bool beside = false;                    // one at rest beside it
    double apart = 1.998;                   // particles of a block [radii]
    double box = 0.2;
    bool sampling = false, logging = false;
};

DemConfig configOf(const Options& o)
{
    DemConfig c;
    c.dimensions = o.dimensions;
    c.device = DeviceKind::cpu;
    c.domainMin = {{0, 0, 0}};
    c.domainMax = {{o.box, o.box, o.box}};
    c.gravity = {{0, -9.81, 0}};
    c.normal = "linear";
    c.tangential = o.friction ? "history" : "none";
    c.rolling = o.rolling ? "spring" : "none";
    c.timeStep = 1e-5;
    c.orientation = o.turns;
    if (o.sleeps) { c.sleepSpeed = 5e-2; c.sleepAfter = 1e-3; }
    return c;
}

constexpr int side = 12;                    // particles of a block along each direction

//- A block that lies on the floor, or falls, each layer sliding over the one below; apart: its
//  particles, in radii
void addBlock(DemInput& in, int dimensions, bool rest, double from, double radii)
{
    const int deep = dimensions == 3 ? side : 1;
    const double apart = radii*radius;
    for (int k = 0; k < deep; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i)
            {
                in.particles.position.insert(in.particles.position.end(),
                    {from + i*apart, radius*(rest ? 1 : 1.2) + j*apart, 0.02 + k*apart});
                in.particles.velocity.insert(in.particles.velocity.end(),
                    {rest ? 0 : 0.02*(j % 2 ? 1 : -1), rest ? 0 : -0.1, 0});
                in.particles.radius.push_back(radius);
                in.particles.mass.push_back(density
                    *(dimensions == 3 ? 4.0/3*M_PI*std::pow(radius, 3) : M_PI*radius*radius));
            }
}

DemInput inputOf(const Options& o)
{
    DemInput in;
    in.materials.push_back(DemMaterial{"glass", 1e7, 0.25});
    in.pairs.resize(1);
    PairProperties& p = in.pairs[0].properties;
    p.normalStiffness = 1e4;
    p.restitution = 0.5;
    p.friction = 0.5;
    p.rollingFriction = 0.05;
    if (!o.oneMaterial)
    {
        in.materials.push_back(DemMaterial{"steel", 1e7, 0.25});
        in.pairs.push_back(in.pairs[0]);
        in.pairs[1].a = in.pairs[1].b = 1;
    }
    DemGroup group;
    for (bool& held : group.held) held = !o.moves;
    group.heldSpin = !o.moves;
    in.groups.push_back(group);
    addBlock(in, o.dimensions, o.rest, 0.02, o.apart);
    if (o.beside) addBlock(in, o.dimensions, true, 0.2, 2);
    const std::int32_t n = std::int32_t(in.particles.size());
    if (o.bonds)
    {
        in.bondTypes.push_back(DemBondType{});
        in.bondTypes[0].normalStiffness = in.bondTypes[0].shearStiffness = 1e8;
        for (std::int32_t i = 0; i + 1 < n; i += 2)
        {
            if ((i + 1) % side == 0) continue;
            in.bonds.a.push_back(i);
            in.bonds.b.push_back(i + 1);
        }
    }
    if (o.clumps)
    {
        in.particles.clump.assign(n, -1);
        in.particles.clump[n - 1] = 0;
        DemClump body;
        for (int d = 0; d < 3; ++d) body.position[d] = in.particles.position[3*(n - 1) + d];
        body.mass = in.particles.mass[n - 1];
        const double inertia = 0.4*body.mass*radius*radius;
        body.inertia = {{inertia, inertia, inertia}};
        in.clumps.push_back(body);
        if (o.bonds && in.bonds.size() && in.bonds.b.back() == n - 1)
        {
            in.bonds.a.pop_back();
            in.bonds.b.pop_back();
        }
    }
    if (o.walls)
        for (int axis = 0; axis < o.dimensions; ++axis)
            for (const bool upper : {false, true})
                in.walls.push_back(plane(axis, upper ? o.box : 0, upper));
    return in;
}

CountedScene make(const Options& o)
{
    const DemInput in = inputOf(o);
    std::shared_ptr<DemScene> scene = createDemScene(configOf(o), in);
    CountedScene s = CountedScene::of(scene, in.particles.size());
    s.sample = [scene] { scene->energy(); };
    s.sampling = o.sampling;
    s.logging = o.logging;
    if (o.sleeps)
    {
        s.before = 400;
        const auto asleep = std::make_shared<std::size_t>(0);
        s.advance = [scene, asleep](int steps) { *asleep = scene->advance(1e30, steps).asleep; };
        s.ready = [asleep, wanted = in.particles.size()/(o.beside ? 2 : 1)]
        {
            if (*asleep != wanted)
                throw std::runtime_error(std::to_string(*asleep) + " particles sleep, not "
                    + std::to_string(wanted));
        };
    }
    return s;
}

Row row(const char* without, const char* scene, const Options& o)
{
    Row r{"dem", without, scene, {"contacts"}, [o] { return make(o); }};
    const auto has = [&](bool there, const char* name) { if (there) r.has.insert(name); };
    has(o.moves, "motion");
    has(o.bonds, "bonds");
    has(o.clumps, "clumps");
    has(o.walls, "walls");
    has(o.sleeps, "sleep");
    has(o.turns, "orientation");
    has(o.sampling, "sampling");
    return r;
}

} // namespace

DemWall plane(int axis, double at, bool upper)
{
    DemWall w;
    w.plane = true;
    w.normal = {{0, 0, 0}};
    w.normal[axis] = upper ? -1 : 1;
    w.point[axis] = at;
    return w;
}

std::vector<Row> demRows()
{
    std::vector<Row> rows;
    const Options whole;
    rows.push_back(row("", "block", whole));
    const auto add = [&](const char* without, void (*less)(Options&))
    {
        Options o = whole;
        less(o);
        rows.push_back(row(without, "block", o));
    };
    add("bonds", [](Options& o) { o.bonds = false; });
    add("clumps", [](Options& o) { o.clumps = false; });
    add("friction", [](Options& o) { o.friction = o.rolling = false; });
    add("rolling friction", [](Options& o) { o.rolling = false; });
    add("walls", [](Options& o) { o.walls = false; });
    add("a material that nobody is of", [](Options& o) { o.oneMaterial = true; });
    add("motion (all held)", [](Options& o) { o.moves = false; });
    add("orientation", [](Options& o) { o.turns = false; });
    add("the third dimension", [](Options& o) { o.dimensions = 2; });
    add("all of these",
        [](Options& o)
        {
            o.bonds = o.clumps = o.friction = o.rolling = o.walls = o.turns = false;
            o.oneMaterial = true;
        });

    Options rest;
    rest.rest = true;
    rest.apart = 2;
    rest.bonds = rest.clumps = rest.turns = false;
    rows.push_back(row("", "block at rest", rest));
    rest.sleeps = true;
    rows.push_back(row("still solids awake", "block at rest", rest));

    Options two;
    two.box = 0.4;
    two.apart = 2.02;                       // steps enough for one to fall asleep
    two.bonds = two.clumps = two.turns = false;
    two.beside = two.sleeps = true;
    rows.push_back(row("", "two blocks", two));
    two.beside = two.sleeps = false;
    rows.push_back(row("the sleeping block", "two blocks", two));

    Options wide;
    wide.box = 0.8;
    rows.push_back(row("", "block in a wide box", wide));
    rows.push_back(row("the empty part of the box", "block in a wide box", whole));

    Options sampled;
    sampled.sampling = sampled.logging = true;
    rows.push_back(row("", "sampled each step", sampled));
    sampled.sampling = false;
    rows.push_back(row("sampling", "sampled each step", sampled));
    rows.push_back(row("sampling and log", "sampled each step", whole));
    return rows;
}

} // namespace riprap
