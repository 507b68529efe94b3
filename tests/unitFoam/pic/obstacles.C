// SPDX-License-Identifier: GPL-3.0-or-later
/*  Surfaces of constant/geometry as obstacles of a grid, and shapes of bodies as lattices of
    distances. */

#include "boxMesh.hpp"
#include "picObstacles.H"
#include "picShapes.H"
#include "scratchCase.hpp"
#include "wallPoints.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double h = 0.1;

    struct ObstacleCase : ScratchCase
    {
        autoPtr<polyMesh> mesh;

        explicit ObstacleCase(int D, const std::string& geometry = "")
        {
            BoxMesh box;
            if (D == 2) box.sides(1, "empty");
            mesh = box.make(time());
            writeDict("constant/geometry", geometry);
        }

        std::vector<riprap::PicObstacle> obstacles(label body = -1)
        {
            const autoPtr<geometryWalls> surfaces(wallGeometry(time()));
            return picObstacles(mesh(), surfaces(), labelList(surfaces->size(), body), h);
        }
    };

    boundBox boundsOf(const riprap::PicObstacle& o)
    {
        boundBox bounds;
        for (std::size_t i = 0; i < o.vertices.size(); i += 3)
            bounds.add(point(o.vertices[i], o.vertices[i + 1], o.vertices[i + 2]));
        return bounds;
    }

    //- Enclosed by the triangles
    double volumeOf(const riprap::PicObstacle& o)
    {
        double sum = 0;
        const auto at = [&](int v)
        { return point(o.vertices[3*v], o.vertices[3*v + 1], o.vertices[3*v + 2]); };
        for (std::size_t e = 0; e < o.elements.size(); e += 3)
            sum += (at(o.elements[e]) & (at(o.elements[e + 1]) ^ at(o.elements[e + 2])))/6;
        return sum;
    }

    const std::string block("block { type searchableBox; min (0.2 0.3 0.1); max (0.6 0.7 0.4); } ");
}

TEST(PicObstacles, blocksAndSheets)
{
    ObstacleCase c(3, block + "ball { type searchableSphere; centre (0.5 0.5 0.5); radius 0.3; } "
        "basin { type searchableBox; min (0.1 0.1 0.1); max (0.9 0.9 0.9); solidSide outside; }");
    const auto all = c.obstacles(4);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].name, "block");
    EXPECT_TRUE(all[0].closed);
    EXPECT_FALSE(all[0].solidOutside);
    EXPECT_TRUE(all[2].closed);
    EXPECT_TRUE(all[2].solidOutside);
    EXPECT_EQ(all[1].body, 4);
    // after the six walls
    for (int i = 0; i < 3; ++i) EXPECT_EQ(all[i].part, 6 + i);
    EXPECT_NEAR(mag(boundsOf(all[0]).min() - point(0.2, 0.3, 0.1)), 0, 1e-12);
    EXPECT_NEAR(mag(boundsOf(all[0]).max() - point(0.6, 0.7, 0.4)), 0, 1e-12);
    EXPECT_NEAR(std::abs(volumeOf(all[0])), 0.4*0.4*0.3, 1e-12);
    EXPECT_NEAR(std::abs(volumeOf(all[1]))/(4*std::acos(-1.0)/3*0.027), 1, 0.1);
}

TEST(PicObstacles, inThePlane)
{
    ObstacleCase c(2, block);
    const auto all = c.obstacles();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].elements.size() % 2, 0u);
    // the four sides' length
    double length = 0;
    for (std::size_t e = 0; e < all[0].elements.size(); e += 2)
    {
        const double* a = &all[0].vertices[3*all[0].elements[e]];
        const double* b = &all[0].vertices[3*all[0].elements[e + 1]];
        length += std::hypot(b[0] - a[0], b[2] - a[2]);
    }
    EXPECT_NEAR(length, 2*(0.4 + 0.3), 1e-12);
    EXPECT_EQ(all[0].part, 4);
}

