// SPDX-License-Identifier: GPL-3.0-or-later
/*  3D walls of any shape: sheets behind smooth regions, edges and corners filled to the mitre. */

#include "laidWalls.hpp"
#include "testTime.H"
#include "wallEdges.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    constexpr int layers = 3;

    //- A wedge: a box whose end leans by `lean`; all sides that are not named are open
    BoxMesh wedge(double lean, const std::vector<int>& walls)
    {
        BoxMesh box;
        box.divide(0, 0, 0.6, 3);
        box.divide(1, 0, 0.4, 2);
        box.divide(2, 0, 0.5, 2);
        box.map = [=](const point& p) { return point(p.x() + lean*p.z(), p.y(), p.z()); };
        box.type.fill("patch");
        for (const int w : walls) box.type[w] = "wall";
        return box;
    }

    struct Laid
    {
        autoPtr<polyMesh> mesh;
        wallSpace space;
        wallSurface wall;
        wallCandidates sheets, edges, corners;

        Laid(const BoxMesh& box, double spacing)
        :
            mesh(box.make(testTime())),
            space(mesh(), wallControls(spacing, layers)),
            wall(space, patchElements(space, wallPatches(mesh())), layers)
        {
            const auto kinds(wall.edgeKinds(space.cosFeature));
            laySheets(space, wall, sheets);
            fillEdges(space, wall, kinds, edges);
            fillCorners(space, wall, kinds, corners);
        }
    };
}

//- One plane: a lattice of its own spacing, layer by layer
TEST(WallSheets, aPlane)
{
    const Laid laid(wedge(0.75, {0}), 0.05);
    // 0.625 x 0.4, leaning
    ASSERT_EQ(laid.sheets.size(), layers*13*8);
    const vector n(normalised(vector(1, 0, -0.75)));
    for (label i = 0; i < laid.sheets.size(); ++i)
    {
        const double behind = -(laid.sheets.position[i] & n);
        EXPECT_NEAR(behind, laid.sheets.depth[i], 1e-9);
        const double layer = behind/0.05 - 0.5;
        EXPECT_NEAR(layer, std::round(layer), 1e-9);
        EXPECT_LT(mag(laid.sheets.normal[i] - n), 1e-9);
        EXPECT_GT(laid.sheets.position[i].y(), 0);
        EXPECT_LT(laid.sheets.position[i].y(), 0.4);
    }
    EXPECT_EQ(laid.edges.size(), 0);
    EXPECT_EQ(laid.corners.size(), 0);
}

//- An edge between two planes: as many points as the mitre's cross-section has area
TEST(WallSheets, edgesAreFilledToTheMitre)
{
    const double dp = 0.02;
    for (const double lean : {0.5, -0.5})
    {
        const Laid laid(wedge(lean, {0, 4}), dp);
        const double half = 0.5*std::atan2(1, lean), d = layers*dp;
        const double area = d*d/std::tan(half);
        EXPECT_NEAR(laid.edges.size()*dp*dp*dp/(area*0.4), 1, 0.12) << lean;
        for (label i = 0; i < laid.edges.size(); ++i)
        {
            const point& p = laid.edges.position[i];
            // as deep behind the farther plane as its layer; behind both if the angle is blunt
            const double low = -p.z();
            const double back = -(p & vector(normalised(vector(1, 0, -lean))));
            if (lean < 0) { EXPECT_GT(min(low, back), 0); }
            EXPECT_NEAR(max(low, back), laid.edges.depth[i], 1e-9);
            EXPECT_LT(max(low, back), d);
            EXPECT_GT(p.y(), 0);
            EXPECT_LT(p.y(), 0.4);
        }
        EXPECT_EQ(laid.corners.size(), 0);
    }
}

//- Where the fluid is outside the angle, layers meet: nothing is added
TEST(WallSheets, nothingBehindConcaveEdges)
{
    BoxMesh box;
    for (int d = 0; d < 3; ++d) box.divide(d, 0, 1, 3);
    box.there = [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; };
    box.type.fill("patch");
    box.type[6] = "wall";
    const Laid laid(box, 0.05);
    EXPECT_EQ(laid.edges.size(), 0);
    EXPECT_EQ(laid.corners.size(), 0);
}

//- A corner of three planes at right angles: layers^3 points
TEST(WallSheets, cornersAreFilled)
{
    const Laid laid(wedge(0, {0, 2, 4}), 0.05);
    EXPECT_EQ(laid.corners.size(), layers*layers*layers);
    for (const point& p : laid.corners.position) EXPECT_LT(cmptMax(p), 0);
    EXPECT_EQ(laid.edges.size(), 0 + layers*layers*(12 + 8 + 10));
}

//- A leaning tank: kernel sums beside its walls, edges and corners, without gaps or doubles
TEST(WallSheets, completeTheKernelsSum)
{
    const double dp = 0.05, lean = 0.5, h = 1.3*dp;
    const auto mesh = wedge(lean, {0, 1, 2, 3, 4, 5}).make(testTime());
    const wallPoints w(laid(mesh(), wallControls(dp, layers)));
    EXPECT_GT(nearestTwo(w.position), 0.699*dp);
    pointField all(w.position);
    pointField fluid(middles({0, 0, 0}, {0.6, 0.4, 0.5}, {{12, 8, 10}}));
    for (point& p : fluid) p.x() += lean*p.z();
    all.append(fluid);
    const double faces[][3] = {{0.3, 0.2, 0}, {0, 0.2, 0.25}, {0.6, 0.2, 0.25}, {0.3, 0, 0.25}};
    const double edges[][3] = {{0, 0.2, 0}, {0.6, 0.2, 0}, {0.3, 0, 0}, {0, 0, 0.25}};
    const double corners[][3] = {{0, 0, 0}, {0.6, 0, 0}, {0, 0.4, 0.5}, {0.6, 0.4, 0.5}};
    const auto sum = [&](const double (&x)[3])
    { return kernelSum(all, {x[0] + lean*x[2], x[1], x[2]}, dp, h, 3); };
    for (const auto& x : faces) EXPECT_NEAR(sum(x), 1, 0.06) << x[0] << ' ' << x[1] << ' ' << x[2];
    for (const auto& x : edges) EXPECT_NEAR(sum(x), 1, 0.13) << x[0] << ' ' << x[1] << ' ' << x[2];
    for (const auto& x : corners)
        EXPECT_NEAR(sum(x), 1, 0.15) << x[0] << ' ' << x[1] << ' ' << x[2];
}
