/*  SPH scene: the plain C++ facade between riprap's particle solver and whoever sets a scene up.

    No OpenFOAM and no CUDA appear here. All quantities are SI, double, host memory; vectors are
    stored x0 y0 z0 x1 y1 z1 ... with three components in 2D as well: the empty one of the fluid is
    ignored, and comes back as the middle of the domain. A scene owns everything that lives on its
    device.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include <memory>
#include "api/equationProperties.hpp"
#include "api/fluidScene.hpp"
#include "api/rankConfig.hpp"
#include "api/termProperties.hpp"

namespace riprap
{

//- Everything that the equations need, checked by the reader of dictionaries (ranges) and once more
//  by createSphScene (consistency, std::invalid_argument). Models by the words of their cards
//  (solvers/sph/sphModels.hpp).
//- Courant numbers of the step, and what stops a run
struct SphLimits : TimeControl
{
    double acousticCourant = 0.3;           // dt <= C h/(c0 + |v|max)
    double forceCourant = 0.25;             // dt <= C sqrt(h/|a|max)
    double viscousCourant = 0.125;          // dt <= C h^2 rho/mu
    double maxDensityDeviation = 0.2;       // |rho/rho0 - 1| that stops the run
    double maxSpeedRatio = 5;               // |v|/vmax that stops the run
    // particles beyond them, or whose acceleration exceeds 100 c0^2/h0, are taken out instead
    bool removeWild = false;
};

struct SphConfig : FluidConfig, EquationProperties, TermProperties, RankConfig, SphLimits
{
    // How
    DeviceKind device = DeviceKind::automatic;
    PrecisionKind precision = PrecisionKind::mixed;

    // Domain: must hold the walls. Fluid that comes closer to its edge than escapeInset has
    // escaped: give the walls' thickness less what a particle may penetrate. Periodic axes are
    // wrapped.
    Vector3 domainMin{{0, 0, 0}}, domainMax{{1, 1, 1}};
    bool periodic[3] = {false, false, false};
    double escapeInset = 0;                 // [m]

    // Of the equation of state
    double maxVelocity = 1;                 // vmax [m/s], the scene's estimate
    double soundSpeed = 10;                 // c0 [m/s], normally 10 vmax (Eq. 35)

    // Kernel
    std::string kernel = "wendlandC2";
    double smoothingRatio = 1.25;           // h0/dp
    bool variableSmoothing = false;         // Eq. 37
    double maxSmoothingGrowth = 1.2;        // h is limited to [h0/f, f h0]

    std::string shifting = "none";
    double shiftingCoefficient = 2;         // A of Skillen et al. 2013
    // div(r) below which no shifting acts, under D; < 0: 1.5 (2D), 2.75 (3D)
    double shiftingSurfaceThreshold = -1;

    // Walls
    std::string wallModel = "extrapolated";
    double wallSpacing = 0;                 // [m]
    bool noSlip = true;                     // wall enters viscous terms

    // Time
    std::string integrator = "leapfrog";

    // Neighbours: what the search radius adds to the support, as a fraction of it; < 0: chosen by
    // the scene
    double skin = -1;
};

//- The walls' true faces, which hold particles back (sph/boundary/wallFaces.hpp): segments (2D, the
//  third vertex is not used) or triangles
struct WallFaceInput
{
    std::vector<double> point;              // 3 a point
    std::vector<std::int32_t> vertex;       // 3 n, of point
    std::vector<double> normal;             // 3 n, unit, out of the wall into the fluid
    std::vector<std::int32_t> body;         // n, index of the moving group, -1: fixed
    std::vector<std::int32_t> part;         // n, faces that bound one solid together
    // n [m], 0: solid behind; else a plate that reaches so far to both sides
    std::vector<double> halfThickness;
    std::size_t size() const { return body.size(); }
};

struct WallInput
{
    std::vector<double> position;           // 3 n
    std::vector<double> normal;             // 3 n, unit, out of the wall into the fluid
    // n, index of the moving group, -1: fixed; empty: all fixed
    std::vector<std::int32_t> body;
    std::vector<std::int32_t> part;         // n, FluidForce::part; empty: all 0
    int nBodies = 0;
    WallFaceInput faces;                    // none: particles are held by forces alone
    std::size_t size() const { return position.size()/3; }
};

//- A particle that was taken out: where it was and what it had
struct WildParticle
{
    std::int32_t id = -1;
    Vector3 position{{0, 0, 0}};
    double deviation = 0, speed = 0;        // rho/rho0 - 1, [m/s]
};

//- What faces of walls did since the start
struct FaceContacts
{
    std::int64_t count = 0;
    std::int64_t atBodies = 0;              // of these
    Vector3 impulse{{0, 0, 0}};             // on the fluid [N s] (2D: a metre of depth)
};

//- What one call of advance did
struct SphReport
{
    double time = 0;                        // [s] reached
    double lastTimeStep = 0, minTimeStep = 0, maxTimeStep = 0;
    std::int64_t steps = 0;                 // taken in this call
    std::int64_t totalSteps = 0;
    // what set the last step: acoustic | force | viscous | fixed | target | maximum
    std::string limit;
    double maxSpeed = 0, maxDensityDeviation = 0;
    std::int64_t rebuilds = 0;              // neighbour structures built in this call
    std::size_t fluid = 0;                  // particles still in the scene
    std::vector<Vector3> escaped;           // last positions of those that left in this call
    std::vector<std::int32_t> escapedId;
    std::vector<WildParticle> wild;         // those that were taken out in this call
    // a particle moved so far that pairs may have been missed in a step
    bool skinExceeded = false;
    StopReason stop = StopReason::none;     // then: which particle, where, when, how much
    std::int32_t stopId = -1;
    Vector3 stopPosition{{0, 0, 0}};
    double stopValue = 0;
    // of several processes. `escaped` and `wild` are of this one, the rest is of all
    RankReport rank;
};

struct WallState
{
    std::vector<double> position, velocity, pressure;   // 3 n, 3 n, n; in the order of WallInput
};

//- Pairs nearer than the support (2h at rest density) among those that the passes of a step look at
//  now
struct NeighbourCounts
{
    std::int64_t particles = 0;
    std::int64_t fluid = 0, walls = 0, solids = 0;      // neighbours of all fluid particles
    // fluid about wall points, where anything asks for it, and about solids
    std::int64_t aboutWalls = 0, aboutSolids = 0;
};

class DemScene;
struct CouplingState;

class SphScene : public FluidScene
{
public:

    //- Advance to time t [s] or by maxSteps (0: no limit), whichever comes first. The last step is
    //  shortened to end at t to round-off. Stops early when a guard fires (see SphReport::stop).
    virtual SphReport advance(double t, std::int64_t maxSteps = 0) = 0;

    //- Ask a running advance to return after the step in hand (safe in a signal handler); if none
    //  is running, the next returns after one step
    virtual void interrupt() = 0;

    virtual WallState walls() = 0;

    //- Force of the fluid on the fixed and moving walls [N] (2D: per metre), per body (-1 first)
    virtual std::vector<Vector3> wallForces() = 0;

    virtual FaceContacts faceContacts() = 0;

    //- The exact state, so that a run continues bit for bit on the same device and precision.
    //  Opaque words with a header and a checksum; after saveState the scene itself continues as a
    //  scene that was given this state.
    std::vector<std::int32_t> saveState() { return savedState(false).take(); }
    //- The same, to be taken at once or later, while the scene moves on
    virtual Later<std::vector<std::int32_t>> savedState(bool later) = 0;

    //- Continue from saved words; std::invalid_argument says what does not fit
    virtual void loadState(const std::vector<std::int32_t>&) = 0;

    //- How many particles are faster than each of the speeds [m/s]
    static constexpr int speedClasses = 8;
    virtual std::array<std::size_t, speedClasses> fasterThan(
        const std::array<double, speedClasses>& speeds) = 0;

    //- Another maxVelocity and soundSpeed, between two calls of advance: each particle keeps its
    //  pressure, tension included, and its velocity. Its density changes, and with it the elastic
    //  energy: SphEnergy::stiffening
    virtual void setMaxVelocity(double maxVelocity, double soundSpeed) = 0;

    //- The step that would be taken now and what limits it
    virtual double estimateTimeStep(std::string& limit) = 0;

    virtual std::vector<ArrayInfo> arrays() const = 0;
    virtual std::vector<KernelInfo> kernels() const = 0;
    virtual void timeKernels(bool on) = 0;  // measure seconds a kernel (slows small scenes)
    virtual double neighboursPerParticle() = 0;     // solids left out
    virtual NeighbourCounts countNeighbours() = 0;

    virtual std::string deviceName() const = 0;
    virtual DeviceKind device() const = 0;

    //- The solids of a coupled scene (api/sphDemScene.hpp), null: there are none; to be read, not
    //  to be advanced
    virtual DemScene* solids() { return nullptr; }
    virtual CouplingState coupling() = 0;
};

//- What automatic chose and why; false where there is no usable GPU
struct DeviceChoice { DeviceKind device = DeviceKind::cpu; std::string reason; };
DeviceChoice chooseDevice(DeviceKind asked, std::size_t particles, int dimensions);

//- Build a scene. motion may be empty when nBodies is 0.
//  @throws std::invalid_argument (inconsistent input), std::runtime_error (device failure)
std::unique_ptr<SphScene> createSphScene
(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion motion = WallMotion()
);

} // namespace riprap
