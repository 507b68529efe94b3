/*  Of picDemStability: bodies of several shapes half out of the water, and flat ones that enter it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/shapes/shapes.hpp"
#include "api/picScene.hpp"

namespace riprap
{

//- A rectangle about the origin, or a disk (of half[0]), as a lattice with points a quarter of a
//  cell apart
inline PicShape latticeOf(const double* half, bool disk, double cell)
{
    PicShape s;
    s.name = disk ? "disk" : "box";
    s.step = 0.25*cell;
    for (int d = 0; d < 2; ++d)
    {
        s.n[d] = int(2*(half[d] + 2*cell)/s.step) + 2;
        s.lower[d] = -0.5*s.step*(s.n[d] - 1);
    }
    const AxisBox<2> box{{{-half[0], -half[1]}}, {{half[0], half[1]}}};
    for (int j = 0; j < s.n[1]; ++j)
        for (int i = 0; i < s.n[0]; ++i)
        {
            const Vec<2, double> x{{s.lower[0] + i*s.step, s.lower[1] + j*s.step}};
            s.distance.push_back(disk ? std::sqrt(squaredNorm(x)) - half[0] : box.distance(x));
        }
    s.volume = disk ? M_PI*half[0]*half[0] : 4*half[0]*half[1];
    return s;
}

struct Floater
{
    const char* name;
    double half[2];             // [cells]
    bool disk;
    double turn;                // [rad]
};

static constexpr Floater floaters[] = {{"disk", {5, 5}, true, 0}, {"square", {5, 5}, false, 0},
    {"square on its edge", {5, 5}, false, 0.785398}, {"barge", {10, 2.5}, false, 0},
    {"barge, tilted", {10, 2.5}, false, 0.2}};

//- Such a body in a tank of 40 x 40 cells, three quarters full: its middle so high above the
//  surface, falling so fast
inline std::unique_ptr<PicScene> floaterScene(
    const Floater& f, double ratio, double above, double speed, bool reflection)
{
    constexpr double h = 1.0/40, g = 9.81, level = 0.75;
    PicConfig c;
    c.dimensions = 2;
    c.device = DeviceKind::cpu;
    c.precision = PrecisionKind::mixed;
    c.cells[0] = c.cells[1] = 40;
    c.cells[2] = 1;
    c.domainMin = {{0, 0, 0}};
    c.domainMax = {{1, 1, 1}};
    c.cellSize = h;
    c.spacing = 0.5*h;
    c.density = 1000;
    c.gravity = {{0, -g, 0}};
    c.pressureTolerance = 1e-8;
    c.reflection = reflection ? 1 : 0;
    FluidInput water;
    for (double y = 0.25*h; y < level; y += 0.5*h)
        for (double x = 0.25*h; x < 1; x += 0.5*h)
            water.position.insert(water.position.end(), {x, y, 0.5});
    water.velocity.assign(water.position.size(), 0.0);
    auto solids = std::make_shared<PicSolids>();
    solids->config.domainMin = c.domainMin;
    solids->config.domainMax = c.domainMax;
    solids->config.normal = "linear";
    const double half[2] = {f.half[0]*h, f.half[1]*h};
    solids->shapes = {latticeOf(half, f.disk, h)};
    DemInput& in = solids->input;
    in.materials.resize(1);
    in.pairs.resize(1);
    in.pairs[0].properties.normalStiffness = 1e5;
    in.particles.position = {0.5, level + above, 0.5};
    in.particles.velocity = {0, -speed, 0};
    in.particles.radius = {half[1]};
    in.particles.mass = {1};
    in.particles.clump = {0};
    DemClump k;
    k.position = {{0.5, level + above, 0.5}};
    k.velocity = {{0, -speed, 0}};
    k.mass = 1000*ratio*solids->shapes[0].volume;
    const double inertia = k.mass
        *(f.disk ? 0.5*half[0]*half[0] : (half[0]*half[0] + half[1]*half[1])/3);
    k.inertia = {{inertia, inertia, inertia}};
    k.orientation = {{std::cos(0.5*f.turn), 0, 0, std::sin(0.5*f.turn)}};
    k.shape = 0;
    in.clumps = {k};
    PicInside inside;
    inside.solids = solids;
    return createPicScene(c, water, PicWalls(), nullptr, std::move(inside));
}

} // namespace riprap
