/*  SPDX-License-Identifier: GPL-3.0-or-later  */
#include "gateScene.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace riprap
{

namespace
{

constexpr double gravity = 9.81, width = 0.1, depth = 0.14, height = 0.2, outside = 0.1;
constexpr double gateHeight = 0.079, gateThickness = 5e-3;
constexpr double young = 10e6, poisson = 0.4, rubber = 1100;
constexpr int clampRows = 4;

SphConfig water(const GateOptions& o)
{
    SphConfig c;
    c.dimensions = 3;
    c.device = o.device;
    c.precision = o.precision;
    c.integrator = o.integrator;
    c.spacing = c.wallSpacing = width/std::round(std::cbrt(o.particles*width/depth));
    c.viscosity = 1e-3;
    c.gravity = {{0, -gravity, 0}};
    c.maxVelocity = std::sqrt(2*gravity*depth);
    c.soundSpeed = 10*c.maxVelocity;
    const double margin = std::ceil(2*c.smoothingRatio)*c.spacing;
    c.domainMin = {{-margin, -margin, -margin}};
    c.domainMax = {{width + gateThickness + outside + margin, height + margin, width + margin}};
    return c;
}

void addWater(GateScene& s)
{
    const double dp = s.config.spacing;
    const int across = int(std::lround(width/dp)), up = int(std::lround(depth/dp));
    for (int k = 0; k < across; ++k)
        for (int j = 0; j < up; ++j)
            for (int i = 0; i < across; ++i)
            {
                const double y = (j + 0.5)*dp;
                s.fluid.position.insert(s.fluid.position.end(), {(i + 0.5)*dp, y, (k + 0.5)*dp});
                s.fluid.density.push_back(s.config.density
                    *(1 + gravity*(depth - y)/(s.config.soundSpeed*s.config.soundSpeed)));
            }
    s.fluid.velocity.assign(s.fluid.position.size(), 0.0);
}

//- Floor, three sides, what is over the gate, and the gate itself where it is a wall.
void addWalls(GateScene& s, GateKind kind, double gateBottom, double gateTop)
{
    const double dp = s.config.spacing;
    const int layers = int(std::ceil(2*s.config.smoothingRatio)),
              across = int(std::lround(width/dp)), up = int(std::lround(height/dp));
    const int length = int(std::lround((width + gateThickness + outside)/dp));
    for (int k = -layers; k < across + layers; ++k)
        for (int j = -layers; j < up; ++j)
            for (int i = -layers; i < length; ++i)
            {
                const double x = (i + 0.5)*dp, y = (j + 0.5)*dp;
                const bool gate = x > width && x < width + gateThickness
                    && (y > gateTop || (kind == GateKind::wall && y > gateBottom));
                if (i < 0 || j < 0 || k < 0 || k >= across || gate)
                    s.walls.position.insert(s.walls.position.end(), {x, y, (k + 0.5)*dp});
            }
    s.walls.normal.assign(s.walls.position.size(), 0.0);
}

void addGate(GateScene& s, const GateOptions& o, GateKind kind, double size, int rows)
{
    const int through = int(std::lround(gateThickness/size)), across = int(std::lround(width/size));
    DemInput& in = s.solids.input;
    DemGroup free, held;
    free.name = "gate";
    held.name = "clamp";
    held.held[0] = held.held[1] = held.held[2] = held.heldSpin = true;
    in.groups = {free, held};
    const double volume = size*size*size;
    for (int k = 0; k < across; ++k)
        for (int j = 0; j < rows + clampRows; ++j)
            for (int i = 0; i < through; ++i)
            {
                in.particles.position.insert(in.particles.position.end(),
                    {width + (i + 0.5)*size, gateHeight + (j - rows + 0.5)*size,
                        (k + 0.5)*size});
                in.particles.group.push_back(j >= rows || kind == GateKind::held);
            }
    const std::size_t n = in.particles.size();
    in.particles.radius.assign(n, 0.5*size);
    in.particles.mass.assign(n, rubber*volume);
    s.solids.volume.assign(n, volume);
    in.materials.push_back(DemMaterial{"rubber", young, poisson});
    DemPair pair;
    pair.properties.normalStiffness = young*size;
    in.pairs.push_back(pair);

    DemConfig& c = s.solids.config;
    c.domainMin = s.config.domainMin;
    c.domainMax = s.config.domainMax;
    c.normal = "linear";
    c.tangential = "none";
    c.integrator = o.solids;
    // what is held has contacts alone, whose limit is another; it takes no steps
    c.stepFraction = kind == GateKind::held ? std::min(o.stepFraction, 0.5) : o.stepFraction;
    s.solids.coupling.kind = o.coupling;
    s.solids.coupling.force = "impulse";
    if (kind == GateKind::held) return;
    DemBondType cement;
    cement.normalStiffness = young/size;
    cement.shearStiffness = young/(1 + poisson)/size;
    in.bondTypes.push_back(cement);
    DemConfig known(c);
    known.dimensions = 3;
    DemParticles whole(in.particles);
    whole.group.clear();            // the clamp is bonded to the gate
    in.bonds = bondsWithin(known, whole, 0, 1e-3*size);
}

} // namespace

GateScene makeGate(const GateOptions& o, GateKind kind)
{
    GateScene s;
    s.config = water(o);
    const double size = width/std::round(width/(o.size*s.config.spacing));
    const int rows = int(std::floor((gateHeight - 0.2*size)/size));
    addWater(s);
    // the same slit under all of them: water shoots through it, and neighbours age with that
    addWalls(s, kind, gateHeight - rows*size, gateHeight + clampRows*size);
    if (kind != GateKind::wall) addGate(s, o, kind, size, rows);
    return s;
}

} // namespace riprap
