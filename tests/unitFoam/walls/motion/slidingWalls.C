// SPDX-License-Identifier: GPL-3.0-or-later
/*  Sides of a grid that slide in their own plane; the table of wall times. */

#include "boxMesh.hpp"
#include "scratchCase.hpp"
#include "slidingWalls.H"
#include "wallTimes.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- Its left side is two patches: cells below are left out
    BoxMesh tank()
    {
        BoxMesh box;
        box.divide(0, 0, 1, 2);
        box.divide(2, 0, 1, 2);
        box.sides(1, "empty");
        box.type[1] = "patch";
        return box;
    }

    std::string said(const BoxMesh& box, const std::string& text, bool noSlip = true)
    {
        const auto mesh = box.make(testTime());
        riprap::PicConfig config;
        config.noSlip = noSlip;
        return messageOf([&]() { readSlidingWalls(entries(text), mesh(), config); });
    }
}

TEST(SlidingWalls, velocitiesOfWholeSides)
{
    const auto mesh = tank().make(testTime());
    riprap::PicConfig config;
    config.noSlip = true;
    readSlidingWalls(entries("zMax (1.5 0 0); xMin (0 0 -2);"), mesh(), config);
    for (int axis = 0; axis < 3; ++axis)
    {
        for (int upper = 0; upper < 2; ++upper)
        {
            for (int d = 0; d < 3; ++d)
            {
                const double expected = axis == 2 && upper && d == 0 ? 1.5
                    : axis == 0 && !upper && d == 2                  ? -2
                                                                     : 0;
                EXPECT_EQ(config.slide[axis][upper][d], expected) << axis << upper << d;
            }
        }
    }
}

TEST(SlidingWalls, whatIsRefused)
{
    EXPECT_EQ(said(tank(), "", false), "");
    EXPECT_EQ(said(tank(), "zMax (1 0 0);", false), "A wall that slides needs `slip noSlip;`");
    EXPECT_EQ(said(tank(), "xMax (0 0 1);"),
        "There is no wall xMax; the mesh's walls are (xMin zMin zMax)");
    EXPECT_EQ(said(tank(), "zMax (1 0 0.1);"),
        "Wall zMax has the velocity (1 0 0.1): it can slide in its own plane only, its z must be "
        "0");
    BoxMesh half(tank());
    half.there = [](int i, int, int k) { return i == 1 || k == 1; };
    EXPECT_EQ(said(half, "xMin (0 0 1);"),
        "Wall xMin is not one whole side of the mesh: only a whole side can slide");
    EXPECT_EQ(said(half, "zMax (1 0 0);"), "");
}

TEST(WallTimes, rows)
{
    EXPECT_EQ(wallTimes::row("solver", 1.5, 6, 1, 4),
        "    solver                             1.50    25.0 %");
    EXPECT_EQ(wallTimes::row("probes", 0.123, 1, 7, 8),
        "        probes                         0.12    12.3 %  7 times");
}
