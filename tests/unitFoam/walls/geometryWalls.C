// SPDX-License-Identifier: GPL-3.0-or-later
/*  Surfaces of constant/geometry: what is refused, on which side the solid is, their elements and
    points. */

#include "geometryWalls.H"
#include "laidWalls.hpp"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    std::string said(const std::string& text)
    {
        return messageOf([&]() { geometryWalls(testTime(), entries(text)); });
    }

    //- 4 x 4 x 4 about the origin; 2D: x and z
    BoxMesh space(int D)
    {
        BoxMesh box;
        for (int d = 0; d < 3; ++d) box.divide(d, -2, 2, 2);
        if (D == 2) { box.divide(1, -0.5, 0.5, 1); box.sides(1, "empty"); }
        return box;
    }

    wallPoints bodyPoints(int D, const std::string& text, double spacing, int layers)
    {
        const auto mesh = space(D).make(testTime());
        const geometryWalls bodies(testTime(), entries(text));
        return generateWallPoints(mesh(), labelList(), &bodies, wallControls(spacing, layers));
    }
}

TEST(GeometryWalls, whatIsRefused)
{
    EXPECT_EQ(said("a 1;"), "Entry a is no dictionary: each surface needs one with its type");
    EXPECT_TRUE(holds(said("a { type searchableBocks; }"), "Unknown type searchableBocks of a; "
                                                           "valid types are "));
    EXPECT_EQ(said("a { type box; min (0 0 0); max (1 0 1); }"),
        "Entries min and max are (0 0 0) and (1 0 1): there is nothing between them");
    EXPECT_EQ(said("a { type cylinder; point1 (1 2 3); point2 (1 2 3); radius 1; }"),
        "Entries point1 and point2 are (1 2 3) and (1 2 3): there is nothing between them");
    EXPECT_EQ(said("a { type sphere; origin (0 0 0); radius 0; }"),
        "Entry radius is 0: it must be positive");
    EXPECT_EQ(said("a { type plate; origin (0 0 0); span (0 0 0); }"),
        "Entry span is the null vector: it needs a length");
    EXPECT_TRUE(holds(said("a { type sphere; origin (0 0 0); radius 1; raduis 2; }"),
        "Unknown entry raduis; valid are"));
    EXPECT_EQ(said("a { type sphere; origin (0 0 0); radius 1; solidSide insid; }"),
        "Unknown solidSide insid; valid ones are (inside outside both); did you mean inside?");
    EXPECT_EQ(said("a { type plate; origin (0 0 0); span (0 1 1); solidSide inside; }"),
        "solidSide inside of a, which is no closed surface: only both is possible");
}

TEST(GeometryWalls, sideOfTheSolid)
{
    const geometryWalls bodies
    (
        testTime(),
        entries("ball { type sphere; origin (0 0 0); radius 1; }"
                "room { type box; min (-1 -1 -1); max (1 1 1); solidSide outside; }"
                "plate { type plate; origin (0 0 0); span (0 1 1); }")
    );
    EXPECT_EQ(bodies.side(0), geometryWalls::solidSide::inside);
    EXPECT_EQ(bodies.side(1), geometryWalls::solidSide::outside);
    EXPECT_EQ(bodies.side(2), geometryWalls::solidSide::both);
    const pointField at({{0.5, 0, 0}, {0.9, 0.9, 0}, {2, 0, 0}});
    EXPECT_EQ(bodies.inSolid(0, at), boolList({true, false, false}));
    EXPECT_EQ(bodies.inSolid(1, at), boolList({false, false, true}));
    EXPECT_EQ(bodies.inSolid(2, at), boolList({false, false, false}));
}

