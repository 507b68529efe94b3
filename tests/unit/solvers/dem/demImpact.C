/*  DEM scenes of few particles against closed forms: impacts, weight on a plane, sliding to
    rolling, slopes, groups, guards.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemImpact = DemTest;

//- Equal bodies exchange their velocities in a head-on elastic impact
TEST_P(DemImpact, HeadOnExchange)
{
    for (const int D : {2, 3})
    {
        DemInput in = oneMaterial();
        addParticle(in, {{-0.05, 0, 0}}, {{1, 0, 0}});
        addParticle(in, {{0.0, 0, 0}});
        auto scene = createDemScene(config(D), in);
        scene->advance(0.08);
        const DemState s = scene->particles();
        // leapfrog's phase error (w dt)^2/24 and a first overlap of up to v dt: 1e-4 at this step;
        // mixed: overlaps to 1e-7 of the radius
        EXPECT_NEAR(s.velocity[3*find(s, 0)], 0, 2e-3);
        EXPECT_NEAR(s.velocity[3*find(s, 1)], 1, 2e-3);
        EXPECT_NEAR(s.velocity[3*find(s, 0)] + s.velocity[3*find(s, 1)], 1, mixed() ? 1e-6 : 1e-13);
    }
}

//- A body at rest on a plane sinks in by m g/k, and the plane carries its weight
TEST_P(DemImpact, WeightOnPlane)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity = Vector3{{0, -9.81, 0}};
        DemInput in = oneMaterial();
        in.pairs[0].properties.restitution = 0.05;
        in.walls.push_back(planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
        addParticle(in, {{0, -0.1901, 0}});
        auto scene = createDemScene(c, in);
        scene->advance(0.5);
        const DemState s = scene->particles();
        const double weight = 0.01*9.81;
        EXPECT_NEAR(s.position[1], -0.19 - weight/1e4, mixed() ? 2e-9 : 1e-12);
        EXPECT_NEAR(scene->wallForces()[0].force[1], -weight, 1e-4*weight);
        EXPECT_EQ(s.contacts[0], 1);
    }
}

//- MFIX DEM04: a sphere thrown along a rough plane slides until t = 2 u0/(7 mu g), then rolls at
//  5/7 u0 (disks: 2/3, u0/(3 mu g))
TEST_P(DemImpact, SlidesThenRolls)
{
    for (const int D : {2, 3})
    {
        const double u0 = 0.5, mu = 0.3, g = 9.81;
        DemConfig c = config(D);
        c.tangential = "history";
        c.gravity = Vector3{{0, -g, 0}};
        DemInput in = oneMaterial();
        in.pairs[0].properties.friction = mu;
        in.pairs[0].properties.restitution = 0.5;
        in.walls.push_back(planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
        const double rest = -0.19 - 0.01*g/1e4;
        addParticle(in, {{-0.3, rest, 0}}, {{u0, 0, 0}});
        auto scene = createDemScene(c, in);
        const double end = (D == 2 ? 1.0/3 : 2.0/7)*u0/(mu*g),
                     rolling = (D == 2 ? 2.0/3 : 5.0/7)*u0;
        scene->advance(0.5*end);
        DemState s = scene->particles();
        EXPECT_NEAR(s.velocity[0], u0 - 0.5*mu*g*end, 1e-3*u0);
        scene->advance(0.25);
        s = scene->particles();
        EXPECT_NEAR(s.velocity[0], rolling, 1e-3*rolling);
        EXPECT_NEAR(s.spin[2], -rolling/0.01, 2e-3*rolling/0.01);
    }
}

//- On a slope below friction's angle and with its rolling held, a body rests on the history spring,
//  and creeps on the one-step spring
//  at V = m g sin(slope)/(k_t dt)
TEST_P(DemImpact, OneStepSpringCreeps)
{
    for (const std::string kind : {"history", "oneStep"})
    {
        const double slope = 0.2, g = 9.81, kappa = 0.4;
        DemConfig c = config(3);
        c.tangential = kind;
        c.timeStep = 2e-5;
        c.gravity = Vector3{{g*std::sin(slope), -g*std::cos(slope), 0}};
        DemInput in = oneMaterial();
        PairProperties& p = in.pairs[0].properties;
        p.friction = 0.6;
        p.restitution = 0.3;
        p.stiffnessRatio = kappa;
        p.tangentialDamping = kind == "history";
        in.groups.emplace_back();
        in.groups[0].heldSpin = true;
        in.walls.push_back(planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
        addParticle(in, {{-0.3, -0.19 - 0.01*g*std::cos(slope)/1e4, 0}});
        auto scene = createDemScene(c, in);
        scene->advance(0.9);                // seven times m/(k_t dt), in which it is approached
        const double speed = scene->particles().velocity[0],
                     creep = 0.01*g*std::sin(slope)/(kappa*1e4*c.timeStep);
        if (kind == "history") EXPECT_NEAR(speed, 0, 1e-4*creep);
        else EXPECT_NEAR(speed, creep, 0.01*creep);
        // the wall gets the weight along its normal, and along itself what holds the body; both act
        // at the centre's height over the wall or on it
        const DemWallForce f = scene->wallForces()[0];
        const double weight = 0.01*g;
        EXPECT_NEAR(f.normal[1], -weight*std::cos(slope), 1e-4*weight);
        EXPECT_NEAR(f.normal[0], 0, 1e-6*weight);
        EXPECT_NEAR(f.force[0] - f.normal[0], weight*std::sin(slope), 1e-3*weight);
        EXPECT_NEAR(f.force[1] - f.normal[1], 0, 1e-6*weight);
        const double x = scene->particles().position[0];
        EXPECT_NEAR(f.normalMoment[2], x*f.normal[1], 1e-6*weight);
        EXPECT_NEAR(f.moment[2] - f.normalMoment[2], 0.2*(f.force[0] - f.normal[0]), 1e-4*weight);
    }
}

//- A sphere that rolls is slowed by 5/7 mu_r g (J = 2/5 m R^2), whichever friction makes it roll; a
//  pair without rolling friction rolls on
TEST_P(DemImpact, RollingFrictionOfAnyFriction)
{
    for (const std::string kind : {"history", "oneStep"})
        for (const std::string rolling : {"constantTorque", "spring"})
            for (const double mu : {0.02, 0.0})
            {
                DemConfig c = config(3);
                c.tangential = kind;
                c.rolling = rolling;
                c.gravity = Vector3{{0, -9.81, 0}};
                DemInput in = oneMaterial();
                PairProperties& p = in.pairs[0].properties;
                p.friction = 0.8;
                p.restitution = 0.3;
                p.rollingFriction = mu;
                in.walls.push_back(planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
                addParticle(in, {{-0.3, -0.19 - 0.01*9.81/1e4, 0}}, {{0.5, 0, 0}});
                in.particles.spin[2] = -0.5/0.01;
                auto scene = createDemScene(c, in);
                scene->advance(0.5);
                EXPECT_NEAR(scene->particles().velocity[0], 0.5 - 5.0/7*mu*9.81*0.5, 1e-3);
            }
}

//- Rolling friction by a spring holds a sphere on a slope of tan < mu_r and lets it go above
TEST_P(DemImpact, RollingFrictionHolds)
{
    for (const double slope : {0.08, 0.15})
    {
        DemConfig c = config(3);
        c.tangential = "history";
        c.rolling = "spring";
        c.gravity = Vector3{{9.81*std::sin(slope), -9.81*std::cos(slope), 0}};
        DemInput in = oneMaterial();
        PairProperties& p = in.pairs[0].properties;
        p.friction = 0.8;
        p.restitution = 0.3;
        p.rollingFriction = 0.1;
        p.rollingDamping = 0.5;
        in.walls.push_back(planeWall({{0, -0.2, 0}}, {{0, 1, 0}}));
        addParticle(in, {{-0.3, -0.19 - 1e-5, 0}});
        auto scene = createDemScene(c, in);
        scene->advance(0.4);
        const double speed = scene->particles().velocity[0];
        if (slope < 0.1) EXPECT_LT(std::abs(speed), 2e-4);
        else EXPECT_NEAR(speed, 5.0/7*9.81*(std::sin(slope) - 0.1*std::cos(slope))*0.4, 0.05*speed);
    }
}

//- Local damping in free fall: a = (1 - alpha) g; viscous damping: v = g/c (1 - exp(-c t)); held
//  axes keep their velocity
TEST_P(DemImpact, Groups)
{
    DemConfig c = config(3);
    c.gravity = Vector3{{0, 0, -10}};
    c.timeStep = 1e-4;
    DemInput in = oneMaterial();
    in.groups.resize(4);
    in.groups[0].localDamping = 0.7;
    in.groups[1].viscousDamping = 5;
    in.groups[2].held[2] = true;
    in.groups[2].force = Vector3{{0.02, 0, 0}};
    in.groups[3].gravity = false;
    in.groups[3].moment = Vector3{{0, 1e-6, 0}};
    for (int k = 0; k < 4; ++k)
    {
        addParticle(in, {{-0.3 + 0.1*k, 0, 0}}, {{0, 0, k == 2 ? 0.5 : 0}});
        in.particles.group.push_back(k);
    }
    auto scene = createDemScene(c, in);
    const double t = 0.2;
    scene->advance(t);
    const DemState s = scene->particles();
    const double single = mixed() ? 2e-5 : 1e-9;
    // the first half step, from rest, is not damped: a velocity of zero has no sign
    EXPECT_NEAR(s.velocity[3*find(s, 0) + 2], -0.3*10*t - 0.7*10*0.5e-4, single);
    // damping of half a step ago
    EXPECT_NEAR(s.velocity[3*find(s, 1) + 2], -2*(1 - std::exp(-5*t)), 5e-4);
    EXPECT_NEAR(s.velocity[3*find(s, 2) + 2], 0.5, 1e-12);
    EXPECT_NEAR(s.velocity[3*find(s, 2)], 2*t, single);
    EXPECT_NEAR(s.velocity[3*find(s, 3) + 2], 0, 1e-12);
    EXPECT_NEAR(s.spin[3*find(s, 3) + 1], 1e-6/(0.4*0.01*1e-4)*t, 10*single);
}

TEST_P(DemImpact, VerletAndLeapfrogAgree)
{
    DemInput in = oneMaterial();
    addParticle(in, {{-0.05, 0, 0}}, {{1, 0.3, 0}});
    addParticle(in, {{0.0, 0, 0}});
    Vector3 v[2];
    for (const std::string kind : {"leapfrog", "velocityVerlet"})
    {
        DemConfig c = config(2);
        c.tangential = "history";
        in.pairs[0].properties.friction = 0.4;
        c.integrator = kind;
        auto scene = createDemScene(c, in);
        scene->advance(0.06);
        const DemState s = scene->particles();
        v[kind == "leapfrog"] = at(s.velocity, find(s, 1));
        const DemEnergy e = scene->energy();
        EXPECT_LE(e.total(), 0.5*0.01*1.09*(1 + 1e-4));
    }
    // the same scheme but for where velocities stand when forces are without memory: rounding and
    // Coulomb's limit alone
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(v[0][d], v[1][d], 1e-3);
}

//- A particle that goes farther in a step than its radius stops the run, and is named
TEST_P(DemImpact, TooFastIsRefused)
{
    DemConfig c = config(3);
    c.timeStep = 1e-5;
    DemInput in = oneMaterial();
    addParticle(in, {{0, 0, 0}});
    // 1.5 mm off, 11 mm in a step; with nobody near it might go on
    addParticle(in, {{-0.0215, 0, 0}}, {{1100, 0, 0}});
    in.particles.id = {7, 42};
    const DemReport r = createDemScene(c, in)->advance(1);
    EXPECT_EQ(r.stop, DemStop::tooFast);
    EXPECT_EQ(r.stopId, 42);
    EXPECT_NEAR(r.stopValue, 1100, 1e-3);
    EXPECT_EQ(r.totalSteps, 1);
    // what it says is what was tested: the way and the limit it broke
    double way = 0, speed = 0, step = 0, limit = 0;
    ASSERT_EQ(std::sscanf(r.stopMessage.c_str(),
                  "goes %lf m in a step of %lf s, at %lf m/s, and its radius is %lf m", &way, &step,
                  &speed, &limit),
        4)
        << r.stopMessage;
    EXPECT_NEAR(way, 11e-3, 1e-6);
    EXPECT_NEAR(speed, 1100, 1e-3);
    EXPECT_NEAR(step, 1e-5, 1e-11);
    EXPECT_NEAR(limit, 0.01, 1e-8);
}

//- One that outruns its neighbours in a step meets them all the same: as with a skin that is wide
//  enough, elastically
TEST_P(DemImpact, FastOnesMeet)
{
    for (const std::string kind : {"leapfrog", "velocityVerlet"})
        for (const double speed : {5.0, 20.0})
        {
            DemConfig c = config(3);
            c.integrator = kind;
            c.timeStep = 2e-4;              // 1 mm and 4 mm in a step, half the skin is 1.5 mm
            DemInput in = oneMaterial(2e5/speed);
            in.particles.id = {3, 9};
            addParticle(in, {{0.1, 0, 0}});
            addParticle(in, {{-0.1, 0.003, 0}}, {{speed, 0, 0}});
            DemState s[2];
            for (const bool wide : {false, true})
            {
                c.skin = wide ? 1 : -1;
                c.allowLargeStep = true;
                auto scene = createDemScene(c, in);
                const DemReport r = scene->advance(1e9, int(0.25/speed/2e-4));
                ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
                s[wide] = scene->particles();
            }
            EXPECT_GT(s[0].velocity[3*find(s[0], 3)], 0.5*speed);
            for (const int id : {3, 9})
                for (int d = 0; d < 3; ++d)
                    EXPECT_NEAR(s[0].velocity[3*find(s[0], id) + d],
                        s[1].velocity[3*find(s[1], id) + d], (mixed() ? 1e-6 : 1e-12)*speed)
                        << id << " " << speed;
        }
}

//- Who leaves the domain is taken out and reported
TEST_P(DemImpact, Escapes)
{
    DemConfig c = config(2);
    DemInput in = oneMaterial();
    addParticle(in, {{0.48, 0, 0}}, {{1, 0, 0}});
    addParticle(in, {{0, 0, 0}});
    auto scene = createDemScene(c, in);
    const DemReport r = scene->advance(0.05);
    EXPECT_EQ(r.stop, DemStop::none);
    EXPECT_EQ(r.particles, 1u);
    ASSERT_EQ(r.escapedId.size(), 1u);
    EXPECT_EQ(r.escapedId[0], 0);
    EXPECT_NEAR(r.escaped[0][0], 0.5, 2e-3);
    EXPECT_EQ(scene->particles().id.size(), 1u);
}

//- Periodic sides: an impact across them
TEST_P(DemImpact, PeriodicImpact)
{
    DemConfig c = config(3);
    c.periodic[0] = c.periodic[1] = c.periodic[2] = true;
    DemInput in = oneMaterial();
    addParticle(in, {{0.47, 0.495, -0.499}}, {{1, 0, 0}});
    addParticle(in, {{-0.49, 0.495, -0.499}});
    auto scene = createDemScene(c, in);
    scene->advance(0.06);
    const DemState s = scene->particles();
    EXPECT_NEAR(s.velocity[3*find(s, 1)], 1, 2e-3);
}

//- Bad input is named
TEST(DemInput, Refusals)
{
    DemConfig c;
    c.device = DeviceKind::cpu;
    c.normal = "linear";
    DemInput good = oneMaterial();
    addParticle(good, {{0.5, 0.5, 0.5}});
    const auto message = [&](auto change)
    {
        DemConfig cc = c;
        DemInput in = good;
        change(cc, in);
        try
        {
            createDemScene(cc, in);
        }
        catch (const std::invalid_argument& e)
        {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    const auto expect = [&](auto change, const char* part)
    { const std::string m = message(change); EXPECT_NE(m.find(part), std::string::npos) << m; };
    EXPECT_EQ(message([](DemConfig&, DemInput&) {}), "accepted");
    expect([](DemConfig&, DemInput& in) { in.pairs[0].properties.normalStiffness = 0; },
        "normal stiffness must be positive");
    expect(
        [](DemConfig& cc, DemInput&) { cc.timeStep = 1; }, "0.5 sqrt(m/k) of contact stone-stone");
    expect([](DemConfig&, DemInput& in) { in.pairs.clear(); }, "nothing is said about materials");
    expect([](DemConfig&, DemInput& in) { in.particles.material = {3}; }, "unknown material 3");
    expect([](DemConfig&, DemInput& in) { in.particles.radius[0] = 0; }, "has no radius");
    expect([](DemConfig&, DemInput& in) { in.particles.position[0] = 3; }, "outside the domain");
    expect(
        [](DemConfig& cc, DemInput&)
        {
            cc.normal = "hertz";
            cc.tangential = "none";
            cc.rolling = "spring";
        },
        "rolling friction needs friction");
    expect(
        [](DemConfig&, DemInput& in)
        {
            in.bonds.a = {0};
            in.bonds.b = {5};
            in.bondTypes.resize(1);
            in.bondTypes[0].normalStiffness = in.bondTypes[0].shearStiffness = 1;
        },
        "unknown particle");
    EXPECT_THROW(bondsWithin(c, good.particles, 0, 0.001), std::invalid_argument);
    c.timeStep = 1;
    c.allowLargeStep = true;
    EXPECT_EQ(message([](DemConfig&, DemInput&) {}), "accepted");
}

RIPRAP_DEM_CASES(DemImpact);

} // namespace
} // namespace riprap
