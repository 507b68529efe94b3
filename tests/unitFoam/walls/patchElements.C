// SPDX-License-Identifier: GPL-3.0-or-later
/*  Wall patches as oriented elements: areas, normals into the fluid, points that are shared. */

#include "laidWalls.hpp"
#include "testTime.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- Two, three and four cells of different lengths, off the origin
    BoxMesh block()
    {
        BoxMesh box;
        box.divide(0, -0.3, 0.1, 2);
        box.divide(1, 1, 1.9, 3);
        box.divide(2, 0.05, 0.25, 4);
        return box;
    }

    struct Sums
    {
        vector area = Zero;
        double size = 0, volume = 0;    // volume: of what the elements enclose, outside them
    };

    Sums sumsOf(const wallSpace& space, const wallElements& all, label source = -1)
    {
        Sums s;
        forAll(all.elements, i)
        {
            if (source >= 0 && all.source[i] != source) continue;
            const auto& e = all.elements[i];
            const point &a = all.points[e[0]], &b = all.points[e[1]];
            const vector A
            (
                space.planar ? space.left(b - a) : 0.5*((b - a) ^ (all.points[e[2]] - a))
            );
            s.area += A;
            s.size += mag(A);
            s.volume += (A & a)/(space.planar ? 2 : 3);
        }
        return s;
    }

    labelList sides(const polyMesh& mesh) { return wallPatches(mesh); }
}

TEST(PatchElements, aBoxIsClosedWithNormalsIntoTheFluid)
{
    const auto mesh = block().make(testTime());
    const wallSpace space(mesh(), wallControls(0.1, 3));
    EXPECT_FALSE(space.planar);
    const wallElements all(patchElements(space, sides(mesh())));
    ASSERT_EQ(all.elements.size(), 2*2*(2*3 + 3*4 + 4*2));
    // Each node of the surface once: 3 x 4 x 5 without the 1 x 2 x 3 inside
    EXPECT_EQ(all.points.size(), 3*4*5 - 1*2*3);
    const Sums s(sumsOf(space, all));
    EXPECT_NEAR(mag(s.area), 0, 1e-14);
    EXPECT_NEAR(s.size, 2*(0.4*0.9 + 0.9*0.2 + 0.2*0.4), 1e-14);
    EXPECT_NEAR(s.volume, -0.4*0.9*0.2, 1e-14);
    EXPECT_EQ(connectedParts(all).size(), 1);
}

TEST(PatchElements, eachPatchByItself)
{
    const auto mesh = block().make(testTime());
    const wallSpace space(mesh(), wallControls(0.1, 3));
    const wallElements all(patchElements(space, sides(mesh())));
    const double area[3] = {0.9*0.2, 0.4*0.2, 0.4*0.9};
    for (label p = 0; p < 6; ++p)
    {
        vector expected(Zero);
        expected[p/2] = (p % 2 ? -1 : 1)*area[p/2];
        EXPECT_LT(mag(sumsOf(space, all, p).area - expected), 1e-14) << p;
    }
    // Two sides that do not touch
    const List<wallElements> parts(connectedParts(patchElements(space, labelList({3, 2}))));
    ASSERT_EQ(parts.size(), 2);
    for (label i = 0; i < 2; ++i)
    {
        EXPECT_EQ(parts[i].points.size(), 3*5);
        EXPECT_EQ(parts[i].elements.size(), 2*2*4);
        for (const label source : parts[i].source) EXPECT_EQ(source, i);
        for (const point& p : parts[i].points) EXPECT_EQ(p.y(), i ? 1 : 1.9);
    }
}

//- The empty axis may be any; the frame of the other two is left-handed for y
TEST(PatchElements, segmentsInTheMidPlane)
{
    for (direction empty = 0; empty < 3; ++empty)
    {
        BoxMesh box(block());
        box.sides(empty, "empty");
        box.nodes[empty] = {box.nodes[empty].front(), box.nodes[empty].back()};
        const auto mesh = box.make(testTime());
        const wallSpace space(mesh(), wallControls(0.1, 3));
        ASSERT_TRUE(space.planar);
        EXPECT_EQ(space.empty, empty);
        const double middle = 0.5*(box.nodes[empty][0] + box.nodes[empty][1]);
        EXPECT_NEAR(space.middle, middle, 1e-14);

        const wallElements all(patchElements(space, sides(mesh())));
        const label n = box.cells((empty + 1) % 3), m = box.cells((empty + 2) % 3);
        EXPECT_EQ(all.elements.size(), 2*(n + m));
        EXPECT_EQ(all.points.size(), 2*(n + m));
        for (const point& p : all.points) EXPECT_NEAR(p[empty], middle, 1e-14);
        for (const auto& e : all.elements) EXPECT_EQ(e[2], -1);
        const vector span(0.4, 0.9, 0.2);
        const double a = span[(empty + 1) % 3], b = span[(empty + 2) % 3];
        const Sums s(sumsOf(space, all));
        EXPECT_NEAR(mag(s.area), 0, 1e-14);
        EXPECT_NEAR(s.size, 2*(a + b), 1e-14);
        EXPECT_NEAR(s.volume, -a*b, 1e-14);
    }
}

TEST(PatchElements, seamsOnCyclicPatches)
{
    BoxMesh box(block());
    box.sides(0, "cyclic");
    const auto mesh = box.make(testTime());
    const wallSpace space(mesh(), wallControls(0.1, 3));
    const wallElements all(patchElements(space, sides(mesh())));
    EXPECT_EQ(all.elements.size(), 2*2*(3*2 + 4*2));
    forAll(all.points, i)
    {
        const bool end = mag(all.points[i].x() + 0.1) > 0.1;
        EXPECT_NEAR(mag(all.seam[i].x()), end, 1e-14);
        EXPECT_NEAR(mag(all.seam[i]), end, 1e-14);
    }
}

//- A solid in the fluid: its elements enclose it, outwards
TEST(PatchElements, cellsThatAreLeftOut)
{
    BoxMesh box(block());
    box.divide(0, -0.3, 0.1, 4);
    box.there = [](int i, int j, int k) { return i != 1 || j != 1 || (k != 1 && k != 2); };
    const auto mesh = box.make(testTime());
    const wallSpace space(mesh(), wallControls(0.1, 3));
    const wallElements all(patchElements(space, labelList(1, 6)));
    EXPECT_EQ(all.elements.size(), 2*(2 + 4*2));
    EXPECT_EQ(all.points.size(), 2*2*3);
    const Sums s(sumsOf(space, all));
    EXPECT_NEAR(mag(s.area), 0, 1e-14);
    EXPECT_NEAR(s.volume, 0.1*0.3*0.1, 1e-14);
}
