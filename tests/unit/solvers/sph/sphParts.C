/*  Parts of the solver of fluid by themselves (solvers/sph/parts): cells and skin, particles,
    points of walls, poses and faces.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cmath>
#include <gtest/gtest.h>
#include "solvers/sph/parts/sphParts.hpp"

namespace riprap
{
namespace
{

SphConfig still()
{
    SphConfig c;
    c.dimensions = 2;
    c.spacing = c.wallSpacing = 0.02;
    return c;
}

FluidInput threeParticles()
{
    FluidInput in;
    in.position = {0.1, 0.2, 0, 0.3, 0.4, 0, 0.5, 0.6, 0};
    in.velocity = {1, 2, 0, 3, 4, 0, 5, 6, 0};
    in.density = {1000, 1010, 990};
    in.id = {7, 3, 5};
    return in;
}

TEST(SphSetting, SkinsFollowTheCaseAndShortPeriods)
{
    SphConfig c = still();
    c.skin = 0.2;
    const double support = supportOf(c);
    SphSetting<Cpu, 2, Double> set(c, 3);
    EXPECT_NEAR(set.grid.radius, 1.2*support, 1e-15);
    // both of a pair may go half of it
    EXPECT_NEAR(set.allowedWay, 0.1*support, 1e-3*0.1*support);
    EXPECT_LT(set.allowedWay, 0.1*support);
    EXPECT_DOUBLE_EQ(set.emptyCoordinate, 0.5);
    EXPECT_NEAR(set.pairReach(float(set.model.hMax)), set.grid.radius, 1e-8);
    // the largest are a fifth larger
    EXPECT_NEAR(set.pairReach(float(set.model.h0)), support, 1e-8);
    // a third of a period holds the support and a thinner skin
    c.periodic[0] = true;
    c.domainMax[0] = 3*1.1*support;
    SphSetting<Cpu, 2, Double> tight(c, 3);
    EXPECT_NEAR(tight.grid.radius, 1.1*support, 1e-8*support);
    c.domainMax[0] = 3*1.04*support;
    EXPECT_THROW((SphSetting<Cpu, 2, Double>(c, 3)), std::invalid_argument);
}

TEST(SphSetting, AnotherSpeedOfSoundChangesModelAndLimits)
{
    SphSetting<Cpu, 2, Double> set(still(), 3);
    const double before = set.model.eos.pressure(0.01);
    set.setMaxVelocity(2, 20);
    EXPECT_DOUBLE_EQ(set.config.maxVelocity, 2);
    EXPECT_NEAR(set.model.eos.pressure(0.01), 4*before, 1e-9*before);
    EXPECT_DOUBLE_EQ(set.limits.maxSpeed, 2*set.config.maxSpeedRatio);
}

TEST(SphParticles, AreWhatTheyWereGivenInAnyCapacity)
{
    SphSetting<Cpu, 2, Double> set(still(), 3);
    SphParticles<Cpu, 2, Double> fluid(set, 3);
    fluid.set(threeParticles());
    fluid.setCapacity(10, 3);
    EXPECT_EQ(fluid.n, 10);
    FluidFields<2, Double> f = fluid.fields();
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(set.box.toMetres(0, f.x[0][i]), 0.1 + 0.2*i, 1e-12);
        EXPECT_NEAR(set.box.toMetres(1, f.x[1][i]), 0.2 + 0.2*i, 1e-12);
        EXPECT_EQ(f.v[1][i], 2 + 2*i);
    }
    EXPECT_NEAR(f.deviation[1], 0.01, 1e-15);
    EXPECT_EQ(f.id[0], 7);
    EXPECT_EQ(f.id[2], 5);
    // fewer slots keep those at the front
    fluid.setCapacity(2, 3);
    f = fluid.fields();
    EXPECT_EQ(f.id[1], 3);
    EXPECT_EQ(fluid.records.view().h, nullptr);
    EXPECT_EQ(f.drift[0], nullptr);
}

TEST(WallPoints, HaveVelocitiesOnlyWhereSomeMove)
{
    SphSetting<Cpu, 2, Double> set(still(), 3);
    WallInput in;
    in.position = {0, 0.1, 0, 0, 0.2, 0};
    WallPoints<Cpu, 2, Double> fixed(set), moving(set);
    fixed.set(in);
    EXPECT_EQ(fixed.velocity(1), nullptr);
    EXPECT_EQ(fixed.fields().body, nullptr);
    EXPECT_EQ(fixed.bodyOf, (std::vector<std::int32_t>{-1, -1}));
    in.body = {-1, 0};
    in.nBodies = 1;
    moving.set(in);
    EXPECT_NE(moving.velocity(1), nullptr);
    EXPECT_EQ(moving.fields().body[1], 0);
    EXPECT_EQ(moving.rest.download(), in.position);
    EXPECT_NEAR(set.box.toMetres(1, moving.fields().x[1][1]), 0.2, 1e-12);
}

TEST(WallPoses, AreAskedForWithinTheCallAndInterpolated)
{
    double earliest = 1e300, latest = -1e300;
    Context<Cpu> context;
    WallPoses<Cpu> poses(context, [&](int body, double t)
    {
        earliest = std::min(earliest, t);
        latest = std::max(latest, t);
        WallPose p;
        p.translation = Vector3{{0, body*std::sin(t), t*t}};
        return p;
    });
    poses.allocate(2);
    poses.set(1, 1.5);
    EXPECT_EQ(earliest, 1);
    EXPECT_EQ(latest, 1.5);
    for (const double t : {1.0, 1.123, 1.499})
    {
        double x, v, a;
        poses.table().evaluate(1, 10, t, x, v, a);
        EXPECT_NEAR(x, std::sin(t), 1e-9);
        EXPECT_NEAR(v, std::cos(t), 1e-5);
        EXPECT_NEAR(a, -std::sin(t), 2e-3);
        poses.table().evaluate(0, 11, t, x, v, a);
        EXPECT_NEAR(x, t*t, 1e-12);
        EXPECT_NEAR(a, 2, 1e-6);
    }
    // calls shorter than a millisecond have a table of one
    poses.set(2, 2);
    EXPECT_DOUBLE_EQ(poses.table().step*poses.table().intervals, 1e-3);
}

TEST(FaceArrays, WithoutFacesNothingIsTouched)
{
    SphSetting<Cpu, 2, Double> set(still(), 3);
    CoupledSolids<Cpu, 2, Double> solids(set);
    FaceArrays<Cpu, 2, Double> faces(set);
    WallFaceInput in;
    faces.set(in, SolidPart(), 0);
    EXPECT_FALSE(faces.any());
    EXPECT_EQ(faces.contact(solids).faces.groups, 0);
    in.point = {0, 0, 0, 0, 1, 0};
    in.vertex = {0, 1, 0};
    in.normal = {2, 0, 0};
    in.body = {-1};
    in.part = {0};
    in.halfThickness = {0};
    faces.set(in, SolidPart(), 1);
    EXPECT_TRUE(faces.any());
    EXPECT_EQ(faces.bodies(), 0);
    // those that stand still, and one that moves
    EXPECT_EQ(faces.contact(solids).faces.groups, 2);
    EXPECT_GT(faces.contact(solids).clearance, 0);
}

TEST(SphClock, EndsAtTheTargetTheLastStepAndAGuard)
{
    Context<Cpu> context;
    SphClock<Cpu> clock(context);
    clock.now = ClockData();
    clock.now.target = 1;
    clock.now.lastStep = 10;
    EXPECT_FALSE(clock.over());
    clock.write();
    clock.data()->time = 1;
    EXPECT_FALSE(clock.over());     // the host has not looked yet
    clock.read();
    EXPECT_TRUE(clock.over());
    clock.now.time = 0;
    clock.now.step = 10;
    EXPECT_TRUE(clock.over());
    clock.now.step = 0;
    clock.now.halt = Halt::density;
    EXPECT_TRUE(clock.over());
    EXPECT_STREQ(wordOf(Limit::acoustic), "acoustic");
    EXPECT_STREQ(wordOf(Limit::growth), "growth");
}

} // namespace
} // namespace riprap
