// SPDX-License-Identifier: GPL-3.0-or-later
/*  Level crossings along a line, and the front of a fluid. */

#include "riprapFoam/functionObjects/fluid/fluidFront.hpp"
#include "riprapFoam/functionObjects/fluid/levelCrossing.hpp"

#include <functional>
#include <gtest/gtest.h>

using namespace riprap;

namespace
{
    //- Fraction that falls linearly from inside to 0 within width about the surface
    double ramp(double s, double surface, double width, double inside)
    {
        return inside*std::min(1.0, std::max(0.0, 0.5 - (s - surface)/width));
    }

    struct Profile { std::vector<double> s, f; };

    Profile profile(double length, int n, const std::function<double(double)>& f)
    {
        Profile p;
        for (int i = 0; i <= n; ++i)
        {
            p.s.push_back(i*length/n);
            p.f.push_back(f(p.s.back()));
        }
        return p;
    }
}

TEST(FluidLevel, isExactForALinearFallAndWhateverTheInsideValue)
{
    // 1 in the open, about 1/2 along a wall, less with a gap
    for (const double inside : {1.0, 0.5, 0.2})
    {
        const Profile p(profile(1, 97, [=](double s) { return ramp(s, 0.3217, 0.05, inside); }));
        const FluidLevel level(fluidLevel(p.s, p.f));
        EXPECT_TRUE(level.wet);
        EXPECT_NEAR(level.reference, inside, 1e-12);
        EXPECT_NEAR(level.top, 0.3217, 1e-12);
        EXPECT_NEAR(level.lowest, 0.3217, 1e-12);
    }
}

TEST(FluidLevel, seesAJetFromAboveAndTheWaterBelowIt)
{
    const auto jet = [](double s)
    { return ramp(s, 0.8, 0.05, 1) - ramp(s, 0.6, 0.05, 1) + ramp(s, 0.2, 0.05, 1); };
    const Profile p(profile(1, 200, jet));
    const FluidLevel level(fluidLevel(p.s, p.f));
    EXPECT_NEAR(level.top, 0.8, 1e-12);
    EXPECT_NEAR(level.lowest, 0.2, 1e-12);
}

TEST(FluidLevel, dryAndFullLines)
{
    const Profile dry(profile(1, 10, [](double) { return 0.01; }));
    EXPECT_FALSE(fluidLevel(dry.s, dry.f).wet);
    EXPECT_EQ(fluidLevel(dry.s, dry.f).top, 0);

    const Profile full(profile(1, 10, [](double) { return 1; }));
    EXPECT_EQ(fluidLevel(full.s, full.f).top, 1);
}

TEST(FluidLevel, dropsAndThinSheetsAreNotTheSurface)
{
    // Water to 0.40, a drop of 0.02 at 0.98, a sheet of 0.02 at 0.7; each falls to half within
    // 0.005
    const auto layer = [](double s, double from, double to)
    { return ramp(s, to, 0.01, 1) - ramp(s, from, 0.01, 1); };
    const auto drop = [&](double s) { return layer(s, 0.97, 0.99); };
    const auto sheet = [&](double s) { return layer(s, 0.69, 0.71); };
    const auto bed = [&](double s) { return ramp(s, 0.4, 0.01, 1); };

    const Profile dropAbove(
        profile(1.2, 1200, [&](double s) { return bed(s) + drop(s) + sheet(s); }));
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f).top, 0.99, 1e-12) << "without a rule";
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f, 0.03).top, 0.4, 1e-12);
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f, 0.03).lowest, 0.4, 1e-12);
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f, 0.019).top, 0.99, 1e-12)
        << "thinner than the drop";

    // On a dry bed: drops are no water, but the first that the line meets is told
    const Profile dry(profile(1.2, 1200, [&](double s) { return sheet(s) + drop(s); }));
    EXPECT_EQ(fluidLevel(dry.s, dry.f, 0.03).top, 0);
    // The median of thin layers lies on their slopes, 0.01 wide
    EXPECT_NEAR(fluidLevel(dry.s, dry.f, 0.03).lowest, 0.71, 0.0025);
    EXPECT_TRUE(fluidLevel(dry.s, dry.f, 0.03).wet);
}

