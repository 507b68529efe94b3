// SPDX-License-Identifier: GPL-3.0-or-later
/*  Walls along three perpendicular axes: each cell of the lattice behind them, once. */

#include "laidWalls.hpp"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    constexpr int layers = 3;

    //- D = 2: in the plane of x and z
    BoxMesh tank(int D, double x = 1, double y = 0.6, double z = 0.8)
    {
        BoxMesh box;
        box.divide(0, -0.5, -0.5 + x, 5);
        box.divide(1, 0.25, 0.25 + y, D == 2 ? 1 : 3);
        box.divide(2, 2, 2 + z, 4);
        if (D == 2) box.sides(1, "empty");
        return box;
    }

    //- Each point is the middle of a cell of the lattice through the lower corner
    void expectOnLattice(const UList<point>& points, const point& corner, double spacing)
    {
        for (const point& p : points)
        {
            for (direction d = 0; d < 3; ++d)
            {
                const double cell = (p[d] - corner[d])/spacing - 0.5;
                ASSERT_NEAR(cell, std::round(cell), 1e-9) << p[d];
            }
        }
    }
}

TEST(WallLattice, aClosedTankIsWrappedInFullLayers)
{
    for (const int D : {2, 3})
    {
        const auto mesh = tank(D).make(testTime());
        const wallPoints w(laid(mesh(), wallControls(0.1, layers)));
        const int wide = 2*layers;
        EXPECT_EQ(w.size(),
            D == 2 ? (10 + wide)*(8 + wide) - 10*8
                   : (10 + wide)*(6 + wide)*(8 + wide) - 10*6*8);
        EXPECT_TRUE(w.notes.empty());
        expectOnLattice(w.position, point(-0.5, D == 2 ? 0.5 : 0.25, 2), 0.1);
        EXPECT_NEAR(nearestTwo(w.position), 0.1, 1e-9);
        const boundBox inside(mesh().bounds()), all(w.position, false);
        for (const point& p : w.position)
            EXPECT_FALSE(inside.contains(p)) << "a wall point in the fluid";
        EXPECT_NEAR(all.min().x(), -0.75, 1e-9);
        EXPECT_NEAR(all.max().z(), 3.05, 1e-9);
    }
}

//- Beside the wall and in the corner the kernel's sum is that of the open fluid, to round-off
TEST(WallLattice, completesTheKernelsSum)
{
    for (const int D : {2, 3})
    {
        const auto mesh = tank(D).make(testTime());
        pointField all(laid(mesh(), wallControls(0.1, layers)).position);
        const boundBox& b = mesh().bounds();
        all.append(middles(b.min(), b.max(), {{10, D == 2 ? 1 : 6, 8}}));
        const double y = D == 2 ? 0.55 : 0.3, h = 0.14;
        const double open = kernelSum(middles({0, 0, 0}, {1, D == 2 ? 0.1 : 1, 1},
            {{10, D == 2 ? 1 : 10, 10}}), {0.45, D == 2 ? 0.05 : 0.45, 0.45}, 0.1, h, D);
        EXPECT_NEAR(open, 1, 0.02);
        for (const point& p : {point(-0.45, y, 2.05), point(0.45, y, 2.35), point(0.05, y, 2.75),
                 point(0.05, y, 2.35)})
            EXPECT_NEAR(kernelSum(all, p, 0.1, h, D), open, 1e-10) << p.x() << ' ' << p.z();
    }
}

//- No multiple of the spacing: between walls it is divided, beyond them it is as asked
TEST(WallLattice, dividesWhatIsNoMultiple)
{
    const auto mesh = tank(2, 1.04, 0.6, 0.83).make(testTime());
    const wallPoints w(laid(mesh(), wallControls(0.1, layers)));
    EXPECT_EQ(w.size(), 16*14 - 10*8);
    ASSERT_EQ(w.notes.size(), 2);
    EXPECT_EQ(w.notes[0],
        "patches: wall spacing along (1 0 0) from 0.1 to 0.104 m, to divide the distances between "
        "walls");
    EXPECT_TRUE(holds(w.notes[1], "along (0 0 1) from 0.1 to 0.10375 m")) << w.notes[1];
    label below = 0;
    for (const point& p : w.position)
    {
        if (p.z() > 2 || p.x() < -0.5 || p.x() > 0.54) continue;
        const double cell = (p.x() + 0.5)/0.104 - 0.5;
        EXPECT_NEAR(cell, std::round(cell), 1e-9);
        ++below;
    }
    EXPECT_EQ(below, 10*layers);
}

