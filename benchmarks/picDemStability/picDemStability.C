/*  picDemStability: where solids in the water of particles in cells fail, by bisection. 2D, without
    viscosity, double precision; the last four mixed.

        picDemStability [-csv FILE] [density|step|gap|speed|subcycles|size|thin|shapes]...

    density   least density ratio at which a disk sinks or rises without blowing up, weakly and
              implicitly coupled, over the step
    step      largest step, implicitly coupled, over the density ratio
    gap       least gap, in cells, with which two disks come to rest on each other and on the floor
    speed     largest speed of an impact on the floor that stays within the gap, over the stiffness
    subcycles largest step of the solids with which two disks that meet bounce as with short steps,
    over their speed
    size      disks of few cells: force of the first step, least size that sinks to the floor, heaps
              of several in a cell without a gap
    thin      largest speed at which two disks, or one and the floor, stay apart, over the gap
    shapes    lightest disk, square and barge that float, with and without `reflection`; largest
              speed at which flat bottoms enter

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>
#include "api/picScene.hpp"
#include "../picStability/picRows.hpp"
#include "../stability/experiments.hpp"
#include "shapes.hpp"

using namespace riprap;

namespace
{

constexpr double g = 9.81, h = 1.0/40, radius = 5*h, level = 0.75;
const double unit = std::sqrt(h/g);         // of steps

struct Scene
{
    double ratio = 2.7;                     // density over the water's
    bool weak = false;
    double step = 0;                        // [s]; 0: by the Courant number
    double gap = 2;                         // [cells]
    double theta = 0.01;                    // overlap at rest [cells]
    double speed = 0;                       // downwards, at the start [m/s]
    std::vector<Vector3> at{{{0.5, 0.4, 0.5}}};
    std::vector<Vector3> velocity;          // else as `speed` says
    double size = radius;                   // radius of all [m]
    double fraction = 0.2;                  // step of the solids over sqrt(m/k)
    double restitution = 0.3;
    bool heavy = true;                      // is there gravity?
    bool mixed = false;
};

//- In a square tank three quarters full, on planes
std::unique_ptr<PicScene> make(const Scene& s)
{
    PicConfig c;
    c.dimensions = 2;
    c.device = DeviceKind::cpu;
    c.precision = s.mixed ? PrecisionKind::mixed : PrecisionKind::doubled;
    c.cells[0] = c.cells[1] = int(std::lround(1/h));
    c.cells[2] = 1;
    c.domainMin = {{0, 0, 0}};
    c.domainMax = {{1, 1, 1}};
    c.cellSize = h;
    c.spacing = 0.5*h;
    c.density = 1000;
    c.gravity = {{0, s.heavy ? -g : 0, 0}};
    c.pressureTolerance = s.mixed ? 1e-8 : 1e-9;
    c.adjustTimeStep = !(s.step > 0);
    if (s.step > 0) c.fixedTimeStep = s.step;
    FluidInput water;
    for (double y = 0.25*h; y < level; y += 0.5*h)
        for (double x = 0.25*h; x < 1; x += 0.5*h)
            water.position.insert(water.position.end(), {x, y, 0.5});
    water.velocity.assign(water.position.size(), 0.0);

    auto solids = std::make_shared<PicSolids>();
    solids->weak = s.weak;
    DemConfig& d = solids->config;
    d.domainMin = c.domainMin;
    d.domainMax = c.domainMax;
    d.normal = "linear";
    d.tangential = "history";
    d.stepFraction = s.fraction;
    d.allowLargeStep = true;
    DemInput& in = solids->input;
    in.materials.resize(1);
    in.pairs.resize(1);
    const double mass = 1000*s.ratio*M_PI*s.size*s.size;
    in.pairs[0].properties.normalStiffness = mass*g/(s.theta*h);
    in.pairs[0].properties.restitution = s.restitution;
    in.pairs[0].properties.friction = 0.3;
    in.pairs[0].properties.gap = s.gap*h;
    for (std::size_t i = 0; i < s.at.size(); ++i)
    {
        const Vector3 v = s.velocity.empty() ? Vector3{{0, -s.speed, 0}} : s.velocity[i];
        in.particles.position.insert(in.particles.position.end(), s.at[i].begin(), s.at[i].end());
        in.particles.velocity.insert(in.particles.velocity.end(), v.begin(), v.end());
        in.particles.radius.push_back(s.size);
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
            rows.add("density", weak ? "weak" : "implicit", step,
                "least density ratio, 60 steps (0.001: none found)",
                bisectRatio(1e-3, 100, false, good));
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
        rows.add("step", "implicit", ratio, "largest step over sqrt(h/g), 4 sqrt(h/g)",
            bisectRatio(0.05, 3.2, true, good));
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
            s.at = {{{0.5, radius + cells*h + 0.2*h, 0.5}},
                {{0.5 + 0.2*radius, radius + cells*h + pitch + 0.4*h, 0.5}}};
            const auto scene = make(s);
            for (int k = 1; k <= 20; ++k) if (!sane(*scene, scene->advance(0.05*k))) return false;
            const std::vector<double> x = scene->solids()->particles().position;
            return x[1] > radius && x[4] > radius
                && std::hypot(x[3] - x[0], x[4] - x[1]) > 2*radius;
        };
        rows.add("gap", "implicit", theta, "least gap [cells], 1 s (1e9: more than 3)",
            bisectRatio(0.1, 3, false, good));
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
        rows.add("speed", "implicit", theta,
            "largest speed of an impact that stays in the gap [m/s]",
            bisectRatio(0.1, 30, true, good));
    }
}

//- Two disks under water meet half-way, without gravity, which would take them elsewhere
struct Meeting
{
    bool stopped = false;                   // or numbers that are none
    // distance of their surfaces, as seen after steps of the water [m]
    double nearest = 1e9;
    // speed at which they come when contact begins, and at which they go when they have parted for
    // six steps and the water has settled [m/s]
    double before = 0, after = 0;
    double mean = 0;                        // of after/before, of all phases
    int subcycles = 0;                      // most in a step of the water
};

Meeting meet(Scene s, double speed, int phase)
{
    const double reach = 2*radius + s.gap*h, half = 0.5*(reach + (1 + 0.1*phase)*h);
    s.at = {{{0.5 - half, 0.4, 0.5}}, {{0.5 + half, 0.4, 0.5}}};
    s.heavy = false;
    s.step = std::min(0.4*h/speed, 0.2*unit);       // not as water at rest would have it
    s.velocity = {{{0.5*speed, 0, 0}}, {{-0.5*speed, 0, 0}}};
    const auto scene = make(s);
    Meeting m;
    const double end = 40*h/speed + 4*M_PI*std::sqrt(s.theta*h/g);
    bool met = false;
    for (int parted = 0, k = 0; parted < 6 && k*s.step < end; ++k)
    {
        const PicReport r = scene->advance(1e30, 1);
        const DemState q = scene->solids()->particles();
        if (r.stop != StopReason::none || q.position.size() < 6
            || !std::isfinite(q.position[0] + q.position[3] + q.velocity[0] + q.velocity[3]))
        {
            m.stopped = true;
            return m;
        }
        const double d = std::hypot(q.position[3] - q.position[0], q.position[4] - q.position[1]),
                     closing = q.velocity[0] - q.velocity[3];
        const bool inside = d < reach;
        // have they changed places?
        m.nearest = std::min(m.nearest, q.position[3] > q.position[0] ? d - 2*radius : -1.0);
        met = met || inside || closing < 0;
        if (!met) m.before = closing;
        m.after = -closing;
        if (met && !inside) ++parted;
        m.subcycles = std::max(m.subcycles, scene->coupling().subcycles);
    }
    return m;
}

//- Of several phases of contact in a step of the water: the worst
Meeting meet(const Scene& s, double speed)
{
    Meeting worst;
    double gain = -1;
    for (int phase = 0; phase < 5; ++phase)
    {
        const Meeting m = meet(s, speed, phase);
        if (m.stopped || !(m.before > 0)) { worst.stopped = true; return worst; }
        worst.nearest = std::min(worst.nearest, m.nearest);
        worst.subcycles = std::max(worst.subcycles, m.subcycles);
        worst.mean += m.after/m.before/5;
        if (m.after/m.before > gain)
        {
            gain = m.after/m.before;
            worst.before = m.before;
            worst.after = m.after;
        }
    }
    return worst;
}

//- Elastic, so that nothing but steps takes or gives energy; the stiffer the contacts are, the more
//  steps they need in one of the water, which is 0.4 cells over the speed
void subcycles(PicRows& rows)
{
    for (const double theta : {0.01, 1e-3, 1e-4})
        for (const double speed : {0.5, 1.0, 2.0, 4.0})
        {
            Scene s;
            s.theta = theta;
            s.restitution = 1;
            s.mixed = true;
            s.fraction = 0.01;
            const Meeting fine = meet(s, speed);
            const std::string kind = "overlap at rest "
                + std::string(theta > 5e-3 ? "0.01"
                        : theta > 5e-4 ? "0.001"
                                           : "0.0001")
                + " cells";
            rows.add("subcycles", kind, speed,
                "speed after over before, steps of 0.01 sqrt(m/k), mean of five phases (1e9: "
                "stops)",
                fine.stopped ? 1e9 : fine.mean);
            int fewest = fine.subcycles;
            const auto good = [&](double fraction)
            {
                Scene t = s;
                t.fraction = fraction;
                const Meeting m = meet(t, speed);
                const bool held = !m.stopped && m.nearest > 0 && m.after <= 1.05*m.before;
                if (held) fewest = std::min(fewest, m.subcycles);
                return held;
            };
            rows.add("subcycles", kind, speed,
                "largest step over sqrt(m/k) that keeps them apart and parts them no faster than "
                "1.05 times as they came (3.2: none found)",
                bisectRatio(0.02, 3.2, true, good));
            rows.add("subcycles", kind, speed, "steps in one of the water with it", fewest);
        }
}

//- Of the first step from rest in a round tank full of water against the added mass of concentric
//  circles (Lamb, Hydrodynamics, 68): rms over places in a cell
double startError(double across, double ratio)
{
    const int n = 60;
    const double cell = 1.0/n, R = 0.45, a = 0.5*across*cell, dt = 1e-3,
                 C = (R*R + a*a)/(R*R - a*a), theory = (ratio - 1)/(ratio + C)*g;
    PicObstacle tank;
    tank.name = "tank";
    tank.solidOutside = true;
    for (int i = 0; i < 400; ++i)
    {
        tank.vertices.insert(tank.vertices.end(),
            {0.5 + R*std::cos(2*M_PI*i/400), 0.5 + R*std::sin(2*M_PI*i/400), 0});
        tank.elements.insert(tank.elements.end(), {i, (i + 1) % 400});
    }
    double sum = 0;
    int places = 0;
    for (const double x : {0.0, 0.23, 0.5})
        for (const double y : {0.0, 0.31, 0.5})
        {
            PicConfig c;
            c.dimensions = 2;
            c.device = DeviceKind::cpu;
            c.precision = PrecisionKind::mixed;
            c.cells[0] = c.cells[1] = n;
            c.cells[2] = 1;
            c.domainMax = {{1, 1, 1}};
            c.cellSize = cell;
            c.spacing = cell;
            c.density = 1000;
            c.gravity = {{0, -g, 0}};
            c.seedsPerDirection = 1;
            c.adjustTimeStep = false;
            c.fixedTimeStep = dt;
            c.pressureTolerance = 1e-9;
            FluidInput water;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    water.position.insert(
                        water.position.end(), {(i + 0.5)*cell, (j + 0.5)*cell, 0.5});
            water.velocity.assign(water.position.size(), 0.0);
            auto solids = std::make_shared<PicSolids>();
            solids->config.domainMin = c.domainMin;
            solids->config.domainMax = c.domainMax;
            solids->config.normal = "linear";
            DemInput& in = solids->input;
            in.materials.resize(1);
            in.pairs.resize(1);
            in.pairs[0].properties.normalStiffness = 1e6;
            in.particles.position = {0.5 + x*cell, 0.5 + y*cell, 0.5};
            in.particles.radius = {a};
            in.particles.mass = {1000*ratio*M_PI*a*a};
            PicInside inside;
            inside.solids = solids;
            inside.obstacles.push_back(tank);
            const auto s = createPicScene(c, water, PicWalls(), nullptr, std::move(inside));
            const PicReport r = s->advance(dt);
            const std::vector<double> v = s->solids()->particles().velocity;
            if (r.stop != StopReason::none || v.empty()) return 1e9;
            sum += std::pow((-v[1]/dt - theory)/theory, 2);
            ++places;
        }
    return std::sqrt(sum/places);
}

//- A heap of disks that touch sinks on the floor and falls apart; how far two of them, or one and
//  the floor, come into the gap, over the gap; without one over the diameter; 1e9: stopped
double heap(double across, double gap)
{
    Scene s;
    s.mixed = true;
    s.size = 0.5*across*h;
    s.gap = gap;
    s.at.clear();
    const double reach = 2*s.size + gap*h, pitch = 1.001*reach, lowest = s.size + gap*h;
    for (int row = 0; row < 4; ++row)
        for (int k = 0; k < 4 - row; ++k)
            s.at.push_back({{0.5 + (k - 0.5*(3 - row))*pitch,
                lowest + 0.01*h + row*pitch*std::sqrt(0.75), 0.5}});
    const auto scene = make(s);
    double most = 0;
    for (int k = 1; k <= 100; ++k)
    {
        if (!sane(*scene, scene->advance(0.01*k))) return 1e9;
        const std::vector<double> x = scene->solids()->particles().position;
        if (x.size() < 3*s.at.size()) return 1e9;
        for (std::size_t i = 0; i < x.size(); i += 3)
        {
            most = std::max(most, lowest - x[i + 1]);
            for (std::size_t j = 0; j < i; j += 3)
                most = std::max(most, reach - std::hypot(x[i] - x[j], x[i + 1] - x[j + 1]));
        }
    }
    return most/(gap > 0 ? gap*h : 2*s.size);
}

void size(PicRows& rows)
{
    for (const double ratio : {0.01, 2.7})
        for (const double across : {16.0, 8.0, 6.0, 4.0, 3.0, 2.0, 1.0, 0.5})
            rows.add("size", ratio < 1 ? "start, density ratio 0.01" : "start, density ratio 2.7",
                across, "error of the first acceleration, rms over nine places; 1e9: stops",
                startError(across, ratio));
    for (const double ratio : {0.5, 2.7})
    {
        const auto good = [&](double across)
        {
            Scene s;
            s.mixed = true;
            s.ratio = ratio;
            s.size = 0.5*across*h;
            const auto scene = make(s);
            for (int k = 1; k <= 100; ++k) if (!sane(*scene, scene->advance(0.01*k))) return false;
            return true;
        };
        rows.add("size", "moves", ratio,
            "least cells across that sinks or rises for 1 s (0.5: none found)",
            bisectRatio(0.5, 8, false, good));
    }
    for (const double gap : {0.0, 0.5, 2.0})
        for (const double across : {8.0, 4.0, 3.0, 2.0, 1.0, 0.5})
            rows.add("size",
                gap > 1 ? "ten in a heap, gap 2"
                    : gap > 0 ? "ten in a heap, gap 0.5"
                              : "ten in a heap, gap 0",
                across,
                gap > 0 ? "most that is used of the gap in 1 s; 1e9: stops"
                        : "largest overlap over the diameter in 1 s; 1e9: stops",
                heap(across, gap));
}

void thin(PicRows& rows)
{
    for (const bool pair : {false, true})
        for (const double cells : {2.0, 1.0, 0.5, 0.25, 0.1})
        {
            const auto good = [&](double speed)
            {
                Scene s;
                s.mixed = true;
                s.gap = cells;
                if (pair)
                {
                    const Meeting m = meet(s, speed);
                    return !m.stopped && m.nearest > 0;
                }
                s.speed = speed;
                s.at = {{{0.5, radius + (cells + 0.5)*h, 0.5}}};
                const auto scene = make(s);
                double lowest = 1;
                for (int k = 1; k <= 60; ++k)
                {
                    const PicReport r = scene->advance(0.002*k);
                    const std::vector<double> x = scene->solids()->particles().position;
                    if (r.stop != StopReason::none || x.empty()) return false;
                    lowest = std::min(lowest, x[1] - radius);
                }
                return lowest > 0;
            };
            rows.add("thin", pair ? "two disks" : "disk and floor", cells,
                "largest speed that stays in the gap [m/s]", bisectRatio(0.05, 40, true, good));
        }
}

//- Half a second; never faster than twice what it came with, or a fall through the tank
bool floats(const Floater& f, double ratio, double above, double speed, bool reflection)
{
    const auto s = floaterScene(f, ratio, above, speed, reflection);
    for (int k = 1; k <= 25; ++k)
    {
        if (s->advance(0.02*k).stop != StopReason::none) return false;
        const DemState q = s->solids()->particles();
        if (q.velocity.empty()) return false;
        for (const double v : q.velocity)
            if (!(std::abs(v) < 2*speed + std::sqrt(2*g))) return false;
    }
    return true;
}

void shapes(PicRows& rows)
{
    for (const bool reflection : {true, false})
        for (const Floater& f : floaters)
            rows.add("shapes",
                std::string(f.name) + (reflection ? ", reflection" : ", no reflection"), f.half[1],
                "least density ratio that floats for 0.5 s, half out at the start (0.001: none "
                "found)",
                bisectRatio(1e-3, 1, false,
                    [&](double ratio) { return floats(f, ratio, 0, 0, reflection); }));
    for (const Floater& f : floaters)
        for (const double ratio : {0.1, 1.0})
            rows.add("shapes", std::string(f.name) + ", enters", ratio,
                "largest speed at which it enters the water [m/s] (30: none found)",
                bisectRatio(0.5, 30, true,
                    [&](double speed) {
                        return floats(f, ratio, (f.turn > 0.5 ? 1.5 : 1)*f.half[1]*h + 0.3*h,
                            speed, true);
                    }));
}

} // namespace

int main(int argc, char** argv)
{
    return runExperiments<PicRows>(argc, argv, "picDemStability",
        {{"density", density}, {"step", step}, {"gap", gap}, {"speed", speed},
            {"subcycles", subcycles}, {"size", size}, {"thin", thin}, {"shapes", shapes}});
}
