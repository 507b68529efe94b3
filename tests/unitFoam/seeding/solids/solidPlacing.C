// SPDX-License-Identifier: GPL-3.0-or-later
/*  Particles of solids in volumes: numbers and places of lattices, masses, random packings and
    their gradings; what is refused. */

#include "solidRegionCase.hpp"

#include <set>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);
    const std::string cube("source box; box (0 0 0) (1 1 1); ");
    const std::string ball("source sphere; centre (0.5 0.5 0.5); radius 0.4; ");

    //- Particles of each radius
    std::map<double, int> sizesOf(const solidRegion& r)
    {
        std::map<double, int> n;
        for (const scalar radius : r.radius) ++n[radius];
        return n;
    }

    //- No two overlap, and all are in the unit cube; in 2D in its mid-plane
    void expectApart(const solidRegion& r, bool planar)
    {
        forAll(r.position, i)
        {
            for (direction d = 0; d < 3; ++d)
            {
                if (planar && d == 1) EXPECT_EQ(r.position[i][d], 0.5);
                else EXPECT_LE(std::abs(r.position[i][d] - 0.5), 0.5 - r.radius[i]*(1 - 1e-5));
            }
            for (label j = 0; j < i; ++j)
                ASSERT_GT(mag(r.position[i] - r.position[j]),
                    (r.radius[i] + r.radius[j])*(1 - 1e-6));
        }
    }
}

TEST(SolidPlacing, cubicLattice)
{
    const SolidRegionCase c;
    const std::string box("source box; box (0 0 0) (0.5 0.4 0.3); ");
    auto r = c.one(box + "spacing 0.1; velocity (1 2 3); spin (4 5 6);");
    ASSERT_EQ(r.size(), 5*4*3);
    const boundBox reach(r.position, false);
    EXPECT_LT(mag(reach.min() - point(0.05, 0.05, 0.05)), 1e-14);
    EXPECT_LT(mag(reach.max() - point(0.45, 0.35, 0.25)), 1e-14);
    EXPECT_NEAR(leastDistance(r.position), 0.1, 1e-14);
    EXPECT_EQ(pairsAt(r.position, 0.1), 4*4*3 + 5*3*3 + 5*4*2);
    forAll(r.position, i)
    {
        EXPECT_EQ(r.radius[i], 0.05);
        EXPECT_NEAR(r.mass[i], 2000*ballOf(0.05), 1e-12);
        EXPECT_EQ(r.velocity[i], vector(1, 2, 3));
        EXPECT_EQ(r.spin[i], vector(4, 5, 6));
        EXPECT_EQ(r.clump[i], -1);
        EXPECT_EQ(r.group[i], 0);
    }
    EXPECT_NEAR(sum(c.one(box + "spacing 0.1; mass cell;").mass), 2000*0.5*0.4*0.3, 1e-10);
    // apart: rows begin and end within the box; of the box's sides both words mean the radius
    for (const char* radius : {"radius 0.03; ", "particleRadius 0.03; "})
    {
        r = c.one(box + radius + "spacing 0.1;");
        EXPECT_EQ(r.size(), 5*4*3);
        EXPECT_LT(mag(boundBox(r.position, false).min() - point(0.03, 0.03, 0.03)), 1e-14);
        EXPECT_EQ(r.radius[0], 0.03);
        EXPECT_EQ(c.one(box + radius).size(), 8*6*5);
    }
}

//- Each touches 12 others, and takes 1/sqrt(2) of the cube of its diameter
TEST(SolidPlacing, hexagonalClosePacking)
{
    const SolidRegionCase c;
    const auto r = c.one(cube + "packing hexagonal; spacing 0.1; mass cell;");
    EXPECT_NEAR(leastDistance(r.position), 0.1, 1e-12);
    // rows of 10 and 9, 0.1 sqrt(3)/2 apart: 11; layers 0.1 sqrt(2/3) apart: 12, of which every
    // other one is moved along and across rows
    const int even = 6*10 + 5*9, odd = 5*10 + 6*9;
    EXPECT_EQ(r.size(), 6*even + 6*odd);
    EXPECT_NEAR(r.mass[0], 2000*1e-3/std::sqrt(2.0), 1e-12);
    int most = 0;
    forAll(r.position, i)
    {
        int near = 0;
        forAll(r.position, j) near += j != i && mag(r.position[i] - r.position[j]) < 0.1 + 1e-9;
        most = std::max(most, near);
    }
    EXPECT_EQ(most, 12);
}

