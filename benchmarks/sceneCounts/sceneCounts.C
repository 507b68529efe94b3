/*  sceneCounts: what a step of small scenes takes, and of the same scenes with one thing less, on
    one thread of the CPU.

        sceneCounts [-steps N] [-blocks N] [-scene NAME] [-without THING] [sphDem|picDem|dem]...

    A line a scene: solver, scene, what is left out, particles (picDem: cells), kernels a step
    (loops over them), fields held, bytes a particle, processor time a step [us], the same over that
    of the scene itself, what the scene has, the kernels that it has run since it was made
    (name=launches a step) and its fields (set.name=bytes). Times: both scenes in turn, -blocks
    times -steps steps; the median of the ratios. -blocks 0: counts alone. -scene: this one alone,
    with those that lack something. -without: the scenes without this alone.

    Under valgrind's callgrind the steps that are counted are dumped, a file a line
    (benchmarks/pages/instructions.py), if its header was there when this was compiled.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <omp.h>
#if __has_include(<valgrind/callgrind.h>)
    #include <valgrind/callgrind.h>
    #define COUNTS_INSTRUCTIONS
#endif
#include "countedScene.hpp"

using namespace riprap;

namespace
{

struct Counts
{
    std::map<std::string, double> kernels;          // launches a step
    std::map<std::string, std::size_t> fields;      // bytes
    double launches = 0;
    std::size_t bytes = 0;
};

void take(CountedScene& s, int steps)
{
    if (!s.logging) return s.advance(steps);
    for (int k = 0; k < steps; ++k)
    {
        s.advance(1);
        if (s.sampling) s.sample();
    }
}

//- Under callgrind, which then writes how many instructions they took
void countedSteps(CountedScene& s, int steps)
{
#ifdef COUNTS_INSTRUCTIONS
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    take(s, steps);
    CALLGRIND_DUMP_STATS;
    CALLGRIND_STOP_INSTRUMENTATION;
#else
    take(s, steps);
#endif
}

Counts count(CountedScene& s, int steps)
{
    std::map<std::string, std::int64_t> before;
    for (const KernelInfo& k : s.kernels()) before[k.name] = k.launches;
    countedSteps(s, steps);
    Counts c;
    for (const KernelInfo& k : s.kernels())
    {
        const double each = double(k.launches - before[k.name])/steps;
        c.kernels[k.name] += each;
        c.launches += each;
    }
    for (const ArrayInfo& a : s.arrays())
    {
        c.fields[a.set + "." + a.name] += a.bytes;
        c.bytes += a.bytes;
    }
    return c;
}

double seconds(CountedScene& s, int steps)
{
    const auto now = []
    {
        timespec t;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return double(t.tv_sec) + 1e-9*double(t.tv_nsec);
    };
    const double start = now();
    take(s, steps);
    return (now() - start)/steps;
}

double median(std::vector<double> v)
{
    std::sort(v.begin(), v.end());
    return v.empty() ? 0 : 0.5*(v[(v.size() - 1)/2] + v[v.size()/2]);
}

void print(const Row& r, const CountedScene& s, const Counts& c, double time, double ratio)
{
    std::printf("%s,%s,%s,%zu,%.4g,%zu,%.4g,%.4g,%.4g,", r.solver.c_str(), r.scene.c_str(),
        r.without.c_str(), s.items, c.launches, c.fields.size(), double(c.bytes)/double(s.items),
        1e6*time, ratio);
    const char* separator = "";
    for (const std::string& name : r.has)
    {
        std::printf("%s%s", separator, name.c_str());
        separator = ";";
    }
    std::printf(",\"");
    separator = "";
    for (const auto& k : c.kernels)
    {
        std::printf("%s%s=%.4g", separator, k.first.c_str(), k.second);
        separator = ";";
    }
    std::printf("\",\"");
    separator = "";
    for (const auto& f : c.fields)
    {
        std::printf("%s%s=%zu", separator, f.first.c_str(), f.second);
        separator = ";";
    }
    std::printf("\"\n");
    std::fflush(stdout);
}

struct Options
{
    int steps = 20, blocks = 0;
    std::string scene, without;                     // empty: all
    std::vector<std::string> solvers;
};

//- A scene, and those with one thing less
void run(const std::vector<Row>& rows, const Options& o)
{
    const int steps = o.steps, blocks = o.blocks;
    std::unique_ptr<CountedScene> whole;
    for (const Row& r : rows)
    {
        if (!o.scene.empty() && r.scene != o.scene) continue;
        // times are measured beside the whole scene
        const bool wanted = o.without.empty() || r.without == o.without;
        if (!wanted && !(blocks && r.without.empty())) continue;
        auto scene = std::make_unique<CountedScene>(r.make());
        take(*scene, steps + scene->before);
        if (scene->ready) scene->ready();
        const Counts c = count(*scene, steps);
        std::vector<double> times, ratios;
        for (int b = 0; b < blocks; ++b)
        {
            const double own = seconds(*scene, steps),
                         of = r.without.empty() ? own : seconds(*whole, steps);
            times.push_back(own);
            ratios.push_back(own/of);
        }
        if (wanted) print(r, *scene, c, median(times), median(ratios));
        if (r.without.empty()) whole = std::move(scene);
    }
}

} // namespace

int main(int argc, char* argv[])
{
    Options o;
    for (int i = 1; i < argc; ++i)
    {
        const bool more = i + 1 < argc;
        if (more && !std::strcmp(argv[i], "-steps")) o.steps = std::max(1, std::atoi(argv[++i]));
        else if (more && !std::strcmp(argv[i], "-blocks"))
            o.blocks = std::max(0, std::atoi(argv[++i]));
        else if (more && !std::strcmp(argv[i], "-scene")) o.scene = argv[++i];
        else if (more && !std::strcmp(argv[i], "-without")) o.without = argv[++i];
        else o.solvers.emplace_back(argv[i]);
    }
    if (o.solvers.empty()) o.solvers = {"sphDem", "picDem", "dem"};
    omp_set_num_threads(1);
    std::printf("solver,scene,without,items,kernels,fields,bytes,time,timeRatio,has,kernelList,"
                "fieldList\n");
    try
    {
        for (const std::string& solver : o.solvers)
        {
            if (solver == "sphDem") run(sphRows(), o);
            else if (solver == "picDem") run(picRows(), o);
            else if (solver == "dem") run(demRows(), o);
            else
            {
                std::fprintf(stderr, "sceneCounts: unknown %s; valid are -steps N, -blocks N, "
                    "-scene NAME, -without THING, sphDem, picDem, dem\n", solver.c_str());
                return 1;
            }
        }
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "sceneCounts: %s\n", e.what());
        return 1;
    }
    return 0;
}
