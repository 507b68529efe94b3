// SPDX-License-Identifier: GPL-3.0-or-later
/*  The pure parts of the function objects: level crossings, the fluid's front, wall coverage and
    sight, sensors, means over time, rigid motion from particles. */

#include "riprapFoam/functionObjects/fluid/fluidFront.hpp"
#include "riprapFoam/functionObjects/fluid/gaugeLine.H"
#include "riprapFoam/functionObjects/fluid/levelCrossing.hpp"
#include "riprapFoam/functionObjects/solids/rigidFit.hpp"
#include "riprapFoam/functionObjects/base/runningMean.hpp"
#include "riprapFoam/functionObjects/probes/sensorDisc.H"
#include "riprapFoam/functionObjects/fluid/wallCoverage.hpp"

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

TEST(RunningMean, exactForStraightLinesAtAnySteps)
{
    RunningMean mean(0.3);
    double t = 0;
    for (int k = 0; k < 60; ++k)
    {
        mean.add(t, {2 + 5*t, 7});
        // Of 2 + 5 t over the last 0.3 s, or since the start
        EXPECT_NEAR(mean.mean()[0], 2 + 5*(t - 0.5*std::min(t, 0.3)), 1e-12) << "at " << t;
        EXPECT_NEAR(mean.mean()[1], 7, 1e-12);
        t += k % 3 ? 0.013 : 0.11;
    }
}

TEST(RunningMean, followsAStepHalfItsWidthLate)
{
    // 0 until t = 1, then 1, by steps of 1/128: half way up at 1 + T/2, and the integral is kept
    RunningMean mean(0.5);
    double integral = 0;
    for (int k = 0; k <= 256; ++k)
    {
        const double t = k/128.0;
        mean.add(t, {t < 1 ? 0.0 : 1.0});
        if (k == 160) { EXPECT_NEAR(mean.mean()[0], 0.5, 0.5/64); }
        if (k == 128) { EXPECT_LT(mean.mean()[0], 0.01); }
        if (k >= 192) { EXPECT_NEAR(mean.mean()[0], 1, 1e-12); }
        integral += mean.mean()[0]/128;
    }
    EXPECT_NEAR(integral, 2 - 1.25, 0.01);
}

TEST(RunningMean, tellsHowManyIntervalsItHolds)
{
    RunningMean mean(0.5);
    for (int k = 0; k <= 8; ++k)
    {
        mean.add(0.125*k, {1});
        EXPECT_EQ(mean.intervals(), k < 4 ? 0 : 4);
    }
}

TEST(RunningMean, goesOnOverARestart)
{
    RunningMean whole(0.2), before(0.2), after(0.2);
    const auto v = [](int k) { return std::vector<double>{std::sin(0.3*k), 0.01*k*k, 1}; };
    const auto at = [](int k) { return 0.02*k + 0.005*(k % 2); };
    for (int k = 0; k <= 20; ++k)
    {
        whole.add(at(k), v(k));
        before.add(at(k), v(k));
    }
    after.restore(before.state(), 3);
    after.add(at(20), v(20));           // the first row of a continued run repeats the time
    for (int k = 21; k < 40; ++k)
    {
        whole.add(at(k), v(k));
        after.add(at(k), v(k));
        EXPECT_EQ(whole.mean(), after.mean());
    }
    after.restore({1, 2, 3}, 4);        // of another number of probes
    after.add(5, {1, 2, 3, 4});
    EXPECT_EQ(after.mean(), (std::vector<double>{1, 2, 3, 4}));
}

TEST(RigidFit, findsTheMotionBack)
{
    const std::vector<Vector3> from{{{1, 0, 0}}, {{0, 2, 0}}, {{-1, 0.5, 0.3}}, {{0.2, -0.3, -1}}};
    for (const double angle : {0.0, 0.4, 1.9, 3.1})
    {
        const double c = std::cos(0.5*angle), s = std::sin(0.5*angle);
        WallPose pose;
        pose.rotation = rotationOf({{c, s*0.48, -s*0.6, s*0.64}});
        pose.translation = {{0.3, -2, 7}};
        std::vector<Vector3> to;
        for (const Vector3& x : from) to.push_back(placed(pose, x));
        const WallPose found(rigidFit(from, to));
        for (int k = 0; k < 9; ++k) EXPECT_NEAR(found.rotation[k], pose.rotation[k], 1e-12);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.translation[k], pose.translation[k], 1e-12);
    }

    // 2D, in the plane of z and x: two points are enough
    for (const double angle : {0.4, -2.0})
    {
        WallPose pose;
        pose.rotation = rotationOf({{std::cos(0.5*angle), 0, std::sin(0.5*angle), 0}});
        pose.translation = {{1, 0, 2}};
        const std::vector<Vector3> pair{{{1, 0, 0}}, {{0, 0, 3}}};
        const WallPose found(rigidFit(pair, {placed(pose, pair[0]), placed(pose, pair[1])}, 1));
        for (int k = 0; k < 9; ++k) EXPECT_NEAR(found.rotation[k], pose.rotation[k], 1e-12);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.translation[k], pose.translation[k], 1e-12);
    }
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
