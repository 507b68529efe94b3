/*  sceneCounts: what a step of small scenes takes, and of the same scenes with one thing less, on
    one thread of the CPU.

        sceneCounts [-steps N] [-blocks N] [sphDem|picDem|dem]...

    A line a scene: solver, scene, what is left out, particles (picDem: cells), kernels a step
    (loops over them), fields held, bytes a particle, processor time a step [us], the same over that
    of the scene itself, what the scene has, the kernels that it has run since it was made
    (name=launches a step) and its
    fields (set.name=bytes). Times: both scenes in turn, -blocks times -steps steps; the median of
    the ratios. -blocks 0: counts alone.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <omp.h>
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

Counts count(CountedScene& s, int steps)
{
    std::map<std::string, std::int64_t> before;
    for (const KernelInfo& k : s.kernels()) before[k.name] = k.launches;
    take(s, steps);
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

//- A scene, and those with one thing less
void run(const std::vector<Row>& rows, int steps, int blocks)
{
    std::unique_ptr<CountedScene> whole;
    for (const Row& r : rows)
    {
        auto scene = std::make_unique<CountedScene>(r.make());
        take(*scene, steps);
        const Counts c = count(*scene, steps);
        std::vector<double> times, ratios;
        for (int b = 0; b < blocks; ++b)
        {
            const double own = seconds(*scene, steps),
                         of = r.without.empty() ? own : seconds(*whole, steps);
            times.push_back(own);
            ratios.push_back(own/of);
        }
        print(r, *scene, c, median(times), median(ratios));
        if (r.without.empty()) whole = std::move(scene);
    }
}

} // namespace

int main(int argc, char* argv[])
{
    int steps = 20, blocks = 0;
    std::vector<std::string> asked;
    for (int i = 1; i < argc; ++i)
    {
        const bool more = i + 1 < argc;
        if (more && !std::strcmp(argv[i], "-steps")) steps = std::max(1, std::atoi(argv[++i]));
        else if (more && !std::strcmp(argv[i], "-blocks"))
            blocks = std::max(0, std::atoi(argv[++i]));
        else asked.emplace_back(argv[i]);
    }
    if (asked.empty()) asked = {"sphDem", "picDem", "dem"};
    omp_set_num_threads(1);
    std::printf("solver,scene,without,items,kernels,fields,bytes,time,timeRatio,has,kernelList,"
                "fieldList\n");
    try
    {
        for (const std::string& solver : asked)
        {
            if (solver == "sphDem") run(sphRows(), steps, blocks);
            else if (solver == "picDem") run(picRows(), steps, blocks);
            else if (solver == "dem") run(demRows(), steps, blocks);
            else
            {
                std::fprintf(stderr,
                    "sceneCounts: unknown %s; valid are -steps N, -blocks N, sphDem, picDem, dem\n",
                    solver.c_str());
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
