// SPDX-License-Identifier: GPL-3.0-or-later
/*  Energies and momenta of solids: closed forms of free flight, springs and rigid bodies. */

#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    //- x and z are solved
    BoxMesh flat()
    {
        BoxMesh box;
        box.sides(1, "empty");
        return box;
    }

    vector three(const FunctionTable& table, const std::string& name, int row)
    {
        return vector(table.at(row, name + 'X'), table.at(row, name + 'Y'),
            table.at(row, name + 'Z'));
    }

    //- Rows now and at time t
    FunctionTable energies(RunningSolids& c, double t)
    {
        c.start();
        auto f = c.function("type solidEnergies;");
        c.run(t);
        c.sample(f());
        return c.table("solidEnergies");
    }

    //- Its principal axes are turned by 90 degrees about z: e1 is along y, e2 along -x
    riprap::DemClump& crossBody(RunningSolids& c, const vector& spin)
    {
        c.add(point(0.5, 0.4, 0.5), 0.05);
        c.add(point(0.5, 0.6, 0.5), 0.05);
        riprap::DemClump& body = c.body(0, point(0.5, 0.5, 0.5), 3, vector(0.02, 0.05, 0.06));
        body.orientation = {{std::sqrt(0.5), 0, 0, std::sqrt(0.5)}};
        body.velocity = {{0.1, 0.2, 0}};
        body.spin = {{spin.x(), spin.y(), spin.z()}};
        return body;
    }
}

TEST(SolidEnergies, ofAThrownSphere)
{
    RunningSolids c(rock());
    const vector u(0.5, 0, 1), w(0, 3, 1);
    c.add(point(0.2, 0.5, 0.5), 0.1, u, w);
    const FunctionTable table(energies(c, 0.2));
    ASSERT_EQ(table.rows.size(), 2u);
    const double m = 1000*4*pi/3*1e-3, rotation = 0.5*0.4*m*0.01*10;
    for (const int row : {0, 1})
    {
        const double t = 0.2*row;
        const vector v(u + t*vector(0, 0, -10)),
            x(point(0.2, 0.5, 0.5) + t*u + 0.5*t*t*vector(0, 0, -10));
        EXPECT_NEAR(table.at(row, "Time"), t, 1e-12);
        EXPECT_NEAR(table.at(row, "translation"), 0.5*m*magSqr(v), 1e-6);
        EXPECT_NEAR(table.at(row, "rotation"), rotation, 1e-8);
        EXPECT_NEAR(table.at(row, "potential"), m*10*x.z(), 1e-6);
        EXPECT_NEAR(table.at(row, "total"), 0.5*m*1.25 + rotation + m*10*0.5, 1e-6);
        EXPECT_LT(mag(three(table, "momentum", row) - m*v), 1e-6);
        EXPECT_LT(mag(three(table, "angular", row) - m*(x ^ v) - 0.4*m*0.01*w), 1e-6);
        for (const char* none : {"contact", "bond", "spring"}) EXPECT_EQ(table.at(row, none), 0);
    }
}

//- Per metre of depth; its place along the empty axis counts in the arm of its momentum
TEST(SolidEnergies, ofADisk)
{
    RunningSolids c(rock(), flat());
    c.add(point(0.2, 0.5, 0.5), 0.1, vector(0.5, 0, 1), vector(0, 3, 0));
    const FunctionTable table(energies(c, 0.2));
    const double m = 1000*pi*0.01;
    const vector v(0.5, 0, -1);
    EXPECT_NEAR(table.last("translation"), 0.5*m*1.25, 1e-6);
    EXPECT_NEAR(table.last("rotation"), 0.5*0.5*m*0.01*9, 1e-8);
    EXPECT_NEAR(table.last("potential"), m*10*0.5, 1e-6);
    EXPECT_LT(mag(three(table, "momentum", 1) - m*v), 1e-6);
    EXPECT_LT(mag(three(table, "angular", 1) - m*(point(0.3, 0.5, 0.5) ^ v)
                  - 0.5*m*0.01*vector(0, 3, 0)),
        1e-6);
}

