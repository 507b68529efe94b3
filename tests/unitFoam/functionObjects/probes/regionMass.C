// SPDX-License-Identifier: GPL-3.0-or-later
/*  Mass of fluid in regions. */

#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    const Water pool{point(0, 0, 0), point(1, 0.5, 0.5)};

    const std::string regions(
        "regions (all { source box; box (-1 -1 -1) (2 2 2); } low { source box; box (0 0 0) (1 0.5 "
        "0.2); } half { source box; box (0.2 0.1 0.3) (0.6 0.4 0.7); } ball { source sphere; "
        "centre "
        "(0.5 0.25 0.25); radius 0.22; } dry { source cylinder; p1 (0.5 0.1 0.8); p2 (0.5 0.4 "
        "0.8); "
        "radius 0.1; });");

    template<class Run>
    void masses(int D)
    {
        Run run(tank(D, 1, 1, 10, 0.5), "");
        run.start(0.05, {pool});
        run.make("regionMass", regions);
        const WrittenTable t(run.table("regionMass"));
        const double width = D == 2 ? 1 : 0.5, across = D == 2 ? 1 : 0.3;
        EXPECT_NEAR(t["allFluidMass"], 1000*0.5*width, 1e-6);
        EXPECT_NEAR(t["allFluidFraction"], 0.5*width/(D == 2 ? 9 : 27), 1e-9);
        EXPECT_NEAR(t["lowFluidMass"], 1000*0.2*width, 1e-6);
        EXPECT_NEAR(t["lowFluidFraction"], 1, 1e-9);
        EXPECT_NEAR(t["halfFluidMass"], 1000*0.4*0.2*across, 1e-6);
        EXPECT_NEAR(t["halfFluidFraction"], 0.5, 1e-9);
        const double pi = std::acos(-1.0);
        const double ball = D == 2 ? pi*0.22*0.22 : 4*pi/3*0.22*0.22*0.22;
        EXPECT_NEAR(t["ballFluidMass"], 1000*ball, 80*ball);
        EXPECT_NEAR(t["ballFluidFraction"]*ball*1000, t["ballFluidMass"], 0.02*1000*ball);
        EXPECT_EQ(t["dryFluidMass"], 0);
        EXPECT_EQ(t["dryFluidFraction"], 0);
        EXPECT_EQ(t.columns.size(), 11u);
    }
}

TEST(RegionMass, ofFluid)
{
    for (const int D : {2, 3})
    {
        masses<RunningSph>(D);
        masses<RunningPic>(D);
    }
}

TEST(RegionMass, whatIsRefused)
{
    RunningSph run(tank(2, 1, 1, 10));
    run.start(0.05, {pool});
    run.write("a.csv", "x,y,z\n0.1,0.2,0.3\n");
    EXPECT_EQ(run.said("regionMass", "regions ();"),
        "Entry regions of function object f is empty: it is a list of dictionaries with names");
    EXPECT_EQ(run.said("regionMass", "regions (a { source csv; file \"a.csv\"; });"),
        "Entry regions of function object f, region a: its source is no volume: box, cylinder, "
        "sphere and surface are");
    EXPECT_EQ(run.said("regionMass", "regions (a { source box; box (0 0.6 0) (1 1 1); });"),
        "Entry regions of function object f, region a: the mid-plane of the 2D mesh does not cut "
        "it");
    EXPECT_EQ(run.said("regionMass", "regions (a { source box; box (0 0 0) (1 1 1); radius 1; });"),
        "Unknown entry radius; valid are (source box)");
}
