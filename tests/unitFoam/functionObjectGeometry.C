// SPDX-License-Identifier: GPL-3.0-or-later
/*  The pure parts of the function objects: level crossings, the fluid's front, wall coverage, sensors. */

#include "riprapFoam/functionObjects/fluidFront.hpp"
#include "riprapFoam/functionObjects/gaugeLine.H"
#include "riprapFoam/functionObjects/levelCrossing.hpp"
#include "riprapFoam/functionObjects/sensorDisc.H"
#include "riprapFoam/functionObjects/wallCoverage.hpp"

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
    const auto jet = [](double s) { return ramp(s, 0.8, 0.05, 1) - ramp(s, 0.6, 0.05, 1) + ramp(s, 0.2, 0.05, 1); };
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

TEST(FluidFront, ignoresSprayAndKeepsToTheFloor)
{
    // A block of 20 x 10 spacings, a pair ahead of it and a single one further on
    std::vector<double> x;
    for (int i = 0; i < 20; ++i) for (int j = 0; j < 10; ++j) x.insert(x.end(), {i + 0.5, j + 0.5, 0});
    x.insert(x.end(), {30, 3, 0, 31, 3, 0, 50, 8, 0});
    // A tongue on top
    for (int i = 20; i < 24; ++i) for (int j = 8; j < 10; ++j) x.insert(x.end(), {i + 0.5, j + 0.5, 0});

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

namespace
{
    //- Lattice of wall particles that fill y < 0 (and x < 0 with corner), from -n to n spacings
    std::vector<double> lattice(double spacing, int n, bool corner, int D)
    {
        std::vector<double> x;
        for (int i = -n; i < n; ++i) for (int j = -n; j < n; ++j) for (int k = D == 2 ? 0 : -n; k < (D == 2 ? 1 : n); ++k)
        {
            if (j < 0 || (corner && i < 0))
                x.insert(x.end(), {(i + 0.5)*spacing, (j + 0.5)*spacing, D == 2 ? 0 : (k + 0.5)*spacing});
        }
        return x;
    }

    SphConfig coverageConfig(KernelKind kernel, int D)
    {
        SphConfig config;
        config.dimensions = D;
        config.kernel = kernel;
        config.spacing = 0.01;
        config.wallSpacing = 0.005;
        return config;
    }
}

TEST(WallCoverage, halfOnAPlaneQuarterInACornerNothingFarAway)
{
    for (const KernelKind kernel : {KernelKind::wendlandC2, KernelKind::cubicSpline})
    {
        for (const int D : {2, 3})
        {
            const SphConfig config(coverageConfig(kernel, D));
            const WallCoverage plane(config, lattice(config.wallSpacing, 8, false, D));
            const WallCoverage corner(config, lattice(config.wallSpacing, 8, true, D));
            const Vector3 origin{{0, 0, 0}};
            // Midpoint sums over lattice planes that straddle the point symmetrically; the kernel's own lattice error is 1e-3
            EXPECT_NEAR(plane.at(origin).share, 0.5, 2e-3);
            EXPECT_NEAR(corner.at(origin).share, 0.25, 2e-3);
            EXPECT_EQ(plane.at({{0, 0.1, 0}}).share, 1);
            EXPECT_EQ(plane.at({{0, 0.1, 0}}).offset[1], 0);
        }
    }
}

TEST(WallCoverage, centroidOfTheHalfSupport)
{
    // Wendland C2 in 2D: 2 int r^2 W dr/(1/2) = 8 alpha h (4 B(4,5) + B(3,5)) 2 = 0.42441 h
    const SphConfig config(coverageConfig(KernelKind::wendlandC2, 2));
    const WallCoverage plane(config, lattice(config.wallSpacing, 8, false, 2));
    const Coverage c(plane.at({{0, 0, 7}}));        // the empty direction does not matter
    const double h = config.smoothingRatio*config.spacing;
    EXPECT_NEAR(c.offset[1], 0.42441*h, 0.013*h);   // midpoint rule at h/2.5: 3 %
    EXPECT_NEAR(c.offset[0], 0, 1e-9*h);
}

TEST(WallCoverage, wrapsPeriodicDirections)
{
    SphConfig config(coverageConfig(KernelKind::wendlandC2, 2));
    config.periodic[0] = true;
    config.domainMin = {{0, -1, 0}};
    config.domainMax = {{0.1, 1, 0}};
    std::vector<double> x;
    for (int i = 0; i < 20; ++i) for (int j = -6; j < 0; ++j)
        x.insert(x.end(), {(i + 0.5)*0.005, (j + 0.5)*0.005, 0});
    const WallCoverage walls(config, x);
    EXPECT_NEAR(walls.at({{0, 0, 0}}).share, walls.at({{0.05, 0, 0}}).share, 1e-12);
    EXPECT_NEAR(walls.at({{0, 0, 0}}).offset[0], 0, 1e-12);
}

TEST(SensorDisc, averagesAsADiscDoes)
{
    const double R = 0.3;
    for (const bool flat : {false, true})
    {
        const Foam::sensorDisc disc
        (
            Foam::makeSensorDisc({1, 2, 3}, {-1, 0, 0}, Foam::vector(0, 0, flat), R)
        );
        double one = 0, y = 0, yy = 0;
        for (Foam::label i = 0; i < disc.points.size(); ++i)
        {
            const double d = disc.points[i].y() - 2;
            EXPECT_NEAR(disc.points[i].x(), 1, 1e-14);
            if (flat) { EXPECT_NEAR(disc.points[i].z(), 3, 1e-14); }
            one += disc.weights[i];
            y += disc.weights[i]*d;
            yy += disc.weights[i]*d*d;
        }
        EXPECT_NEAR(one, 1, 1e-14);
        EXPECT_NEAR(y, 0, 1e-14);
        // Second moment of a disc's area about a diameter; 3D: less 1/37^2 of it
        EXPECT_NEAR(yy, R*R/4*(flat ? 1 : 1 - 1.0/1369), 1e-14);
    }
}

TEST(GaugeLine, fromFootToTheBounds)
{
    const Foam::boundBox bounds(Foam::point(0, 0, 0), Foam::point(2, 1, 0.1));
    EXPECT_NEAR(Foam::gaugeLength(bounds, {0.5, 0.25, 0}, {0, 1, 0}), 0.75, 1e-15);
    EXPECT_NEAR(Foam::gaugeLength(bounds, {0.5, 0.25, 0}, {-1, 0, 0}), 0.5, 1e-15);
    EXPECT_LT(Foam::gaugeLength(bounds, {0.5, 1.25, 0}, {0, 1, 0}), 0);

    const Foam::gaugeLine line(Foam::makeGaugeLine(bounds, {0.5, 0, 0}, {0, 1, 0}, 0.1));
    EXPECT_EQ(line.points.size(), 41);
    EXPECT_EQ(line.points.last(), Foam::point(0.5, 1, 0));
    EXPECT_EQ(line.height.back(), 1);
}
