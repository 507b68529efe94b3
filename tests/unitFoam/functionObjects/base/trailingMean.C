// SPDX-License-Identifier: GPL-3.0-or-later
/*  Means over a trailing time: what a restart is given, and too few samples. */

#include "scratchCase.hpp"
#include "trailingMean.H"

#include <gtest/gtest.h>

using Foam::functionObjects::trailingMean;

namespace
{
    std::string warningOf(const std::function<void()>& f)
    {
        testing::internal::CaptureStderr();
        testing::internal::CaptureStdout();
        f();
        return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
    }

    void addRamp(trailingMean& mean, int from, int to, double step)
    {
        for (int i = from; i <= to; ++i) mean.add(i*step, {2*i*step, 5}, Foam::dictionary(), "f");
    }
}

TEST(TrailingMean, goesOnWithWhatTheRunBeforeKept)
{
    trailingMean whole, before, after;
    EXPECT_FALSE(whole.on());
    whole.begin(0.5, Foam::scalarList(), 2);
    before.begin(0.5, Foam::scalarList(), 2);
    EXPECT_TRUE(whole.on());
    warningOf([&]() { addRamp(whole, 0, 200, 0.01); });
    warningOf([&]() { addRamp(before, 0, 120, 0.01); });
    after.begin(0.5, before.state(), 2);
    warningOf([&]() { addRamp(after, 121, 200, 0.01); });
    ASSERT_EQ(whole.mean().size(), 2u);
    EXPECT_NEAR(whole.mean()[0], 2*(2 - 0.25), 1e-12);
    EXPECT_NEAR(whole.mean()[1], 5, 1e-12);
    EXPECT_EQ(after.mean(), whole.mean());
    // an edited dictionary: samples at hand come first
    after.begin(0.25, Foam::scalarList(), 2);
    warningOf([&]() { addRamp(after, 201, 201, 0.01); });
    EXPECT_NEAR(after.mean()[0], 2*(2.01 - 0.125), 1e-12);
}

TEST(TrailingMean, warnsOnceOfFewSamples)
{
    trailingMean few;
    few.begin(0.5, Foam::scalarList(), 2);
    const std::string warning(warningOf([&]() { addRamp(few, 0, 50, 0.2); }));
    const std::size_t first = warning.find("Entry average of function object f: 0.5 s are ");
    EXPECT_NE(first, std::string::npos) << warning;
    EXPECT_EQ(warning.find("Entry average", first + 1), std::string::npos);
    trailingMean enough;
    enough.begin(0.5, Foam::scalarList(), 2);
    EXPECT_EQ(warningOf([&]() { addRamp(enough, 0, 500, 0.001); }), "");
}
