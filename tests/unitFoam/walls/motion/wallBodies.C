// SPDX-License-Identifier: GPL-3.0-or-later
/*  Walls that move: poses at any time are those of their functions' formulas. */

#include "boxMesh.hpp"
#include "scratchCase.hpp"
#include "sweptDomain.H"
#include "wallBodies.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    wallBodies bodies(const std::string& motion, const Time& time = testTime())
    {
        return wallBodies(time, readWallMotion(entries(motion)));
    }

    std::string said(const std::string& motion)
    {
        return messageOf([&]() { bodies(motion); });
    }

    point placed(const riprap::WallPose& pose, const point& x)
    {
        point p;
        for (direction i = 0; i < 3; ++i)
        {
            p[i] = pose.translation[i];
            for (direction j = 0; j < 3; ++j) p[i] += pose.rotation[3*i + j]*x[j];
        }
        return p;
    }

    const char* const piston =
        "piston { patches (left); solidBodyMotionFunction oscillatingLinearMotion; "
        "oscillatingLinearMotionCoeffs { amplitude (0.1 0 0); omega 6; } }";
    const char* const wheel =
        "wheel { patches (\"w.*\"); solidBodyMotionFunction rotatingMotion; "
        "rotatingMotionCoeffs { origin (1 0 2); axis (0 1 0); omega 0.5; } }";
}

TEST(WallBodies, posesByFormula)
{
    const wallBodies all(bodies(std::string(piston) + wheel));
    ASSERT_EQ(all.size(), 2);
    EXPECT_EQ(all.name(1), "wheel");
    EXPECT_EQ(all.function(0), "oscillatingLinearMotion");
    const point x(0.3, -2, 5);
    for (const double t : {0.0, 0.1, 0.77, 12.5})
    {
        const point p(placed(all.pose(0, t), x));
        EXPECT_LT(mag(p - x - vector(0.1*std::sin(6*t), 0, 0)), 1e-14);
        // about (1 0 2) by 0.5 t round y, right-handed
        const point q(placed(all.pose(1, t), x));
        const double c = std::cos(0.5*t), s = std::sin(0.5*t), dx = x.x() - 1, dz = x.z() - 2;
        EXPECT_LT(mag(q - point(1 + c*dx + s*dz, -2, 2 + c*dz - s*dx)), 1e-13);
    }
    // the clock of the run is where it was
    EXPECT_EQ(testTime().value(), 0);
}

//- Between rows of a table a motion goes on smoothly; on them it is what they say, the first too
TEST(WallBodies, tables)
{
    ScratchCase c("endTime 2;");
    c.write("constant/table", "4((0 ((0 0 0) (0 0 0))) (1 ((0.1 0 0) (0 0 0))) "
                              "(2 ((0.2 0 0) (0 0 0))) (3 ((0.3 0 0) (0 0 0))))");
    const wallBodies all
    (
        bodies("gate { patches (g); solidBodyMotionFunction tabulated6DoFMotion; "
               "CofG (0 0 0); timeDataFileName \""
                + c.path() + "/constant/table\"; }", c.time())
    );
    for (const double t : {0.0, 0.25, 1.0, 1.5, 2.0})
    {
        const riprap::WallPose pose(all.pose(0, t));
        EXPECT_NEAR(pose.translation[0], 0.1*t, 1e-12) << t;
        EXPECT_NEAR(pose.translation[1], 0, 1e-14);
    }
    EXPECT_TRUE(holds(messageOf([&]() { all.pose(0, 7); }), "Motion gate: "));
}

TEST(WallBodies, namesOfWalls)
{
    const wallBodies all(bodies(std::string(piston) + wheel));
    EXPECT_EQ(all.bodyOf({"right", "left", "wa", "wb"}), labelList({-1, 0, 1, 1}));
    EXPECT_EQ(messageOf([&]() { all.bodyOf({"right", "wa"}); }),
        "Entry patches (left) selects no wall; valid are (right wa)");
    const wallBodies twice(bodies(std::string(wheel)
        + "b { patches (wa); solidBodyMotionFunction linearMotion; velocity (1 0 0); }"));
    EXPECT_EQ(messageOf([&]() { twice.bodyOf({"wa"}); }), "Wall wa moves with wheel already");
}

