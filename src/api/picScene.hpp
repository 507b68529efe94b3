/*  PIC scene: the plain C++ facade between riprap's particle-in-cell solver and whoever sets a
    scene up.

    SI, double, host memory; vectors with three components in 2D as well: the empty one of the fluid
    is ignored, and comes back as the middle of the domain. A scene owns everything that lives on
    its device, but not the solver of the pressure equation.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include "api/linearSolver.hpp"
#include "api/transferProperties.hpp"
#include "api/demScene.hpp"
#include "api/rankConfig.hpp"
#include "api/fluidScene.hpp"

namespace riprap
{

//- Water in it loses velocity at a rate that grows from `from`, where it is 0, to `to`, as the
//  square of the distance: pic/terms/absorb.hpp
struct PicAbsorber
{
    std::string name;
    Vector3 from{{0, 0, 0}}, to{{0, 0, 0}};     // [m]
    double rate = 0;                        // at `to` and beyond [1/s]
};

//- Particles that have come in and gone out through an opening since the very start
struct PicPassage
{
    std::int64_t in = 0, out = 0;
    // of the water that came in, less what went out [m3] (2D: m2)
    double volume = 0;
    // of that, what is not yet particles that have come or gone
    double pending = 0;
};

//- A part of the sides through which water comes and goes (pic/openings): its velocity is given, or
//  what flows in, over the part of it that is under water, or the height of the water that stands
//  beyond. As functions of time [s]
struct PicOpening
{
    std::string name;
    std::string kind = "level";             // pic/openings/kinds.hpp
    std::function<Vector3(double)> velocity;        // [m/s]
    std::function<double(double)> flowRate;         // into the domain [m3/s] (2D: m2/s)
    // against gravity, from the world's origin [m]; of velocity and flowRate: up to which there is
    // a flow, null: as the water stands
    std::function<double(double)> level;
    // of a run that continues without its exact state: what had passed
    PicPassage before;
};

//- Steps, and what stops a run
struct PicLimits : TimeControl
{
    double maxCourant = 0.5;
    // of particles that no water carries; at least maxCourant
    double maxFlyingCourant = 4;
    // a particle that went this many cells in a step stops the run
    double maxCourantEver = 5;
    // [m/s], a faster particle stops the run; 0: fallSpeeds times that of a fall through the
    // domain, or of the first step; without gravity and motion none
    double maxSpeed = 0;
    static constexpr double fallSpeeds = 50;
};

struct PicConfig : FluidConfig, PicLimits, RankConfig
{
    // How
    DeviceKind device = DeviceKind::automatic;
    PrecisionKind precision = PrecisionKind::mixed;

    // The grid: cells of edge cellSize that fill the domain
    Vector3 domainMin{{0, 0, 0}}, domainMax{{1, 1, 1}};
    bool periodic[3] = {false, false, false};
    int cells[3] = {1, 1, 1};               // along x, y, z
    double cellSize = 0;                    // [m]

    // Particles of a new run: as given, or seeded in the cells that those given fill
    int seedsPerDirection = 2;              // of a cell; 0: as given
    double jitter = 0;                      // of seeds, 0 .. 1 of their own part of the cell

    // Transfer and motion
    int splineOrder = 2;                    // picSplines.hpp
    std::string transfer = "flip";          // word of a scheme (picTransfers.hpp)
    TransferProperties transferNumbers;
    int advectionOrder = 3;                 // 2, 3
    // 0 .. 1: of the divergence by advection (solvers/pic/driver/projection.hpp)
    double reflection = 1;
    double positionCorrection = 0.05;       // coefficient, 0: off

    double pressureTolerance = 1e-10;       // without a solver of the caller's
    double reflectionTolerance = 0;         // of the first of a step's two solutions; 0: the same

    // of several ranks: each solves for p of the whole grid if that has no more cells than this,
    // where messages cost more than they save
    int gatheredCells = 1 << 15;

    std::string viscousScheme = "automatic";    // pic/terms/viscousSchemes.hpp

    // Walls
    bool noSlip = false;
    // of sides that water sticks to, in their own plane: along x, y, z; lower, upper [m/s]
    Vector3 slide[3][2] = {};

    std::vector<PicAbsorber> absorbers;
    std::vector<PicOpening> openings;

    // Multirate: particles of water that goes at most so many cells in so many steps are stepped
    // once in these (pic/multirate); 1: each particle in each step
    int slowInterval = 1;
    double slowCourant = 0.25;
};

//- Sides of the domain, and what the faces of the grid are where they are not open water: cells'
//  faces normal to each solved direction, in the order of UniformGrid; empty: all inner faces open,
//  the sides of the domain closed and at rest
struct PicWalls
{
    std::vector<double> aperture[3];        // 0 closed .. 1 open
    std::vector<double> wallVelocity[3];    // of the closed part along the direction [m/s]
    // on the sides: number of the opening a face belongs to, -1: none; empty: there are none
    std::vector<int> opening[3];
    // on the sides: FluidForce::part of the wall, -1: none; empty: there are none
    std::vector<int> part[3];
};

//- A surface inside the domain, oriented or not
struct PicObstacle
{
    std::string name;
    std::vector<double> vertices;           // 3 each [m], as at the identity pose
    std::vector<int> elements;              // 2D: two vertices each, in the plane; 3D: three
    bool closed = true;                     // else a sheet: it parts, but has no inside
    bool solidOutside = false;              // the water is inside, as in a basin
    int body = -1;                          // index of its motion, -1: it rests
    int part = 0;                           // FluidForce::part
};

//- The shape of rigid bodies by signed distances at the points of a lattice about their principal
//  axes (2D: of the plane as given), the first axis fastest (pic/shapes/sampledShape.hpp)
struct PicShape
{
    std::string name;
    Vector3 lower{{0, 0, 0}};               // of the first point, from the centre of mass [m]
    double step = 0;                        // [m]
    std::array<int, 3> n{{1, 1, 1}};        // points; 2D: one along the empty axis
    std::vector<double> distance;           // [m]
    // that distances are held to (pic/shapes/latticeVolume.hpp) [m3] (2D: m2); 0: as they have it
    double volume = 0;
};

//- Solids in the water (solvers/pic/bodies/picBodies.hpp). The fluid decides on device, precision,
//  dimensions and gravity
struct PicSolids
{
    DemConfig config;
    DemInput input;
    std::vector<PicShape> shapes;           // of clumps that have one (DemClump::shape)
    // their motion from the last step's pressure, not solved with it
    bool weak = false;
    // beta of paper 2, Eq. 20: what water between solids that touch keeps of its velocity a step
    double contactVelocity = 1;
    double contactVelocityTime = 0;         // [s] or in this time, whatever the step; 0: a step
};

//- What is inside the domain; motion: of obstacles that move
struct PicInside
{
    std::vector<PicObstacle> obstacles;
    WallMotion motion;
    std::shared_ptr<const PicSolids> solids;        // null: there are none
    std::unique_ptr<DemScene> scene;                // theirs; made by createPicScene

    bool empty() const { return obstacles.empty() && !scene; }
};

//- Why a call of advance ended before its time, if it did
struct PicStop
{
    StopReason stop = StopReason::none;     // then: which particle, where, its Courant number
    std::int32_t stopId = -1;
    Vector3 stopPosition{{0, 0, 0}};
    double stopValue = 0;
    std::string stopMessage;                // of solids: which limit
};

//- What one call of advance did
struct PicReport : PicStop
{
    double time = 0;                        // [s] reached
    double lastTimeStep = 0, minTimeStep = 0, maxTimeStep = 0;
    std::int64_t steps = 0, totalSteps = 0;
    // what set the last step: Courant | waves | viscous | fixed | target | maximum
    std::string limit;
    double maxSpeed = 0;                    // of particles [m/s]
    double maxCourant = 0;
    // of water at the end [m3] (2D: m2), flying particles included
    double volume = 0;
    double volumeError = 0;                 // relative to what the particles stand for, at the end
    // sum of what the steps lost (-) or gained before it was put right, relative
    double volumeDrift = 0;
    std::size_t fluid = 0, flying = 0;      // particles in the scene, those of them that fly
    std::size_t slow = 0;                   // and those that wait for the end of an interval
    std::vector<Vector3> escaped;           // last positions of those that left in this call
    std::vector<std::int32_t> escapedId;
    std::vector<PicPassage> passed;         // an opening each
    std::int64_t pressureIterations = 0;
    double largestResidual = 0;             // of the pressure equation at the end of a solution
    bool pressureConverged = true, viscosityConverged = true;
    // of several processes: what this one has; all else is of all
    RankReport rank;
};

//- The grid's fields, cells x fastest over the three directions of the domain
struct PicGridState
{
    std::vector<double> pressure;           // [Pa]
    std::vector<double> velocity;           // 3 a cell [m/s]; 0 away from the water
    std::vector<double> water;              // part of the cell, 0 .. 1
    std::vector<double> distance;           // to the surface [m], negative in water
};

//- Memory for n cells: pressure, velocity (3 a cell) and water as in PicGridState
struct PicCellFields { double *pressure, *velocity, *water; };

inline void takeCells(
    const PicGridState& from, const std::int32_t* cells, std::size_t n, const PicCellFields& to)
{
    #pragma omp parallel for schedule(static) if (n > 10000)
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t c = cells[i];
        to.pressure[i] = from.pressure[c];
        for (int d = 0; d < 3; ++d) to.velocity[3*i + d] = from.velocity[3*c + d];
        to.water[i] = from.water[c];
    }
}

//- What the kick of the last step did to momentum [N s] (2D: per metre): water = gravity + other -
//  walls - solids
struct PicMomentum
{
    Vector3 water{{0, 0, 0}};               // of what the pressure moves, on the grid
    Vector3 gravity{{0, 0, 0}};             // its weight
    // by the pressure, on walls and obstacles; on solids that move with the water, shear included
    Vector3 walls{{0, 0, 0}}, solids{{0, 0, 0}};
    // viscosity, zones that absorb waves, water beyond openings
    Vector3 other{{0, 0, 0}};
    // what of it came to the particles; gravity on flying ones included
    Vector3 particles{{0, 0, 0}};
};

//- fluid(): smoothingLength is the edge of the cells. energy(): elastic 0. sample(): of the grid;
//  volumeFraction 1/2 on the surface
class PicScene : public FluidScene
{
public:

    //- Advance to time t [s] or by maxSteps (0: no limit), whichever comes first. The last step is
    //  shortened to end at t to round-off. Stops early when a guard fires (see PicReport::stop).
    virtual PicReport advance(double t, std::int64_t maxSteps = 0) = 0;

    //- Ask a running advance to return after the step in hand (safe in a signal handler); if none
    //  is running, the next returns after one step
    virtual void interrupt() = 0;

    virtual PicGridState grid() = 0;

    //- The same of n cells of the block, in their order, into the caller's memory
    virtual void cellFields(const std::int32_t* cells, std::size_t n, const PicCellFields& to)
    {
        takeCells(grid(), cells, n, to);
    }

    //- forcesOnWalls() of all processes, on each, in the order of one process
    virtual std::vector<FluidForce> forcesOnWallsOfAll() { return forcesOnWalls(); }

    //- The solids, null: there are none; to be read, not to be advanced
    virtual DemScene* solids() { return nullptr; }

    //- The water's force on all of them in the last step [N], and their steps in it
    struct Coupling { Vector3 force{{0, 0, 0}}; int subcycles = 0; };
    virtual Coupling coupling() { return Coupling(); }

    //- Momentum of the steps from now on, and of the last one; costs copies to the host
    virtual void watchMomentum(bool) {}
    virtual PicMomentum momentum() { return PicMomentum(); }

    //- Edge of the square or cube that a particle stands for [m]
    virtual double particleSpacing() const = 0;

    //- The exact state: see SphScene
    std::vector<std::int32_t> saveState() { return savedState(false).take(); }
    //- The same, to be taken at once or later, while the scene moves on
    virtual Later<std::vector<std::int32_t>> savedState(bool later) = 0;
    virtual void loadState(const std::vector<std::int32_t>&) = 0;

    virtual double estimateTimeStep(std::string& limit) = 0;
    virtual std::vector<ArrayInfo> arrays() const = 0;
    virtual std::vector<KernelInfo> kernels() const = 0;
    virtual void timeKernels(bool on) = 0;
    virtual std::string deviceName() const = 0;
    virtual DeviceKind device() const = 0;
};

//- Parts of a case's input
enum class PicInput {device, guards, solver, multirate};

//- Which of them several processes cannot take, and why
struct PicRefusal : std::invalid_argument
{
    PicInput input;

    PicRefusal(PicInput what, const std::string& why) : std::invalid_argument(why), input(what) {}
};

//- What createPicScene refuses with PicConfig::ranks, for those who want to know before they make
//  its input
//  @throws PicRefusal
void checkPicRanks(const PicConfig&, const LinearSolver* solver);

//- Build a scene. solver, which must outlive it, solves the pressure equation; nullptr: our
//  multigrid, to pressureTolerance
//  @throws std::invalid_argument (inconsistent input), std::runtime_error (device failure)
std::unique_ptr<PicScene> createPicScene(const PicConfig&, const FluidInput&, const PicWalls&,
    LinearSolver* solver = nullptr, PicInside inside = PicInside());

} // namespace riprap
