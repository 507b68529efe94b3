// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a scene of solids is given, and what does not fit together. */

#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    const std::string linear("device cpu; contact { normal linear; tangential none; } ");
    const std::string three(
        "materials { a { rho 1000; E 2e6; nu 0.1; } b { rho 1; E 3e6; nu 0.2; } "
        "c { rho 2; E 5e6; nu 0; } } ");

    //- Two spheres of these materials, on their own walls
    std::string said(const std::string& properties, const std::vector<int>& materials)
    {
        RunningSolids c(properties);
        for (std::size_t i = 0; i < materials.size(); ++i)
        {
            c.add(point(0.2 + 0.3*double(i), 0.5, 0.5), 0.05);
            c.solids.particles.material[i] = materials[i];
        }
        return messageOf([&]() { c.makeInput(); });
    }

    std::string pair(const std::string& name, const char* more = "")
    {
        return name + " { stiffness 1e4; restitution 1; " + more + " } ";
    }
}

TEST(DemInput, pairsThatCanMeetMustBeThere)
{
    const std::string walls("walls { material c; } ");
    const std::string missing("Entry pairs: missing are "),
        rest(", which can meet; an entry default serves all that have none");
    EXPECT_EQ(said(linear + three + walls, {0, 1}),
        missing + "(a-a a-b a-c b-b b-c)" + rest);
    EXPECT_EQ(said(linear + three + walls + "pairs { " + pair("b-a") + pair("c-a") + "}", {0, 1}),
        missing + "(a-a b-b b-c)" + rest);
    // walls do not meet walls, and nobody is of material b
    EXPECT_EQ(said(linear + three + walls + "pairs { " + pair("a-a") + pair("c-a") + "}", {0, 0}),
        "");
    EXPECT_EQ(said(linear + three + walls + "pairs { " + pair("default") + "}", {0, 1}), "");
}

TEST(DemInput, gapsOfAWrongUnit)
{
    const auto of = [](const char* gap)
    {
        return said(linear + three + "walls { material a; } pairs { " + pair("a-a", gap) + "}",
            {0, 0});
    };
    EXPECT_EQ(of("gap 10;"), "");
    EXPECT_EQ(of("gap 10.1;"),
        "Entry pairs: gap of a-a is 10.1 m, more than 100 times the largest particle, 0.1 m "
        "across");
}

//- Elastic constants of the materials are those of the pairs
TEST(DemInput, materialsAndPairs)
{
    RunningSolids c(three
        + "device cpu; contact { normal hertz; tangential none; } walls { patches "
          "(); } pairs { default { restitution 0.5; } b-a { restitution 0.9; } }");
    c.add(point(0.5, 0.5, 0.5), 0.1);
    c.makeInput();
    ASSERT_EQ(c.input.pairs.size(), 6u);
    for (const riprap::DemPair& p : c.input.pairs)
    {
        const double young[3] = {2e6, 3e6, 5e6}, poisson[3] = {0.1, 0.2, 0};
        EXPECT_EQ(p.properties.youngA, young[p.a]);
        EXPECT_EQ(p.properties.youngB, young[p.b]);
        EXPECT_EQ(p.properties.poissonA, poisson[p.a]);
        EXPECT_EQ(p.properties.poissonB, poisson[p.b]);
        EXPECT_EQ(p.properties.restitution, p.a + p.b == 1 ? 0.9 : 0.5);
    }
}

//- A force that is shared goes to single particles and bodies in equal parts, beside what each has
TEST(DemInput, sharedForces)
{
    RunningSolids c(
        rock("groups { raft { force (1 0 0); sharedForce (0 6 -9); } none { sharedForce "
             "(1 1 1); } }"));
    for (int i = 0; i < 5; ++i) c.add(point(0.1 + 0.15*i, 0.5, 0.5), 0.05, Zero, Zero, "raft");
    c.body(3, point(0.6, 0.5, 0.5), 1, vector(1, 1, 1), "raft");
    c.makeInput();
    ASSERT_EQ(c.input.groups.size(), 3u);
    // three particles and a body of two
    EXPECT_EQ(c.input.groups[1].force, (riprap::Vector3{{1, 1.5, -2.25}}));
    EXPECT_EQ(c.input.groups[0].force, (riprap::Vector3{{0, 0, 0}}));
    EXPECT_EQ(c.input.groups[2].force, (riprap::Vector3{{0, 0, 0}}));
}

//- By moduli a bond has E and G over the sum of its radii: a type for each sum, in the order of
//  kinds and sums
TEST(DemInput, calibratedBonds)
{
    RunningSolids c(rock("bonds { plain { normalStiffness 7; shearStiffness 5; } rubber { "
                         "calibration moduli; E 10; G 4; tensileStrength 3; } }"));
    const double radius[5] = {0.05, 0.05, 0.1, 0.1, 0.05};
    for (int i = 0; i < 5; ++i) c.add(point(0.1 + 0.2*i, 0.5, 0.5), radius[i]);
    for (int i = 0; i < 4; ++i) c.bond(i, i + 1);
    c.bond(4, 0);
    c.solids.bonds.type = {1, 1, 1, 1, 0};
    // sums 0.1, 0.15, 0.2, 0.15 of rubber
    c.makeInput();
    ASSERT_EQ(c.input.bondTypes.size(), 4u);
    EXPECT_EQ(c.typeOfBondType, labelList({0, 1, 1, 1}));
    EXPECT_EQ(c.input.bonds.type, (std::vector<std::int32_t>{1, 2, 3, 2, 0}));
    const double sum[4] = {0, 0.1, 0.15, 0.2};
    for (int t = 0; t < 4; ++t)
    {
        const riprap::DemBondType& type = c.input.bondTypes[t];
        EXPECT_NEAR(type.normalStiffness, t ? 10/sum[t] : 7, 1e-12);
        EXPECT_NEAR(type.shearStiffness, t ? 4/sum[t] : 5, 1e-12);
        EXPECT_EQ(type.tensileStrength, t ? 3 : riprap::DemBondType().tensileStrength);
    }
}