TEST(FluidLevel, layersAndFilms)
{
    const auto layer = [](double s, double from, double to)
    { return ramp(s, to, 0.01, 1) - ramp(s, from, 0.01, 1); };

    // A jet thicker than the least above a pool: seen from above, with a drop over both
    const Profile jet(profile(1, 1000,
        [&](double s)
        { return ramp(s, 0.2, 0.01, 1) + layer(s, 0.6, 0.65) + layer(s, 0.8, 0.82); }));
    EXPECT_NEAR(fluidLevel(jet.s, jet.f, 0.03).top, 0.65, 1e-12);
    EXPECT_NEAR(fluidLevel(jet.s, jet.f, 0.03).lowest, 0.2, 1e-12);

    // A film on the bed is water however thin; along its foot a wall halves f, so that it begins a
    // little above
    const Profile film(
        profile(1, 1000, [&](double s) { return layer(s, 0.005, 0.02) + layer(s, 0.5, 0.51); }));
    EXPECT_NEAR(fluidLevel(film.s, film.f, 0.03).top, 0.02, 0.0025);

    // So is one on a solid that the line passes through, from 0.3 to 0.495; the drop above is none
    const Profile crest(
        profile(1, 1000, [&](double s) { return layer(s, 0.5, 0.515) + layer(s, 0.8, 0.81); }));
    std::vector<bool> solid(crest.s.size());
    for (std::size_t i = 0; i < solid.size(); ++i)
        solid[i] = crest.s[i] > 0.3 && crest.s[i] < 0.495;
    EXPECT_EQ(fluidLevel(crest.s, crest.f, 0.03).top, 0);
    EXPECT_NEAR(fluidLevel(crest.s, crest.f, 0.03, solid).top, 0.515, 0.0025);

    // Up to the end of the line, where the gauge ends under water
    const Profile roof(profile(1, 1000, [&](double s) { return layer(s, 0.98, 2); }));
    EXPECT_EQ(fluidLevel(roof.s, roof.f, 0.03).top, 0);
    EXPECT_EQ(fluidLevel(roof.s, roof.f, 0.019).top, 1);
}

TEST(FluidFront, ignoresSprayAndKeepsToTheFloor)
{
    // A block of 20 x 10 spacings, a pair ahead of it and a single one further on
    std::vector<double> x;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 10; ++j) x.insert(x.end(), {i + 0.5, j + 0.5, 0});
    x.insert(x.end(), {30, 3, 0, 31, 3, 0, 50, 8, 0});
    // A tongue on top
    for (int i = 20; i < 24; ++i)
        for (int j = 8; j < 10; ++j) x.insert(x.end(), {i + 0.5, j + 0.5, 0});

    FrontRule rule;
    rule.support = 2.5;
    EXPECT_EQ(fluidFront(x, rule), 50);
    rule.minNeighbours = 1;
    EXPECT_EQ(fluidFront(x, rule), 31);
    rule.minNeighbours = 3;
    EXPECT_EQ(fluidFront(x, rule), 23.5);
    rule.maxHeight = 4;
    EXPECT_EQ(fluidFront(x, rule), 19.5);
    rule.origin = {{20, 0, 0}};
    rule.direction = {{-1, 0, 0}};
    EXPECT_EQ(fluidFront(x, rule), 19.5);
}

TEST(FluidFront, noneWhenNothingCounts)
{
    FrontRule rule;
    rule.support = 1;
    EXPECT_TRUE(std::isinf(fluidFront({}, rule)));
    rule.minNeighbours = 2;
    EXPECT_TRUE(std::isinf(fluidFront({0, 0, 0, 100, 0, 0}, rule)));
    EXPECT_TRUE(std::isinf(fluidFront({std::nan(""), 0, 0}, rule)));
}
