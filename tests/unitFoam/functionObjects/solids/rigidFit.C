// SPDX-License-Identifier: GPL-3.0-or-later
/*  Rigid motion from particles that share it. */

#include "riprapFoam/functionObjects/fluid/wallNeighbours.hpp"
#include "riprapFoam/functionObjects/solids/rigidFit.hpp"

#include <gtest/gtest.h>

using namespace riprap;

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
