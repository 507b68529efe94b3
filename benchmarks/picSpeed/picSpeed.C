/*  picSpeed: time a step of a dam break by particles in cells, by phase.

        picSpeed [--device cpu|gpu|auto] [--precision mixed|double] [--dim 2|3] [--across N] [--box
        F] [--transfer flip|pic|flipPic|apic] [--affine yes|no]
                 [--spline 1|2|3] [--reflection 0..1] [--tolerance T] [--reflectionTolerance T]
                 [--steps N] [--warmUp N] [--kernels] [--repeats] [--solids N] [--solidCells M]
                 [--pool F] [--bed F] [--interval K] [--slowCo C]

    The column is N cells wide, 2 N high and, in 3D, N deep, with 2 seeds a direction and cell, in a
    box 4 F columns wide and 2.5 F high. Steps go by maxCourant 0.5. With --pool water stands F
    columns deep in the whole box instead, with --bed beside the column. --interval: slow particles,
    whose path is C cells at most, are stepped once in K steps (multirate). --solids: so many disks
    or spheres of stone, M cells across (8), fall from a lattice two cells apart that begins at the
    floor. A line a run: time a step, particle-steps/s; then, of as many steps with every kernel
    timed, seconds a step of each kernel and each part. The particle part is transfers, motion and
    sort; correction of positions, surface, velocities on the grid and pressure are told apart. With
    --repeats the run is done once
    more, and the line says whether its state is the same to the bit.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <omp.h>
#include "api/picScene.hpp"

namespace
{

using namespace riprap;

struct Options
{
    PicConfig config;
    int dimensions = 3, across = 40, solids = 0, solidCells = 8;
    double box = 1, pool = 0, bed = 0;
    std::int64_t steps = 40, warmUp = 10;
    bool kernels = false, repeats = false;
};

template<class T>
T oneOf(const std::string& option, const std::string& word,
    std::initializer_list<std::pair<const char*, T>> words)
{
    std::string valid;
    for (const auto& w : words)
    {
        if (word == w.first) return w.second;
        valid += std::string(" ") + w.first;
    }
    throw std::invalid_argument(option + ": '" + word + "' is none of" + valid);
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
            o.config.device = oneOf<DeviceKind>(a, value(),
                {{"cpu", DeviceKind::cpu}, {"gpu", DeviceKind::gpu},
                    {"auto", DeviceKind::automatic}});
        else if (a == "--precision")
            o.config.precision = oneOf<PrecisionKind>(
                a, value(), {{"mixed", PrecisionKind::mixed}, {"double", PrecisionKind::doubled}});
        else if (a == "--transfer") o.config.transfer = value();
        else if (a == "--affine")
            o.config.transferNumbers.affine = oneOf<bool>(
                a, value(), {{"yes", true}, {"no", false}});
        else if (a == "--dim") o.dimensions = oneOf<int>(a, value(), {{"2", 2}, {"3", 3}});
        else if (a == "--across") o.across = std::stoi(value());
        else if (a == "--box") o.box = std::stod(value());
        else if (a == "--spline") o.config.splineOrder = std::stoi(value());
        else if (a == "--reflection") o.config.reflection = std::stod(value());
        else if (a == "--tolerance") o.config.pressureTolerance = std::stod(value());
        else if (a == "--reflectionTolerance") o.config.reflectionTolerance = std::stod(value());
        else if (a == "--steps") o.steps = std::stoll(value());
        else if (a == "--warmUp") o.warmUp = std::stoll(value());
        else if (a == "--solids") o.solids = std::stoi(value());
        else if (a == "--solidCells") o.solidCells = std::stoi(value());
        else if (a == "--pool") o.pool = std::stod(value());
        else if (a == "--bed") o.bed = std::stod(value());
        else if (a == "--interval") o.config.slowInterval = std::stoi(value());
        else if (a == "--slowCo") o.config.slowCourant = std::stod(value());
        else if (a == "--kernels") o.kernels = true;
        else if (a == "--repeats") o.repeats = true;
        else throw std::invalid_argument("unknown option " + a);
    }
    if (o.across < 4 || o.steps < 1 || o.warmUp < 1 || !(o.box >= 1))
        throw std::invalid_argument(
            "--across: at least 4; --steps and --warmUp: at least 1; --box: at least 1");
    return o;
}

//- The column, a metre wide, at rest; particles mark the middle of their part of a cell
FluidInput column(Options& o)
{
    PicConfig& c = o.config;
    const bool three = o.dimensions == 3;
    const double h = 1.0/o.across;
    c.cellSize = h;
    c.cells[0] = int(std::lround(4*o.box*o.across));
    c.cells[1] = int(std::lround(2.5*o.box*o.across));
    c.cells[2] = three ? o.across : 1;
    c.domainMax = {{c.cells[0]*h, c.cells[1]*h, c.cells[2]*h}};
    c.dimensions = o.dimensions;
    c.gravity = {{0, -9.81, 0}};
    c.density = 1000;
    c.viscosity = 0;
    c.seedsPerDirection = 0;
    const double s = 0.5*h;
    c.spacing = s;
    FluidInput f;
    const double beside = o.pool > 0 ? o.pool : o.bed;
    const int deep = three ? 2*o.across : 1, wide = 2*(beside > 0 ? c.cells[0] : o.across),
              low = int(std::lround(2*beside*o.across)), high = o.pool > 0 ? low : 4*o.across;
    f.position.reserve(std::size_t(3)*deep*(std::size_t(wide)*low + 2*o.across*high));
    for (int k = 0; k < deep; ++k)
        for (int j = 0; j < std::max(low, high); ++j)
            for (int i = 0; i < (j < low ? wide : 2*o.across); ++i)
                f.position.insert(f.position.end(),
                    {(i + 0.5)*s, (j + 0.5)*s, three ? (k + 0.5)*s : 0.5*h});
    f.velocity.assign(f.position.size(), 0);
    f.density.assign(f.size(), c.density);
    return f;
}

//- Stones in layers, the lowest on the floor
PicInside stones(const Options& o)
{
    constexpr double density = 2650, gap = 2;       // cells
    PicInside inside;
    if (!o.solids) return inside;
    const PicConfig& c = o.config;
    const double h = c.cellSize, radius = 0.5*o.solidCells*h, pitch = (o.solidCells + gap)*h;
    auto s = std::make_shared<PicSolids>();
    s->config.domainMin = c.domainMin;
    s->config.domainMax = c.domainMax;
    s->config.normal = "linear";
    s->config.tangential = "history";
    s->input.materials.resize(1);
    s->input.pairs.resize(1);
    s->input.pairs[0].properties.normalStiffness = 1e6;
    s->input.pairs[0].properties.restitution = 0.3;
    s->input.pairs[0].properties.gap = gap*h;
    for (int d = 0; d < o.dimensions; ++d)
        for (int side = 0; side < 2; ++side)
        {
            DemWall w;
            w.plane = true;
            w.normal = {{0, 0, 0}};
            w.normal[d] = side ? -1 : 1;
            w.point = side ? c.domainMax : c.domainMin;
            s->input.walls.push_back(w);
        }
    int n[3];
    for (int d = 0; d < 3; ++d)
        n[d] = d < o.dimensions ? int((c.domainMax[d] - c.domainMin[d])/pitch) : 1;
    if (std::int64_t(n[0])*n[1]*n[2] < o.solids)
        throw std::invalid_argument("--solids: the box has no room for so many");
    for (int k = 0; k < o.solids; ++k)
    {
        const int at[3] = {k % n[0], k/(n[0]*n[2]), k/n[0] % n[2]};
        for (int d = 0; d < 3; ++d)
            s->input.particles.position.push_back(
                d < o.dimensions ? c.domainMin[d] + (at[d] + 0.5)*pitch : 0.5*h);
        s->input.particles.radius.push_back(radius);
        s->input.particles.mass.push_back(density
            *(o.dimensions == 2 ? M_PI*radius*radius
                                 : 4*M_PI/3*radius*radius*radius));
    }
    inside.solids = s;
    return inside;
}

double seconds(PicScene& scene, std::int64_t steps, PicReport& r)
{
    const auto start = std::chrono::steady_clock::now();
    r = scene.advance(1e9, steps);
    if (r.stop != StopReason::none) throw std::runtime_error("a guard stopped the run");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//- The part of a step that a kernel belongs to
const char* partOf(const std::string& kernel)
{
    static const std::map<std::string, const char*> parts{{"picKeys", "sort"}, {"sort", "sort"},
        {"clearCells", "sort"}, {"countCells", "sort"}, {"scan", "sort"}, {"putInOrder", "sort"},
        {"bodiesOfRows", "solids"}, {"bodyDistances", "solids"}, {"restoreDistances", "solids"},
        {"findShares", "solids"}, {"measureShares", "solids"}, {"closeByBodies", "solids"},
        {"bodyFaceVelocities", "solids"}, {"restoreFaces", "solids"}, {"bodyVolumes", "solids"},
        {"findBodyCells", "solids"}, {"fillBodyCells", "solids"}, {"sumBodyRows", "solids"},
        {"sumBodies", "solids"}, {"openVolumes", "solids"}, {"openWeights", "solids"},
        {"markKnownCells", "solids"}, {"extendSurface", "solids"}, {"pushOut", "solids"},
        {"countCoupled", "solids"}, {"fillCoupled", "solids"}, {"keepSorted", "solids"},
        {"coupledBodies", "pressure"}, {"coupledAdd", "pressure"}, {"hasParticles", "to grid"},
        {"listOccupied", "to grid"}, {"particleToGrid", "to grid"}, {"gatherTiles", "to grid"},
        {"gridToParticle", "to particles"}, {"moveParticles", "motion"},
        {"correctPositions", "correction of positions"}, {"markWetCells", "surface"},
        {"markNearWater", "surface"}, {"waterVolume", "surface"}, {"countFlying", "surface"},
        {"advectLevelSet", "surface"}, {"holdSurface", "surface"}, {"startDistance", "surface"},
        {"spreadDistance", "surface"}, {"shiftSurface", "surface"}, {"findFastTiles", "multirate"},
        {"chooseSlowTiles", "multirate"},
        {"flagSlowTiles", "multirate"}, {"wakeTiles", "multirate"}, {"endDueTiles", "multirate"},
        {"flagSummedTiles", "multirate"}, {"listSummedTiles", "multirate"},
        {"addToInterval", "multirate"}, {"enterSlowTiles", "multirate"},
        {"countSlow", "multirate"}};
    const auto at = parts.find(kernel);
    if (at != parts.end()) return at->second;
    return kernel.compare(0, 8, "pressure") == 0 ? "pressure" : "velocities on the grid";
}

//- Launches a step, of all so far, and seconds a step of each kernel and each part
void printKernels(
    const PicScene& scene, std::size_t particles, std::int64_t steps, std::int64_t allSteps)
{
    double sum = 0, ofParticles = 0;
    std::map<std::string, double> parts;
    for (const KernelInfo& k : scene.kernels())
        if (k.seconds > 0)
        {
            sum += k.seconds;
            parts[partOf(k.name)] += k.seconds;
            std::printf("    %-28s %8.1f launches, %10.3f us a step\n", k.name.c_str(),
                double(k.launches)/allSteps, 1e6*k.seconds/steps);
        }
    std::printf("    %-28s %8s           %10.3f us a step\n", "all of these", "", 1e6*sum/steps);
    for (const auto& p : parts)
        std::printf("  %-30s %8s           %10.3f us a step\n", p.first.c_str(), "",
            1e6*p.second/steps);
    for (const char* p : {"sort", "to grid", "to particles", "motion"}) ofParticles += parts[p];
    std::printf("  %-30s %8s           %10.3f us a step, %.4g particle-steps/s\n",
        "transfers, motion and sort", "", 1e6*ofParticles/steps,
        double(particles)*double(steps)/ofParticles);
}

int run(Options o)
{
    FluidInput in = column(o);
    const std::size_t n = in.size();
    auto scene = createPicScene(o.config, in, PicWalls(), nullptr, stones(o));
    in = FluidInput();
    PicReport r;
    seconds(*scene, o.warmUp, r);
    const double wall = seconds(*scene, o.steps, r);
    std::size_t bytes = 0;
    for (const ArrayInfo& a : scene->arrays()) bytes += a.bytes;
    std::string again;
    if (o.repeats)
    {
        PicReport second;
        auto other = createPicScene(o.config, column(o), PicWalls(), nullptr, stones(o));
        seconds(*other, o.warmUp, second);
        seconds(*other, o.steps, second);
        again = other->saveState() == scene->saveState() ? ", repeats to the bit"
                                                         : ", DOES NOT REPEAT";
    }
    const std::int64_t cells = std::int64_t(o.config.cells[0])*o.config.cells[1]*o.config.cells[2];
    std::printf("%s, %d threads, %dD, %zu particles, %lld cells, %lld steps: %.4g us a step, %.4g "
                "particle-steps/s; %.3g iterations a step, "
                "%zu bytes a particle, volume error %.2g%s\n",
        scene->deviceName().c_str(), omp_get_max_threads(), o.dimensions, n, (long long)cells,
        (long long)r.steps, 1e6*wall/r.steps, double(n)*double(r.steps)/wall,
        double(r.pressureIterations)/r.steps, bytes/n, r.volumeError, again.c_str());
    if (o.config.slowInterval > 1)
        std::printf("    %.3g %% of the particles are slow at the end\n",
            100.0*double(r.slow)/double(r.fluid));
    if (o.solids)
        std::printf("    %d solids, %d steps of theirs in the last one, of %.4g s\n", o.solids,
            scene->coupling().subcycles, r.lastTimeStep);
    if (!o.kernels) return 0;
    scene->timeKernels(true);
    const double timed = seconds(*scene, o.steps, r);
    std::printf("    with every kernel timed %.4g us a step\n", 1e6*timed/r.steps);
    printKernels(*scene, n, r.steps, r.totalSteps);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try { return run(read(argc, argv)); }
    catch (const std::exception& e) { std::fprintf(stderr, "picSpeed: %s\n", e.what()); }
    return 2;
}
