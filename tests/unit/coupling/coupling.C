/*  Fluid and solids: the force of one pair as the paper has it, momentum, energy and exact restart.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "couplingTest.hpp"
#include "sph/kernels/wendlandC2.hpp"

namespace riprap
{
namespace
{

using Coupling = CouplingTest;

RIPRAP_ALL_SETUPS(Coupling);

//- One fluid particle and one solid one of half its size: paper 1, Eqs. 34, 40 and 41 in double
TEST_P(Coupling, ForceOfOnePair)
{
    for (const std::string& kind : allKinds)
    {
        SCOPED_TRACE(kind);
        SphConfig c = config();
        c.wallSpacing = c.spacing;
        FluidInput f;
        const double x = 0.5, distance = 0.8*c.spacing, deviation = 0.01;
        f.position = {x, 0.5, D() == 3 ? 0.5 : 0.0};
        f.velocity = {0, 0, 0};
        f.density = {c.density*(1 + deviation)};
        SolidInput solids = block(c, 1, 0.5*c.spacing, {{0, 0, 0}});
        solids.coupling.kind = kind;
        solids.input.particles.position = {x + distance, 0.5, D() == 3 ? 0.5 : 0.0};
        const auto s = createSphDemScene(c, f, {}, solids);

        const double h = c.smoothingRatio*c.spacing, q = distance/h, rho = f.density[0];
        const double m = c.density*std::pow(c.spacing, D()), mS = c.density*solids.volume[0];
        // |dW/dr|, negative
        const double slope = WendlandC2::alpha(D())/std::pow(h, D() + 2)*WendlandC2::slope(q)
            *distance;
        const double w = WendlandC2::alpha(D())/std::pow(h, D())*WendlandC2::value(q);
        const auto pressure = [&](double d)
        { return c.soundSpeed*c.soundSpeed*c.density/7*(std::pow(1 + d, 7) - 1); };
        const double p = pressure(deviation);
        double pS = 0, rhoS = c.density;
        if (kind == "pressureApproximation") pS = p*w*m/rho;
        if (kind == "extrapolated") pS = p;
        if (pS > 0)
            rhoS = c.density
                *std::pow(1 + 7*pS/(c.soundSpeed*c.soundSpeed*c.density), 1.0/7);
        const double expected = kind == "pressureGradient"
            // away from the fluid
            ? -m/rho*solids.volume[0]*p*slope : -m*mS*(p/(rho*rho) + pS/(rhoS*rhoS))*slope;
        const CouplingState now = s->coupling();
        EXPECT_NEAR(now.force[0], expected, (mixed() ? 3e-5 : 1e-10)*expected);
        EXPECT_GT(expected, 0);
        EXPECT_EQ(now.force[1], 0);
    }
}

//- Artificial viscosity is friction that grows with the spacing: it acts between fluid and solids
//  where it acts at walls, and only there
TEST_P(Coupling, ArtificialViscosityActsOnSolidsAsAtWalls)
{
    const auto push = [&](const char* viscosity, bool atWalls)
    {
        SphConfig c = config();
        c.wallSpacing = c.spacing;
        c.viscosityModel = viscosity;
        c.artificialAtWalls = atWalls;
        FluidInput f;
        f.position = {0.5, 0.5, D() == 3 ? 0.5 : 0.0};
        f.velocity = {0.1, 0, 0};
        f.density = {1.01*c.density};
        SolidInput solids = block(c, 1, 0.5*c.spacing, {{0, 0, 0}});
        solids.input.particles.position = {0.5 + 0.8*c.spacing, 0.5, D() == 3 ? 0.5 : 0.0};
        return createSphDemScene(c, f, {}, solids)->coupling().force[0];
    };
    const double none = push("none", true);
    EXPECT_GT(none, 0);
    EXPECT_EQ(push("artificial", false), none);
    EXPECT_GT(push("artificial", true), (mixed() ? 1 + 3e-5 : 1 + 1e-10)*none);
}

//- What the fluid loses the solids gain, step by step, whatever the scheme; bonded bodies and rigid
//  ones
TEST_P(Coupling, MomentumIsKept)
{
    struct Case { std::string scheme, force; bool rigid; };
    const Case cases[] = {{"leapfrog", "held", false}, {"symplectic", "impulse", false},
        {"symplectic", "interpolated", false}, {"leapfrog", "interpolated", true},
        {"symplectic", "held", true}, {"symplectic", "impulse", true}};
    for (const std::string& kind : allKinds)
        for (const Case& now : cases)
        {
            SCOPED_TRACE(kind + ", " + now.scheme + ", " + now.force
                + (now.rigid ? ", rigid" : ", bonded"));
            SphConfig c = waterBox();
            c.integrator = now.scheme;
            c.acousticCourant = 0.2;
            const double size = 0.6*c.spacing;
            SolidInput solids = block(c, 5, size, {{0.3, 0.3, D() == 3 ? 0.3 : 0.0}});
            if (now.rigid) solids = rigid(solids);
            solids.coupling.kind = kind;
            solids.coupling.force = now.force;
            const auto s = createSphDemScene(
                c, waterAround(c, {{0.3, 0.3, 0.3}}, 5*size), {}, solids);
            const Momentum before = momentum(*s, c);
            const double start = std::sqrt(
                std::pow(s->coupling().total[0], 2) + std::pow(s->coupling().total[1], 2));
            const SphReport report = s->advance(1, 20);
            ASSERT_EQ(report.stop, StopReason::none);
            const Momentum after = momentum(*s, c);
            if (!now.rigid) { EXPECT_GT(s->coupling().subcycles, 1); }
            // each velocity is rounded a few times a step
            for (int d = 0; d < D(); ++d)
                EXPECT_NEAR(after.sum[d], before.sum[d], 40*epsilon()*after.size)
                    << "axis " << d;
            EXPECT_GT(start*report.time, 1e-4*after.size) << "or the test would prove nothing";
            double speed = 0;
            const DemState q = s->solids()->particles();
            for (const double v : q.velocity) speed = std::max(speed, std::abs(v));
            EXPECT_GT(speed, 1e-3) << "the solids must have been moved";
        }
}

//- A held force is late by half a step, one on the line through the last two is not: errors of the
//  first and of the second order in the step
TEST_P(Coupling, OrderOfTheForceInTime)
{
    if (D() == 3 || mixed())
        GTEST_SKIP() << "neither the third dimension nor rounding adds anything";
    const auto centre = [&](const std::string& force, double dt)
    {
        SphConfig c = waterBox();
        c.integrator = "symplectic";
        c.viscosityModel = "none";
        c.adjustTimeStep = false;
        c.fixedTimeStep = dt;
        const double size = c.spacing;
        SolidInput solids = block(c, 4, size, {{0.3, 0.3, 0}});
        solids.config.timeStep = 2e-5;          // another one would be another solid
        // without accelerations of steps past
        solids.coupling.kind = "pressureGradient";
        solids.coupling.force = force;
        FluidInput water = waterAround(c, {{0.3, 0.3, 0.3}}, 4*size);
        for (std::size_t i = 0; i < water.size(); ++i)
        {
            water.density[i] = c.density
                *(1.01 + 0.005*std::sin(2*std::acos(-1.0)*water.position[3*i]));
            for (int d = 0; d < 3; ++d) water.velocity[3*i + d] = 0;
        }
        const auto s = createSphDemScene(c, water, {}, solids);
        s->advance(0.016);
        const DemState q = s->solids()->particles();
        double x = 0;
        for (std::size_t i = 0; i < q.id.size(); ++i) x += q.position[3*i]/double(q.id.size());
        return x;
    };
    const auto order = [&](const std::string& force)
    {
        const double a = centre(force, 1e-4), b = centre(force, 5e-5), d = centre(force, 2.5e-5);
        return std::log2(std::abs(a - b)/std::abs(b - d));
    };
    EXPECT_NEAR(order("held"), 1, 0.3);
    EXPECT_GT(order("interpolated"), 1.7);
    EXPECT_GT(order("impulse"), 1.7);
}

std::int64_t launches(const DemScene& scene)
{
    std::int64_t n = 0;
    for (const KernelInfo& k : scene.kernels()) n += k.launches;
    return n;
}

//- Solids that are all held cost no steps of their own, and stay where they are; one that is free
//  brings them back
TEST_P(Coupling, HeldSolidsTakeOneStep)
{
    for (const bool free : {false, true})
    {
        const SphConfig c = waterBox();
        const double size = 0.6*c.spacing;
        SolidInput solids = block(c, 5, size, {{0.3, 0.3, D() == 3 ? 0.3 : 0.0}});
        DemGroup held;
        held.held[0] = held.held[1] = held.held[2] = held.heldSpin = true;
        solids.input.groups = {held, DemGroup()};
        solids.input.particles.group.assign(solids.input.particles.size(), 0);
        if (free) solids.input.particles.group.back() = 1;
        const auto s = createSphDemScene(c, waterAround(c, {{0.3, 0.3, 0.3}}, 5*size), {}, solids);
        ASSERT_EQ(s->advance(1, 10).stop, StopReason::none);
        EXPECT_EQ(s->coupling().subcycles > 1, free);
        EXPECT_NEAR(s->solids()->time(), s->time(), 1e-12*s->time());
        // held ones launch nothing of their own step by step: as much in 30 steps as in 10
        const std::int64_t before = launches(*s->solids());
        s->advance(1, 10);
        const std::int64_t ten = launches(*s->solids()) - before;
        s->advance(1, 30);
        const std::int64_t thirty = launches(*s->solids()) - before - ten;
        if (free) { EXPECT_GT(thirty, ten); }
        else { EXPECT_EQ(thirty, ten); }
        const DemState now = s->solids()->particles();
        double way = 0, force = 0;
        for (std::size_t i = 0; i < now.id.size(); ++i)
            for (int d = 0; d < D(); ++d)
            {
                way = std::max(way,
                    std::abs(now.position[3*i + d]
                        - solids.input.particles.position[3*std::size_t(now.id[i]) + d]));
                force = std::max(force, std::abs(s->coupling().force[3*i + d]));
            }
        EXPECT_GT(force, 0);
        if (free) EXPECT_GT(way, 1e-9);
        else EXPECT_LT(way, 1e-9);      // fixed point
    }
}

//- Nothing is dissipated: fluid and solids together keep their energy, but for the second order in
//  the step and what Eqs. 32 and 34 exchange more than they should (docs/theory.md): 2 % of the
//  kinetic energy. The water stands off the block by another gap than it was put at; until it has
//  found that, pressure that solids take from the fluid does work p dV on it that no energy answers
//  for: 2 % and 1.4 % at this pressure, by itself (docs/coupling.md)
TEST_P(Coupling, EnergyIsKept)
{
    if (D() == 3) GTEST_SKIP() << "the third dimension adds nothing";
    for (const std::string& kind : allKinds)
    {
        SCOPED_TRACE(kind);
        SphConfig c = waterBox();
        c.spacing = 0.025;
        c.smoothingRatio = 1.5;
        c.soundSpeed = 10;
        c.maxVelocity = 1;
        c.integrator = "symplectic";
        c.acousticCourant = 0.4;
        c.viscosityModel = "none";
        const double side = 6*c.spacing, low = 0.4;
        SolidInput solids = block(c, 6, c.spacing, {{low, low, 0}});
        solids.coupling.kind = kind;
        solids.coupling.force = "impulse";     // bonds are not damped
        FluidInput water = waterAround(c, {{low, low, 0}}, side);
        for (std::size_t i = 0; i < water.size(); ++i)
        {
            const double x = 2*std::acos(-1.0)*water.position[3*i],
                         y = 2*std::acos(-1.0)*water.position[3*i + 1];
            water.velocity[3*i] = 0.3*std::sin(y);
            water.velocity[3*i + 1] = 0.3*std::sin(x);
            water.density[i] = 1.01*c.density;          // pressed together: nothing is in tension
        }
        const auto s = createSphDemScene(c, water, {}, solids);
        const auto total = [&]
        {
            const SphEnergy e = s->energy();
            return e.kinetic + e.elastic + s->solids()->energy().total();
        };
        s->advance(0.1);
        const double before = total(), kinetic = s->energy().kinetic;
        s->advance(0.2);
        EXPECT_NEAR(total(), before, 0.02*kinetic);
        EXPECT_GT(s->solids()->energy().total(), 1e-6*kinetic) << "the solids must have taken part";
    }
}

//- A rigid body a twentieth as heavy as the water that it displaces, pushed about by it: the
//  reversible step holds it, whatever the coupling
TEST_P(Coupling, LightBodiesAreStable)
{
    if (D() == 3 || !mixed())
        GTEST_SKIP() << "neither the third dimension nor precision adds anything";
    for (const std::string& kind : allKinds)
    {
        SCOPED_TRACE(kind);
        SphConfig c = waterBox();
        c.soundSpeed = 10;
        c.maxVelocity = 1;
        c.integrator = "symplectic";
        c.acousticCourant = 0.4;
        c.viscosityModel = "none";
        SolidInput solids = rigid(block(c, 6, c.spacing, {{0.3, 0.6, 0}}));
        for (double& m : solids.input.particles.mass) m *= 0.05/0.8;
        solids.input.clumps[0].mass *= 0.05/0.8;
        for (double& j : solids.input.clumps[0].inertia) j *= 0.05/0.8;
        solids.coupling.kind = kind;
        solids.coupling.force = "impulse";
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
        EXPECT_EQ(r.stop, StopReason::none);
        EXPECT_LT(s->solids()->energy().total(), 0.02*kinetic)
            << "as a body that moves with the water has";
    }
}

TEST_P(Coupling, ContinuesToTheBit)
{
    for (const std::string kind : {"pressureGradient", "extrapolated"})
        for (const std::string scheme : {"leapfrog", "symplectic"})
        {
            SphConfig c = waterBox();
            c.integrator = scheme;
            const double size = 0.6*c.spacing;
            SolidInput solids = block(c, 4, size, {{0.3, 0.3, D() == 3 ? 0.3 : 0.0}});
            solids.coupling.kind = kind;
            solids.coupling.force = scheme == "symplectic" ? "impulse" : "interpolated";
            const FluidInput water = waterAround(c, {{0.3, 0.3, 0.3}}, 4*size);
            const auto a = createSphDemScene(c, water, {}, solids),
                       b = createSphDemScene(c, water, {}, solids);
            a->advance(0.01);
            b->loadState(a->saveState());
            a->advance(0.02);
            b->advance(0.02);
            expectSameBits(a->fluid(), b->fluid());
            const DemState p = a->solids()->particles(), q = b->solids()->particles();
            EXPECT_EQ(p.id, q.id);
            EXPECT_EQ(p.position, q.position);
            EXPECT_EQ(p.velocity, q.velocity);
            EXPECT_EQ(a->coupling().force, b->coupling().force);
            EXPECT_DOUBLE_EQ(a->solids()->time(), a->time());
        }
}

} // namespace
} // namespace riprap
