/*  Boundaries of stability from both sides: just below one a small disturbance stays small, just
    above it grows (docs/stability.md). Theory is that of benchmarks/README.md.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "coupling/couplingTest.hpp"
#include "dem/demTest.hpp"
#include "paperEquations.hpp"

namespace riprap
{
namespace
{

class StabilityLimits : public CouplingTest
{
protected:

    static constexpr int sites = 16;

    SphConfig periodicBox() const
    {
        SphConfig c = config();
        c.spacing = 1.0/sites;
        c.periodic[0] = c.periodic[1] = true;
        c.eos = "linear";
        c.adjustTimeStep = false;
        c.integrator = "symplectic";
        return c;
    }

    double largest(SphScene& s) const
    {
        double most = 0;
        for (const double v : s.fluid().velocity) most = std::max(most, std::abs(v));
        return most;
    }

    //- omega of the fastest sound of the lattice
    double fastestSound(const SphConfig& c) const
    {
        const double h = c.smoothingRatio*c.spacing, volume = c.spacing*c.spacing,
                     k = 2*std::acos(-1.0);
        double most = 0;
        for (int m = 0; m <= sites/2; ++m)
            for (int n = 0; n <= m; ++n)
            {
                double S[2] = {0, 0};
                for (int i = -6; i <= 6; ++i)
                    for (int j = -6; j <= 6; ++j)
                    {
                        const Vector3 x{{i*c.spacing, j*c.spacing, 0}},
                            g = paper::gradW(c.kernel, 2, x, h);
                        for (int d = 0; d < 2; ++d)
                            S[d] -= volume*g[d]*std::sin(k*(m*x[0] + n*x[1]));
                    }
                most = std::max(most, c.soundSpeed*std::hypot(S[0], S[1]));
            }
        return most;
    }

    FluidInput noise(const SphConfig& c) const
    {
        FluidInput f = lattice(c, {{0, 0, 0}}, {{1, 1, 0}});
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> u(-1, 1);
        for (std::size_t i = 0; i < f.size(); ++i)
            for (int d = 0; d < 2; ++d) f.velocity[3*i + d] = 1e-6*c.soundSpeed*u(engine);
        return f;
    }
};

RIPRAP_PLANE_SETUPS(StabilityLimits);

//- Density diffusion of 0.1 shortens the symplectic step from omega dt = 2 to 1.755
TEST_P(StabilityLimits, DiffusionShortensTheStepOfSound)
{
    SphConfig c = periodicBox();
    c.diffusion = "molteni";
    const double omega = fastestSound(c);
    for (const double theta : {1.70, 1.85})
    {
        c.fixedTimeStep = theta/omega;
        const auto s = scene(c, noise(c));
        const double before = largest(*s);
        s->advance(1e30, 300);
        if (theta < 1.755) { EXPECT_LT(largest(*s), 2*before); }
        else { EXPECT_GT(largest(*s), 1000*before); }
    }
}

//- The fastest decay of a shear wave times dt is one: nu dt/h^2 = 0.163 with Wendland's kernel and
//  h = 1.25 spacings
TEST_P(StabilityLimits, ViscousStep)
{
    SphConfig c = periodicBox();
    c.viscosityModel = "laminar";
    const double h = c.smoothingRatio*c.spacing, nu = 100*c.soundSpeed*h;
    c.viscosity = nu*c.density;
    for (const double x : {0.155, 0.172})
    {
        c.fixedTimeStep = x*h*h/nu;
        const auto s = scene(c, noise(c));
        s->advance(1e30, 20);
        const double before = largest(*s);
        s->advance(1e30, 200);
        if (x < 0.163) { EXPECT_LT(largest(*s), before); }
        else { EXPECT_GT(largest(*s), 100*before); }
    }
}

//- The energy of a light body over the water's: with forces held over the step, or interpolated, it
//  grows below a density ratio of theirs; with the reversible step it stays what a body has that
//  moves with the water
TEST_P(StabilityLimits, HeldForcesThrowLightBodies)
{
    if (!mixed()) GTEST_SKIP() << "precision adds nothing";
    const auto share = [&](double ratio, const std::string& force)
    {
        SphConfig c = waterBox();
        c.soundSpeed = 10;
        c.maxVelocity = 1;
        c.integrator = "symplectic";
        c.acousticCourant = 0.4;
        c.viscosityModel = "none";
        SolidInput solids = rigid(block(c, 6, c.spacing, {{0.3, 0.6, 0}}));
        for (double& m : solids.input.particles.mass) m *= ratio/0.8;
        solids.input.clumps[0].mass *= ratio/0.8;
        for (double& j : solids.input.clumps[0].inertia) j *= ratio/0.8;
        solids.coupling.kind = "pressureGradient";
        solids.coupling.force = force;
        FluidInput water = waterAround(c, {{0.3, 0.6, 0}}, 6*c.spacing);
        for (std::size_t i = 0; i < water.size(); ++i)
        {
            const double x = 2*std::acos(-1.0)*water.position[3*i],
                         y = 2*std::acos(-1.0)*water.position[3*i + 1];
            water.velocity[3*i] = 0.3*std::sin(y);
            water.velocity[3*i + 1] = 0.3*std::sin(x);
            water.density[i] = 1.01*c.density;
        }
        const auto s = createSphDemScene(c, water, {}, solids);
        const double kinetic = s->energy().kinetic;
        const SphReport r = s->advance(0.4);
        return r.stop == StopReason::none ? s->solids()->energy().total()/kinetic : 1e300;
    };
    EXPECT_LT(share(0.3, "held"), 0.04) << "its least is 0.21";
    EXPECT_GT(share(0.05, "held"), 1);
    EXPECT_LT(share(0.15, "interpolated"), 0.03) << "its least is 0.117";
    EXPECT_GT(share(0.025, "interpolated"), 0.1);
    EXPECT_LT(share(0.025, "impulse"), 0.02);
}


class StabilityOfSolids : public DemTest
{
protected:

    //- Bodies of radius, mass and stiffness 1
    DemConfig unit(int dimensions) const
    {
        DemConfig c = config(dimensions);
        c.domainMin = Vector3{{-50, -50, -50}};
        c.domainMax = Vector3{{50, 50, 50}};
        c.allowLargeStep = true;
        return c;
    }

    //- Has the kinetic energy grown a millionfold within 600 steps?
    bool grows(DemConfig c, const DemInput& in, double step) const
    {
        c.timeStep = step;
        const auto s = createDemScene(c, in);
        const auto kinetic = [&]
        {
            const DemEnergy e = s->energy();
            return e.translation + e.rotation;
        };
        const double before = kinetic();
        for (int part = 0; part < 30; ++part)
        {
            if (s->advance(1e9, 20).stop != DemStop::none || !(kinetic() < 1e6*before)) return true;
        }
        return false;
    }
};

INSTANTIATE_TEST_SUITE_P(, StabilityOfSolids,
    testing::Values(DemCase{DeviceKind::cpu, PrecisionKind::doubled}), demCaseName);

//- 2 sqrt(m/k)
TEST_P(StabilityOfSolids, BodyOnAFloor)
{
    DemConfig c = unit(3);
    const double weight = 1e-3;
    c.gravity = Vector3{{0, 0, -weight}};
    DemInput in = oneMaterial(1);
    DemWall floor;
    floor.name = "floor";
    floor.plane = true;
    floor.point = Vector3{{0, 0, 0}};
    floor.normal = Vector3{{0, 0, 1}};
    in.walls.push_back(floor);
    addParticle(in, {{0, 0, 1 - weight}}, {{0, 0, 1e-12}}, 1, 1);
    EXPECT_FALSE(grows(c, in, 1.98));
    EXPECT_TRUE(grows(c, in, 2.02));
}

//- Compressed along a periodic axis: sqrt(m/k); disks in a hexagonal packing without friction:
//  2/sqrt(6)
TEST_P(StabilityOfSolids, Packings)
{
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> u(-1e-12, 1e-12);
    const double apart = 2 - 1e-3;
    {
        DemConfig c = unit(2);
        c.domainMin = Vector3{{0, -10, -10}};
        c.domainMax = Vector3{{12*apart, 10, 10}};
        c.periodic[0] = true;
        DemInput in = oneMaterial(1);
        for (int i = 0; i < 12; ++i)
            addParticle(in, {{apart*(i + 0.25), 0, 0}}, {{u(engine), 0, 0}}, 1, 1);
        EXPECT_FALSE(grows(c, in, 0.98));
        EXPECT_TRUE(grows(c, in, 1.02));
    }
    {
        DemConfig c = unit(2);
        const double row = std::sqrt(0.75)*apart;
        c.domainMin = Vector3{{0, 0, -10}};
        c.domainMax = Vector3{{6*apart, 6*row, 10}};
        c.periodic[0] = c.periodic[1] = true;
        DemInput in = oneMaterial(1);
        for (int j = 0; j < 6; ++j)
            for (int i = 0; i < 6; ++i)
                addParticle(in, {{apart*(i + 0.25 + 0.5*(j % 2)), row*(j + 0.25), 0}},
                    {{u(engine), u(engine), 0}}, 1, 1);
        EXPECT_FALSE(grows(c, in, 0.80));
        EXPECT_TRUE(grows(c, in, 0.835));
    }
}

//- Paper 2's stiffness m g/(theta dx): a gap of 2 dx is used up at 2 dx/sqrt(theta dx/g) against a
//  wall
TEST_P(StabilityOfSolids, SpeedThatUsesUpAGap)
{
    const double dx = 0.1, g = 1e-3, theta = 0.01, speed = 2*dx/std::sqrt(theta*dx/g);
    const auto left = [&](double v)
    {
        DemConfig c = unit(3);
        c.normal = "cellSpring";
        c.gravity = Vector3{{0, 0, 0}};
        c.stepFraction = 0.01;
        DemInput in = oneMaterial(1);
        PairProperties& p = in.pairs[0].properties;
        p.theta = theta;
        p.cellSize = dx;
        p.gravity = g;
        p.gap = 2*dx;
        DemWall floor;
        floor.name = "floor";
        floor.plane = true;
        floor.point = Vector3{{0, 0, 0}};
        floor.normal = Vector3{{0, 0, 1}};
        in.walls.push_back(floor);
        addParticle(in, {{0, 0, 1 + 2*dx + 1e-3}}, {{0, 0, -v}}, 1, 1);
        const auto s = createDemScene(c, in);
        double least = 1;
        for (int k = 0; k < 2000; ++k)
        {
            s->advance(1e9, 1);
            const DemState now = s->particles();
            least = std::min(least, now.position[2] - 1);
            if (now.velocity[2] > 0) break;
        }
        return least;
    };
    EXPECT_GT(left(0.98*speed), 0);
    EXPECT_LT(left(1.02*speed), 0);
}

//- Local damping of alpha takes alpha of the unbalanced force: bodies fall at (1 - alpha) g and
//  rise against (1 + alpha) g
TEST_P(StabilityOfSolids, LocalDampingInFlight)
{
    for (const bool up : {false, true})
    {
        DemConfig c = unit(3);
        const double g = 1e-3, alpha = 0.5, start = up ? 0.2 : 0, time = 50;
        c.gravity = Vector3{{0, 0, -g}};
        c.timeStep = 0.1;
        DemInput in = oneMaterial(1);
        in.groups.resize(1);
        in.groups[0].localDamping = alpha;
        addParticle(in, {{0, 0, 0}}, {{0, 0, start}}, 1, 1);
        const auto s = createDemScene(c, in);
        s->advance(time);
        EXPECT_NEAR(
            (start - s->particles().velocity[2])/(g*time), up ? 1 + alpha : 1 - alpha, 2e-3);
    }
}

} // namespace
} // namespace riprap
