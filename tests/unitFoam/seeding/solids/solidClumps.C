// SPDX-License-Identifier: GPL-3.0-or-later
/*  Clumps: mass properties are those of the surface or outline, spheres touch it from inside and
    turn with it; what is refused. */

#include "solidRegionCase.hpp"

#include <algorithm>

using namespace Foam;

namespace
{
    //- Sides 0.3, 0.2 and 0.1 with the lower corner at the origin, in millimetres
    const boundBox brick(point(0, 0, 0), point(300, 200, 100));
    const std::string source("source clumpsFromSurface; file \"brick.off\"; scale 1e-3; ");
    const std::string outline("source clumpsFromOutline; outline ((0 7 0) (0.3 0 0) (0.3 0 0.1) (0 "
                              "0 0.1)); ");
    const point middle(0.15, 0.1, 0.05);
    const double mass = 2000*0.3*0.2*0.1;

    struct ClumpCase : SolidRegionCase
    {
        explicit ClumpCase(const BoxMesh& box = BoxMesh()) : SolidRegionCase(box)
        {
            write("constant/triSurface/brick.off", boxSurface(brick));
        }
    };

    //- Of the brick as it stands in its file, about its centre
    tensor brickInertia() { return mass/12*tensor(0.05, 0, 0, 0, 0.1, 0, 0, 0, 0.13); }

    //- Distance from the centre of a sphere within the brick to its surface
    double depthIn(const point& x)
    {
        return cmptMin(min(x, point(0.3, 0.2, 0.1) - x));
    }

    //- What turns the spheres of body b to where they stand in the first one, by its pose
    void expectTurned(const solidRegion& r, label b, const tensor& turn)
    {
        const label n = r.size()/r.clumps.size();
        for (label i = 0; i < n; ++i)
        {
            const vector given(r.position[i] - centreOf(r.clumps[0]));
            const vector now(r.position[b*n + i] - centreOf(r.clumps[b]));
            EXPECT_LT(mag(now - (turn & given)), 1e-12);
            EXPECT_EQ(r.radius[b*n + i], r.radius[i]);
        }
    }
}

TEST(SolidClumps, massPropertiesAreTheSurfaces)
{
    ClumpCase c;
    const auto r = c.one(source + "velocity (1 2 3); spin (4 5 6); centres ((0.3 0.3 0.3) (0.7 0.7 "
        "0.7));");
    ASSERT_EQ(r.clumps.size(), 2);
    for (const auto& b : r.clumps)
    {
        EXPECT_NEAR(b.mass, mass, 1e-10);
        EXPECT_NEAR(b.volume, 0.006, 1e-14);
        EXPECT_LT(mag(inertiaOf(b) - brickInertia()), 1e-10);
        for (int d = 0; d < 3; ++d)
        {
            EXPECT_EQ(b.velocity[d], 1 + d);
            EXPECT_EQ(b.spin[d], 4 + d);
        }
    }
    EXPECT_EQ(centreOf(r.clumps[1]), 0.7*vector::one);
    const label n = r.size()/2;
    forAll(r.clump, i) EXPECT_EQ(r.clump[i], i < n ? 0 : 1);
    EXPECT_EQ(r.shape.get<fileName>("file"), "brick.off");
    EXPECT_EQ(r.shape.get<scalar>("scale"), 1e-3);
}

TEST(SolidClumps, spheresTouchFromInside)
{
    ClumpCase c;
    // without centres where the surface is
    auto r = c.one(source + "spheres 12;");
    ASSERT_EQ(r.clumps.size(), 1);
    EXPECT_LT(mag(centreOf(r.clumps[0]) - middle), 1e-12);
    EXPECT_EQ(r.size(), 12);
    // centres are tried 7.5 mm apart, evenly about the middle: none is at half the height
    EXPECT_NEAR(r.radius[0], 0.05 - 0.0075/2, 1e-9);
    forAll(r.position, i)
    {
        EXPECT_NEAR(depthIn(r.position[i]), r.radius[i], 1e-9);
        EXPECT_LE(r.radius[i], i ? r.radius[i - 1] : 1);
        for (label j = 0; j < i; ++j)
        {
            EXPECT_GE(mag(r.position[i] - r.position[j]), 0.8*r.radius[j]);
        }
    }
    // all that are large enough
    r = c.one(source + "smallestRadius 0.04; spheres 10000;");
    EXPECT_GE(min(r.radius), 0.04);
    const auto coarse = c.one(source + "resolution 10;");
    EXPECT_NEAR(max(coarse.radius), 0.05 - 0.03/2, 1e-9);
    // each has the mass of its material, which the body does not use
    EXPECT_NEAR(r.mass[0], 2000*ballOf(r.radius[0]), 1e-12);
}

TEST(SolidClumps, turnedAboutAnAxis)
{
    ClumpCase c;
    const std::string text(source + "spheres 5; resolution 15; ");
    const auto given = c.one(text + "centres ((0.5 0.5 0.5));");
    auto r = c.one(text + "centres ((0.5 0.5 0.5)); orientation turned; axis (0 0 2); angle 90;");
    const tensor turn(0, -1, 0, 1, 0, 0, 0, 0, 1);
    EXPECT_LT(mag(inertiaOf(r.clumps[0]) - (turn & brickInertia() & turn.T())), 1e-10);
    forAll(r.position, i)
        EXPECT_LT(mag(r.position[i] - 0.5*vector::one
            - (turn & (given.position[i] - 0.5*vector::one))), 1e-12);
    r = c.one(text + "orientation given;");
    EXPECT_LT(mag(inertiaOf(r.clumps[0]) - brickInertia()), 1e-10);
}

