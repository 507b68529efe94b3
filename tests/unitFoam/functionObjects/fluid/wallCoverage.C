// SPDX-License-Identifier: GPL-3.0-or-later
/*  How much of a kernel's support walls cover, and what they hide. */

#include "riprapFoam/functionObjects/fluid/wallCoverage.hpp"

#include <gtest/gtest.h>

using namespace riprap;

namespace
{
    //- Lattice of wall particles that fill y < 0 (and x < 0 with corner), from -n to n spacings
    std::vector<double> lattice(double spacing, int n, bool corner, int D)
    {
        std::vector<double> x;
        for (int i = -n; i < n; ++i)
            for (int j = -n; j < n; ++j)
                for (int k = D == 2 ? 0 : -n; k < (D == 2 ? 1 : n); ++k)
                {
                    if (j < 0 || (corner && i < 0))
                        x.insert(x.end(),
                            {(i + 0.5)*spacing, (j + 0.5)*spacing,
                                D == 2 ? 0 : (k + 0.5)*spacing});
                }
        return x;
    }

    SphConfig coverageConfig(const std::string& kernel, int D)
    {
        SphConfig config;
        config.dimensions = D;
        config.kernel = kernel;
        config.spacing = 0.01;
        config.wallSpacing = 0.005;
        return config;
    }
}

namespace
{
    //- Coverage from the points (3 n) of one set, seen at a point; with planes if asked
    struct Seen { Coverage coverage; std::vector<SightPlane> planes; };

    Seen seen(const SphConfig& config, const WallPointSet& set, const Vector3& x,
        bool sight = false, const WallPose& pose = {})
    {
        const WallCoverage kernel(config);
        Seen s;
        std::vector<WallNeighbour> near;
        set.near(x, pose, near);
        if (sight) addWallPlanes(near, config.wallSpacing, s.planes);
        s.coverage = kernel.of(near, s.planes);
        return s;
    }

    WallPointSet pointSet(
        const SphConfig& config, const std::vector<double>& x, const Vector3& normal = {{0, 1, 0}})
    {
        WallPointSet set(supportOf(config) + config.wallSpacing);
        for (std::size_t i = 0; i < x.size(); i += 3)
            set.insert({{x[i], x[i + 1], x[i + 2]}}, normal);
        return set;
    }
}

TEST(WallCoverage, halfOnAPlaneQuarterInACornerNothingFarAway)
{
    for (const std::string& kernel : kernelWords())
    {
        for (const int D : {2, 3})
        {
            const SphConfig config(coverageConfig(kernel, D));
            const WallPointSet plane(pointSet(config, lattice(config.wallSpacing, 8, false, D)));
            const WallPointSet corner(pointSet(config, lattice(config.wallSpacing, 8, true, D)));
            const Vector3 origin{{0, 0, 0}};
            // Midpoint sums over lattice planes that straddle the point symmetrically; the kernel's
            // own lattice error is 1e-3
            EXPECT_NEAR(seen(config, plane, origin).coverage.share, 0.5, 2e-3);
            EXPECT_NEAR(seen(config, corner, origin).coverage.share, 0.25, 2e-3);
            EXPECT_EQ(seen(config, plane, {{0, 0.1, 0}}).coverage.share, 1);
            EXPECT_EQ(seen(config, plane, {{0, 0.1, 0}}).coverage.offset[1], 0);
            EXPECT_FALSE(plane.mayReach({{0, 0.1, 0}}));
        }
    }
}

TEST(WallCoverage, centroidOfTheHalfSupport)
{
    // Wendland C2 in 2D: 2 int r^2 W dr/(1/2) = 8 alpha h (4 B(4,5) + B(3,5)) 2 = 0.42441 h
    const SphConfig config(coverageConfig("wendlandC2", 2));
    const double h = config.smoothingRatio*config.spacing;
    const Coverage c(seen(config, pointSet(config, lattice(config.wallSpacing, 8, false, 2)),
        {{0, 0, 0}}).coverage);
    EXPECT_NEAR(c.offset[1], 0.42441*h, 0.013*h);   // midpoint rule at h/2.5: 3 %
    EXPECT_NEAR(c.offset[0], 0, 1e-9*h);

    // What a plane hides without any wall point behind it, integrated: the same, without the
    // lattice's error
    const Coverage hidden(WallCoverage(config).of({}, {{{{0, 1, 0}}, 0}}));
    EXPECT_NEAR(hidden.share, 0.5, 1e-5);         // 512 shells
    EXPECT_NEAR(hidden.offset[1], 0.42441*h, 1e-4*h);

    // 3D: pi int r^3 W dr/(1/2) = 42 (4 B(5,5) + B(4,5)) h = 5/12 h
    const SphConfig solid(coverageConfig("wendlandC2", 3));
    const Coverage half(WallCoverage(solid).of({}, {{{{0, 0, 1}}, 0}}));
    EXPECT_NEAR(half.share, 0.5, 1e-3);
    EXPECT_NEAR(half.offset[2], 5*h/12, 1e-3*h);
}

