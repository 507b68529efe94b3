// SPDX-License-Identifier: GPL-3.0-or-later
/*  Where groups of solids are and how they have turned, by formula; what a restart is given. */

#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    std::string wheel(const std::string& axis, double omega, const char* more = "")
    {
        return rock("groups { wheel { motion { solidBodyMotionFunction rotatingMotion; origin "
                    "(0.5 0.5 0.5); axis "
                + axis + "; omega " + std::to_string(omega) + "; } } } " + more,
            "patches ();");
    }

    //- Three spheres that are not on a line, of group wheel
    void addThree(RunningSolids& c, const char* group = "wheel")
    {
        for (const point& x : {point(0.7, 0.5, 0.5), point(0.5, 0.65, 0.5), point(0.4, 0.4, 0.4)})
            c.add(x, 0.02, Zero, Zero, group);
    }

    vector vectorOf(const FunctionTable& table, const std::string& name, int row)
    {
        return vector(table.at(row, name + 'X'), table.at(row, name + 'Y'),
            table.at(row, name + 'Z'));
    }

    //- In equal steps
    void turn(RunningSolids& c, functionObject& f, double from, double to)
    {
        for (int i = 1; i <= 4; ++i)
        {
            c.run(from + 0.25*i*(to - from));
            c.sample(f);
        }
    }
}

TEST(GroupMotion, centresAndExtents)
{
    RunningSolids c(rock("groups { pair { } none { } }", "patches ();"));
    const vector u(0.1, 0, 0.2), w(0, -0.3, 0);
    c.add(point(0.2, 0.3, 0.4), 0.05, u, Zero, "pair");
    c.add(point(0.6, 0.3, 0.5), 0.1, w, Zero, "pair");
    c.add(point(0.8, 0.8, 0.8), 0.02);
    c.start();
    auto f = c.function("type groupMotion; groups (pair none);");
    c.run(0.1);
    c.sample(f());
    const FunctionTable table(c.table("groupMotion"));
    ASSERT_EQ(table.columns.size(), 29u);
    EXPECT_EQ(table.columns[1], "pairParticles");
    EXPECT_EQ(table.columns[15], "noneParticles");
    const double m = 1000*4*pi/3;
    for (const int row : {0, 1})
    {
        // masses are as 1 to 8
        const double t = 0.1*row;
        const vector fall(0, 0, -10), drop(0.5*t*t*fall);
        const point a(point(0.2, 0.3, 0.4) + t*u + drop), b(point(0.6, 0.3, 0.5) + t*w + drop);
        EXPECT_EQ(table.at(row, "pairParticles"), 2);
        EXPECT_NEAR(table.at(row, "pairMass"), m*9*0.05*0.05*0.05, 1e-6);
        EXPECT_LT(mag(vectorOf(table, "pairCentre", row) - (a + 8*b)/9), 1e-8);
        EXPECT_LT(mag(vectorOf(table, "pairMin", row)
                      - min(a - 0.05*vector::one, b - 0.1*vector::one)),
            1e-8);
        EXPECT_LT(mag(vectorOf(table, "pairMax", row)
                      - max(a + 0.05*vector::one, b + 0.1*vector::one)),
            1e-8);
        const vector v(table.at(row, "pairUx"), table.at(row, "pairUy"), table.at(row, "pairUz"));
        EXPECT_LT(mag(v - (u + 8*w)/9 - t*fall), 1e-8);
        for (int k = 15; k < 29; ++k) EXPECT_EQ(table.rows[row][k], 0) << table.columns[k];
    }
}

//- By the bodies' own masses, not those of their members; in 2D with places along the empty axis
TEST(GroupMotion, rigidBodiesAndDisks)
{
    BoxMesh flat;
    flat.sides(1, "empty");
    RunningSolids c(rock("groups { raft { } }", "patches ();"), flat, "(0 0 0)");
    c.add(point(0.2, 0.5, 0.2), 0.1, vector(1, 0, 0), Zero, "raft");
    const int first = c.add(point(0.7, 0.5, 0.7), 0.05);
    c.add(point(0.8, 0.5, 0.7), 0.05);
    const double m = 1000*pi*0.01;
    riprap::DemClump& body = c.body(first, point(0.74, 0.5, 0.7), 3*m, vector(1, 1, 1), "raft");
    body.velocity = {{0, 0, 0.4}};
    c.start();
    c.function("type groupMotion; groups (raft);");
    const FunctionTable table(c.table("groupMotion"));
    EXPECT_EQ(table.last("raftParticles"), 3);
    EXPECT_NEAR(table.last("raftMass"), 4*m, 1e-6);
    EXPECT_LT(mag(vectorOf(table, "raftCentre", 0) - point(0.2 + 3*0.74, 2, 0.2 + 3*0.7)/4), 1e-8);
    EXPECT_LT(mag(vectorOf(table, "raftMin", 0) - point(0.1, 0.4, 0.1)), 1e-8);
    EXPECT_LT(mag(vectorOf(table, "raftMax", 0) - point(0.85, 0.6, 0.75)), 1e-8);
    EXPECT_NEAR(table.last("raftUx"), 0.25, 1e-8);
    EXPECT_NEAR(table.last("raftUz"), 0.3, 1e-8);
}

