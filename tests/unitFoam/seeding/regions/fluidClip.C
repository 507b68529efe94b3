// SPDX-License-Identifier: GPL-3.0-or-later
/*  Water cut at solids: as many particles go as the bodies fill of it, the others are moved off
    their surface, evenly on both sides; bodies without a shape. */

#include "fluidRegionCase.hpp"

#include <algorithm>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0), spacing = 0.05;
    const std::string all("source box; box (0 0 0) (1 1 1); clip yes; ");
    const std::string half("source box; box (0 0 0) (1 1 0.5); clip yes; ");

    //- Water about one region of solids
    struct ClipCase : FluidRegionCase
    {
        explicit ClipCase(const std::string& solid, const BoxMesh& box = SolidRegionCase::flat())
        :
            FluidRegionCase(box)
        {
            addObstacle(one(solid));
        }

        //- How far particles are off a cylinder along y or a ball about `centre`
        static double nearest(const particleRegion& r, const point& centre, double radius,
            bool planar)
        {
            double least = 1e300;
            for (vector x : r.position)
            {
                x -= centre;
                if (planar) x.y() = 0;
                least = std::min(least, mag(x) - radius);
            }
            return least;
        }
    };

    std::string cylinder(double z, double radius = 0.2)
    {
        return "rigid yes; spacing 0.05; source cylinder; p1 (0.5 0 " + std::to_string(z)
            + "); p2 (0.5 1 " + std::to_string(z) + "); radius " + std::to_string(radius) + "; ";
    }

    //- How far the worst is from the mirror image of another across the middle of an axis
    double fromImages(const pointField& position, direction axis)
    {
        double most = 0;
        for (point image : position)
        {
            image[axis] = 1 - image[axis];
            double least = 1e300;
            for (const point& x : position) least = std::min(least, mag(x - image));
            most = std::max(most, least);
        }
        return most;
    }
}

TEST(FluidClip, asManyGoAsTheBodyFills)
{
    for (const double radius : {0.2, 0.23, 0.31})
    {
        const ClipCase c(cylinder(0.5, radius));
        const auto r = c.water(all);
        // 16 x 16 points a cell that is cut
        EXPECT_NEAR(400 - r.size(), pi*radius*radius/0.0025, 0.6) << radius;
        EXPECT_GT(c.nearest(r, {0.5, 0, 0.5}, radius, true), 0.5*spacing - 1e-9);
        EXPECT_GT(leastDistance(r.position), 0.6*spacing);
        EXPECT_EQ(r.pressure.size(), r.size());
        for (const point& x : r.position) EXPECT_EQ(x.y(), 0.5);
        // of a body half in the water the half of it
        const ClipCase floating(cylinder(0.5, radius));
        EXPECT_NEAR(200 - floating.water(half).size(), pi*radius*radius/0.005, 0.6) << radius;
    }
}

TEST(FluidClip, theLatticeBeyondStays)
{
    const ClipCase c(cylinder(0.5, 0.15));
    const auto r = c.water(all);
    int beyond = 0, there = 0;
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k)
        {
            const point x((i + 0.5)*spacing, 0.5, (k + 0.5)*spacing);
            // removed are those within the body, moved those less than four spacings off
            if (mag(x - point(0.5, 0.5, 0.5)) < 0.15 + 4*spacing) continue;
            ++beyond;
            for (const point& y : r.position) there += mag(x - y) < 1e-9;
        }
    EXPECT_GT(beyond, 100);
    EXPECT_EQ(there, beyond);
    // hydrostatic at the places that they were moved to
    forAll(r.position, i) EXPECT_NEAR(r.pressure[i], 1e4*(1 - r.position[i].z()), 400);
}

