// SPDX-License-Identifier: GPL-3.0-or-later
/*  The mesh as a uniform grid: its order of cells, open sides, meshes that are none. */

#include "boxMesh.hpp"
#include "picGrid.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    BoxMesh block(int D = 3)
    {
        BoxMesh box;
        box.divide(0, -1, 1, 8);
        box.divide(1, 0, 0.75, D == 2 ? 1 : 3);
        box.divide(2, 3, 4, 4);
        if (D == 2) box.sides(1, "empty");
        return box;
    }

    riprap::PicConfig config(int D)
    {
        riprap::PicConfig c;
        c.dimensions = D;
        if (D == 2) { c.axes[1] = 2; c.axes[2] = 1; }
        return c;
    }

    std::string said(const BoxMesh& box, int D = 3)
    {
        const auto mesh = box.make(testTime());
        return messageOf([&]() { picGrid(mesh(), config(D)); });
    }
}

TEST(PicGrid, cellsInTheirOrder)
{
    for (const int D : {2, 3})
    {
        const auto mesh = block(D).make(testTime());
        riprap::PicConfig c(config(D));
        const picGrid grid(mesh(), c);
        EXPECT_NEAR(grid.cellSize(), 0.25, 1e-14);
        grid.set(c);
        EXPECT_EQ(c.cells[0], 8);
        EXPECT_EQ(c.cells[1], D == 2 ? 1 : 3);
        EXPECT_EQ(c.cells[2], 4);
        for (label i = 0; i < mesh->nCells(); ++i) EXPECT_EQ(grid.gridCell()[i], i);
    }
}

//- Walls closed, patches open, openings and walls by their numbers
TEST(PicGrid, sides)
{
    BoxMesh box(block(2));
    box.type[5] = box.type[1] = "patch";
    const auto mesh = box.make(testTime());
    riprap::PicConfig c(config(2));
    c.openings.resize(1);
    c.openings[0].name = "xMax";
    const riprap::PicWalls walls(picGrid(mesh(), c).walls());
    ASSERT_EQ(walls.aperture[0].size(), 9u*4);
    ASSERT_EQ(walls.aperture[1].size(), 8u*5);
    for (int k = 0; k < 4; ++k)
    {
        for (int i = 0; i < 9; ++i)
        {
            const int f = i + 9*k;
            EXPECT_EQ(walls.aperture[0][f], i > 0);
            EXPECT_EQ(walls.opening[0][f], i == 8 ? 0 : -1);
            EXPECT_EQ(walls.part[0][f], i == 0 ? 0 : -1);       // xMin
        }
    }
    for (int k = 0; k < 5; ++k)
    {
        for (int i = 0; i < 8; ++i)
        {
            const int f = i + 8*k;
            EXPECT_EQ(walls.aperture[1][f], k > 0);
            EXPECT_EQ(walls.opening[1][f], -1);
            EXPECT_EQ(walls.part[1][f], k == 0 ? 1 : -1);       // zMin
        }
    }
    EXPECT_TRUE(picGrid(mesh(), config(2)).walls().opening[0].empty());
}

TEST(PicGrid, meshesThatAreNoBlock)
{
    const std::string rule(
        ": PIC needs a mesh that is one block of equal squares (2D) or cubes (3D) "
        "along the axes, without grading");
    BoxMesh box(block());
    box.divide(0, -1, 1, 7);
    EXPECT_EQ(said(box), "Cell 0 at (-0.857143 0.125 3.125) is 0.285714 m long along x and 0.25 m "
                         "along y" + rule);
    box = block();
    box.nodes[0] = {-1, -0.75, -0.45, -0.2, 0};
    EXPECT_TRUE(holds(said(box), "is not one of 4 x 3 x 4 equal ones of 0.015625 m3" + rule));
    box = block();
    box.there = [](int i, int j, int k) { return i != 7 || j != 2 || k != 3; };
    EXPECT_EQ(said(box), "The mesh has 95 cells, and the box around it 96" + rule);
    box = block();
    box.map = [](const point& p) { return point(p.x() + 0.3*p.z(), p.y(), p.z()); };
    EXPECT_TRUE(holds(said(box), rule));
    box = block(2);
    EXPECT_EQ(said(box, 2), "");
}
