// SPDX-License-Identifier: GPL-3.0-or-later
/*  Momentum of water on a grid: at rest, in free fall. */

#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    WrittenTable momentum(int D, const Water& water)
    {
        RunningPic run(tank(D, 1, 1, 10, 0.5), "", "deltaT 0.001; adjustTimeStep no;");
        run.start(0.05, {water});
        const auto f = run.make("momentumBalance");
        for (int k = 0; k < 2; ++k)
        {
            run.step();
            FluidCase::sample(*f);
        }
        return run.table("momentumBalance");
    }

    void expectVector(const WrittenTable& t, const std::string& what, const vector& v,
        double tolerance)
    {
        const char* axes[] = {"X", "Y", "Z"};
        for (int d = 0; d < 3; ++d) EXPECT_NEAR(t[what + axes[d]], v[d], tolerance) << what << d;
    }
}

TEST(MomentumBalance, wallsCarryWaterAtRest)
{
    for (const int D : {2, 3})
    {
        const WrittenTable t(momentum(D, {point(0, 0, 0), point(1, 0.5, 0.4)}));
        ASSERT_EQ(t.rows.size(), 3u);
        // without the half cell at the floor, which cannot move
        const double weight = (D == 2 ? 350 : 175)*10*0.001;
        for (int i = 1; i < 22; ++i) EXPECT_EQ(t.rows[0][i], 0) << t.columns[i];
        expectVector(t, "gravity", vector(0, 0, -weight), 1e-6*weight);
        expectVector(t, "walls", vector(0, 0, -weight), 1e-6*weight);
        for (const char* none : {"water", "solids", "other", "residual", "particles"})
            expectVector(t, none, vector(0, 0, 0), 1e-6*weight);
    }
}

TEST(MomentumBalance, fallingWaterGetsItsWeight)
{
    for (const int D : {2, 3})
    {
        const WrittenTable t(
            momentum(D, {point(0.2, 0.1, 0.4), point(0.8, 0.4, 0.8), vector(1, 0, 0)}));
        const double weight = (D == 2 ? 240 : 72)*10*0.001;
        expectVector(t, "particles", vector(0, 0, -weight), 1e-6*weight);
        for (const char* none : {"walls", "solids", "other", "residual"})
            expectVector(t, none, vector(0, 0, 0), 1e-6*weight);
        // what the grid moves, of which the surface's cells have a part
        EXPECT_NEAR(t["waterZ"], t["gravityZ"], 1e-6*weight);
        EXPECT_NEAR(t["gravityZ"], -weight, 0.2*weight);
    }
}
