/*  demSpeed: particle-steps a second of the collapse of a granular column, or of a block of bonded
    particles (columnScene.hpp), rebuilds included.

        demSpeed [--device cpu|gpu|auto] [--precision mixed|double] [--steps N] [--warmUp N]
        [--copies N] [--rolling] [--ratio R] [--triangles]
                 [--bonded SIDE] [--held] [--sleep SPEED] [--skin S] [--bed FILE] [--write FILE]
                 [--profile]

    Prints a line a run: time by the clock and by the processor, kinetic energy and contacts a
    particle at the end. 1200 steps are 24 ms: LAMMPS has 0.1960 J a bed then, LIGGGHTS 0.1938 J.
    --held keeps the bed at rest by a wall, --sleep lets who is slower sleep after 5 ms: begin the
    timing after that with --warmUp. --write leaves the bed as it is at the end: with --held --ratio
    3 and 150,000 steps it is a settled bed of unequal spheres for --bed. A second line says what a
    step must move of a particle at the least, by count, each array once (records, forces of bonds,
    lists, histories of what touches), and which share of the machine's measured bandwidth (triad)
    the run reaches by that count.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <omp.h>
#include "columnScene.hpp"
#include "core/backend/machineLimits.hpp"

namespace
{

using namespace riprap;

struct Options
{
    DemConfig config;
    ColumnOptions column;
    std::int64_t steps = 1200, warmUp = 50;
    std::string bed = "settledBed.xyz.gz", written;
    int bonded = 0;             // particles along a side of the block; 0: the column
    bool profile = false;
};

//- Bytes a particle-step, by count; rebuilds left out
double bytesMoved(const Options& o, bool gpu, double listed, double contacts, double bonds)
{
    const double real = o.config.precision == PrecisionKind::mixed ? 4 : 8;
    // 3D records: position, radius | velocity, mass | spin, material
    const double records = 12*real, reference = 3*real;
    const double history = o.bonded ? 0 : (o.column.rolling ? 8 : 4)*real;
    // GPU: records read and written, low words both ways, own words, full lists, histories kept at
    // both ends
    double bytes = 2*records + 2*24 + 16 + reference + 4 + 4*listed + 2*history*contacts;
    // CPU: fields of position, velocity, spin both ways, forces and moments written and read,
    // records read and written; half lists, with owners
    if (!gpu)
        bytes = 2*(24 + 24 + 3*real) + 4*6*real + 2*records + reference + 12
            + (8*listed + 2*history*contacts)/2;
    // a bond: ends, gap, history of seven numbers both ways, force written and read by both ends
    return bytes + bonds*(8 + 8 + 4 + 14*real + 3*13*real);
}

Options read(int argc, char** argv)
{
    Options o;
    for (int k = 1; k < argc; ++k)
    {
        const std::string a = argv[k];
        const auto value = [&]
        {
            if (++k >= argc) throw std::invalid_argument(a + " needs a value");
            return std::string(argv[k]);
        };
        if (a == "--device")
        {
            const std::string v = value();
            if (v != "cpu" && v != "gpu" && v != "auto")
                throw std::invalid_argument("--device cpu, gpu or auto");
            o.config.device = v == "cpu" ? DeviceKind::cpu
                                         : (v == "gpu" ? DeviceKind::gpu : DeviceKind::automatic);
        }
        else if (a == "--precision")
        {
            const std::string v = value();
            if (v != "mixed" && v != "double")
                throw std::invalid_argument("--precision mixed or double");
            o.config.precision = v == "mixed" ? PrecisionKind::mixed : PrecisionKind::doubled;
        }
        else if (a == "--steps") o.steps = std::stoll(value());
        else if (a == "--warmUp") o.warmUp = std::stoll(value());
        else if (a == "--copies") o.column.copies = std::stoi(value());
        else if (a == "--ratio") o.column.sizeRatio = std::stod(value());
        else if (a == "--skin") o.config.skin = std::stod(value());
        else if (a == "--bed") o.bed = value();
        else if (a == "--write") o.written = value();
        else if (a == "--bonded") o.bonded = std::stoi(value());
        else if (a == "--held") o.column.held = true;
        else if (a == "--sleep")
        {
            o.config.sleepSpeed = std::stod(value());
            o.config.sleepAfter = 5e-3;
        }
        else if (a == "--rolling") o.column.rolling = true;
        else if (a == "--triangles") o.column.triangles = true;
        else if (a == "--profile") o.profile = true;
        else throw std::invalid_argument("unknown option " + a);
    }
    return o;
}

int run(const Options& o)
{
    DemConfig config = o.config;
    DemInput in;
    const auto began = std::chrono::steady_clock::now();
    const auto since = [](auto from)
    { return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count(); };
    if (o.steps <= o.warmUp)
        throw std::invalid_argument("--steps must be more than those of --warmUp");
    if (o.bonded) bondedScene(o.bonded, config, in);
    else columnScene(o.bed, o.column, config, in);
    const std::size_t n = in.particles.size(), bonds = in.bonds.size();
    const double seeded = since(began);
    auto scene = createDemScene(config, in);
    in = DemInput();
    const double made = since(began) - seeded;
    DemReport r = scene->advance(1e9, o.warmUp);
    scene->timeKernels(o.profile);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    r = scene->advance(1e9, o.steps - o.warmUp);
    const double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double used = double(std::clock() - cpu)/CLOCKS_PER_SEC, work = double(n)*double(r.steps);
    if (r.stop != DemStop::none)
    {
        std::fprintf(stderr, "demSpeed: %s\n", r.stopMessage.c_str());
        return 1;
    }
    std::size_t bytes = 0;
    for (const ArrayInfo& a : scene->arrays()) bytes += a.bytes;
    const double listed = scene->neighboursPerParticle(), contacts = scene->contactsPerParticle();
    const DemEnergy e = scene->energy();
    std::printf("%s, %d threads, %zu spheres, %lld steps: %.4g s, %.4g particle-steps/s, %.4g a "
                "CPU second; rebuilds %lld; at %.6g s "
                "kinetic energy (of translation) %.5g J a bed, %.4g contacts and %.4g listed a "
                "particle, %zu bytes a particle\n",
        scene->deviceName().c_str(), omp_get_max_threads(), n, (long long)r.steps, wall,
        work/wall, work/used, (long long)r.rebuilds, r.time, e.translation/o.column.copies,
        contacts, listed, bytes/n);
    const bool gpu = scene->device() == DeviceKind::gpu;
    const double moved = bytesMoved(o, gpu, listed, contacts, double(bonds)/double(n));
    const double triad = gpu ? triadBandwidth(Gpu()) : triadBandwidth(Cpu());
    std::printf("    %.4g bytes a particle-step, %.3g of a triad of %.4g bytes/s; ", moved,
        moved*work/wall/triad, triad);
    if (config.sleepSpeed > 0) std::printf("%zu asleep; ", r.asleep);
    if (bonds)
        std::printf(
            "%zu bonds, %.4g bond-steps/s; ", bonds, double(bonds)*double(r.steps)/wall);
    std::printf("seeded in %.3g s, made in %.3g s\n", seeded, made);
    if (!o.written.empty()) writeBed(o.written, scene->particles(), o.column.copies);
    if (o.profile)
        for (const KernelInfo& k : scene->kernels())
            if (k.seconds > 0)
                std::printf(
                    "    %-20s %8lld  %.4g s\n", k.name.c_str(), (long long)k.launches, k.seconds);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try { return run(read(argc, argv)); }
    catch (const std::exception& e) { std::fprintf(stderr, "demSpeed: %s\n", e.what()); }
    return 2;
}