TEST(PicObstacles, mustReachTheMesh)
{
    ObstacleCase c(3, "far { type searchableBox; min (2 0 0); max (3 1 1); }");
    EXPECT_EQ(messageOf([&]() { c.obstacles(); }),
        "Surface far of constant/geometry, (2 0 0) (3 1 1), does not meet the mesh, (0 0 0) (1 1 "
        "1): move it there, or leave it out");
    // what moves may come later
    EXPECT_EQ(messageOf([&]() { c.obstacles(0); }), "");
    const autoPtr<geometryWalls> surfaces(wallGeometry(c.time()));
    EXPECT_TRUE(holds(
        messageOf([&]() { requireObstacles(c.mesh(), surfaces(), List<wallMotion>(), h); }),
        "Surface far of constant/geometry"));
}

//- Distances from spheres and boxes at all points of their lattice
TEST(PicShapes, distances)
{
    ObstacleCase c(3);
    c.writeDict("0/uniform/lagrangian/solids/cloudProperties",
        "geometry positions; shapes { ball { source sphere; centre (1 2 3); radius 0.2; } block { "
        "source box; box (0 0 0) (0.4 0.2 0.1); } }");
    riprap::PicConfig config;
    config.dimensions = 3;
    const auto all = picShapes(c.time(), config, h);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].name, "ball");
    EXPECT_NEAR(all[0].volume, 4*std::acos(-1.0)/3*0.008, 1e-12);
    EXPECT_NEAR(all[1].volume, 0.4*0.2*0.1, 1e-12);
    for (const riprap::PicShape& s : all)
    {
        EXPECT_NEAR(s.step, h/4, 1e-12);
        ASSERT_EQ(s.distance.size(), std::size_t(s.n[0])*s.n[1]*s.n[2]);
        double inside = 0;
        for (std::size_t i = 0; i < s.distance.size(); ++i)
        {
            const std::size_t row = i/s.n[0], layer = row/s.n[1];
            const vector y(s.lower[0] + s.step*(i % s.n[0]),
                s.lower[1] + s.step*(row % s.n[1]), s.lower[2] + s.step*layer);
            if (s.name == "ball") { EXPECT_NEAR(s.distance[i], mag(y) - 0.2, 1e-9); }
            inside += s.distance[i] < 0 ? s.step*s.step*s.step : 0;
        }
        EXPECT_NEAR(inside/s.volume, 1, 0.15) << s.name;
        // two cells beyond the body on all sides
        for (int d = 0; d < 3; ++d)
        {
            EXPECT_LE(s.lower[d], -2*h);
            EXPECT_NEAR(s.lower[d] + 0.5*(s.n[d] - 1)*s.step, 0, 1e-12);
        }
    }
}

TEST(PicShapes, inThePlane)
{
    ObstacleCase c(2);
    c.writeDict("0/uniform/lagrangian/solids/cloudProperties",
        "geometry positions; shapes { plate { outline ((0 0.5 0) (30 0.5 0) (30 0.5 1) (0 0.5 1)); "
        "} }");
    riprap::PicConfig config;
    config.axes[1] = 2;
    config.axes[2] = 1;
    const auto all = picShapes(c.time(), config, h);
    ASSERT_EQ(all.size(), 1u);
    const riprap::PicShape& s = all[0];
    EXPECT_EQ(s.n[1], 1);
    EXPECT_EQ(s.lower[1], 0);
    EXPECT_NEAR(s.volume, 30, 1e-12);
    // the longest side in 100 steps
    EXPECT_NEAR(s.step, 0.3, 1e-12);
    for (std::size_t i = 0; i < s.distance.size(); ++i)
    {
        const double x = std::abs(s.lower[0] + s.step*(i % s.n[0])) - 15;
        const std::size_t row = i/s.n[0];
        const double z = std::abs(s.lower[2] + s.step*row) - 0.5;
        const double out = std::hypot(std::max(x, 0.0), std::max(z, 0.0));
        EXPECT_NEAR(s.distance[i], out > 0 ? out : std::max(x, z), 1e-9);
    }
}
