// SPDX-License-Identifier: GPL-3.0-or-later
/*  When the particles hand back: equal steps, ends at written times and at the end. */

#include "scratchCase.hpp"
#include "timePlan.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- The times at which steps end
    std::vector<double> ends(const std::string& control, double stepOfParticles = 0)
    {
        ScratchCase c(control);
        timePlan plan(c.time());
        std::vector<double> times;
        while (plan.run() && times.size() < 1000)
        {
            const double target = plan.target(), now = c.time().value();
            const bool each = plan.sampleInterval() == 0;
            plan.advanceTo(each ? std::min(target, now + stepOfParticles) : target);
            times.push_back(c.time().value());
        }
        return times;
    }

    double interval(const std::string& control)
    {
        ScratchCase c(control);
        return timePlan(c.time()).sampleInterval();
    }

    std::string said(const std::string& control)
    {
        ScratchCase c;
        c.write("system/controlDict", control);
        return messageOf([&]() { requireWriteIntervals(c.path()/"system/controlDict"); });
    }
}

TEST(TimePlan, sampleInterval)
{
    EXPECT_EQ(interval("endTime 3; sampleInterval 0.07;"), 0.07);
    EXPECT_EQ(interval("endTime 3; sampleInterval 0;"), 0);
    EXPECT_NEAR(interval("endTime 3;"), 0.03, 1e-15);
    EXPECT_NEAR(interval("endTime 3; writeControl runTime; writeInterval 0.5;"), 0.05, 1e-15);
    EXPECT_NEAR(
        interval("endTime 3; writeControl adjustableRunTime; writeInterval 0.2;"), 0.02, 1e-15);
    EXPECT_EQ(messageOf([]() { interval("endTime 3; sampleInterval -1;"); }),
        "Entry sampleInterval is -1: it must be zero (every particle step) or positive");
}

TEST(TimePlan, equalStepsOfTwelveDigits)
{
    const auto times = ends("endTime 0.7; sampleInterval 0.1;");
    EXPECT_EQ(times, (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}));
    // the last step is shorter
    EXPECT_EQ(ends("endTime 0.35; sampleInterval 0.1;"),
        (std::vector<double>{0.1, 0.2, 0.3, 0.35}));
    // but no sliver
    EXPECT_EQ(ends("endTime 0.20000000001; sampleInterval 0.1;").size(), 2u);
}

//- Steps are made even up to a written time, of the case or of a function object
TEST(TimePlan, endsAtWrittenTimes)
{
    const auto times = ends("endTime 0.5; writeControl adjustableRunTime; writeInterval 0.25; "
                            "sampleInterval 0.1;");
    ASSERT_EQ(times.size(), 6u);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(times[i], 0.5*(i + 1)/6, 2e-12);
    EXPECT_EQ(times[2], 0.25);
    EXPECT_EQ(times[5], 0.5);
    EXPECT_EQ(ends("endTime 0.5; sampleInterval 0.2; functions { a { writeControl "
                   "adjustable; writeFrequency 0.25; } b { writeControl timeStep; writeInterval "
                   "1; } }"),
        (std::vector<double>{0.125, 0.25, 0.375, 0.5}));
}

TEST(TimePlan, eachParticleStep)
{
    const auto times = ends("endTime 0.1; sampleInterval 0; writeControl adjustableRunTime; "
                            "writeInterval 0.05;", 0.02);
    ASSERT_EQ(times.size(), 6u);
    EXPECT_EQ(times[2], 0.05);
    EXPECT_EQ(times[5], 0.1);
}

//- To the bit the times of a run that was not stopped
TEST(TimePlan, goesOnLikeTheWholeRun)
{
    const std::string plan("writeControl adjustableRunTime; writeInterval 0.3; "
                           "sampleInterval 0.07; endTime 1.2; ");
    const auto whole = ends(plan);
    ScratchCase c(plan);
    c.time().setTime(0.6, 0);
    timePlan after(c.time());
    std::vector<double> rest;
    while (after.run())
    {
        after.advanceTo(after.target());
        rest.push_back(c.time().value());
    }
    ASSERT_EQ(whole.size(), 20u);
    EXPECT_EQ(rest, std::vector<double>(whole.begin() + 10, whole.end()));
}

TEST(TimePlan, endBeforeTheStart)
{
    ScratchCase c("endTime 1;");
    c.time().setTime(2, 0);
    EXPECT_EQ(messageOf([&]() { timePlan plan(c.time()); }),
        "Entry endTime is 1, before time 2 at which the run starts");
}

TEST(TimePlan, writeIntervalsMustBePositive)
{
    EXPECT_EQ(said("writeControl timeStep; writeInterval 0;"), "");
    EXPECT_EQ(said("writeControl runTime; writeInterval 0.1;"), "");
    EXPECT_EQ(said("writeControl runTime; writeInterval 0;"),
        "Entry writeInterval is 0: it must be positive");
    EXPECT_EQ(said("writeControl adjustable; writeFrequency -1;"),
        "Entry writeFrequency is -1: it must be positive");
    EXPECT_EQ(said("functions { a { executeControl runTime; executeInterval 0; } }"),
        "Entry executeInterval is 0: it must be positive");
    EXPECT_EQ(messageOf([]() { requireWriteIntervals("/nowhere/controlDict"); }), "");
}