TEST(SolidClumps, atRandomEachItsOwnWay)
{
    ClumpCase c;
    const std::string text(source
        + "spheres 5; resolution 15; centres ((0.25 0.25 0.25) (0.75 0.75 0.25) (0.25 0.75 0.75) "
          "(0.75 0.25 0.75)); orientation random; ");
    const auto r = c.one(text), again = c.one(text + "seed 1;"), other = c.one(text + "seed 2;");
    EXPECT_EQ(r.position, again.position);
    EXPECT_NE(r.position, other.position);
    const tensor first(turnOf(r.clumps[0]));
    for (label b = 0; b < 4; ++b)
    {
        const tensor R(turnOf(r.clumps[b]));
        EXPECT_LT(mag((R & R.T()) - tensor::I), 1e-12);
        EXPECT_EQ(mag(R - first) > 0.1, b > 0);
        // spheres and principal axes turn together
        expectTurned(r, b, R & first.T());
    }
}

//- Entries of a uniform rotation have the mean 0 and the mean square 1/3: within three standard
//  errors of 400 bodies
TEST(SolidClumps, randomIsUniform)
{
    for (const bool planar : {false, true})
    {
        ClumpCase c(planar ? SolidRegionCase::flat() : BoxMesh());
        std::string text(planar ? outline : source);
        text += "spheres 1; resolution 4; orientation random; centres (";
        for (int i = 0; i < 400; ++i) text += "(0.5 0.5 0.5)";
        const auto r = c.one(text + ");");
        tensor mean(Zero), square(Zero);
        for (const auto& b : r.clumps)
        {
            const tensor R(turnOf(b));
            mean += R/400;
            square += cmptMultiply(R, R)/400;
        }
        if (planar)
        {
            EXPECT_NEAR(mean.yy(), 1, 1e-12);
            for (const double m : {mean.xx(), mean.zz(), mean.xz()}) EXPECT_NEAR(m, 0, 0.11);
            EXPECT_NEAR(square.xz(), 0.5, 0.08);
            continue;
        }
        for (direction d = 0; d < 9; ++d)
        {
            EXPECT_NEAR(mean[d], 0, 0.09);
            EXPECT_NEAR(square[d], 1.0/3, 0.05);
        }
    }
}

TEST(SolidClumps, outlinesIn2D)
{
    ClumpCase c(SolidRegionCase::flat());
    const auto r = c.one(outline + "centres ((0.5 0 0.5) (0.5 9 0.8)); orientation turned; angle "
                                   "-90;");
    ASSERT_EQ(r.clumps.size(), 2);
    const auto& b = r.clumps[0];
    EXPECT_NEAR(b.mass, 2000*0.03, 1e-10);
    EXPECT_NEAR(b.volume, 0.03, 1e-14);
    EXPECT_NEAR(b.inertia[2], 2000*0.03*(0.09 + 0.01)/12, 1e-10);
    EXPECT_EQ(centreOf(r.clumps[1]), point(0.5, 0.5, 0.8));
    // upright: 0.1 along x and 0.3 along z
    const boundBox reach(r.position, false);
    EXPECT_NEAR(max(r.radius), 0.05 - 0.0075/2, 1e-9);
    forAll(r.position, i)
    {
        const vector x(cmptMag(r.position[i] - centreOf(r.clumps[r.clump[i]])));
        EXPECT_NEAR(std::min(0.05 - x.x(), 0.15 - x.z()), r.radius[i], 1e-9);
        EXPECT_EQ(r.position[i].y(), 0.5);
    }
    EXPECT_GT(reach.span().z(), 0.3);
    // about the empty direction, y: of -90 degrees x goes to z
    EXPECT_LT(mag((turnOf(b) & vector(1, 0, 0)) - vector(0, 0, 1)), 1e-12);
    EXPECT_EQ(r.shape.toc(), wordList({"outline"}));
}

TEST(SolidClumps, whatIsRefused)
{
    ClumpCase c;
    EXPECT_EQ(c.said(outline), "Source clumpsFromOutline needs a case in 2D; in 3D it is "
                               "clumpsFromSurface");
    EXPECT_EQ(c.said(source + "resolution 12; centres ();"), "Entry centres is empty");
    EXPECT_EQ(c.said(source + "resolution 12; smallestRadius 0.06;"),
        "No sphere of at least smallestRadius 0.06 m fits into the surface");
    EXPECT_EQ(c.said(source + "resolution 12; orientation turned; angle 3; axis (0 0 0);"),
        "Entry axis is (0 0 0): it needs a length");
    EXPECT_EQ(c.said(source + "resolution 12; orientation turnd;"),
        "Entry orientation has the unknown word turnd; valid are (given turned random); did you "
        "mean turned?");
    EXPECT_TRUE(holds(c.said(source + "resolution 12; orientation turned; axis (0 0 1);"),
        "Entry 'angle' not found in dictionary"));
    EXPECT_TRUE(holds(
        c.said(source + "resolution 12; seed 2;"), "Unknown entry seed; valid are (set clip "));
    EXPECT_EQ(c.said(source + "resolution 3;"),
        "Entry resolution is 3: it must be from 4 to 400");
    EXPECT_EQ(c.said(source + "spheres 0;"),
        "Entry spheres is 0: it must be from 1 to 10000");
    ClumpCase flat(SolidRegionCase::flat());
    EXPECT_EQ(flat.said(source), "Source clumpsFromSurface needs a case in 3D; in 2D it is "
                                 "clumpsFromOutline");
    EXPECT_EQ(flat.said(outline + "smallestRadius 0.06;"),
        "No sphere of at least smallestRadius 0.06 m fits into the outline");
    EXPECT_TRUE(holds(flat.said(outline + "orientation turned; angle 3; axis (0 1 0);"),
        "Unknown entry axis"));
}
