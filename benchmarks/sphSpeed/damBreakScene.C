// SPDX-License-Identifier: GPL-3.0-or-later

#include "damBreakScene.hpp"

#include <algorithm>
#include <cmath>

namespace riprap
{

namespace
{

constexpr double gravity = 9.81, columnHeight = 2, tankLength = 4, tankHeight = 2.5, rate = 2;

void setModel(SphConfig& c, const SpeedOptions& o)
{
    c.dimensions = o.dimensions;
    c.device = o.device;
    c.precision = o.precision;
    c.smoothingRatio = o.ratio;
    c.integrator = o.integrator;
    c.wallModel = o.walls;
    c.viscosity = 1e-3;
    c.gravity = {{0, -gravity, 0}};
    c.maxVelocity = std::sqrt(2*gravity*columnHeight);
    c.soundSpeed = 10*c.maxVelocity;
    if (o.terms == TermSet::paper) { c.antiClump = 0.01; c.xsph = 0.5; }
    if (o.terms == TermSet::delta)
    {
        c.viscosityModel = "artificial";
        c.diffusion = "fourtakas";
    }
    c.skin = o.skin;
}

void addFluid(FluidInput& f, const SphConfig& c, int across, bool atRest)
{
    const double dp = c.spacing;
    const int deep = c.dimensions == 3 ? across : 1;
    const std::size_t n = std::size_t(2)*across*across*deep;
    f.position.reserve(3*n);
    f.velocity.reserve(3*n);
    f.density.reserve(n);
    for (int k = 0; k < deep; ++k)
        for (int j = 0; j < 2*across; ++j)
            for (int i = 0; i < across; ++i)
            {
                const double x = (i + 0.5)*dp, y = (j + 0.5)*dp,
                             z = c.dimensions == 3 ? (k + 0.5)*dp : 0;
                f.position.insert(f.position.end(), {x, y, z});
                const double speed = atRest ? 0 : rate;
                f.velocity.insert(f.velocity.end(), {speed*x, -speed*y, 0});
                f.density.push_back(
                    c.density*(1 + gravity*(columnHeight - y)/(c.soundSpeed*c.soundSpeed)));
            }
}

void addWalls(WallInput& w, const SphConfig& c, int across, int layers)
{
    const double dp = c.spacing;
    const bool three = c.dimensions == 3;
    const int length = int(std::lround(tankLength/dp)), height = int(std::lround(tankHeight/dp));
    for (int k = three ? -layers : 0; k < (three ? across + layers : 1); ++k)
        for (int j = -layers; j < height; ++j)
        {
            const bool open = j >= 0 && (!three || (k >= 0 && k < across));
            for (int i = -layers; i < length + layers; ++i)
            {
                if (open && i == 0) i = length;
                w.position.insert(
                    w.position.end(), {(i + 0.5)*dp, (j + 0.5)*dp, three ? (k + 0.5)*dp : 0});
            }
        }
    w.normal.assign(w.position.size(), 0);
}

} // namespace

DamBreakScene makeDamBreak(const SpeedOptions& o, double particles)
{
    DamBreakScene s;
    setModel(s.config, o);
    const int across = std::max(4, int(std::lround(std::pow(0.5*particles, 1.0/o.dimensions))));
    const double dp = 1.0/across;
    const int layers = int(std::ceil(2*o.ratio - 1e-9));
    s.config.spacing = s.config.wallSpacing = dp;
    const double margin = layers*dp;
    s.config.domainMin = {{-margin, -margin, -margin}};
    s.config.domainMax = {{tankLength + margin, tankHeight + margin, 1 + margin}};
    addFluid(s.fluid, s.config, across, o.atRest);
    addWalls(s.walls, s.config, across, layers);
    return s;
}

} // namespace riprap