TEST(SolidPlacing, layersLieInDips)
{
    const SolidRegionCase c;
    const auto r = c.one("source box; box (0 0 0) (0.5 0.4 0.35); packing layers; spacing 0.1; "
                         "mass cell;");
    // heights 0.05 + 0.0707 k up to 0.3: 4 layers
    EXPECT_EQ(r.size(), 2*5*4 + 2*4*3);
    EXPECT_NEAR(leastDistance(r.position), 0.1, 1e-12);
    EXPECT_NEAR(r.mass[0], 2000*1e-3/std::sqrt(2.0), 1e-12);
    // a layer's own contacts, and four below and above each of the smaller ones
    EXPECT_EQ(pairsAt(r.position, 0.1), 2*(4*4 + 5*3) + 2*(3*3 + 4*2) + 12*4*3);
}

TEST(SolidPlacing, disks)
{
    const SolidRegionCase c(SolidRegionCase::flat());
    const std::string box("source box; box (0 0 0) (1.05 1 0.55); spacing 0.1; mass cell; clip "
                          "yes; ");
    // rows 0.0866 apart up to 0.5: 6. There is room for 10 in each of them: layers take 9
    auto r = c.one(box + "packing hexagonal;");
    EXPECT_EQ(r.size(), 3*10 + 3*9);
    EXPECT_EQ(r.clipped, 3);
    EXPECT_NEAR(leastDistance(r.position), 0.1, 1e-12);
    for (const scalar m : r.mass) EXPECT_NEAR(m, 2000*0.01*std::sqrt(3.0)/2, 1e-12);
    r = c.one(box + "packing layers;");
    EXPECT_EQ(r.size(), 3*10 + 3*9);
    EXPECT_EQ(r.clipped, 0);
    for (const point& x : r.position) EXPECT_EQ(x.y(), 0.5);
    // 2D: mass of a disk per metre
    r = c.one("source box; box (0 0 0) (1 1 1); spacing 0.25;");
    EXPECT_EQ(r.size(), 16);
    EXPECT_NEAR(r.mass[3], 2000*pi*0.125*0.125, 1e-12);
}

//- Bodies whose surface is in the volume: counted here for the same lattice
TEST(SolidPlacing, roundVolumes)
{
    const SolidRegionCase c;
    const auto r = c.one("source cylinder; p1 (0.5 0.5 0.1); p2 (0.5 0.5 0.9); radius 0.4; spacing "
                         "0.1; mass cell;");
    int n = 0;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) n += std::hypot(0.1*i - 0.35, 0.1*j - 0.35) + 0.05 <= 0.4;
    EXPECT_EQ(r.size(), 8*n);
    // as many as fit, and no more than the volume
    EXPECT_LT(sum(r.mass), 2000*pi*0.16*0.8);
    const auto s = c.one(ball + "particleRadius 0.02;");
    n = 0;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j)
            for (int k = 0; k < 20; ++k)
                n += mag(vector(i - 9.5, j - 9.5, k - 9.5)*0.04) + 0.02 <= 0.4;
    EXPECT_NEAR(s.size(), n, 0.02*n);
    for (const point& x : s.position) EXPECT_LE(mag(x - 0.5*vector::one), 0.38 + 0.1*0.02);
}

TEST(SolidPlacing, aGradingBecomesWholeBodies)
{
    for (const bool planar : {false, true})
    {
        const SolidRegionCase c(planar ? SolidRegionCase::flat() : BoxMesh());
        const std::string text(cube + "packing random; solidFraction 0.3; radii (0.05 0.1); shares "
            "(0.25 0.75); ");
        const auto volume = [&](double radius)
        { return planar ? pi*radius*radius : ballOf(radius); };
        auto r = c.one(text);
        auto n = sizesOf(r);
        EXPECT_EQ(n[0.05], std::lround(0.25*0.3/volume(0.05)));
        EXPECT_EQ(n[0.1], std::lround(0.75*0.3/volume(0.1)));
        EXPECT_EQ(r.sizes, scalarList({0.05, 0.1}));
        forAll(r.mass, i) EXPECT_NEAR(r.mass[i], 2000*volume(r.radius[i]), 1e-9);
        expectApart(r, planar);
        // shares of the number; with one mass for all the region's is kept
        r = c.one(text + "sharesOf number; mass cell;");
        n = sizesOf(r);
        const double mean = 0.25*volume(0.05) + 0.75*volume(0.1);
        EXPECT_EQ(n[0.05], std::lround(0.25*0.3/mean));
        EXPECT_EQ(n[0.1], std::lround(0.75*0.3/mean));
        EXPECT_NEAR(sum(r.mass), 2000, 1e-9);
        EXPECT_EQ(min(r.mass), max(r.mass));
        expectApart(r, planar);
    }
}

