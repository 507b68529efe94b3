/*  What scenes of a fluid share, whatever moves it: how it is given, read back and sampled.

    SI, double, host memory; vectors are stored x0 y0 z0 x1 y1 z1 ... with three components in 2D as
    well.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/later.hpp"
#include "api/sceneTypes.hpp"

namespace riprap
{

struct FluidConfig
{
    int dimensions = 2;                     // 2 or 3
    int axes[3] = {0, 1, 2};                // 2D: axes[0], axes[1] are solved, axes[2] is empty
    double spacing = 0;                     // of the particles as given [m]
    double density = 1000;                  // reference density rho0 [kg/m3]
    double viscosity = 0;                   // dynamic viscosity mu [Pa s]
    Vector3 gravity{{0, 0, 0}};             // [m/s2]
};

//- Steps of the fluid's particles, as either method has them
struct TimeControl
{
    double startTime = 0;                   // [s] the scene's clock when it is made
    bool adjustTimeStep = true;
    double fixedTimeStep = 0;               // [s], used if !adjustTimeStep
    double maxTimeStep = 1e30;              // [s]
};

//- Particles as the reader of a case or setParticles gives them
struct FluidInput
{
    std::vector<double> position;           // 3 n
    std::vector<double> velocity;           // 3 n
    std::vector<double> density;            // n [kg/m3]
    std::vector<std::int32_t> id;           // n, unique; empty: 0 .. n-1
    std::size_t size() const { return position.size()/3; }
};

enum class StopReason {none, notANumber, density, speed, listOverflow, solids, tooFast};

struct FluidEnergy                            // [J] (2D: per metre of depth)
{
    double kinetic = 0, potential = 0, elastic = 0;
    double wallWork = 0;                    // done by moving walls since the start
    // SPH, where walls move: what the pressure of all walls did beyond that, since the start
    double wallPressureWork = 0;
    // SPH: by faces of walls on particles that they put back, since the start; negative: taken
    double faceWork = 0;
    // elastic energy that changes of the speed of sound have added since the start
    double stiffening = 0;
};

using SphEnergy = FluidEnergy;

//- Fluid on the host, in the device's order
struct FluidState
{
    std::vector<double> position, velocity; // 3 n
    std::vector<double> density, pressure, smoothingLength; // n
    std::vector<std::int32_t> id;
};

struct FluidExtremes
{
    double speed = 0;                       // largest [m/s]
    double densityDeviation = 0;            // largest of |rho/rho0 - 1|
};

//- The particles that lie furthest along a direction, in no order
struct FluidEnd
{
    std::size_t particles = 0;              // in all
    std::vector<double> position;           // 3 m
};

//- Interpolated values at points; SPH: sum V f W / sum V W, and sum V W itself. They are those at
//  the centroid of what was sampled, which is not the point where the fluid about it is one-sided
struct SampleResult
{
    std::vector<double> volumeFraction;     // m: sum of V_j W, about 1 inside, 0 outside
    std::vector<double> pressure;           // m [Pa], 0 where there is no fluid
    std::vector<double> velocity;           // 3 m [m/s]
    // 3 m [m] of the sampled fluid, from the point; 0 where there is none
    std::vector<double> centroid;
};

//- What hides fluid from points of sampling: at point i fluid counts only where normal.(x - x_i) >=
//  -depth for each of the planes first[i] .. first[i + 1] - 1. Empty: all of it counts
struct SightPlanes
{
    std::vector<std::int32_t> first;        // m + 1, or empty
    std::vector<double> normal;             // 3 a plane, unit
    std::vector<double> depth;              // of the plane behind the point [m]
};

//- Force of the fluid on a place of a wall or on a solid [N], and its moment about that place [N m]
//  (2D: a metre of depth)
struct FluidForce
{
    // of walls the caller's number of what the place belongs to, of solids their group
    std::int32_t part = 0;
    Vector3 place{{0, 0, 0}};               // [m]
    Vector3 pressure{{0, 0, 0}}, viscous{{0, 0, 0}};
    Vector3 pressureMoment{{0, 0, 0}}, viscousMoment{{0, 0, 0}};
};

class FluidScene
{
public:
    virtual ~FluidScene() = default;

    virtual double time() const = 0;
    virtual FluidState fluid() = 0;
    //- As it is now, for a thread that takes it while the scene moves on
    virtual Later<FluidState> fluidLater()
    {
        return takenOf<FluidState>(false, 0, [this] { return fluid(); });
    }
    virtual FluidEnergy energy() = 0;
    virtual FluidExtremes extremes() = 0;

    //- Those no more than reach [m] behind the one that is furthest along a unit vector; a few more
    //  where round-off decides
    virtual FluidEnd farEnd(const Vector3& direction, double reach) = 0;

    //- Where they are not zero, now (SPH) or in the last step (PIC)
    virtual std::vector<FluidForce> forcesOnWalls() = 0;
    virtual std::vector<FluidForce> forcesOnSolids() = 0;

    //- Interpolation of the fluid at points (3 m). Particles behind the planes are left out; a
    //  grid's water ends at its walls by itself
    virtual SampleResult sample(const std::vector<double>& points, const SightPlanes&) = 0;
    SampleResult sample(const std::vector<double>& points) { return sample(points, SightPlanes()); }
};

} // namespace riprap
