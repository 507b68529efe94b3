/*  SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "scenes.hpp"
#include <algorithm>
#include <cmath>

namespace riprap
{

namespace
{

constexpr double g = 9.81;

//- Particles in the middle of their part of a cell, below a height
template<class Height, class Velocity>
FluidInput fill(const PicConfig& c, const Height& height, const Velocity& velocity)
{
    FluidInput f;
    const int n = int(std::lround(1/c.spacing));
    for (int i = 0; i < n; ++i)
    {
        const double x = (i + 0.5)/n;
        const int rows = std::max(1, int(std::lround(height(x)/c.spacing)));
        for (int j = 0; j < rows; ++j)
        {
            const double y = (j + 0.5)*height(x)/rows;
            double v[2];
            velocity(x, y, v);
            f.position.insert(f.position.end(), {x, y, 0.5});
            f.velocity.insert(f.velocity.end(), {v[0], v[1], 0});
        }
    }
    return f;
}

void still(double, double, double* v) { v[0] = v[1] = 0; }

//- rms of particles' velocities less those of the grid where they are, and of the velocities
//  themselves
double noiseOf(PicScene& scene)
{
    const FluidState f = scene.fluid();
    const SampleResult grid = scene.sample(f.position);
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < f.velocity.size(); ++i)
    {
        if (!(grid.volumeFraction[i/3] > 0.5)) continue;
        const double d = f.velocity[i] - grid.velocity[i];
        difference += d*d;
        size += f.velocity[i]*f.velocity[i];
    }
    return size > 0 ? std::sqrt(difference/size) : 0;
}

void note(const PicReport& r, PicOutcome& o, std::int64_t& iterations)
{
    o.stopped = o.stopped || r.stop != StopReason::none;
    o.volumeError = std::max(o.volumeError, std::abs(r.volumeError));
    o.volumeDrift = std::max(o.volumeDrift, std::abs(r.volumeDrift));
    o.speed = std::max(o.speed, r.maxSpeed);
    iterations += r.pressureIterations;
}

} // namespace

PicConfig picSettings(int n)
{
    PicConfig c;
    c.device = DeviceKind::cpu;
    c.precision = PrecisionKind::doubled;
    c.cells[0] = c.cells[1] = n;
    c.cellSize = 1.0/n;
    c.spacing = 0.5*c.cellSize;
    c.gravity = {{0, -g, 0}};
    c.pressureTolerance = 1e-10;
    c.maxCourantEver = 1e3;
    return c;
}

PicOutcome vortices(PicConfig c, double turns)
{
    const auto velocity = [](double x, double y, double* v)
    {
        v[0] = -std::cos(2*M_PI*x)*std::sin(2*M_PI*y);
        v[1] = std::sin(2*M_PI*x)*std::cos(2*M_PI*y);
    };
    c.gravity = {{0, 0, 0}};
    c.periodic[0] = c.periodic[1] = true;
    if (c.seedsPerDirection > 1) c.jitter = 0.5;
    const auto scene = createPicScene(c, fill(c, [](double) { return 1.0; }, velocity), PicWalls());
    PicOutcome o;
    std::int64_t iterations = 0, steps = 0;
    const double start = scene->energy().kinetic;
    for (int k = 1; k <= 20 && !o.stopped; ++k)
    {
        const PicReport r = scene->advance(turns*k/20);
        note(r, o, iterations);
        steps = r.totalSteps;
        o.kept = scene->energy().kinetic/start;
        o.energy = std::max(o.energy, o.kept);
    }
    o.iterations = steps ? double(iterations)/steps : 0;
    if (o.stopped) return o;
    o.noise = noiseOf(*scene);
    const FluidState f = scene->fluid();
    double error = 0, size = 0;
    for (std::size_t i = 0; i < f.id.size(); ++i)
    {
        double v[2];
        velocity(f.position[3*i], f.position[3*i + 1], v);
        for (int d = 0; d < 2; ++d)
        {
            error += std::pow(f.velocity[3*i + d] - v[d], 2);
            size += v[d]*v[d];
        }
    }
    o.error = std::sqrt(error/size);
    return o;
}

PicOutcome sloshing(const PicConfig& c, double periods)
{
    const double depth = 0.5, amplitude = 0.05, k = M_PI;
    const auto scene = createPicScene(c,
        fill(
            c, [&](double x) { return depth + amplitude*std::cos(k*x); }, still),
        PicWalls());
    const double period = 2*M_PI/std::sqrt(g*k*std::tanh(k*depth)),
                 wave = 0.25*c.density*g*amplitude*amplitude;
    PicOutcome o;
    std::int64_t iterations = 0, steps = 0;
    const FluidEnergy start = scene->energy();
    for (int j = 1; j <= int(16*periods) && !o.stopped; ++j)
    {
        const PicReport r = scene->advance(period*j/16);
        note(r, o, iterations);
        steps = r.totalSteps;
        const FluidEnergy e = scene->energy();
        o.kept = 1 + (e.kinetic + e.potential - start.kinetic - start.potential)/wave;
        o.energy = std::max(o.energy, o.kept);
    }
    o.iterations = steps ? double(iterations)/steps : 0;
    if (!o.stopped) o.noise = noiseOf(*scene);
    return o;
}

PicOutcome pool(PicConfig c, double level, double floor)
{
    c.spacing = 0.05*c.cellSize;
    c.jitter = 0.9;
    PicInside inside;
    FluidInput water = fill(c, [&](double) { return (level + floor)*c.cellSize; }, still);
    if (floor > 0)
    {
        PicObstacle o;
        o.name = "floor";
        const double y = floor*c.cellSize;
        o.vertices = {-1, -1, 0, 2, -1, 0, 2, y, 0, -1, y, 0};
        o.elements = {0, 1, 1, 2, 2, 3, 3, 0};
        inside.obstacles.push_back(o);
        FluidInput above;
        for (std::size_t i = 0; i < water.size(); ++i)
            if (water.position[3*i + 1] > y)
            {
                above.position.insert(
                    above.position.end(), &water.position[3*i], &water.position[3*i] + 3);
                above.velocity.insert(above.velocity.end(), 3, 0.0);
            }
        water = above;
    }
    const auto scene = createPicScene(c, water, PicWalls(), nullptr, std::move(inside));
    PicOutcome o;
    std::int64_t iterations = 0;
    note(scene->advance(0.5), o, iterations);
    return o;
}

} // namespace riprap
