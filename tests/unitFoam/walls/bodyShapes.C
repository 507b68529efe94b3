// SPDX-License-Identifier: GPL-3.0-or-later
/*  Shapes of constant/geometry as triangles: closed, outwards, of the area and volume of theirs. */

#include "bodyShapes.H"
#include "scratchCase.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    struct Measures
    {
        double area = 0, volume = 0, open = 0;
        boundBox box;
    };

    Measures measuresOf(const wallElements& all)
    {
        Measures m;
        vector sum(Zero);
        for (const auto& e : all.elements)
        {
            const point &a = all.points[e[0]], &b = all.points[e[1]], &c = all.points[e[2]];
            const vector A(0.5*((b - a) ^ (c - a)));
            sum += A;
            m.area += mag(A);
            m.volume += (A & (a - point(1, 1, 1)))/3;
        }
        m.open = mag(sum);
        m.box = boundBox(all.points, false);
        return m;
    }

    //- Every edge twice, in opposite senses
    bool closed(const wallElements& all)
    {
        std::set<std::pair<label, label>> ways;
        for (const auto& e : all.elements)
        {
            for (label v = 0; v < 3; ++v)
            {
                if (!ways.insert({e[v], e[(v + 1) % 3]}).second) return false;
            }
        }
        for (const auto& way : ways)
        {
            if (!ways.count({way.second, way.first})) return false;
        }
        return true;
    }
}

TEST(BodyShapes, box)
{
    wallElements all;
    addBox(all, treeBoundBox(point(1, 2, 3), point(2, 2.5, 5)).points(), 4);
    const Measures m(measuresOf(all));
    EXPECT_EQ(all.elements.size(), 12);
    EXPECT_TRUE(closed(all));
    EXPECT_NEAR(m.volume, 1, 1e-14);
    EXPECT_NEAR(m.area, 2*(0.5 + 2 + 1), 1e-14);
    for (const label source : all.source) EXPECT_EQ(source, 4);
}

//- Chords miss the circle by 1 % of the spacing: areas and volumes are less by that over the radius
TEST(BodyShapes, roundOnes)
{
    const double r = 0.4, spacing = 0.05, miss = 0.01*spacing/r;
    wallElements cylinder;
    addCylinder(cylinder, entries("point1 (1 1 1); point2 (1 2 3); radius 0.4;"), spacing, 0);
    EXPECT_TRUE(closed(cylinder));
    const double length = std::sqrt(5.0);
    Measures m(measuresOf(cylinder));
    EXPECT_NEAR(m.volume/(pi*r*r*length), 1 - miss, miss);
    EXPECT_NEAR(m.area/(2*pi*r*(length + r)), 1 - 0.5*miss, miss);

    wallElements sphere;
    addSphere(sphere, {1, 2, 3}, r, spacing, 0);
    EXPECT_TRUE(closed(sphere));
    m = measuresOf(sphere);
    EXPECT_NEAR(m.volume/(4*pi/3*r*r*r), 1 - 2*miss, 2*miss);
    EXPECT_NEAR(m.area/(4*pi*r*r), 1 - miss, 2*miss);
    for (const point& p : sphere.points) EXPECT_NEAR(mag(p - point(1, 2, 3)), r, 1e-14);

    wallElements disk;
    addDisk(disk, entries("origin (1 2 3); normal (0 1 1); radius 0.4;"), spacing, 0);
    m = measuresOf(disk);
    EXPECT_NEAR(m.area/(pi*r*r), 1 - miss, miss);
    EXPECT_NEAR(m.open, m.area, 1e-12);
}

TEST(BodyShapes, facetsByTheSpacing)
{
    wallElements coarse, fine, none;
    addSphere(coarse, {0, 0, 0}, 1, 0.5, 0);
    addSphere(fine, {0, 0, 0}, 1, 0.05, 0);
    // a tenth of the spacing: sqrt(10) times the facets round it, ten times as many in all
    EXPECT_NEAR(double(fine.elements.size())/coarse.elements.size(), 10, 1);
    // at most 2,048 round
    addDisk(none, entries("origin (0 0 0); normal (0 0 1); radius 1e4;"), 0.05, 0);
    EXPECT_LE(none.elements.size(), 2049);
}

TEST(BodyShapes, plate)
{
    wallElements all;
    addPlate(all, entries("origin (1 2 3); span (0 0.5 2);"), 0);
    const Measures m(measuresOf(all));
    EXPECT_NEAR(m.area, 1, 1e-14);
    EXPECT_NEAR(m.open, 1, 1e-14);
    EXPECT_EQ(m.box.min(), point(1, 2, 3));
    EXPECT_EQ(m.box.max(), point(1, 2.5, 5));
}

TEST(BodyShapes, trianglesMustBeOrientedAlikeAndOutwards)
{
    const pointField corners({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const auto said = [&](const List<labelledTri>& faces)
    {
        const triSurfaceMesh s
        (
            IOobject("tet", testTime().constant(), testTime(), IOobject::NO_READ,
                IOobject::NO_WRITE, false),
            triSurface(faces, geometricSurfacePatchList(), corners)
        );
        wallElements all;
        return messageOf([&]() { addTriangles(all, s, "tet", 0); });
    };
    const labelledTri a(0, 2, 1, 0), b(0, 1, 3, 0), c(0, 3, 2, 0), d(1, 2, 3, 0);
    const labelledTri turned(1, 3, 2, 0);
    EXPECT_EQ(said({a, b, c, d}), "");
    EXPECT_TRUE(holds(said({a, b, c, turned}), "the triangles of surface tet are not oriented "
                                               "alike at"));
    const auto back = [](const labelledTri& t) { return labelledTri(t[1], t[0], t[2], 0); };
    EXPECT_EQ(said({back(a), back(b), back(c), back(d)}),
        "the normals of the closed surface tet point into it: run surfaceOrient");
}
