// SPDX-License-Identifier: GPL-3.0-or-later
/*  Mass of solids in regions: particles by their material, bodies by their own. */

#include "runningSolids.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string halves("type regionMass; regions (low { source box; box (0 0 0) (1 1 0.5); } "
                             "high { source box; box (0 0 0.5) (1 1 1); });");
}

TEST(RegionMass, ofSolids)
{
    const double ball = 4*std::acos(-1.0)/3*1e-3;
    RunningSolids c(rock());
    c.add({0.2, 0.2, 0.3}, 0.1);
    c.add({0.5, 0.5, 0.49}, 0.1);
    c.add({0.8, 0.8, 0.8}, 0.05);
    c.start();
    c.function(halves);
    const FunctionTable t(c.table("regionMass"));
    EXPECT_EQ(t.columns,
        (std::vector<std::string>{"Time", "lowSolids", "lowSolidMass", "lowSolidFraction",
            "highSolids", "highSolidMass", "highSolidFraction"}));
    EXPECT_EQ(t.last("lowSolids"), 2);
    EXPECT_NEAR(t.last("lowSolidMass"), 2*1000*ball, 1e-6);
    EXPECT_NEAR(t.last("lowSolidFraction"), 2*ball/0.5, 1e-9);
    EXPECT_EQ(t.last("highSolids"), 1);
    EXPECT_NEAR(t.last("highSolidMass"), 125*ball, 1e-6);
}

//- Where their centre of mass is, as one each, of the volume that is known or follows from density
TEST(RegionMass, ofRigidBodies)
{
    RunningSolids c(rock());
    c.add({0.2, 0.2, 0.45}, 0.1);
    c.add({0.2, 0.2, 0.6}, 0.1);
    c.body(0, {0.2, 0.2, 0.525}, 12, {0.1, 0.1, 0.1});
    c.add({0.7, 0.7, 0.7}, 0.1);
    c.add({0.7, 0.7, 0.9}, 0.1);
    c.body(2, {0.7, 0.7, 0.8}, 5, {0.1, 0.1, 0.1}).volume = 0.02;
    c.add({0.5, 0.5, 0.1}, 0.05);
    c.solids.particles.clump.push_back(-1);
    c.start();
    c.function(halves);
    const FunctionTable t(c.table("regionMass"));
    EXPECT_EQ(t.last("highSolids"), 2);
    EXPECT_NEAR(t.last("highSolidMass"), 17, 1e-9);
    EXPECT_NEAR(t.last("highSolidFraction"), (0.012 + 0.02)/0.5, 1e-9);
    EXPECT_EQ(t.last("lowSolids"), 1);
    EXPECT_NEAR(t.last("lowSolidMass"), 500*std::acos(-1.0)/3*1e-3, 1e-6);
}