//- Turned about y the sections of a cylinder along y and of a ball are circles; segments have the
//  fluid on their left
TEST(GeometryWalls, sectionsIn2D)
{
    const auto mesh = space(2).make(testTime());
    const wallSpace at(mesh(), wallControls(0.05, 3));
    const geometryWalls bodies
    (
        testTime(),
        entries("pile { type cylinder; point1 (0.3 -1 0.2); point2 (0.3 1 0.2); radius 0.5; }"
                "ball { type sphere; origin (0 0.3 0); radius 0.5; }"
                "room { type box; min (-1 -1 -0.5); max (1 1 0.5); solidSide outside; }"
                "far  { type sphere; origin (0 3 0); radius 0.5; }")
    );
    const double lengths[] = {2*pi*0.5, 2*pi*0.4, 6}, areas[] = {pi*0.25, pi*0.16, -2};
    for (label b = 0; b < 3; ++b)
    {
        const wallElements all(bodyElements(at, bodies, b, b));
        double length = 0, area = 0;
        for (const auto& e : all.elements)
        {
            EXPECT_EQ(e[2], -1);
            const point &p = all.points[e[0]], &q = all.points[e[1]];
            length += mag(q - p);
            area += 0.5*(at.left(q - p) & p);
        }
        EXPECT_NEAR(length/lengths[b], 1, 2e-3) << b;
        EXPECT_NEAR(area/areas[b], 1, 4e-3) << b;
        EXPECT_EQ(connectedParts(all).size(), 1);
    }
    EXPECT_EQ(messageOf([&]() { bodyElements(at, bodies, 3, 0); }),
        "surface far of constant/geometry does not meet the mid-plane of the mesh, y = 0");
}

TEST(GeometryWalls, aBallIsFilledFromItsSurface)
{
    const double dp = 0.1, r = 0.5;
    for (const int D : {2, 3})
    {
        const wallPoints w
        (
            bodyPoints(D, "ball { type sphere; origin (0 0 0); radius 0.5; }", dp, 2)
        );
        double expected = 0;
        for (const double d : {0.05, 0.15})
            expected += D == 2 ? std::round(2*pi*(r - d)/dp) : std::round(4*pi*sqr(r - d)/sqr(dp));
        EXPECT_NEAR(w.size(), expected, 0.02*expected);
        for (label i = 0; i < w.size(); ++i)
        {
            const point& p = w.position[i];
            const double layer = (r - mag(p))/dp - 0.5;
            EXPECT_NEAR(layer, std::round(layer), 0.1);
            EXPECT_GT(w.normal[i] & p/mag(p), 0.95);     // of facets
        }
        EXPECT_GT(nearestTwo(w.position), 0.65*dp);
        for (label f = 0; f < w.faces.size(); ++f) EXPECT_EQ(w.faces.part[f], 1);
    }
}

//- Layers on both sides of a plate, normals away from its middle plane
TEST(GeometryWalls, aPlateIsInTheMiddleOfItsLayers)
{
    for (const int layers : {3, 4})
    {
        const wallPoints w
        (
            bodyPoints(3, "p { type plate; origin (0 -0.5 -0.4); span (0 1 0.8); }", 0.1, layers)
        );
        EXPECT_EQ(w.size(), 10*8*4);
        for (label i = 0; i < w.size(); ++i)
        {
            const point& p = w.position[i];
            EXPECT_NEAR(std::abs(mag(p.x()) - 0.1), 0.05, 1e-9);
            EXPECT_NEAR(w.normal[i].x(), p.x() > 0 ? 1 : -1, 1e-9);
        }
        ASSERT_EQ(w.faces.size(), 2);
        EXPECT_NEAR(w.faces.halfThickness[0], 0.2, 1e-12);
    }
}

TEST(GeometryWalls, readFromTheCase)
{
    ScratchCase c;
    EXPECT_FALSE(wallGeometry(c.time()).valid());
    c.writeDict("constant/geometry", "ball { type sphere; origin (0 0 0); radius 1; }");
    ASSERT_TRUE(wallGeometry(c.time()).valid());
    EXPECT_EQ(wallGeometry(c.time())->names(), wordList({"ball"}));
    c.write("constant/geometry", "ball { type sphere; origin (0 0 0); radius 1; }");
    EXPECT_TRUE(holds(messageOf([&]() { wallGeometry(c.time()); }),
        "The file does not begin as a dictionary does, with FoamFile"));
}
