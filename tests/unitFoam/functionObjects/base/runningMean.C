// SPDX-License-Identifier: GPL-3.0-or-later
/*  Means over a trailing time. */

#include "riprapFoam/functionObjects/base/runningMean.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace riprap;

TEST(RunningMean, exactForStraightLinesAtAnySteps)
{
    RunningMean mean(0.3);
    double t = 0;
    for (int k = 0; k < 60; ++k)
    {
        mean.add(t, {2 + 5*t, 7});
        // Of 2 + 5 t over the last 0.3 s, or since the start
        EXPECT_NEAR(mean.mean()[0], 2 + 5*(t - 0.5*std::min(t, 0.3)), 1e-12) << "at " << t;
        EXPECT_NEAR(mean.mean()[1], 7, 1e-12);
        t += k % 3 ? 0.013 : 0.11;
    }
}

TEST(RunningMean, followsAStepHalfItsWidthLate)
{
    // 0 until t = 1, then 1, by steps of 1/128: half way up at 1 + T/2, and the integral is kept
    RunningMean mean(0.5);
    double integral = 0;
    for (int k = 0; k <= 256; ++k)
    {
        const double t = k/128.0;
        mean.add(t, {t < 1 ? 0.0 : 1.0});
        if (k == 160) { EXPECT_NEAR(mean.mean()[0], 0.5, 0.5/64); }
        if (k == 128) { EXPECT_LT(mean.mean()[0], 0.01); }
        if (k >= 192) { EXPECT_NEAR(mean.mean()[0], 1, 1e-12); }
        integral += mean.mean()[0]/128;
    }
    EXPECT_NEAR(integral, 2 - 1.25, 0.01);
}

TEST(RunningMean, tellsHowManyIntervalsItHolds)
{
    RunningMean mean(0.5);
    for (int k = 0; k <= 8; ++k)
    {
        mean.add(0.125*k, {1});
        EXPECT_EQ(mean.intervals(), k < 4 ? 0 : 4);
    }
}

TEST(RunningMean, goesOnOverARestart)
{
    RunningMean whole(0.2), before(0.2), after(0.2);
    const auto v = [](int k) { return std::vector<double>{std::sin(0.3*k), 0.01*k*k, 1}; };
    const auto at = [](int k) { return 0.02*k + 0.005*(k % 2); };
    for (int k = 0; k <= 20; ++k)
    {
        whole.add(at(k), v(k));
        before.add(at(k), v(k));
    }
    after.restore(before.state(), 3);
    after.add(at(20), v(20));           // the first row of a continued run repeats the time
    for (int k = 21; k < 40; ++k)
    {
        whole.add(at(k), v(k));
        after.add(at(k), v(k));
        EXPECT_EQ(whole.mean(), after.mean());
    }
    after.restore({1, 2, 3}, 4);        // of another number of probes
    after.add(5, {1, 2, 3, 4});
    EXPECT_EQ(after.mean(), (std::vector<double>{1, 2, 3, 4}));
}