TEST(WallBodies, whatIsRefused)
{
    EXPECT_EQ(said("a 1;"), "Entry a is no dictionary: motion holds one for each group of patches "
                            "that moves");
    EXPECT_TRUE(holds(said("a { patches (b); }"),
        "Motion a: entry solidBodyMotionFunction is missing; valid are ("));
    EXPECT_TRUE(holds(said("a { patches (b); solidBodyMotionFunction linearMotoin; }"),
        "Entry solidBodyMotionFunction has the unknown word linearMotoin; valid are ("));
    EXPECT_TRUE(holds(said("a { patches (b); solidBodyMotionFunction linearMotoin; }"),
        "did you mean linearMotion?"));
    EXPECT_TRUE(holds(said("a { patches (b); solidBodyMotionFunction linearMotion; "
                           "linearMotionCoeffs { velocity (1 0 0); } speed 3; }"),
        "Unknown entry speed; valid are"));
}

TEST(WallBodies, speedAndSweep)
{
    const wallBodies all(bodies(std::string(piston) + wheel));
    const boundBox box(point(0, 0, 0), point(0.5, 1, 2));
    EXPECT_NEAR(all.largestSpeed(0, box, 0, 10), 0.6, 1e-3);
    // the corner farthest from the axis
    EXPECT_NEAR(all.largestSpeed(1, box, 0, 1), 0.5*std::hypot(1, 2), 1e-3);
    EXPECT_EQ(all.largestSpeed(0, box, 1, 1), 0);

    boundBox swept;
    all.sweep(0, box, 0, 10, swept);
    EXPECT_NEAR(swept.min().x(), -0.1, 1e-3);
    EXPECT_NEAR(swept.max().x(), 0.6, 1e-3);
    EXPECT_EQ(swept.max().z(), 2);
    boundBox until;
    all.sweep(0, box, 0, 0.1, until);
    EXPECT_EQ(until.min().x(), 0);
    EXPECT_NEAR(until.max().x(), 0.5 + 0.1*std::sin(0.6), 1e-14);
}

TEST(WallBodies, mustStayNearAndInThePlane)
{
    const wallBodies all
    (
        bodies(std::string(wheel)
            + "a { patches (a); solidBodyMotionFunction linearMotion; velocity (1 0 0); }")
    );
    const boundBox mesh(point(0, 0, 0), point(3, 4, 12));
    EXPECT_EQ(messageOf([&]() { all.requirePlanar(0, 1, 0, 5); }), "");
    EXPECT_EQ(messageOf([&]() { all.requirePlanar(0, 2, 0, 5); }),
        "Motion wheel leaves the plane of this 2D case: z is its empty direction");
    EXPECT_EQ(messageOf([&]() { all.requirePlanar(1, 0, 0, 5); }),
        "Motion a leaves the plane of this 2D case: x is its empty direction");
    EXPECT_EQ(messageOf([&]() { all.requireNear(1, {{0, 0, 0}, {1.2e5, 1, 1}}, mesh); }), "");
    EXPECT_EQ(messageOf([&]() { all.requireNear(1, {{0, 0, 0}, {1.4e5, 1, 1}}, mesh); }),
        "Motion a takes its walls 139997 m away, more than 10000 times the size of the mesh, 13 "
        "m, until endTime: is there a wrong unit among (patches solidBodyMotionFunction "
        "velocity)?");
}

//- The domain covers what moves, and a margin, except where it is periodic
TEST(WallBodies, widenTheDomain)
{
    ScratchCase c("endTime 2;");
    BoxMesh box;
    box.sides(1, "empty");
    const auto mesh = box.make(c.time());
    struct Config
    {
        int dimensions = 2, axes[3] = {0, 2, 1};
        bool periodic[3] = {false, false, false};
        double domainMin[3] = {0, 0, 0}, domainMax[3] = {1, 1, 1};
    };
    const wallBodies all
    (
        bodies("a { patches (a); solidBodyMotionFunction linearMotion; velocity (-1 0 0.25); }",
            c.time())
    );
    const List<boundBox> reference(1, boundBox(point(0, 0, 0), point(0, 1, 1)));
    for (const bool periodic : {false, true})
    {
        Config config;
        config.periodic[0] = periodic;
        coverMotion(mesh(), all, reference, 0.1, config);
        EXPECT_NEAR(config.domainMin[0], periodic ? 0 : -2.1, 1e-12);
        EXPECT_NEAR(config.domainMax[0], 1, 1e-12);
        EXPECT_NEAR(config.domainMin[2], -0.1, 1e-12);
        EXPECT_NEAR(config.domainMax[2], 1.6, 1e-12);
        EXPECT_EQ(config.domainMax[1], 1);
    }
}
