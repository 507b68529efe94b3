// SPDX-License-Identifier: GPL-3.0-or-later
/*  Bodies of several sizes: their numbers, and random places without overlap. */

#include "bodyGrading.H"
#include "boxMesh.hpp"
#include "particlePacking.H"
#include "randomPacking.H"
#include "scratchCase.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    bodyGrading grading(const std::string& text)
    {
        const dictionary dict(entries(text));
        checkedDictionary checked(dict);
        bodyGrading g(readGrading(checked));
        checked.end();
        return g;
    }

    particlePacking frame(int D)
    {
        BoxMesh box;
        if (D == 2) box.sides(1, "empty");
        const auto mesh = box.make(testTime());
        return particlePacking(mesh(), particlePacking::kind::square, 0.1, Zero);
    }
}

TEST(BodyGrading, sharesOfMassAndOfNumber)
{
    for (const bool planar : {true, false})
    {
        const double unit = ballVolume(1, planar), big = ballVolume(2, planar);
        const bodyGrading mass(grading("radii (1 2); shares (0.25 0.75);"));
        const labelList m(mass.counts(100*unit, planar));
        EXPECT_EQ(m[0], 25);
        EXPECT_EQ(m[1], std::lround(75*unit/big));
        const bodyGrading number(grading("radii (1 2); shares (0.8 0.2); sharesOf number;"));
        const double mean = 0.8*unit + 0.2*big;
        EXPECT_EQ(number.counts(50*mean, planar), labelList({40, 10}));
        const scalarField all(number.fill(50*mean, planar, dictionary()));
        EXPECT_EQ(all.size(), 50);
        EXPECT_EQ(all[39], 1);
        EXPECT_EQ(all[40], 2);
    }
    EXPECT_NEAR(ballVolume(2, true), 4*std::acos(-1.0), 1e-14);
    EXPECT_NEAR(ballVolume(2, false), 32*std::acos(-1.0)/3, 1e-13);
}

TEST(BodyGrading, whatIsRefused)
{
    EXPECT_EQ(messageOf([]() { grading("radii (1 2); shares (1);"); }),
        "Entry radii has 2 values and entry shares 1: each radius needs its share");
    EXPECT_EQ(messageOf([]() { grading("radii (1 2); shares (0.5 0.6);"); }),
        "Entry shares adds up to 1.1: shares are fractions of the mass that add up to 1");
    EXPECT_TRUE(holds(messageOf([]() { grading("radii (1 -2); shares (0.5 0.5);"); }),
        "Entry radii is -2: it must be "));
    const bodyGrading g(grading("radii (1 20); shares (0.5 0.5);"));
    EXPECT_EQ(messageOf([&]() { g.fill(100*ballVolume(1, false), false, dictionary()); }),
        "Entry radii: the share 0.5 of the radius 20 is less than half a body of 50: a larger "
        "region or share has some, or leave the radius out");
}

TEST(RandomPacking, radiiFillTheFraction)
{
    const randomPacking p{0.03, 0.06, 0.4, 7};
    for (const bool planar : {true, false})
    {
        const scalarField radii(p.radii(1, planar));
        double volume = 0, mean = 0;
        for (const double r : radii)
        {
            EXPECT_GE(r, 0.03);
            EXPECT_LE(r, 0.06);
            volume += ballVolume(r, planar);
            mean += r/radii.size();
        }
        EXPECT_NEAR(volume, 0.4, 0.5*ballVolume(0.06, planar));
        // evenly distributed: within three standard deviations
        EXPECT_NEAR(mean, 0.045, 3*0.03/std::sqrt(12.0*radii.size()));
        EXPECT_EQ(radii, p.radii(1, planar));
        EXPECT_NE(radii, (randomPacking{0.03, 0.06, 0.4, 8}.radii(1, planar)));
    }
}

TEST(RandomPacking, nothingOverlaps)
{
    for (const int D : {2, 3})
    {
        const randomPacking p{0.05, 0.08, D == 2 ? 0.55 : 0.3, 3};
        const boundBox box(point(0, 0, 0), point(1, 1, 1));
        const scalarField radii(p.radii(1, D == 2));
        const auto fits = [&](const point& x, scalar r)
        {
            bool in = true;
            for (const direction d : {0, 1, 2})
                if (D == 3 || d != 1) in = in && x[d] > r && x[d] < 1 - r;
            return in;
        };
        pointField x;
        ASSERT_TRUE(p.place(box, fits, frame(D), radii, x));
        ASSERT_EQ(x.size(), radii.size());
        forAll(x, i)
        {
            EXPECT_TRUE(fits(x[i], radii[i]));
            if (D == 2) { EXPECT_NEAR(x[i].y(), 0.5, 1e-14); }
            for (label j = 0; j < i; ++j)
                EXPECT_GT(mag(x[i] - x[j]), (1 - 1e-6)*(radii[i] + radii[j]));
        }
    }
}

//- Two bodies that need more room than there is
TEST(RandomPacking, tooFull)
{
    const randomPacking p{0.3, 0.3, 1, 3};
    const auto fits = [](const point& x, scalar r)
    { return x.x() > r && x.x() < 1 - r && x.z() > r && x.z() < 1 - r; };
    pointField x;
    const boundBox box(point(0, 0, 0), point(1, 1, 1));
    EXPECT_TRUE(p.place(box, fits, frame(2), scalarField(1, 0.3), x));
    EXPECT_FALSE(p.place(box, fits, frame(2), scalarField(3, 0.3), x));
    EXPECT_FALSE(p.place(box, fits, frame(2), scalarField(1, 0.6), x));
}
