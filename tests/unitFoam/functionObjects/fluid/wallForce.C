// SPDX-License-Identifier: GPL-3.0-or-later
/*  Forces of water at rest on its walls, by groups that move. */

#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    WrittenTable forces(int D, double dp, const std::string& more = "")
    {
        RunningSph run(tank(D, 1, 1, 10, 0.5),
            "maxVelocity 3; walls { motion { piston { patches (xMin); solidBodyMotionFunction "
            "linearMotion; linearMotionCoeffs { velocity (0 0 0); } } } }" + more);
        run.start(dp, {{point(0, 0, 0), point(1, 0.5, 0.5), Zero, 0.5}});
        run.make("wallForce");
        return run.table("wallForce");
    }

    //- Of the pressure on a side, relative: rho g h^2/2
    double deviation(const WrittenTable& t, double width)
    {
        return std::abs(t["pistonFx"]/(1250*width) + 1);
    }
}

TEST(WallForce, carriesTheWater)
{
    for (const int D : {2, 3})
    {
        const double width = D == 2 ? 1 : 0.5;
        const WrittenTable t(forces(D, 0.05));
        EXPECT_EQ(t.columns, (std::vector<std::string>{"Time", "fixedFx", "fixedFy", "fixedFz",
            "pistonFx", "pistonFy", "pistonFz"}));
        EXPECT_LT(deviation(t, width), 0.05);
        // the other side is among the fixed ones
        EXPECT_NEAR(t["fixedFx"], -t["pistonFx"], 1e-3*t["fixedFx"]);
        EXPECT_NEAR((t["fixedFz"] + t["pistonFz"])/(-5000*width), 1, 0.05);
        EXPECT_NEAR(t["fixedFy"] + t["pistonFy"], 0, 1e-3);
    }
    // with more neighbours
    EXPECT_LT(deviation(forces(2, 0.025, "smoothingLength { ratio 2; }"), 1), 0.01);
}