//- By its own mass and inertia; one that tumbles keeps its angular momentum
TEST(SolidEnergies, ofARigidBody)
{
    const vector w(5, 0.4, 0.3), u(0.1, 0.2, 0);
    RunningSolids c(rock(), BoxMesh(), "(0 0 0)");
    crossBody(c, w);
    const FunctionTable table(energies(c, 0.5));
    // I of x, y, z: those of e2, e1, e3
    const vector Iw(0.05*w.x(), 0.02*w.y(), 0.06*w.z());
    for (const int row : {0, 1})
    {
        EXPECT_NEAR(table.at(row, "translation"), 0.5*3*0.05, 1e-9);
        EXPECT_NEAR(table.at(row, "rotation"), 0.5*(w & Iw), row ? 1e-4 : 1e-9);
        EXPECT_LT(mag(three(table, "momentum", row) - 3*u), 1e-9);
        EXPECT_LT(mag(three(table, "angular", row) - 3*(point(0.5, 0.5, 0.5) ^ u) - Iw),
            row ? 1e-6 : 1e-9);
    }
    // it has turned indeed
    const riprap::DemClumpState now(c.scene->clumps());
    EXPECT_GT(mag(vector(now.spin[0], now.spin[1], now.spin[2]) - w), 0.1);
}

TEST(SolidEnergies, ofARigidBodyIn2D)
{
    RunningSolids c(rock(), flat(), "(0 0 0)");
    c.add(point(0.4, 0.5, 0.5), 0.05);
    c.add(point(0.6, 0.5, 0.5), 0.05);
    riprap::DemClump& body = c.body(0, point(0.5, 0.5, 0.5), 3, vector(0, 0, 0.06));
    body.velocity = {{0.1, 0, -0.2}};
    body.spin = {{0, -2, 0}};
    const FunctionTable table(energies(c, 0.5));
    EXPECT_NEAR(table.last("rotation"), 0.5*0.06*4, 1e-9);
    EXPECT_LT(mag(three(table, "angular", 1)
                  - 3*(point(0.55, 0.5, 0.4) ^ vector(0.1, 0, -0.2)) - vector(0, -0.12, 0)),
        1e-9);
}

TEST(SolidEnergies, ofSprings)
{
    RunningSolids c(rock("bonds { glue { normalStiffness 1e7; shearStiffness 1e7; } } groups { "
                         "buoy { springs { coil { anchor (0.5 0.5 0.9); point (0.5 0.5 0.6); "
                         "stiffness 40; restLength 0.2; } } } }",
                        "patches ();"),
        BoxMesh(), "(0 0 0)");
    // overlap by 0.002
    c.add(point(0.2, 0.2, 0.2), 0.05);
    c.add(point(0.298, 0.2, 0.2), 0.05);
    // a bond that is stretched by 0.001
    c.add(point(0.8, 0.2, 0.2), 0.02);
    c.add(point(0.8, 0.241, 0.2), 0.02);
    c.bond(2, 3);
    c.solids.bonds.gap[0] = 0;
    c.add(point(0.5, 0.5, 0.5), 0.1);
    c.body(4, point(0.5, 0.5, 0.5), 2, vector(0.1, 0.1, 0.1), "buoy");
    const FunctionTable table(energies(c, 0.3));
    const double contact = 0.5*1e5*4e-6, bond = 0.5*1e7*pi*4e-4*1e-6, spring = 0.5*40*0.01;
    EXPECT_NEAR(table.at(0, "contact"), contact, 1e-9);
    EXPECT_NEAR(table.at(0, "bond"), bond, 1e-9);
    EXPECT_NEAR(table.at(0, "spring"), spring, 1e-9);
    EXPECT_NEAR(table.at(0, "total"), contact + bond + spring, 1e-9);
    // the spheres have parted, and the body swings: 0.1 cos(sqrt(k/m) t)
    const double phase = std::sqrt(20.0)*0.3;
    EXPECT_NEAR(table.at(1, "contact"), 0, 1e-12);
    EXPECT_NEAR(table.at(1, "spring"), spring*std::pow(std::cos(phase), 2), 1e-4);
    EXPECT_NEAR(table.at(1, "total"), contact + bond + spring, 0.02*spring);
}
