// SPDX-License-Identifier: GPL-3.0-or-later

#include "thrownBlock.hpp"

#include <algorithm>
#include <cmath>

namespace riprap
{

int ThrownBlock::layers() const { return int(std::ceil(2*ratio/wallRatio - 1e-9)); }

double ThrownBlock::duration() const { return (2*h() + 1.2*side*spacing + 4*spacing)/speed; }

void setDefaults(SphConfig& c, double alpha)
{
    c.viscosity = 1e-3;
    c.viscosityModel = "laminarAndArtificial";
    c.artificialAlpha = alpha;
    c.artificialAtWalls = false;
    c.antiClump = 0.01;
    c.diffusion = "fourtakas";
    c.integrator = "symplectic";
    c.adjustTimeStep = true;
    c.acousticCourant = 0.5;
}

void setWildRule(SphConfig& c)
{
    c.maxDensityDeviation = 0.5;
    c.maxSpeedRatio = 5;
    c.removeWild = true;
}

std::unique_ptr<SphScene> throwBlock(const ThrownBlock& b)
{
    const double dp = b.spacing, d = b.wallRatio*dp;
    SphConfig c;
    c.device = DeviceKind::cpu;
    c.spacing = dp;
    c.wallSpacing = d;
    c.smoothingRatio = b.ratio;
    c.kernel = b.kernel;
    c.density = b.density;
    c.soundSpeed = b.soundSpeed;
    c.maxVelocity = 0.1*b.soundSpeed;
    c.viscosityModel = b.artificial > 0 ? "artificial" : "none";
    c.artificialAlpha = b.artificial;
    c.wallModel = b.walls;
    c.integrator = b.integrator;
    c.adjustTimeStep = b.timeStep <= 0;
    c.fixedTimeStep = b.timeStep;
    if (b.forceLimit) { c.acousticCourant = 1e9; c.forceCourant = 1; }
    c.maxDensityDeviation = 1e3;
    c.maxSpeedRatio = 1e9;

    if (b.defaults) { setDefaults(c, b.artificial); c.acousticCourant = b.courant; }
    if (b.wildRule) setWildRule(c);

    const double half = b.floorHalf(), below = b.thickness() + 10*dp;
    c.domainMin = {{-half, -below, 0}};
    c.domainMax = {{half, (4*b.side + 40)*dp, 1}};

    FluidInput f;
    for (int j = 0; j < b.side; ++j)
        for (int i = 0; i < b.side; ++i)
        {
            f.position.insert(f.position.end(),
                {(i + 0.5 - 0.5*b.side)*dp + b.offset*d, 2*b.h() + (j + 0.5)*dp, 0});
            f.velocity.insert(f.velocity.end(), {0, -b.speed, 0});
            f.density.push_back(c.density);
        }
    WallInput w;
    const int across = int(half/d) - 1;
    for (int j = 1; j <= b.layers(); ++j)
        for (int i = -across; i < across; ++i)
            w.position.insert(w.position.end(), {(i + 0.5)*d, (0.5 - j)*d, 0});
    w.normal.assign(w.position.size(), 0);
    if (b.impermeable)
    {
        w.faces.point = {-half, 0, 0, half, 0, 0};
        w.faces.vertex = {0, 1, -1};
        w.faces.normal = {0, 1, 0};
        w.faces.body = {-1};
        w.faces.part = {0};
        w.faces.halfThickness = {0};
    }
    return createSphScene(c, f, w);
}

double depth(SphScene& scene, const SphReport& report, const ThrownBlock& b)
{
    double lowest = 1e30;
    const auto see = [&](double x, double y)
    {
        if (std::abs(x) < b.floorHalf() - 4*b.h()) lowest = std::min(lowest, y);
    };
    const FluidState s = scene.fluid();
    for (std::size_t i = 0; i < s.id.size(); ++i) see(s.position[3*i], s.position[3*i + 1]);
    for (const Vector3& x : report.escaped) see(x[0], x[1]);
    return -lowest;
}

} // namespace riprap