TEST(WallLattice, endsWhereTheTankIsOpen)
{
    for (const int D : {2, 3})
    {
        BoxMesh open(tank(D));
        open.type[5] = "patch";
        const auto mesh = open.make(testTime());
        const wallPoints w(laid(mesh(), wallControls(0.1, layers)));
        const int wide = 2*layers;
        EXPECT_EQ(w.size(),
            D == 2 ? (10 + wide)*(8 + layers) - 10*8
                   : (10 + wide)*(6 + wide)*(8 + layers) - 10*6*8);
        for (const point& p : w.position) EXPECT_LT(p.z(), 2.8);
    }
}

//- A cyclic pair: exactly as many columns as go between, none beyond
TEST(WallLattice, endsAtCyclicPatches)
{
    BoxMesh channel(tank(2, 1.04));
    channel.sides(0, "cyclic");
    const auto mesh = channel.make(testTime());
    const wallPoints w(laid(mesh(), wallControls(0.1, layers)));
    EXPECT_EQ(w.size(), 10*2*layers);
    for (const point& p : w.position)
    {
        const double cell = (p.x() + 0.5)/0.104 - 0.5;
        EXPECT_NEAR(cell, std::round(cell), 1e-9);
        EXPECT_GT(p.x(), -0.5);
        EXPECT_LT(p.x(), 0.54);
    }
}

//- A block in the fluid, 0.4 x 0.4: full where layers of both sides meet, else hollow
TEST(WallLattice, fillsSolidsOnce)
{
    for (const int D : {2, 3})
    {
        BoxMesh box;
        for (int d = 0; d < 3; ++d) box.divide(d, 0, 2, 5);
        if (D == 2) { box.divide(1, 0, 1, 1); box.sides(1, "empty"); }
        box.there = [=](int i, int j, int k) { return i != 2 || k != 2 || (D == 3 && j != 2); };
        const auto mesh = box.make(testTime());
        for (const int n : {1, 2, 3})
        {
            const wallPoints w
            (
                generateWallPoints(mesh(), labelList(1, 6), nullptr, wallControls(0.1, n))
            );
            EXPECT_EQ(w.size(), n > 1 ? std::pow(4, D) : std::pow(4, D) - std::pow(2, D)) << n;
            EXPECT_NEAR(nearestTwo(w.position), 0.1, 1e-9);
            for (const point& p : w.position)
            {
                EXPECT_LT(mag(p.x() - 1), 0.2);
                EXPECT_LT(mag(p.z() - 1), 0.2);
            }
        }
    }
}

//- Turned, the same lattice is turned
TEST(WallLattice, inAnyFrame)
{
    const double angle = 0.4, c = std::cos(angle), s = std::sin(angle);
    const auto turned = [=](const point& p)
    { return point(c*p.x() - s*p.z(), p.y(), s*p.x() + c*p.z()); };
    for (const int D : {2, 3})
    {
        BoxMesh box(tank(D));
        const auto straight = box.make(testTime(), "straight");
        box.map = turned;
        const auto mesh = box.make(testTime(), "turned");
        const wallPoints a(laid(straight(), wallControls(0.1, layers)));
        const wallPoints b(laid(mesh(), wallControls(0.1, layers)));
        ASSERT_EQ(a.size(), b.size());
        for (const point& p : a.position)
        {
            double least = 1;
            for (const point& q : b.position) least = std::min(least, mag(turned(p) - q));
            EXPECT_LT(least, 1e-9);
        }
    }
}