TEST(SolidPlacing, aRangeOfRadii)
{
    const SolidRegionCase c;
    const std::string text(cube + "packing random; solidFraction 0.25; particleRadius 0.06; "
        "largestRadius 0.12; ");
    const auto r = c.one(text), again = c.one(text + "seed 1;"), other = c.one(text + "seed 2;");
    expectApart(r, false);
    double volume = 0;
    for (const scalar radius : r.radius)
    {
        EXPECT_GE(radius, 0.06);
        EXPECT_LE(radius, 0.12);
        volume += ballOf(radius);
    }
    EXPECT_NEAR(volume, 0.25, 0.5*ballOf(0.12));
    EXPECT_EQ(r.position, again.position);
    EXPECT_NE(r.position, other.position);
    EXPECT_GT(std::set<double>(r.radius.begin(), r.radius.end()).size(), 0.9*r.size());
    EXPECT_TRUE(r.sizes.empty());
    const auto even = c.one(cube + "packing random; solidFraction 0.2; particleRadius 0.1;");
    EXPECT_EQ(even.size(), std::lround(0.2/ballOf(0.1)));
    expectApart(even, false);
}

TEST(SolidPlacing, sizesThatAreRefused)
{
    const SolidRegionCase c;
    EXPECT_EQ(c.said(cube), "Region a: How large are the particles? Write `particleRadius <m>;` or "
                            "`spacing <m>;`, the distance between the centres of neighbours");
    EXPECT_EQ(c.said(ball), "Region a: radius 0.4 is that of the sphere, not of its particles. How "
                            "large are the particles? Write `particleRadius <m>;` or `spacing "
                            "<m>;`, the distance between the centres of neighbours");
    EXPECT_EQ(c.said(ball + "packing random; solidFraction 0.3; spacing 0.1;"),
        "Region a: radius 0.4 is that of the sphere, not of its particles. How large are the "
        "particles? Write `particleRadius <m>;`");
    EXPECT_EQ(c.said(cube + "radius 0.1; particleRadius 0.1;"), "Entries radius and particleRadius "
        "are both there: one of them is the particles' radius");
    EXPECT_EQ(c.said(cube + "spacing 0.1; radii (0.1); shares (1);"),
        "Entry radii needs `packing random;`: on a lattice all particles have one radius");
    EXPECT_EQ(c.said(cube + "spacing 0.1; packing fitted;"),
        "Entry packing is fitted, which is for one rigid body: with `rigid yes;`");
    EXPECT_TRUE(holds(c.said(cube + "radius 1e-6;"),
        "Region a would hold about 1.25e+17 particles, and "));
    EXPECT_TRUE(holds(c.said(cube + "radius 1e-6;"), ": is the particles' radius or spacing "
                                                     "meant?"));
    EXPECT_EQ(c.said(cube + "radius 0.6;"), "Region a holds no particle: bodies must lie wholly in "
        "it. The mesh is (0 0 0) to (1 1 1)");
    EXPECT_EQ(c.said(cube + "spacing 0.1; mass both;"),
        "Entry mass has the unknown word both; valid are (cell particle)");
    EXPECT_EQ(c.said(cube + "spacing 0.1; packing squre;"), "Entry packing has the unknown word "
        "squre; valid are (square hexagonal layers random fitted); did you mean square?");
}

TEST(SolidPlacing, randomPackingsThatAreRefused)
{
    const SolidRegionCase c;
    const std::string random(cube + "packing random; ");
    EXPECT_EQ(c.said(random + "radius 0.1; solidFraction 1.1;"),
        "Entry solidFraction is 1.1: it must be from 0 to 1");
    EXPECT_TRUE(
        holds(c.said(random + "radius 0.1;"), "Entry 'solidFraction' not found in dictionary"));
    EXPECT_EQ(c.said(random + "radius 0.1; largestRadius 0.05; solidFraction 0.3;"),
        "Entry largestRadius is 0.05, less than the particles' radius 0.1");
    const std::string sizes(random + "radii (0.05 0.1); solidFraction 0.3; ");
    for (const char* other : {"particleRadius", "largestRadius", "radius"})
        EXPECT_EQ(c.said(sizes + "shares (0.5 0.5); " + other + " 0.1;"),
            std::string("Entries radii and ") + other
                + " are both there: one of them says how large the particles are");
    EXPECT_EQ(c.said(sizes + "shares (0.5 0.5); mass cell;"), "Entry sharesOf is mass, but with "
        "`mass cell;` all particles have one mass: valid is number");
    EXPECT_EQ(c.said(sizes), "Entry shares is missing: sizes need radii (<m> ..) and shares "
                             "(<fraction> ..), one for each");
    EXPECT_EQ(c.said(sizes + "shares (0.5 0.4);"),
        "Entry shares adds up to 0.9: shares are fractions of the mass that add up to 1");
    EXPECT_EQ(c.said(random + "radius 0.5; solidFraction 0.9;"), "Region a: 2 bodies cannot be "
        "brought apart at solidFraction 0.9; random packings reach about 0.8 in 2D and 0.6 in 3D, "
        "less beside walls");
    EXPECT_TRUE(holds(c.said(random + "radius 1e-6; solidFraction 0.3;"),
        "Region a would hold about 1e+18 particles, and "));
}
