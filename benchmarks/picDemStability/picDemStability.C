/*  picDemStability: where solids in the water of particles in cells fail, by bisection. 2D, double precision, without viscosity.

        picDemStability [-csv FILE] [density|step|gap|speed]...

    density   least density ratio at which a disk sinks or rises without blowing up, weakly and implicitly coupled, over the step
    step      largest step, implicitly coupled, over the density ratio
    gap       least gap, in cells, with which two disks come to rest on each other and on the floor
    speed     largest speed of an impact on the floor that stays within the gap, over the stiffness

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>
#include "scene/picScene.hpp"
#include "../picStability/picRows.hpp"
#include "../stability/experiments.hpp"

using namespace riprap;

namespace
{

constexpr double g = 9.81, h = 1.0/40, radius = 5*h, level = 0.75;

struct Scene
{
    double ratio = 2.7;                     // density over the water's
    bool weak = false;
    double step = 0;                        // [s]; 0: by the Courant number
    double gap = 2;                         // [cells]
    double theta = 0.01;                    // overlap at rest [cells]
    double speed = 0;                       // downwards, at the start [m/s]
    std::vector<Vector3> at{{{0.5, 0.4, 0.5}}};
};

//- In a square tank three quarters full, on planes
std::unique_ptr<PicScene> make(const Scene& s)
{
    PicConfig c;
    c.dimensions = 2;
    c.device = DeviceKind::cpu;
    c.precision = PrecisionKind::doubled;
    c.cells[0] = c.cells[1] = int(std::lround(1/h));
    c.cells[2] = 1;
    c.domainMin = {{0, 0, 0}};
    c.domainMax = {{1, 1, 1}};
    c.cellSize = h;
    c.spacing = 0.5*h;
    c.density = 1000;
    c.gravity = {{0, -g, 0}};
    c.pressureTolerance = 1e-9;
    c.adjustTimeStep = !(s.step > 0);
    if (s.step > 0) c.fixedTimeStep = s.step;
    FluidInput water;
    for (double y = 0.25*h; y < level; y += 0.5*h)
        for (double x = 0.25*h; x < 1; x += 0.5*h) water.position.insert(water.position.end(), {x, y, 0.5});
    water.velocity.assign(water.position.size(), 0.0);

    auto solids = std::make_shared<PicSolids>();
    solids->weak = s.weak;
    DemConfig& d = solids->config;
    d.domainMin = c.domainMin;
    d.domainMax = c.domainMax;
    d.normal = NormalKind::linear;
    d.tangential = TangentialKind::history;
    DemInput& in = solids->input;
    in.materials.resize(1);
    in.pairs.resize(1);
    const double mass = 1000*s.ratio*M_PI*radius*radius;
    in.pairs[0].properties.normalStiffness = mass*g/(s.theta*h);
    in.pairs[0].properties.restitution = 0.3;
    in.pairs[0].properties.friction = 0.3;
    in.pairs[0].properties.gap = s.gap*h;
    for (const Vector3& x : s.at)
    {
        in.particles.position.insert(in.particles.position.end(), x.begin(), x.end());
        in.particles.velocity.insert(in.particles.velocity.end(), {0, -s.speed, 0});
        in.particles.radius.push_back(radius);
        in.particles.mass.push_back(mass);
    }
    for (int side = 0; side < 4; ++side)
    {
        DemWall w;
        w.plane = true;
        const int axis = side/2 ? 0 : 1;
        w.normal = {{0, 0, 0}};
        w.normal[axis] = side % 2 ? -1 : 1;
        w.point[axis] = side % 2;
        in.walls.push_back(w);
    }
    PicInside inside;
    inside.solids = solids;
    return createPicScene(c, water, PicWalls(), nullptr, std::move(inside));
}

//- Never faster than a free fall from the surface to the floor
bool sane(PicScene& s, const PicReport& r)
{
    if (r.stop != StopReason::none) return false;
    const DemState q = s.solids()->particles();
    if (q.velocity.empty()) return false;
    for (const double v : q.velocity) if (!(std::abs(v) < std::sqrt(2*g*level))) return false;
    return true;
}

//- A disk sinks or rises for `steps`
bool moves(const Scene& scene, int steps)
{
    const auto s = make(scene);
    for (int k = 0; k < steps; ++k) if (!sane(*s, s->advance(1e30, 1))) return false;
    return true;
}

const double unit = std::sqrt(h/g);         // of steps

void density(PicRows& rows)
{
    for (const bool weak : {true, false})
        for (const double step : {0.025, 0.05, 0.1, 0.2})
        {
            const auto good = [&](double ratio)
            {
                Scene s;
                s.ratio = ratio;
                s.weak = weak;
                s.step = step*unit;
                return moves(s, 60);
            };
            rows.add("density", weak ? "weak" : "implicit", step, "least density ratio, 60 steps (0.001: none found)", bisectRatio(1e-3, 100, false, good));
        }
}

void step(PicRows& rows)
{
    for (const double ratio : {0.01, 0.5, 2.7, 100.0})
    {
        const auto good = [&](double step)
        {
            Scene s;
            s.ratio = ratio;
            s.step = step*unit;
            return moves(s, std::max(10, int(std::lround(4/step))));
        };
        rows.add("step", "implicit", ratio, "largest step over sqrt(h/g), 4 sqrt(h/g)", bisectRatio(0.05, 3.2, true, good));
    }
}

void gap(PicRows& rows)
{
    for (const double theta : {0.01, 0.1})
    {
        const auto good = [&](double cells)
        {
            Scene s;
            s.gap = cells;
            s.theta = theta;
            const double pitch = 2*radius + cells*h;
            s.at = {{{0.5, radius + cells*h + 0.2*h, 0.5}}, {{0.5 + 0.2*radius, radius + cells*h + pitch + 0.4*h, 0.5}}};
            const auto scene = make(s);
            for (int k = 1; k <= 20; ++k) if (!sane(*scene, scene->advance(0.05*k))) return false;
            const std::vector<double> x = scene->solids()->particles().position;
            return x[1] > radius && x[4] > radius && std::hypot(x[3] - x[0], x[4] - x[1]) > 2*radius;
        };
        rows.add("gap", "implicit", theta, "least gap [cells], 1 s (1e9: more than 3)", bisectRatio(0.1, 3, false, good));
    }
}

void speed(PicRows& rows)
{
    for (const double theta : {0.003, 0.01, 0.03, 0.1})
    {
        const auto good = [&](double speed)
        {
            Scene s;
            s.theta = theta;
            s.speed = speed;
            s.at = {{{0.5, radius + 2*h + 0.5*h, 0.5}}};
            const auto scene = make(s);
            double lowest = 1;
            for (int k = 1; k <= 100; ++k)
            {
                const PicReport r = scene->advance(0.002*k);
                if (r.stop != StopReason::none) return false;
                const std::vector<double> x = scene->solids()->particles().position;
                if (x.empty()) return false;
                lowest = std::min(lowest, x[1] - radius);
            }
            return lowest > 0;
        };
        rows.add("speed", "implicit", theta, "largest speed of an impact that stays in the gap [m/s]", bisectRatio(0.1, 30, true, good));
    }
}

} // namespace

int main(int argc, char** argv)
{ return runExperiments<PicRows>(argc, argv, "picDemStability", {{"density", density}, {"step", step}, {"gap", gap}, {"speed", speed}}); }