TEST(DemInput, tooManyStiffnesses)
{
    RunningSolids c(rock("bonds { rubber { calibration moduli; E 10; G 4; } }"));
    const int n = 100002;
    for (int i = 0; i < n; ++i)
    {
        c.add(point(0.5, 0.5, 0.5), 0.1*std::exp(1e-5*i));
        if (i) c.bond(0, i);
    }
    EXPECT_EQ(messageOf([&]() { c.makeInput(); }),
        "Entry bonds: the particles' radii make 100001 different stiffnesses; calibration direct "
        "has one");
}

TEST(DemInput, planesFaceTheParticles)
{
    const auto of = [](const char* planes, double z)
    {
        RunningSolids c(rock("", std::string("planes { slope { ") + planes + " } }"));
        c.add(point(0.5, 0.5, 0.6), 0.05);
        c.add(point(0.5, 0.2, z), 0.05);
        c.start();
        return messageOf([&]() { requireBeforePlanes(c.settings, c.input); });
    };
    const char* const up = "point (0 0 0.3); normal (0 0 2);";
    EXPECT_EQ(of(up, 0.4), "");
    EXPECT_EQ(of(up, 0.26), "");                        // pressed, and not wholly behind
    EXPECT_EQ(of(up, 0.2),
        "Entry planes of walls: of slope, particle 1 is 0.1 m behind the entry point, and its "
        "radius "
        "is 0.05 m: the plane's normal must point to the particles");
    EXPECT_TRUE(holds(of("point (0 0 0.3); normal (0 0 -2);", 0.2), "particle 0 is 0.3 m behind"));
    EXPECT_EQ(of("point (0 0 0.3); normal (0 0 2); } } motion { slope { patches (slope); "
                 "solidBodyMotionFunction linearMotion; velocity (0 0 0.1);",
                  0.2),
        "");                                            // it moves
}

//- v = velocity + spin x (x - centre) of what turns and slides; motions are not asked for before
//  the interval, nor after it
TEST(DemMotion, rigidMotion)
{
    RunningSolids c(rock("groups { wheel { motion { solidBodyMotionFunction rotatingMotion; origin "
                         "(0.5 0 0.5); axis (0 3 4); omega 2; } } slider { motion { "
                         "solidBodyMotionFunction linearMotion; velocity (1 -2 3); } } }"));
    const wallBodies bodies(c.time(), c.settings.groupMotion);
    const vector w(0, 1.2, 1.6), o(0.5, 0, 0.5);
    for (const double t : {0.0, 0.3, 1.0})
    {
        const riprap::RigidMotion m(rigidMotion(bodies, 0, t, 0, 1)),
            s(rigidMotion(bodies, 1, t, 0, 1));
        const vector spin(m.spin[0], m.spin[1], m.spin[2]),
            centre(m.centre[0], m.centre[1], m.centre[2]),
            velocity(m.velocity[0], m.velocity[1], m.velocity[2]);
        EXPECT_LT(mag(spin - w), 1e-8) << t;
        const point x(0.2, 0.7, 0.9);
        EXPECT_LT(mag(velocity + (spin ^ (x - centre)) - (w ^ (x - o))), 1e-5) << t;
        for (int d = 0; d < 3; ++d)
        {
            EXPECT_NEAR(s.spin[d], 0, 1e-12);
            EXPECT_NEAR(s.velocity[d], d == 0 ? 1 : d == 1 ? -2 : 3, 1e-8);
            EXPECT_NEAR(s.centre[d], s.velocity[d]*t, 1e-5);
        }
    }
}

//- The domain holds what moving walls reach until endTime; a plane has no bounds
TEST(DemMotion, domainOfMovingWalls)
{
    BoxMesh box;
    RunningSolids c(rock("", "planes { slope { point (0 0 0.1); normal (0 0 1); } } motion { lid { "
                             "patches (zMax); solidBodyMotionFunction oscillatingLinearMotion; "
                             "amplitude (0 0.2 0.3); omega 10; } } "),
        box, "(0 0 -10)", "adjustTimeStep yes; endTime 2;");
    c.add(point(0.5, 0.5, 0.5), 0.05);
    c.makeInput();
    const riprap::DemConfig& config = c.settings.config;
    const double low[3] = {0, -0.2, 0}, high[3] = {1, 1.2, 1.3};
    for (int d = 0; d < 3; ++d)
    {
        EXPECT_NEAR(config.domainMin[d], low[d], 2e-3) << d;
        EXPECT_NEAR(config.domainMax[d], high[d], 2e-3) << d;
        // walls of the mesh stand but for the lid
        EXPECT_TRUE(config.walled[d][0]);
        EXPECT_EQ(config.walled[d][1], d < 2);
    }
}