TEST(WallCoverage, ofAGroupThatHasMovedAsIfItsPointsHad)
{
    const SphConfig config(coverageConfig("wendlandC2", 2));
    const WallPointSet rest(pointSet(config, lattice(config.wallSpacing, 8, true, 2)));
    const double angle = 0.7;
    WallPose pose;
    pose.rotation = {
        {std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1}};
    pose.translation = {{0.3, -0.2, 0}};

    WallPointSet moved(supportOf(config) + config.wallSpacing);
    const std::vector<double> x(lattice(config.wallSpacing, 8, true, 2));
    for (std::size_t i = 0; i < x.size(); i += 3)
        moved.insert(placed(pose, {{x[i], x[i + 1], 0}}), turned(pose, {{0, 1, 0}}));

    for (const Vector3& at :
        {Vector3{{0.001, 0.002, 0}}, Vector3{{0.01, 0, 0}}, Vector3{{0, 0.02, 0}}})
    {
        const Vector3 there = placed(pose, at);
        const Coverage a = seen(config, rest, there, false, pose).coverage,
                       b = seen(config, moved, there).coverage;
        EXPECT_NEAR(a.share, b.share, 1e-12);
        EXPECT_NEAR(a.offset[0], b.offset[0], 1e-14);
        EXPECT_NEAR(a.offset[1], b.offset[1], 1e-14);
        EXPECT_LT(a.share, 0.9);
    }
}

TEST(WallSight, aFloorAndAWallButNoThinPlatesOtherSide)
{
    const SphConfig config(coverageConfig("wendlandC2", 2));
    const double dp = config.wallSpacing;

    // Floor y < 0 and wall x < 0, a gauge on the wall a spacing above the floor
    WallPointSet corner(pointSet(config, lattice(dp, 8, false, 2)));
    for (int j = 0; j < 8; ++j)
        for (int i = 1; i < 6; ++i)
            corner.insert({{-(i - 0.5)*dp, (j + 0.5)*dp, 0}}, {{1, 0, 0}});
    const Seen onWall(seen(config, corner, {{0, dp, 0}}, true));
    EXPECT_TRUE(seenFrom(onWall.planes, {{0.3*dp, 0.3*dp, 0}}));
    EXPECT_FALSE(seenFrom(onWall.planes, {{-0.01*dp, 0, 0}})) << "in the wall";
    EXPECT_FALSE(seenFrom(onWall.planes, {{dp, -1.01*dp, 0}})) << "in the floor";
    EXPECT_TRUE(seenFrom(onWall.planes, {{dp, -0.99*dp, 0}})) << "just above it";

    // In the open there is nothing to hide behind
    EXPECT_TRUE(seen(config, corner, {{0.035, 0.039, 0}}, true).planes.empty());

    // A plate two points thick, x from -dp to dp: fluid beyond it counts for neither volume nor
    // pressure
    WallPointSet plate(2*config.smoothingRatio*config.spacing + dp);
    for (int j = -12; j < 12; ++j)
        for (const double side : {-1.0, 1.0})
            plate.insert({{0.5*side*dp, (j + 0.5)*dp, 0}}, {{side, 0, 0}});
    const Seen left(seen(config, plate, {{-dp, 0, 0}}, true)),
        right(seen(config, plate, {{dp, 0, 0}}, true));
    EXPECT_FALSE(seenFrom(left.planes, {{2.5*dp, 0, 0}}));
    EXPECT_TRUE(seenFrom(left.planes, {{-2.5*dp, 0, 0}}));
    EXPECT_FALSE(seenFrom(right.planes, {{-2.5*dp, 0, 0}}));
    EXPECT_NEAR(left.coverage.share, 0.5, 2e-3);
    EXPECT_NEAR(left.coverage.offset[0], -right.coverage.offset[0], 1e-9);
    EXPECT_LT(left.coverage.offset[0], 0);
    EXPECT_GT(seen(config, plate, {{-dp, 0, 0}}).coverage.share, 0.55)
        << "without planes the other side counts";

    // On the side of a box near its top edge (a convex one): water above the top is not hidden
    WallPointSet box(2*config.smoothingRatio*config.spacing + dp);
    for (int j = 1; j < 12; ++j) for (int i = 1; i < 12; ++i)
    {
        const bool top = j < i;
        box.insert({{(i - 0.5)*dp, -(j - 0.5)*dp, 0}}, {{top ? 0.0 : -1.0, top ? 1.0 : 0.0, 0}});
    }
    const Seen side(seen(config, box, {{0, -1.5*dp, 0}}, true));
    EXPECT_TRUE(seenFrom(side.planes, {{-0.5*dp, 3*dp, 0}}));
    EXPECT_FALSE(seenFrom(side.planes, {{dp, 0, 0}}));
}
