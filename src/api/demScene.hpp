/*  DEM scene: the plain C++ facade between riprap's solids and whoever sets a scene up.

    No OpenFOAM and no CUDA appear here. All quantities are SI, double, host memory; vectors are
    stored x0 y0 z0 x1 y1 z1 ... with three components in 2D as well (the empty one of a position is
    returned as given; a spin and a moment in 2D are their component along axes[2]). 2D is per metre
    of depth. A scene owns everything that lives on its device.

    Nothing given here is ignored: what a scene cannot do is refused by createDemScene with
    std::invalid_argument.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <memory>
#include <string>
#include "api/later.hpp"
#include "api/pairProperties.hpp"
#include "api/rankConfig.hpp"
#include "api/sceneTypes.hpp"

namespace riprap
{

struct DemConfig : RankConfig
{
    // Where and how
    int dimensions = 3;                     // 2: disks, 3: spheres
    int axes[3] = {0, 1, 2};                // 2D: axes[0], axes[1] are solved, axes[2] is empty
    DeviceKind device = DeviceKind::automatic;
    PrecisionKind precision = PrecisionKind::mixed;

    // Domain: a particle whose centre leaves it has escaped. Periodic axes are wrapped.
    Vector3 domainMin{{0, 0, 0}}, domainMax{{1, 1, 1}};
    bool periodic[3] = {false, false, false};
    // does a wall stand at the end [axis][0: min, 1: max]? Who is pressed into it leaves a radius
    // (the smallest) later
    bool walled[3][2] = {};

    Vector3 gravity{{0, 0, 0}};             // [m/s2]

    // Contact laws by their words (solvers/dem/demFamilies.hpp), the same for all pairs; their
    // numbers are of the pair (DemPair)
    std::string normal = "hertz", tangential = "history", rolling = "none";
    // do bonded pairs touch as well (paper 1), or only once the bond is broken?
    bool contactWithinBonds = false;

    // Time
    double startTime = 0;
    std::string integrator = "leapfrog";    // dem/motion/integrators.hpp
    // [s]; 0: stepFraction of the smallest limit (DemPlan::limits)
    double timeStep = 0;
    // of sqrt(m/k), or Rayleigh's time; paper 2's Eq. 18 is 2 pi/gamma of sqrt(m/k)
    double stepFraction = 0.2;
    double maxTimeStep = 0;                 // of the step by stepFraction [s]; 0: no limit
    bool allowLargeStep = false;            // else a step above DemPlan::hardStop is refused

    // Neighbours: what the search adds to contact, as a fraction of the smallest diameter; < 0:
    // chosen by the scene
    double skin = -1;

    // Particles that have been slower than this (their surfaces, too) for so long, with all their
    // neighbours, sleep until something near them moves; 0: nobody sleeps
    double sleepSpeed = 0;                  // [m/s]
    double sleepAfter = 0;                  // [s]

    bool orientation = false;               // follow how particles have turned (output)
};

struct DemMaterial
{
    std::string name;
    double young = 0;                       // E [Pa]; of laws by elastic constants
    double poisson = 0.25;
};

//- What two materials do to each other. Young's moduli and Poisson's ratios are put in from the
//  materials.
struct DemPair
{
    int a = 0, b = 0;                       // materials, in any order
    PairProperties properties;
};

//- What rigid bodies of a group may do. In 2D they turn about the empty direction alone, and
//  directions lie in the plane
// of the centre of mass: along a direction alone, across it alone
enum class TranslationKind {free, line, plane, none};
enum class RotationKind {free, axis, none};             // about a direction alone
struct DemConstraint
{
    TranslationKind translation = TranslationKind::free;
    RotationKind rotation = RotationKind::free;
    Vector3 direction{{0, 0, 1}};           // of line and plane
    Vector3 axis{{0, 0, 1}};                // of rotation and hinge
    // turns about `axis` through `point` and does nothing else
    bool hinge = false;
    Vector3 point{{0, 0, 0}};
    bool any() const
    {
        return hinge || translation != TranslationKind::free || rotation != RotationKind::free;
    }
};

//- Between a point of a rigid body and one of space: a spring, or a line that goes slack
struct DemSpring
{
    std::string name;
    Vector3 anchor{{0, 0, 0}};              // in space
    Vector3 point{{0, 0, 0}};               // on the body as it stands at DemClump::start
    double stiffness = 0;                   // [N/m]
    double damping = 0;                     // of the rate of its length [N s/m]
    double length = 0;                      // unstretched [m]
    bool slack = false;                     // pulls, and never pushes
};

//- What is done to particles of a group
struct DemGroup
{
    std::string name;
    bool held[3] = {false, false, false};   // the velocity along this axis is kept as given
    bool heldSpin = false;                  // the spin is kept as given
    // index of a prescribed motion (DemInput::groupMotion); -1: none
    int motion = -1;
    bool gravity = true;
    Vector3 force{{0, 0, 0}};               // on each particle [N]
    Vector3 moment{{0, 0, 0}};              // on each particle [N m]
    // alpha of paper 1, Eq. 25, on force and moment; wrong in free flight
    double localDamping = 0;
    double viscousDamping = 0;              // F = -c m v [1/s]
    double viscousSpinDamping = 0;          // M = -c I w [1/s]
    // of rigid bodies: a group with any has no other particles
    DemConstraint constraint;
    std::vector<DemSpring> springs;         // of the one rigid body of the group
};

//- Rigid motion of a group: v = velocity + spin x (x - centre)
struct RigidMotion { Vector3 velocity{{0, 0, 0}}, spin{{0, 0, 0}}, centre{{0, 0, 0}}; };
using GroupMotion = std::function<RigidMotion(int motion, double t)>;

struct DemParticles
{
    std::vector<double> position, velocity, spin;   // 3 n; velocity and spin may be empty: at rest
    std::vector<double> radius, mass;               // n [m], [kg]
    // n [kg m2]; empty: 2/5 m R^2 (spheres), 1/2 m R^2 (disks)
    std::vector<double> inertia;
    std::vector<std::int32_t> material, group;      // n; may be empty: all 0
    std::vector<std::int32_t> clump;                // n, index of the clump or -1; empty: none
    std::vector<std::int32_t> id;                   // n, unique, not negative; empty: 0 .. n-1
    std::size_t size() const { return position.size()/3; }
};

//- Where a rigid body is, and how it stands: quaternion (w, x, y, z) from the principal axes to
//  space
struct DemPose
{
    Vector3 position{{0, 0, 0}};
    std::array<double, 4> orientation{{1, 0, 0, 0}};
};

//- A rigid body of several spheres: particles of this clump index move with it; their masses and
//  inertias are not used
struct DemClump
{
    Vector3 position{{0, 0, 0}};            // centre of mass
    Vector3 velocity{{0, 0, 0}}, spin{{0, 0, 0}};   // spin in space
    // quaternion (w, x, y, z) from the principal axes to space
    std::array<double, 4> orientation{{1, 0, 0, 0}};
    double mass = 0;
    Vector3 inertia{{0, 0, 0}};             // principal moments [kg m2]; 2D: inertia[2] alone
    // [m3] (2D: [m2]); 0: not known, the mass over the density of its material
    double volume = 0;
    // since it was made, from `start`; else it stands there now
    bool moved = false;
    DemPose start;
    int group = 0;
    // of PicSolids::shapes, by which water sees it; -1: its spheres. Contacts see spheres
    int shape = -1;
};

struct DemBondType
{
    // kn, ks of the cement [Pa/m] (Eq. 42: E/(R_A + R_B))
    double normalStiffness = 0, shearStiffness = 0;
    double radiusFactor = 1;                // alpha
    std::string radiusKind = "mean";        // of the two radii (dem/bond/bondRadius.hpp)
    // 2D: round cement (A = pi R^2) instead of a plate of unit thickness; 3D is always round
    bool cylinder = false;
    double tensileStrength = 1e300, shearStrength = 1e300;  // sigma_c, tau_c [Pa]
    // dashpots beside the bond's springs, fraction of critical
    double dampingRatio = 0;
};

//- Bonds are made as given, never by accident. Each remembers the gap at which it was made as its
//  unstressed one.
struct DemBonds
{
    std::vector<std::int32_t> a, b;         // ids of particles
    std::vector<std::int32_t> type;         // index of DemInput::bondTypes; empty: all 0
    std::vector<double> gap;                // unstressed gap [m]; empty: the gap at hand
    std::size_t size() const { return a.size(); }
};

//- A wall: a plane (the half-space behind `point`, against `normal`), or a surface of triangles
//  (3D: three indices an element,
//  2D: two), touched from both sides
struct DemWall
{
    std::string name;
    int material = 0;
    bool plane = false;
    Vector3 point{{0, 0, 0}}, normal{{0, 0, 1}};    // plane; normal towards the particles
    std::vector<double> vertices;           // 3 m
    std::vector<std::int32_t> elements;     // indices of vertices, D an element
    // body index handed to DemInput::wallMotion; -1: at rest
    int motion = -1;
};

struct DemInput
{
    std::vector<DemMaterial> materials;
    std::vector<DemPair> pairs;             // every pair that can meet must be here
    std::vector<DemGroup> groups;           // empty: one, free
    DemParticles particles;
    std::vector<DemClump> clumps;
    std::vector<DemBondType> bondTypes;
    DemBonds bonds;
    std::vector<DemWall> walls;
    GroupMotion groupMotion;
    WallMotion wallMotion;
};

//- Neighbouring particles of a group whose surfaces are no further apart than `tolerance` [m]: what
//  to bond at seeding
DemBonds bondsWithin(const DemConfig&, const DemParticles&, int group, double tolerance);

//- A time that limits the step, and what it comes from: sqrt(m/k) of contacts and bonds, Rayleigh's
//  time of spheres pi R sqrt(rho/G)/(0.1631 nu + 0.8766). Hertz contacts: k at the overlap of an
//  impact at the speed that particles have or can fall to in the domain
//- hardStop: the largest step, of `critical`
struct StepLimit
{
    std::string name;
    double critical = 0;
    std::string cause;
    double hardStop = 0.5;
};

//- What a scene would take, before it is made
struct DemPlan
{
    std::size_t particles = 0, clumps = 0, bonds = 0, wallElements = 0;
    std::size_t bytes = 0;                  // device memory, about
    double timeStep = 0;                    // that will be taken
    // the limits' smallest, or what springs of a close packing stand
    double hardStop = 0;
    std::string hardCause;                  // which of them, in words
    std::string cause;                      // what sets the step
    std::vector<StepLimit> limits;
    std::vector<int> together;              // of each clump, members that can touch a plane at once
    std::vector<std::string> warnings;      // e.g. paper 2's spring eats the gap at this speed
};
DemPlan planDemScene(const DemConfig&, const DemInput&);

enum class DemStop {none, notANumber, tooFast};

using DemRankReport = RankReport;

struct DemReport
{
    double time = 0, lastTimeStep = 0;
    std::int64_t steps = 0, totalSteps = 0; // in this call, in all
    std::int64_t rebuilds = 0;              // of the neighbour lists, in this call
    double maxSpeed = 0;                    // [m/s] in the last step
    std::size_t particles = 0;              // still in the scene
    std::size_t brokenBonds = 0;            // in all
    std::size_t asleep = 0;                 // now
    std::vector<Vector3> escaped;           // last positions of those that left in this call
    std::vector<std::int32_t> escapedId;
    // particles that went through surfaces within the domain in this call
    std::size_t passedWalls = 0;
    std::int32_t passedId = -1;             // one of them
    DemStop stop = DemStop::none;           // then: which particle, where, how much, in words
    std::int32_t stopId = -1;
    Vector3 stopPosition{{0, 0, 0}};
    double stopValue = 0;
    std::string stopMessage;                // of particle stopId; of none where that is -1
    // of several processes. `escaped` and `passed` are of this one, the rest is of all
    DemRankReport rank;
};

//- Particles on the host, in the device's order
struct DemState
{
    // 3 n; force and moment of the last step, all of them
    std::vector<double> position, velocity, spin, force, moment;
    std::vector<double> orientation;        // 4 n (w, x, y, z) if DemConfig::orientation
    std::vector<double> radius, mass;
    std::vector<std::int32_t> material, group, clump, contacts, brokenBonds, id;
};

//- Contacts that carry force, each once. b < 0: wall -1 - b
struct DemContacts
{
    std::vector<std::int32_t> a, b;         // ids
    std::vector<double> point, force;       // 3 n; force on a
    std::vector<double> overlap;            // [m]
};

struct DemBondState
{
    std::vector<std::int32_t> number;       // its place among those that were given
    std::vector<std::int32_t> a, b, type;   // ids
    // 0, 1: in tension, 2: in shear, 3: a particle left the scene
    std::vector<std::int32_t> broken;
    std::vector<double> force, moment;      // 3 n, on a
    std::vector<double> gap, restGap;       // [m]
};

struct DemClumpState
{
    std::vector<double> position, velocity, spin, orientation, force, moment;
    // a clump: it is out of the domain, and what stands here is its last
    std::vector<char> left;
};

//- A spring or line of a group (DemGroup::springs), in the order of groups
struct DemSpringState
{
    std::string name;
    double length = 0;                      // now [m]
    double tension = 0;                     // [N], negative: it pushes
    Vector3 point{{0, 0, 0}}, force{{0, 0, 0}};     // where it acts, and on the body [N]
    bool left = false;                      // its body is out of the domain: nothing of it acts
};

struct DemEnergy                            // [J] (2D: per metre)
{
    double translation = 0, rotation = 0, potential = 0, contact = 0, bond = 0, spring = 0;
    double total() const { return translation + rotation + potential + contact + bond + spring; }
};

//- Of a group: its particles and the box about them; of those that are no members of rigid bodies
//  mass, sums of m x and m u. Components along the empty axis are 0
struct DemGroupSums
{
    double particles = 0, mass = 0;
    Vector3 massPosition{{0, 0, 0}}, momentum{{0, 0, 0}};
    Vector3 min{{0, 0, 0}}, max{{0, 0, 0}};
};

//- Of particles that are no members of rigid bodies, about the origin; in 2D the angular one is
//  along the empty axis
struct DemMomentum { Vector3 linear{{0, 0, 0}}, angular{{0, 0, 0}}; };

//- On the wall, and what of it is normal to where it is touched; moments about the origin
struct DemWallForce
{
    Vector3 force{{0, 0, 0}}, moment{{0, 0, 0}}, normal{{0, 0, 0}}, normalMoment{{0, 0, 0}};
};

class DemScene
{
public:
    virtual ~DemScene() = default;

    //- Advance to time t [s] or by maxSteps (0: no limit). The last steps are shortened to end at t
    //  to round-off. Stops early when a guard fires.
    virtual DemReport advance(double t, std::int64_t maxSteps = 0) = 0;
    virtual void interrupt() = 0;
    virtual double time() const = 0;

    //- What the last advance did; of solids in a fluid, that of the whole scene
    virtual const DemReport& lastReport() const = 0;

    virtual DemState particles() = 0;

    //- As it is now, for a thread that takes it while the scene moves on
    virtual Later<DemState> particlesLater()
    {
        return takenOf<DemState>(false, 0, [this] { return particles(); });
    }

    //- The same without contacts and brokenBonds, which take most of the time
    virtual DemState motion() = 0;
    virtual DemContacts contacts() = 0;
    // of several processes: each bond on one of them, all bodies on each; all make these calls
    virtual DemBondState bonds() = 0;
    virtual DemClumpState clumps() = 0;
    virtual DemEnergy energy() = 0;

    //- Summed on the device: at 1e6 particles in less than a millisecond, where motion() and a loop
    //  take a hundred
    virtual DemGroupSums groupSums(int group) = 0;
    virtual DemMomentum momentum() = 0;
    // of all contacts now, of the diameter of the smaller one
    virtual double deepestOverlap() = 0;
    virtual std::vector<DemWallForce> wallForces() = 0;     // in the order of DemInput::walls

    //- Forces and moments from outside (a fluid), added in every step until given anew; 3 values an
    //  id 0 .. largest id
    virtual void setExternalForces(
        const std::vector<double>& force, const std::vector<double>& moment) = 0;

    //- Exact state, histories and bonds included: a run continues bit for bit on the same device
    //  and precision
    std::vector<std::int32_t> saveState() { return savedState(false).take(); }
    //- The same, to be taken at once or later, while the scene moves on
    virtual Later<std::vector<std::int32_t>> savedState(bool later) = 0;
    virtual void loadState(const std::vector<std::int32_t>&) = 0;

    virtual DemPlan plan() const = 0;
    virtual std::vector<ArrayInfo> arrays() const = 0;
    virtual std::vector<KernelInfo> kernels() const = 0;
    virtual void timeKernels(bool on) = 0;
    // listed, each pair counted at both ends
    virtual double neighboursPerParticle() = 0;
    // between particles, each counted at both ends
    virtual double contactsPerParticle() = 0;
    virtual std::string deviceName() const = 0;
    virtual DeviceKind device() const = 0;
    virtual std::vector<DemSpringState> springs() = 0;      // of rigid bodies; a call of all
};

//- @throws std::invalid_argument (inconsistent input), std::runtime_error (device failure)
std::unique_ptr<DemScene> createDemScene(const DemConfig&, const DemInput&);

} // namespace riprap