//- A body in the middle would heel if more went on one side
TEST(FluidClip, evenlyOnBothSides)
{
    for (const double z : {0.5, 0.52, 0.47})
    {
        const ClipCase c(cylinder(z));
        const auto r = c.water(half);
        int left = 0;
        for (const point& x : r.position) left += x.x() < 0.5;
        EXPECT_LE(std::abs(2*left - r.size()), r.size() % 2) << z;
    }
    // a body whose own particles are symmetric, of which 0.4*0.1875/0.05^2 are in the water
    const ClipCase c("rigid yes; spacing 0.05; source box; box (0.3 0 0.3125) (0.7 1 0.7125);");
    const auto r = c.water(half);
    EXPECT_EQ(200 - r.size(), 30);
    EXPECT_LT(fromImages(r.position, 0), 1e-6*spacing);
}

TEST(FluidClip, ballsIn3D)
{
    const ClipCase c("rigid yes; spacing 0.05; source sphere; centre (0.5 0.5 0.5); radius 0.12;",
        BoxMesh());
    const auto r = c.water(half);
    EXPECT_NEAR(20*20*10 - r.size(), ballOf(0.12)/2/(spacing*spacing*spacing), 1);
    EXPECT_GT(c.nearest(r, {0.5, 0.5, 0.5}, 0.12, false), 0.5*spacing - 1e-9);
}

//- Three quarters of its lowest layer of cells are in a block: 12 of 16 that are equally deep go
TEST(FluidClip, fourMirrorImagesIn3D)
{
    const ClipCase c("rigid yes; spacing 0.1; source box; box (0.3 0.3 0.225) (0.7 0.7 0.625);",
        BoxMesh());
    const auto r = c.water(half, "spacing 0.1;");
    EXPECT_EQ(10*10*5 - r.size(), 4*4*2 + 12);
    for (const direction axis : {0, 1}) EXPECT_LT(fromImages(r.position, axis), 1e-7);
}

//- Bonded particles with the mass of their region are a body, too
TEST(FluidClip, bondedBodies)
{
    const std::string block("source box; box (0.3 0 0.2) (0.7 1 0.6); spacing 0.05; ");
    const ClipCase c(block + "mass cell;");
    // two sides of it are on the lattice's
    EXPECT_EQ(400 - c.water(all).size(), 64);
    // by its particles alone: gone are those within 0.4 spacings of a disk's surface, that is all
    // within the block
    const ClipCase none(block);
    EXPECT_EQ(400 - none.water(all).size(), 64);
    const ClipCase shifted("source box; box (0.32 0 0.2) (0.72 1 0.6); spacing 0.05; ");
    int gone = 0;
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k)
        {
            double least = 1;
            for (const point& x : shifted.obstacles[0].centre)
                least = std::min(least, std::hypot((i + 0.5)*spacing - x.x(),
                    (k + 0.5)*spacing - x.z()) - 0.025);
            gone += least < 0.4*spacing;
        }
    EXPECT_EQ(400 - shifted.water(all).size(), gone);
}

TEST(FluidClip, withoutALattice)
{
    ClipCase c(cylinder(0.5));
    c.write(
        "a.csv", "x,y,z,u,v,w,p\n0.719,0,0.5,1,2,3,4\n0.721,0,0.5,5,6,7,8\n0.5,0,0.5,0,0,0,0\n");
    const auto r = c.water("source csv; file \"a.csv\"; clip yes;");
    ASSERT_EQ(r.size(), 1);
    EXPECT_EQ(r.position[0], point(0.721, 0.5, 0.5));
    EXPECT_EQ(r.velocity[0], vector(5, 6, 7));
    EXPECT_EQ(r.pressure[0], 8);
    // hexagonal water is cut by the same rule, and not moved
    const std::string lattice("spacing 0.05; packing hexagonal;");
    const auto cut = c.water(all, lattice);
    FluidRegionCase empty(SolidRegionCase::flat());
    int n = 0;
    for (const point& x : empty.water(all, lattice).position)
        n += mag(x - point(0.5, 0.5, 0.5)) - 0.2 >= 0.4*spacing;
    EXPECT_EQ(cut.size(), n);
    // nothing is near
    EXPECT_EQ(c.water("source box; box (0 0 0) (0.2 1 0.2); clip yes;").size(), 16);
    // and regions without the word stay as they are
    EXPECT_EQ(c.water("source box; box (0 0 0) (1 1 1);").size(), 400);
}
