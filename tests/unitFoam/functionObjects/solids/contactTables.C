// SPDX-License-Identifier: GPL-3.0-or-later
/*  contactChains and solidWallForce: piles whose contacts are known, walls that are pressed. */

#include "lineFile.hpp"
#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0), k = 1e5, R = 0.05, mg = 10*1000*4*pi/3*R*R*R;

    //- n spheres on each other at rest: each contact carries the weight above it
    void addPile(RunningSolids& c, int n)
    {
        double z = 0;
        for (int i = 0; i < n; ++i)
        {
            z += (i ? 2 : 1)*R - (n - i)*mg/k;
            c.add(point(0.3, 0.6, z), R);
        }
    }
}

TEST(ContactChains, ofAPile)
{
    RunningSolids c(rock());
    addPile(c, 3);
    c.add(point(0.8, 0.8, 0.8), R);
    c.start();
    c.function("type contactChains;");
    const FunctionTable table(c.table("contactChains"));
    EXPECT_EQ(table.last("contacts"), 3);
    EXPECT_EQ(table.last("wallContacts"), 1);
    EXPECT_NEAR(table.last("maxForce"), 3*mg, 1e-6*mg);
    EXPECT_NEAR(table.last("meanForce"), 2*mg, 1e-6*mg);
    EXPECT_NEAR(table.last("maxOverlap"), 3*mg/k, 1e-9);

    const LineFile lines(c.read("VTK/f/f_0.vtp"));
    ASSERT_EQ(lines.of("Points").size(), 3*5u);         // four centres, a foot
    ASSERT_EQ(lines.of("normalForce").size(), 3u);
    for (int i = 0; i < 3; ++i)
    {
        const int a = int(lines.of("connectivity")[2*i]),
                  b = int(lines.of("connectivity")[2*i + 1]);
        const double za = lines.of("Points")[3*a + 2], zb = lines.of("Points")[3*b + 2];
        const bool wall = std::min(za, zb) < 0.5*R;
        // a line's force by the number of spheres above its middle
        const int above = 3 - int(std::round(0.5*(za + zb)/R/2));
        const double force = wall ? 3*mg : above*mg;
        EXPECT_EQ(lines.of("offsets")[i], 2*i + 2);
        EXPECT_EQ(lines.of("wall")[i], wall);
        EXPECT_NEAR(lines.of("normalForce")[i], force, 1e-5*mg);
        EXPECT_NEAR(lines.of("overlap")[i], force/k, 1e-7);
        EXPECT_NEAR(lines.of("force")[3*i + 2], za > zb ? force : -force, 1e-5*mg);
        // to the foot it is the radius, and little less to the wall
        EXPECT_NEAR(std::abs(za - zb), (wall ? R : 2*R - force/k), wall ? 1.01*force/k : 1e-6);
    }
    EXPECT_TRUE(holds(c.read("VTK/f.vtp.series"), "{ \"name\" : \"f/f_0.vtp\", \"time\" : 0 }"));
}

TEST(ContactChains, noneInFlight)
{
    RunningSolids c(rock());
    c.add(point(0.5, 0.5, 0.5), R);
    c.start();
    auto f = c.function("type contactChains;");
    c.run(0.01);
    c.sample(f());
    const FunctionTable table(c.table("contactChains"));
    EXPECT_EQ(table.rows.size(), 2u);
    for (const char* column : {"contacts", "wallContacts", "maxForce", "meanForce", "maxOverlap"})
        EXPECT_EQ(table.last(column), 0) << column;
    EXPECT_EQ(LineFile(c.read("VTK/f/f_0.01.vtp")).of("force").size(), 0u);
}

//- Weight and its moment about the origin, on the wall that carries it; sphere by sphere on two
//  walls that are at rest with it
TEST(SolidWallForce, ofAPile)
{
    RunningSolids c(rock("", "planes { slope { point (1 1 0.05); normal (0 0 1); } }"));
    addPile(c, 1);
    c.solids.particles.position[2] += 0.05;             // on the plane
    c.start();
    auto f = c.function("type solidWallForce;");
    for (const double t : {0.1, 0.2}) c.run(t), c.sample(f());
    const FunctionTable table(c.table("solidWallForce"));
    ASSERT_EQ(table.columns.size(), 1 + 7*6u);
    for (const char* wall : {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax", "slope"})
        for (const std::string what : {"Fx", "Fy", "Fz", "Mx", "My", "Mz"})
        {
            const double expected = std::string(wall) != "slope" ? 0
                : what == "Fz"                                   ? -mg
                : what == "Mx"                                   ? -0.6*mg
                : what == "My"                                   ? 0.3*mg
                                                                 : 0;
            for (const int row : {0, 1, 2})
                EXPECT_NEAR(table.at(row, wall + what), expected, 1e-6*mg) << wall << what << row;
        }
}

TEST(SolidWallForce, meanOfTheTimeBefore)
{
    RammedFloor c;
    c.start();
    auto f = c.function("type solidWallForce; average 0.1;");
    for (int i = 1; i <= 20; ++i)
    {
        c.run(0.01*i);
        f->execute();
        if (i % 10 == 0) f->write();
    }
    const FunctionTable now(c.table("solidWallForce")), mean(c.table("solidWallForceMean"));
    EXPECT_EQ(mean.columns, now.columns);
    for (const int row : {0, 1, 2})
    {
        const double t = 0.1*row;
        EXPECT_NEAR(now.at(row, "zMinFz"), -c.rate*t, 1e-4*c.rate);
        EXPECT_NEAR(mean.at(row, "zMinFz"), -c.rate*std::max(t - 0.05, 0.0), 1e-4*c.rate);
        EXPECT_NEAR(mean.at(row, "zMinMx"), -0.6*c.rate*std::max(t - 0.05, 0.0), 1e-4*c.rate);
    }
}

//- A run that goes on has the samples of the one before
TEST(SolidWallForce, meanOverARestart)
{
    RammedFloor c;
    c.start();
    auto before = c.function("type solidWallForce; average 0.1;");
    for (int i = 1; i <= 15; ++i) c.run(0.01*i), c.sample(before());
    before.clear();
    auto after = c.function("type solidWallForce; average 0.1;");
    c.run(0.16);
    c.sample(after());
    // a second file in the folder of the start
    EXPECT_NEAR(c.table("solidWallForceMean_0").last("zMinFz"), -c.rate*0.11, 1e-4*c.rate);
    EXPECT_EQ(c.refused("type solidWallForce; average -1;"),
        "Entry average of function object f is -1: it must not be negative");
}
