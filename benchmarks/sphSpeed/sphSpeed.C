/*  sphSpeed: whole time steps of a dam break, timed. See speedOptions.C for its words,
    damBreakScene.hpp for the scene, speedRow.C for what it prints, benchmarks/README.md for how it
    is meant.

    For each number of particles: build, develop, then repeats of many steps each, at most 0.05 s of
    the flow. A repeat is timed from outside, with rebuilds, time-step control and the host's part
    in it; the median of repeats counts. Repeats that together are longer than 0.05 s of the flow
    start from one saved state, so that all do the same work. Kernels are timed in one more repeat,
    since timing each launch keeps the GPU from replaying recorded steps.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "damBreakScene.hpp"
#include "speedRow.hpp"
#include "core/backend/machineLimits.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <omp.h>
#include <stdexcept>

using namespace riprap;

namespace
{

struct Timing { double seconds, cpuSeconds; std::int64_t steps, rebuilds; double timeStep; };

Timing timed(SphScene& scene, int steps)
{
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    const SphReport r = scene.advance(1e30, steps);
    const double cpuSeconds = double(std::clock() - cpu)/CLOCKS_PER_SEC;
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (r.stop != StopReason::none || r.steps != steps || !r.escaped.empty())
        throw std::runtime_error("the scene did not hold at t = " + std::to_string(r.time) + ": "
            + std::to_string(r.escaped.size()) + " particles escaped, " + std::to_string(r.steps)
            + " of " + std::to_string(steps) + " steps taken, guard " + std::to_string(int(r.stop))
            + ", value " + std::to_string(r.stopValue));
    return Timing{seconds/steps, cpuSeconds/steps, r.steps, r.rebuilds, r.lastTimeStep};
}

double median(std::vector<double> v)
{
    std::sort(v.begin(), v.end());
    const std::size_t m = v.size()/2;
    return v.size() % 2 ? v[m] : 0.5*(v[m - 1] + v[m]);
}

MachineLimits measureLimits(bool gpu, PrecisionKind precision)
{
    static std::map<std::pair<bool, PrecisionKind>, MachineLimits> known;
    const auto key = std::make_pair(gpu, precision);
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    const bool mixed = precision == PrecisionKind::mixed;
    MachineLimits m;
    m.triad = gpu ? triadBandwidth(Gpu()) : triadBandwidth(Cpu());
    if (gpu) m.fma = mixed ? fmaPeak<float>(Gpu()) : fmaPeak<double>(Gpu());
    else m.fma = mixed ? fmaPeak<float>(Cpu()) : fmaPeak<double>(Cpu());
    if (gpu && mixed) m.gather = gatherRate(Gpu());
    std::printf(
        "machine: triad %.3g B/s, multiply-adds %.3g /s (%s)", m.triad, m.fma, wordOf(precision));
    if (m.gather > 0) std::printf(", gathers %.3g neighbours/s", m.gather);
    std::printf("\n");
    return known[key] = m;
}

void addMemory(const SphScene& scene, SpeedRow& row)
{
    double fluid = 0, lists = 0;
    for (const ArrayInfo& a : scene.arrays())
    {
        row.memory += a.bytes;
        if (a.set == "fluid") fluid += a.bytes;
        if (a.set == "lists") lists += a.bytes;
    }
    row.bytes = fluid/row.fluid;
    row.bytesWithLists = (fluid + lists)/row.fluid;
}

//- Seconds and launches (times 1e6) of each kernel a step
void addKernels(SphScene& scene, int steps, SpeedRow& row)
{
    std::map<std::string, KernelInfo> before;
    for (const KernelInfo& k : scene.kernels()) before[k.name] = k;
    scene.timeKernels(true);
    timed(scene, steps);
    scene.timeKernels(false);
    for (KernelInfo k : scene.kernels())
    {
        k.seconds = (k.seconds - before[k.name].seconds)/steps;
        k.launches = std::int64_t(1e6*double(k.launches - before[k.name].launches)/steps);
        if (k.launches > 0) row.kernels.push_back(k);
    }
    std::sort(row.kernels.begin(), row.kernels.end(),
        [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
}

SpeedRow measure(const SpeedOptions& o, double particles)
{
    SpeedRow row;
    std::unique_ptr<SphScene> scene;
    {
        const DamBreakScene s = makeDamBreak(o, particles);
        row.fluid = s.fluid.size();
        row.walls = s.walls.size();
        scene = createSphScene(s.config, s.fluid, s.walls);
    }
    row.device = scene->deviceName();
    row.gpu = scene->device() == DeviceKind::gpu;
    row.threads = row.gpu ? 1 : omp_get_max_threads();
    row.limits = measureLimits(row.gpu, o.precision);
    if (o.develop) timed(*scene, o.develop);
    row.developed = scene->time();

    const Timing trial = timed(*scene, 10);
    const double longest = 0.05/trial.timeStep;
    row.steps = o.steps ? o.steps : int(std::max(10.0, std::min(longest, o.seconds/trial.seconds)));
    std::vector<std::int32_t> state;
    if (row.steps*double(o.repeat) > longest) state = scene->saveState();
    // before the first repeat: the machine at full clock, recorded steps of the right length
    const int warm = std::max(20, row.steps/4);
    if (state.empty()) timed(*scene, warm);
    std::vector<double> seconds, cpu;
    double steps = 0, rebuilds = 0;
    for (int k = 0; k < o.repeat; ++k)
    {
        if (!state.empty())
        {
            scene->loadState(state);
            timed(*scene, warm);
        }
        const Timing t = timed(*scene, row.steps);
        seconds.push_back(t.seconds);
        cpu.push_back(t.cpuSeconds);
        steps += t.steps;
        rebuilds += t.rebuilds;
        row.timeStep = t.timeStep;
    }
    row.seconds = median(seconds);
    row.cpuSeconds = median(cpu);
    row.spread = (*std::max_element(seconds.begin(), seconds.end())
                     - *std::min_element(seconds.begin(), seconds.end()))
        /row.seconds;
    row.interval = steps/std::max(1.0, rebuilds);
    row.neighbours = scene->neighboursPerParticle();
    addMemory(*scene, row);
    if (o.kernels) addKernels(*scene, std::min(row.steps, 200), row);
    return row;
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        const SpeedOptions o = readSpeedOptions(argc, argv);
        printHeader();
        for (const double particles : o.particles)
        {
            SpeedOptions named = o;
            if (named.name.empty()) named.name = std::to_string(o.dimensions) + "D";
            const SpeedRow row = measure(named, particles);
            printRow(named, row);
            appendCsv(named, row);
        }
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "sphSpeed: %s\n", e.what());
        return 1;
    }
    return 0;
}
