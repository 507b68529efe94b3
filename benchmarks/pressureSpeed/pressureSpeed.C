/*  Times one pressure step of PIC (equation, solution to a tolerance, projection) with riprap's
    multigrid.

        pressureSpeed [-device cpu|gpu] [-scene wavy|spray|tank|baffles] [-cells NX,NY[,NZ]] [-box
        N] [-precision mixed|double]
                      [-tolerance 1e-8] [-repeats 5] [-phases]

    Prints a line of CSV: scene,D,cells,wet,pocketCells,precision,device,
    tolerance,iterations,residual,bestMs,medianMs,processorMs,repeats (processorMs: of all threads,
    which other programs on the machine disturb less). With -phases each kernel is timed by itself
    (on the GPU this needs a synchronisation a launch, so that the sum is no step's time).

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cstdio>
#include <cstring>
#include <exception>
#include "core/backend/device.hpp"
#include "pressureSpeed.hpp"

namespace
{

using namespace riprap;

[[noreturn]] void usage(const std::string& why)
{
    std::fprintf(stderr,
        "pressureSpeed: %s\n"
        "pressureSpeed [-device cpu|gpu] [-scene wavy|spray|tank|baffles] [-cells NX,NY[,NZ]] "
        "[-box N] [-precision mixed|double]"
        " [-tolerance 1e-8] [-repeats 5] [-phases]\n",
        why.c_str());
    std::exit(2);
}

bool read(int argc, char** argv, SpeedCase& c)
{
    bool gpu = false;
    for (int i = 1; i < argc; ++i)
    {
        const std::string option = argv[i];
        if (option == "-phases") { c.phases = true; continue; }
        if (i + 1 >= argc) usage("'" + option + "' needs a value, or is unknown");
        const std::string value = argv[++i];
        if (option == "-device" && (value == "cpu" || value == "gpu")) gpu = value == "gpu";
        else if (option == "-scene") c.scene = value;
        else if (option == "-cells")
        {
            c.dimensions = std::sscanf(value.c_str(), "%d,%d,%d", &c.n[0], &c.n[1], &c.n[2]);
            if (c.dimensions < 2 || c.n[0] < 1 || c.n[1] < 1 || (c.dimensions == 3 && c.n[2] < 1))
                usage("-cells needs two or three numbers");
        }
        else if (option == "-box") c.box = std::atoi(value.c_str());
        else if (option == "-precision" && (value == "mixed" || value == "double"))
            c.mixed = value == "mixed";
        else if (option == "-tolerance") c.tolerance = std::atof(value.c_str());
        else if (option == "-repeats") c.repeats = std::atoi(value.c_str());
        else usage(std::string("unknown option or value: ").append(option + " ").append(value));
    }
    if (c.box < 1 || c.repeats < 1) usage("-box and -repeats must be 1 or more");
    return gpu;
}

SpeedRow time(bool gpu, const SpeedCase& c)
{
    if (!gpu) return timePressure(Cpu{}, c);
#ifdef RIPRAP_CUDA
    std::string why;
    if (!gpuCount(why)) usage("no GPU: " + why);
    return timePressure(Gpu{}, c);
#else
    usage("built without CUDA");
#endif
}

} // namespace

int main(int argc, char** argv)
{
    SpeedCase c;
    const bool gpu = read(argc, argv, c);
    try
    {
        const SpeedRow r = time(gpu, c);
        std::printf("%s,%d,%d,%d,%d,%s,%s,%g,%d,%.2e,%.4f,%.4f,%.4f,%s\n", c.scene.c_str(),
            c.dimensions, r.cells, r.wet, r.pocketCells, c.mixed ? "mixed" : "double",
            r.device.c_str(), c.tolerance, r.iterations, r.residual, 1e3*r.best, 1e3*r.median,
            1e3*r.processor, r.repeats ? "yes" : "NO");
        for (std::size_t k = 0; k < r.phases.size(); ++k)
            std::printf("    %-24s %10.4f ms  %lld launches\n", r.phases[k].first.c_str(),
                1e3*r.phases[k].second, r.launches[k]);
        return r.repeats ? 0 : 1;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "pressureSpeed: %s\n", e.what());
        return 1;
    }
}
