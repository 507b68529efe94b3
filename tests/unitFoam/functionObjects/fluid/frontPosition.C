// SPDX-License-Identifier: GPL-3.0-or-later
/*  Front and levels of fluid in tables. */

#include "particleCloudIO.H"
#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    const double dp = 0.05;

    //- A column at a wall, a sheet on the bed before it, and a drop ahead
    const std::vector<Water> surge{{point(0, 0, 0), point(0.6, 0.4, 0.5)},
        {point(0.6, 0, 0), point(0.8, 0.4, 0.1)}, {point(1.2, 0, 0.6), point(1.25, 0.05, 0.65)}};

    template<class Run>
    void frontOfSurge(int D, int particles)
    {
        Run run(tank(D, 2, 1, 20, 0.4));
        run.start(dp, surge);
        run.make("frontPosition");
        const WrittenTable t(run.table("frontPosition"));
        EXPECT_NEAR(t["front"], 0.8, 1e-6);
        EXPECT_NEAR(t["frontFloor"], 0.8, 1e-6);
        EXPECT_NEAR(t["max"], 1.25, 1e-6);
        EXPECT_NEAR(t["height"], 0.5, 0.2*dp);
        EXPECT_EQ(t["particles"], particles);
        EXPECT_EQ(t["escaped"], 0);
        // from elsewhere, another way, high above the bed, and with spray
        run.make("frontPosition", "origin (1.5 0 0.6); direction (-3 0 0);", "back");
        EXPECT_NEAR(run.table("frontPosition", "back")["front"], 1.5, 1e-6);
        run.make("frontPosition", "floorHeight 0; minNeighbours 0;", "spray");
        EXPECT_NEAR(run.table("frontPosition", "spray")["front"], 1.25, 1e-6);
        EXPECT_EQ(run.table("frontPosition", "spray")["frontFloor"], 0);
        run.make("frontPosition", "direction (0 0 1); up (-1 0 0); origin (0 0 0.1);", "high");
        EXPECT_NEAR(run.table("frontPosition", "high")["front"], 0.4, 1e-6);
    }
}

TEST(FrontPosition, sph)
{
    frontOfSurge<RunningSph>(2, 12*10 + 4*2 + 1);
    frontOfSurge<RunningSph>(3, (12*10 + 4*2)*8 + 1);
}

TEST(FrontPosition, pic)
{
    // given particles as they are
    struct AsGiven : RunningPic
    {
        explicit AsGiven(const BoxMesh& box) : RunningPic(box, "seeds { perDirection 0; }") {}
    };
    frontOfSurge<AsGiven>(2, 12*10 + 4*2 + 1);
    frontOfSurge<AsGiven>(3, (12*10 + 4*2)*8 + 1);
}

//- Where no scene is, from the clouds of times, by the spacing that is given or kept with them
TEST(FrontPosition, ofWrittenClouds)
{
    FluidCase c(tank(2, 2, 1, 20), "deltaT 0.5;", "(0 0 -10)");
    const auto writeCloud = [&](double x, bool withSpacing)
    {
        particleCloud cloud("fluid", 3);
        cloud.position = pointField({{x, 0.5, 0.1}, {x - 0.04, 0.5, 0.1}, {x + 0.5, 0.5, 0.1}});
        if (withSpacing) cloud.properties.add("spacing", 0.04);
        writeParticleCloud(c.mesh(), cloud);
    };
    EXPECT_EQ(c.said("frontPosition"),
        "Entry spacing of function object f is missing: no particle scene is running, cloud fluid "
        "at time 0 does not tell, and there is no \"" + c.path() + "/system/setParticlesDict\"");
    // no cloud: no row
    const auto f = c.make("frontPosition", "spacing 0.1;");
    EXPECT_EQ(c.read("postProcessing/f/0/frontPosition.dat"), "");
    writeCloud(1, false);
    f->write();
    EXPECT_NEAR(c.table("frontPosition")["front"], 1.05, 1e-6);
    EXPECT_NEAR(c.table("frontPosition")["max"], 1.55, 1e-6);
    EXPECT_EQ(c.table("frontPosition")["height"], 0);
    ++c.time();
    writeCloud(1.2, true);
    const auto g = c.make("frontPosition", "", "g");
    g->write();
    EXPECT_NEAR(c.table("frontPosition", "g")["front"], 1.22, 1e-6);
    EXPECT_EQ(c.table("frontPosition", "g")["particles"], 3);
}

TEST(FrontPosition, countsWhatHasLeft)
{
    RunningSph run(tank(2, 2, 1, 20), "maxVelocity 5;", "deltaT 0.05;");
    // beyond the open top in 0.02 s
    run.start(dp, {{point(0, 0, 0), point(0.5, 1, 0.2)},
                      {point(1, 0, 0.9), point(1.1, 1, 1), vector(0, 0, 20)}});
    const auto f = run.make("frontPosition");
    run.step();
    f->write();
    const WrittenTable t(run.table("frontPosition"));
    EXPECT_EQ(t.at("particles", 0), 44);
    EXPECT_EQ(t["particles"], 40);
    EXPECT_EQ(t["escaped"], 4);
}
