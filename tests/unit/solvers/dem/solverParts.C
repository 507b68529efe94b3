/*  Parts of the solver of solids by themselves (solvers/dem/parts): prescribed motions, and how far
    neighbours are sought.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/demTest.hpp"
#include "solvers/dem/parts/prescribedMotion.hpp"
#include "solvers/dem/parts/searchReach.hpp"

namespace riprap
{
namespace
{

DemConfig frictionless()
{
    DemConfig c;
    c.domainMin = Vector3{{-0.5, -0.5, -0.5}};
    c.domainMax = Vector3{{0.5, 0.5, 0.5}};
    c.normal = "linear";
    c.tangential = "none";
    return c;
}

DemClockData clock(double time, double target, double dt)
{
    DemClockData c;
    c.time = time;
    c.target = target;
    c.fullDt = dt;
    return c;
}

TEST(PrescribedMotion, IsAskedForUpToTheTargetAndGoesOnStraight)
{
    double earliest = 1e300, latest = -1e300;
    DemInput in = oneMaterial();
    in.groupMotion = [&](int, double t)
    {
        earliest = std::min(earliest, t);
        latest = std::max(latest, t);
        RigidMotion m{};
        m.velocity = Vector3{{2*t, 0, 0}};
        m.spin = Vector3{{0, 0, 3*t}};
        return m;
    };
    DemSetting<Cpu, 3, Double> set(frictionless(), in, DemPlan());
    PrescribedMotion<Cpu, 3, Double> motion(set);
    motion.holdGroups(1);
    DemClockData now = clock(1, 1.02, 0.01);
    motion.sample(now);
    EXPECT_EQ(earliest, 1);
    EXPECT_EQ(latest, 1.02);
    EXPECT_EQ(now.windowEnd, 1.02);
    const MotionTable table = motion.groupTable();
    for (const double t : {1.0, 1.013, 1.02, 1.3})
    {
        EXPECT_NEAR(table.at(0, 0, t), 2*t, 1e-9);
        EXPECT_NEAR(table.at(0, 5, t), 3*t, 1e-9);
        EXPECT_EQ(table.at(0, 1, t), 0);
    }
}

TEST(PrescribedMotion, WindowsOfLongCallsEndAfterTheirSteps)
{
    DemInput in = oneMaterial();
    in.wallMotion = [](int, double t)
    {
        WallPose p;
        p.translation = Vector3{{0, t, 0}};
        return p;
    };
    DemSetting<Cpu, 3, Double> set(frictionless(), in, DemPlan());
    PrescribedMotion<Cpu, 3, Double> motion(set);
    motion.holdWalls(1);
    DemClockData now = clock(0, 100, 0.5);
    motion.sample(now);
    EXPECT_EQ(now.windowEnd, 0.5*motion.windowSteps);
    EXPECT_NEAR(motion.wallTable().at(0, 10, 7.25), 7.25, 1e-12);
    EXPECT_NEAR(motion.wallTable().at(0, poseNumbers/2 + 10, 7.25), 1, 1e-9);      // its rate
}

TEST(SearchReach, SkinsFollowTheSmallestRadiusAndTheDomain)
{
    DemInput in = oneMaterial();
    in.particles.radius = {0.01, 0.02};
    DemConfig c = frictionless();
    DemSetting<Cpu, 2, Mixed> set(c, in, DemPlan());
    PairTable<Cpu, 2, Mixed> pairs(set);
    pairs.set(in.particles);
    SearchReach<Cpu, 2, Mixed> reach(set, pairs);
    reach.setBox(in.particles.radius);
    EXPECT_EQ(reach.skin, reach.leastSkin());
    EXPECT_DOUBLE_EQ(reach.skin, 0.15*2*0.01);
    EXPECT_DOUBLE_EQ(reach.mostSkin(false), 0.01);
    EXPECT_DOUBLE_EQ(reach.wallCell(), 0.02 + 0.003);
    reach.set(0.008);
    EXPECT_EQ(reach.state().skin, 0.008);
    EXPECT_EQ(reach.state().radii.largest, reach.radii.largest);
    // of a periodic domain: a third of it holds the largest pair and the skin, and walls that have
    // been repeated hold no more than the least one
    c.periodic[set.config.axes[0]] = true;
    DemSetting<Cpu, 2, Mixed> periodic(c, in, DemPlan());
    SearchReach<Cpu, 2, Mixed> again(periodic, pairs);
    again.setBox(in.particles.radius);
    EXPECT_EQ(again.mostSkin(true), again.leastSkin());
    EXPECT_THROW(again.setBox({0.01, 0.2}), std::invalid_argument);
}

} // namespace
} // namespace riprap
