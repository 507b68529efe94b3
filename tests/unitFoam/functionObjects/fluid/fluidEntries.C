// SPDX-License-Identifier: GPL-3.0-or-later
/*  Function objects of fluid: entries that are refused, and cases without a scene. */

#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    std::string noScene(const std::string& type, const std::string& needed,
        const std::string& solver)
    {
        return "Function object f of type " + type
            + " needs a running particle scene, and there is no " + needed
            + " on mesh region0.\n    riprapFoam with solver " + solver
            + " has one, as has its option -postProcess; other solvers and the utility postProcess "
              "have none.";
    }

    const Water still{point(0, 0, 0), point(1, 1, 0.5), Zero, 0.5};
}

TEST(FluidEntries, withoutAScene)
{
    FluidCase c(tank(2, 1, 1, 10), "", "(0 0 -10)");
    for (const char* type : {"energyBalance", "particleProbes", "particlesToMesh", "wallForce"})
        EXPECT_EQ(c.said(type), noScene(type, "sphScene", "sphDem"));
    EXPECT_EQ(c.said("waterLevel", "points ((0 0 0));"),
        noScene("waterLevel", "sphScene", "sphDem"));
    EXPECT_EQ(c.said("momentumBalance"), noScene("momentumBalance", "picScene", "picDem"));
    EXPECT_EQ(c.said("regionMass", "regions ();"),
        "Function object f of type regionMass needs a running scene of fluid or solids. riprapFoam "
        "has one, as has its option -postProcess; the utility postProcess has none.");
}

TEST(FluidEntries, ofAnotherMethod)
{
    RunningPic pic(tank(2, 1, 1, 10));
    pic.start(0.05, {still});
    EXPECT_EQ(pic.said("wallForce"), noScene("wallForce", "sphScene", "sphDem"));
    RunningSph sph(tank(2, 1, 1, 10));
    sph.start(0.1, {still});
    EXPECT_EQ(sph.said("momentumBalance"), noScene("momentumBalance", "picScene", "picDem"));
}

TEST(FluidEntries, wrongOnes)
{
    RunningSph run(tank(2, 1, 1, 10));
    run.start(0.1, {still});
    EXPECT_TRUE(holds(run.said("energyBalance", "minThickness 1;"),
        "Unknown entry minThickness; valid are (type libs functionObjectLibs enabled log region"));
    EXPECT_EQ(run.said("waterLevel", "points ();"),
        "Entry points of function object f is empty: it is a list of points");
    EXPECT_EQ(run.said("waterLevel", "points ((0.5 0.5 0)); up (0 1 0);"),
        "Entry up of function object f has no length in the plane of the 2D mesh");
    EXPECT_EQ(run.said("waterLevel", "points ((0.5 0.5 0)); minThickness -1;"),
        "Entry minThickness of function object f is -1: it must not be negative");
    EXPECT_EQ(run.said("waterLevel", "points ((0.5 0.5 0) (3 0.5 0)); up (0 0 2);"),
        "Entry points of function object f: gauge 1 at (3 0.5 0) along (0 0 1) meets nothing of "
        "the "
        "mesh, which spans (0 0 0) to (1 1 1)");
    EXPECT_EQ(run.said("frontPosition", "direction (0 2 0);"),
        "Entry direction of function object f has no length in the plane of the 2D mesh");
    EXPECT_EQ(run.said("frontPosition", "spacing 0;"), "Entry spacing is 0: it must be positive");
    EXPECT_EQ(run.said("frontPosition", "floorHeight -1;"),
        "Entry floorHeight of function object f is -1: it must not be negative");
    EXPECT_EQ(run.said("particlesToMesh", "fields ();"),
        "Entry fields of function object f is empty; valid are (p U alpha.water)");
    EXPECT_EQ(run.said("particlesToMesh", "fields (p alpha);"),
        "Entry fields of function object f: unknown field alpha; valid are (p U alpha.water)");
    EXPECT_EQ(run.said("particlesToMesh", "minVolumeFraction 1.5;"),
        "Entry minVolumeFraction is 1.5: it must be from 0 to 1");
}
