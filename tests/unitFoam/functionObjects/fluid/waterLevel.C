// SPDX-License-Identifier: GPL-3.0-or-later
/*  Gauges in fluid of known levels. */

#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    const double dp = 0.05;

    //- Deep, shallow, and a slab above the shallow part
    const std::vector<Water> layers{{point(0, 0, 0), point(1, 0.4, 0.5)},
        {point(1, 0, 0), point(2, 0.4, 0.2)}, {point(1.2, 0, 0.6), point(1.8, 0.4, 0.9)}};

    template<class Run>
    void gauges(int D, double tolerance)
    {
        Run run(tank(D, 2, 1, 20, 0.4));
        run.start(dp, layers);
        run.make("waterLevel", "points ((0.5 0.2 0) (0 0.2 0.1) (1.5 0.2 0) (1.5 0.2 0.3));");
        const WrittenTable t(run.table("waterLevel"));
        const double expected[4] = {0.5, 0.4, 0.9, 0.6};
        const double lowest[4] = {0.5, 0.4, 0.2, 0.6};
        for (int i = 0; i < 4; ++i)
        {
            const std::string n(std::to_string(i));
            EXPECT_NEAR(t["level" + n], expected[i], tolerance) << i;
            EXPECT_NEAR(t["lowest" + n], lowest[i], tolerance) << i;
        }
        ASSERT_EQ(t.comments.size(), 4u);
        EXPECT_EQ(t.comments[1], "Gauge 1 (0 0.2 0.1)");
        // the slab is 0.3 thick: a drop of the size that is asked for
        run.make("waterLevel", "points ((1.5 0.2 0)); minThickness 0.35;", "thick");
        EXPECT_NEAR(run.table("waterLevel", "thick")["level0"], 0.2, tolerance);
        // across the deep part, and where it is dry
        run.make("waterLevel", "points ((0 0.2 0.35)); up (1 0 0);", "across");
        EXPECT_NEAR(run.table("waterLevel", "across")["level0"], 1, tolerance);
        run.make("waterLevel", "points ((1.9 0.2 0.4));", "dry");
        EXPECT_EQ(run.table("waterLevel", "dry")["level0"], 0);
        EXPECT_EQ(run.table("waterLevel", "dry")["lowest0"], 0);
    }
}

TEST(WaterLevel, sph)
{
    gauges<RunningSph>(2, 0.2*dp);
    gauges<RunningSph>(3, 0.2*dp);
}

TEST(WaterLevel, pic)
{
    gauges<RunningPic>(2, 0.02);
    gauges<RunningPic>(3, 0.02);
}

//- Water on a solid that the gauge passes through stands, however shallow
TEST(WaterLevel, onASolid)
{
    RunningSph run(tank(2, 2, 1, 20));
    run.writeDict(
        "constant/geometry", "step { type searchableBox; min (1 -1 -0.1); max (1.6 2 0.3); }");
    run.start(dp, {{point(0, 0, 0), point(1, 1, 0.4)}, {point(1, 0, 0.3), point(1.6, 1, 0.4)}});
    run.make("waterLevel", "points ((1.3 0.5 0) (0.5 0.5 0)); minThickness 0.2;");
    const WrittenTable t(run.table("waterLevel"));
    // two particles deep
    EXPECT_NEAR(t["level0"], 0.4, 0.5*dp);
    EXPECT_NEAR(t["level1"], 0.4, 0.25*dp);
    run.make("waterLevel", "points ((1.3 0.5 0.2)); minThickness 0.2;", "in");
    EXPECT_NEAR(run.table("waterLevel", "in")["level0"], 0.2, 0.5*dp);
}
