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

TEST(FluidLevel, dropsAndThinSheetsAreNotTheSurface)
{
    // Water to 0.40, a drop of 0.02 at 0.98, a sheet of 0.02 at 0.7; each falls to half within 0.005
    const auto layer = [](double s, double from, double to) { return ramp(s, to, 0.01, 1) - ramp(s, from, 0.01, 1); };
    const auto drop = [&](double s) { return layer(s, 0.97, 0.99); };
    const auto sheet = [&](double s) { return layer(s, 0.69, 0.71); };
    const auto bed = [&](double s) { return ramp(s, 0.4, 0.01, 1); };

    const Profile dropAbove(profile(1.2, 1200, [&](double s) { return bed(s) + drop(s) + sheet(s); }));
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f).top, 0.99, 1e-12) << "without a rule";
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f, 0.03).top, 0.4, 1e-12);
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f, 0.03).lowest, 0.4, 1e-12);
    EXPECT_NEAR(fluidLevel(dropAbove.s, dropAbove.f, 0.019).top, 0.99, 1e-12) << "thinner than the drop";

    // On a dry bed: drops are no water, but the first that the line meets is told
    const Profile dry(profile(1.2, 1200, [&](double s) { return sheet(s) + drop(s); }));
    EXPECT_EQ(fluidLevel(dry.s, dry.f, 0.03).top, 0);
    // The median of thin layers lies on their slopes, 0.01 wide
    EXPECT_NEAR(fluidLevel(dry.s, dry.f, 0.03).lowest, 0.71, 0.0025);
    EXPECT_TRUE(fluidLevel(dry.s, dry.f, 0.03).wet);
}

TEST(FluidLevel, layersAndFilms)
{
    const auto layer = [](double s, double from, double to) { return ramp(s, to, 0.01, 1) - ramp(s, from, 0.01, 1); };

    // A jet thicker than the least above a pool: seen from above, with a drop over both
    const Profile jet(profile(1, 1000, [&](double s) { return ramp(s, 0.2, 0.01, 1) + layer(s, 0.6, 0.65) + layer(s, 0.8, 0.82); }));
    EXPECT_NEAR(fluidLevel(jet.s, jet.f, 0.03).top, 0.65, 1e-12);
    EXPECT_NEAR(fluidLevel(jet.s, jet.f, 0.03).lowest, 0.2, 1e-12);

    // A film on the bed is water however thin; along its foot a wall halves f, so that it begins a little above
    const Profile film(profile(1, 1000, [&](double s) { return layer(s, 0.005, 0.02) + layer(s, 0.5, 0.51); }));
    EXPECT_NEAR(fluidLevel(film.s, film.f, 0.03).top, 0.02, 0.0025);

    // Up to the end of the line, where the gauge ends under water
    const Profile roof(profile(1, 1000, [&](double s) { return layer(s, 0.98, 2); }));
    EXPECT_EQ(fluidLevel(roof.s, roof.f, 0.03).top, 0);
    EXPECT_EQ(fluidLevel(roof.s, roof.f, 0.019).top, 1);
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
