/*  gateSpeed: what an elastic gate costs the water that it holds: whole steps of the same scene
    with a wall, with held particles and with bonded ones in its place (gateScene.hpp), in one
    table. Medians of repeats, timed from outside; kernels in one more repeat.

        gateSpeed [-device auto|cpu|gpu] [-particles N] [-size RATIO] [-integrator
        leapfrog|symplectic] [-solids leapfrog|velocityVerlet]
                  [-coupling WORD] [-stepFraction F] [-precision mixed|double] [-develop N] [-steps
                  N] [-repeat N] [-kernels 0|1]

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "gateScene.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>

using namespace riprap;

namespace
{

template<class T>
T valueOf(const std::map<std::string, T>& words, const std::string& word)
{
    const auto found = words.find(word);
    if (found != words.end()) return found->second;
    std::string valid;
    for (const auto& w : words) valid += " " + w.first;
    throw std::invalid_argument("'" + word + "' is none of" + valid);
}

std::string oneOf(const std::vector<std::string>& words, const std::string& word)
{
    std::string valid;
    for (const std::string& w : words)
    {
        if (w == word) return word;
        valid += " " + w;
    }
    throw std::invalid_argument("'" + word + "' is none of" + valid);
}

double positive(const std::string& text)
{
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    if (used != text.size() || !(value > 0))
        throw std::invalid_argument("'" + text + "' is no positive number");
    return value;
}

GateOptions read(int argc, char** argv)
{
    GateOptions o;
    const std::map<std::string, std::function<void(const std::string&)>> switches{
        {"-device",
            [&](const std::string& s)
            {
                o.device = valueOf<DeviceKind>(
                    {{"auto", DeviceKind::automatic}, {"cpu", DeviceKind::cpu},
                        {"gpu", DeviceKind::gpu}},
                    s);
            }},
        {"-precision",
            [&](const std::string& s)
            {
                o.precision = valueOf<PrecisionKind>(
                    {{"mixed", PrecisionKind::mixed}, {"double", PrecisionKind::doubled}}, s);
            }},
        {"-integrator",
            [&](const std::string& s)
            {
                o.integrator = oneOf({"leapfrog", "symplectic"}, s);
            }},
        {"-solids",
            [&](const std::string& s)
            {
                o.solids = oneOf({"leapfrog", "velocityVerlet"}, s);
            }},
        {"-coupling",
            [&](const std::string& s)
            {
                o.coupling = oneOf({"stationary", "pressureGradient", "pressureApproximation",
                                       "extrapolated"}, s);
            }},
        {"-stepFraction", [&](const std::string& s) { o.stepFraction = positive(s); }},
        {"-particles", [&](const std::string& s) { o.particles = positive(s); }},
        {"-size", [&](const std::string& s) { o.size = positive(s); }},
        {"-develop", [&](const std::string& s) { o.develop = int(positive(s)); }},
        {"-steps", [&](const std::string& s) { o.steps = int(positive(s)); }},
        {"-repeat", [&](const std::string& s) { o.repeat = int(positive(s)); }},
        {"-kernels", [&](const std::string& s) { o.kernels = s == "1"; }}};
    for (int i = 1; i < argc; i += 2)
    {
        const auto found = switches.find(argv[i]);
        if (found == switches.end() || i + 1 == argc)
        {
            std::string valid;
            for (const auto& s : switches) valid += " " + s.first;
            throw std::invalid_argument(
                std::string(argv[i]) + ": the options, each with a value, are" + valid);
        }
        found->second(argv[i + 1]);
    }
    return o;
}

double timed(SphScene& scene, int steps, std::int64_t& rebuilds)
{
    const auto start = std::chrono::steady_clock::now();
    const SphReport r = scene.advance(1e30, steps);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (r.stop != StopReason::none || r.steps != steps)
        throw std::runtime_error("the scene did not hold at t = " + std::to_string(r.time));
    rebuilds += r.rebuilds;
    return seconds/steps;
}

void printKernels(SphScene& scene, int steps)
{
    std::map<std::string, KernelInfo> before;
    for (const KernelInfo& k : scene.kernels()) before[k.name] = k;
    if (scene.solids()) scene.solids()->timeKernels(true);
    scene.timeKernels(true);
    std::int64_t rebuilds = 0;
    timed(scene, steps, rebuilds);
    for (const KernelInfo& k : scene.kernels())
    {
        const double seconds = (k.seconds - before[k.name].seconds)/steps;
        if (k.launches > before[k.name].launches)
            std::printf("    %-24s %10.2f us %8.2f launches a step\n", k.name.c_str(),
                1e6*seconds, double(k.launches - before[k.name].launches)/steps);
    }
}

//- Particle-steps of water a second
double measure(const GateOptions& o, GateKind kind, double alone)
{
    static const char* names[] = {"wall", "held", "elastic"};
    std::unique_ptr<SphScene> scene;
    std::size_t fluid, solids, bonds;
    {
        const GateScene s = makeGate(o, kind);
        fluid = s.fluid.size();
        solids = s.solids.input.particles.size();
        bonds = s.solids.input.bonds.size();
        scene = solids ? createSphDemScene(s.config, s.fluid, s.walls, s.solids)
                       : createSphScene(s.config, s.fluid, s.walls);
    }
    std::int64_t rebuilds = 0;
    timed(*scene, o.develop, rebuilds);
    std::vector<double> seconds;
    seconds.reserve(o.repeat);
    rebuilds = 0;
    for (int k = 0; k < o.repeat; ++k) seconds.push_back(timed(*scene, o.steps, rebuilds));
    std::sort(seconds.begin(), seconds.end());
    const double step = seconds[seconds.size()/2], both = double(fluid + solids)/step;
    const int subcycles = solids ? scene->coupling().subcycles : 0;
    std::printf("%-8s %9zu %9zu %9zu %9d %10.1f %8.1f %12.4g %12.4g %8.3f %10.4g\n",
        names[int(kind)], fluid, solids, bonds, subcycles, 1e6*step,
        double(o.steps)*o.repeat/double(std::max<std::int64_t>(1, rebuilds)), fluid/step,
        both, alone > 0 ? both/alone : 1, scene->time());
    std::fflush(stdout);
    if (o.kernels) printKernels(*scene, std::min(o.steps, 50));
    return fluid/step;
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        const GateOptions o = read(argc, argv);
        std::printf("%-8s %9s %9s %9s %9s %10s %8s %12s %12s %8s %10s\n", "gate", "water", "solids",
            "bonds", "subcycles", "us/step", "rebuild", "water/s", "all/s", "of wall", "t [s]");
        const double alone = measure(o, GateKind::wall, 0);
        measure(o, GateKind::held, alone);
        measure(o, GateKind::elastic, alone);
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "gateSpeed: %s\n", e.what());
        return 1;
    }
    return 0;
}