//- Along the axis, as long as the angle, up to half a turn: 270 degrees are -90
TEST(GroupMotion, rotation)
{
    RunningSolids c(wheel("(1 2 2)", 0.5*pi));
    addThree(c);
    c.start();
    auto f = c.function("type groupMotion; rotation yes;");
    turn(c, f(), 0, 1);
    turn(c, f(), 1, 3);
    const FunctionTable table(c.table("groupMotion"));
    const vector n(1.0/3, 2.0/3, 2.0/3);
    ASSERT_EQ(table.rows.size(), 9u);
    for (int row = 0; row < 9; ++row)
    {
        const double angle = 90*table.at(row, "Time");
        if (std::abs(angle - 180) < 1) continue;        // either sign
        EXPECT_LT(
            mag(vectorOf(table, "wheelRotation", row) - (angle < 180 ? angle : angle - 360)*n),
            0.05)
            << angle;
        EXPECT_EQ(vectorOf(table, "freeRotation", row), vector(Zero));
    }
}

//- In 2D about the empty axis; a body that goes through a periodic end has not turned by it
TEST(GroupMotion, rotationIn2DAndThroughPeriodicEnds)
{
    BoxMesh flat;
    flat.sides(1, "empty");
    flat.sides(0, "cyclic");
    RunningSolids c(rock("groups { raft { } }", "patches ();"), flat, "(0 0 0)");
    c.add(point(0.85, 0.5, 0.5), 0.05);
    c.add(point(0.95, 0.5, 0.5), 0.05);
    riprap::DemClump& body = c.body(0, point(0.9, 0.5, 0.5), 3, vector(1, 1, 1), "raft");
    body.velocity = {{0.4, 0, 0}};
    body.spin = {{0, 0.5, 0}};
    c.start();
    auto f = c.function("type groupMotion; groups (raft); rotation yes;");
    turn(c, f(), 0, 1);
    const FunctionTable table(c.table("groupMotion"));
    for (int row = 0; row <= 4; ++row)
        EXPECT_LT(mag(vectorOf(table, "raftRotation", row)
                      - vector(0, 0.5*table.at(row, "Time")*180/pi, 0)),
            1e-4);
    // it is beyond the end indeed
    EXPECT_LT(c.now(&riprap::DemState::position, 1).x(), 0.5);
}

//- A lone sphere tells by its own turn
TEST(GroupMotion, rotationOfOneSphere)
{
    RunningSolids c(rock("orientation yes; groups { top { } }", "patches ();"), BoxMesh(),
        "(0 0 0)");
    c.add(point(0.5, 0.5, 0.5), 0.1, vector(0.1, 0, 0), vector(0, 0, 1.5), "top");
    c.start();
    auto f = c.function("type groupMotion; groups (top); rotation yes;");
    turn(c, f(), 0, 1);
    EXPECT_LT(mag(vectorOf(c.table("groupMotion"), "topRotation", 4) - vector(0, 0, 1.5*180/pi)),
        1e-4);
}

//- From the first start on: over a restart, and where the dictionary was edited
TEST(GroupMotion, rotationGoesOn)
{
    RunningSolids c(wheel("(0 0 1)", 1));
    addThree(c);
    c.start();
    const std::string text("type groupMotion; groups (wheel); rotation yes;");
    auto before = c.function(text);
    turn(c, before(), 0, 0.4);
    before->read(entries(text));
    c.run(0.5);
    c.sample(before());
    EXPECT_NEAR(c.table("groupMotion").last("wheelRotationZ"), 0.5*180/pi, 0.01);
    before.clear();
    auto after = c.function(text);
    turn(c, after(), 0.5, 1.2);
    EXPECT_NEAR(c.table("groupMotion_0").last("wheelRotationZ"), 1.2*180/pi, 0.01);
}

TEST(GroupMotion, whatDoesNotTellHowItTurns)
{
    RunningSolids c(rock("groups { one { } line { } several { } }"));
    c.add(point(0.2, 0.2, 0.2), 0.05, Zero, Zero, "one");
    for (const double x : {0.2, 0.4, 0.6}) c.add(point(x, 0.5, 0.5), 0.05, Zero, Zero, "line");
    c.add(point(0.2, 0.8, 0.8), 0.05);
    c.body(4, point(0.2, 0.8, 0.8), 1, vector(1, 1, 1), "several");
    c.add(point(0.5, 0.8, 0.8), 0.05);
    c.add(point(0.8, 0.8, 0.2), 0.05);
    c.body(5, point(0.5, 0.8, 0.5), 1, vector(1, 1, 1), "several");
    c.start();
    const auto said = [&](const std::string& group)
    { return c.refused("type groupMotion; rotation yes; groups (" + group + ");"); };
    EXPECT_EQ(said("free"), "");                        // nobody is in it
    EXPECT_EQ(said("one"),
        "Entry rotation: group one of solids is one particle, of which only orientation yes; of "
        "constant/solidProperties tells how it turns");
    EXPECT_EQ(said("line"),
        "Entry rotation: group line of solids lies on one line, which does not tell how it turns");
    EXPECT_EQ(said("several"),
        "Entry rotation: group several of solids is several bodies: this is for one");
    EXPECT_EQ(said("lines"),
        "Unknown group lines; constant/solidProperties has (free one line several); did you mean "
        "line?");
    EXPECT_EQ(said(""), "Entry groups of function object f is empty");
}
