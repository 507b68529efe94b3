// SPDX-License-Identifier: GPL-3.0-or-later
/*  What the log says: of entries without effect, of progress, of sizes and memory. */

#include "logPrecision.H"
#include "moduleLog.H"
#include "progressClock.H"
#include "sceneNeeds.H"
#include "scratchCase.hpp"
#include "StringStream.H"

#include <cstdio>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    dictionary named(const std::string& text, const fileName& name)
    {
        dictionary dict(entries(text));
        dict.name() = name;
        return dict;
    }

    std::string logOf(const sceneNeeds& needs)
    {
        OStringStream os;
        needs.log(os);
        return os.str();
    }

    //- What f writes to the log
    std::string captured(const std::function<void()>& f)
    {
        testing::internal::CaptureStdout();
        f();
        return testing::internal::GetCapturedStdout();
    }
}

TEST(SceneNeeds, namesFileAndEntry)
{
    sceneNeeds needs;
    EXPECT_EQ(logOf(needs), "Entries and models without effect on this scene: none found\n\n");
    const dictionary tip(
        named("drag 1; mass 2;", "/home/a/case/constant/solidProperties.groups.tip"));
    needs.idle(tip, "drag", "no fluid");
    needs.idle(tip, "none", "is not there");
    const dictionary control(named("a 1; b 2;", "/home/a/case/system/controlDict"));
    needs.idle(control, wordList({"b", "c", "a"}), "why");
    EXPECT_EQ(logOf(needs),
        "No effect on this scene\n"
        "    constant/solidProperties, entry groups/tip/drag: no fluid\n"
        "    system/controlDict, entry a: why\n"
        "    system/controlDict, entry b: why\n\n");
}

TEST(SceneNeeds, whatModelsCost)
{
    const dictionary sph(named("", "/case/constant/sphProperties"));
    modelCost cost;
    cost.steps = 20;
    cost.seconds = 2e-3;
    cost.without = 1.5e-3;
    cost.bytes = 3e6;
    cost.bytesWithout = 2e6;
    sceneNeeds needs;
    needs.on(sph, "XSPH", "all move alike", "none", cost);
    EXPECT_EQ(logOf(needs),
        "On, and without effect on this scene\n"
        "    constant/sphProperties, entry XSPH: all move alike; `XSPH none` does the same, tried "
        "for 20 steps; saves 25 % of a step (500 of 2e+03 us, measured) and 1 MB of 3 MB\n\n");

    // one that differs makes no claim; one within the clock's noise none of speed
    sceneNeeds other;
    cost.same = false;
    other.on(sph, "a", "why", "none", cost);
    EXPECT_TRUE(holds(logOf(other), "none found"));
    cost = modelCost();
    cost.seconds = 1;
    cost.without = 0.99;
    other.on(sph, "a", "why", "none", cost);
    other.costly(sph, "b", "much");
    EXPECT_EQ(logOf(other),
        "On, and without effect on this scene\n"
        "    constant/sphProperties, entry a: why; `a none` does the same; saves less than 2 % of "
        "a "
        "step (measured)\n"
        "On, with an effect below what this scene resolves\n"
        "    constant/sphProperties, entry b: much\n\n");
}

TEST(SceneNeeds, subDictionaries)
{
    const dictionary dict(entries("a { b 1; } c 2;"));
    EXPECT_EQ(subDictOf(dict, "a").get<label>("b"), 1);
    EXPECT_TRUE(subDictOf(dict, "c").empty());
    EXPECT_TRUE(subDictOf(dict, "d").empty());
    EXPECT_EQ(threeDigits(1234.5), "1.23e+03");
    EXPECT_EQ(threeDigits(0.12345), "0.123");
}

TEST(ModuleLog, sizesAndMemory)
{
    EXPECT_EQ(bytesText(0), "0 B");
    EXPECT_EQ(bytesText(999), "999 B");
    EXPECT_EQ(bytesText(1000), "1 kB");
    EXPECT_EQ(bytesText(1234567), "1.235 MB");
    EXPECT_EQ(bytesText(5e15), "5000 TB");

    std::vector<riprap::ArrayInfo> arrays(3);
    arrays[0].set = arrays[2].set = "fluid";
    arrays[1].set = "walls";
    for (int i = 0; i < 3; ++i) arrays[i].bytes = 1000*(i + 1);
    EXPECT_EQ(captured([&]() { logMemory(arrays, 4); }),
        "Memory on the device\n    fluid: 4 kB\n    walls: 2 kB\n    all: 6 kB, 1.5 kB a "
        "particle\n\n");
}

TEST(ModuleLog, axesAndPrecision)
{
    struct { int dimensions = 2, axes[3] = {0, 2, 1}; bool periodic[3] = {false, true, true}; } c;
    EXPECT_EQ(axesText(c, false), "x z");
    EXPECT_EQ(axesText(c, true), "z");
    c.periodic[2] = false;
    EXPECT_EQ(axesText(c, true), "none");

    const int before = Info().precision();
    {
        const logPrecision six(3);
        EXPECT_EQ(captured([]() { Info << 1.0/3 << endl; }), "0.333\n");
    }
    EXPECT_EQ(Info().precision(), before);
}

TEST(ProgressClock, atTheEndAndNotBefore)
{
    progressClock clock;
    EXPECT_EQ(captured([&]() { clock.log(1, 0, 1); }), "");     // no steps
    clock.start();
    clock.stop(10, 1000);
    EXPECT_EQ(captured([&]() { clock.log(0.5, 0, 1); }), "");   // a moment after the last
    const std::string end(captured([&]() { clock.log(1, 0, 1); }));
    EXPECT_EQ(end.find("Progress = 100 %, "), 0u) << end;
    EXPECT_TRUE(holds(end, " steps/s, "));
    EXPECT_TRUE(holds(end, " particle-steps/s\n"));
    EXPECT_FALSE(holds(end, "expected end"));
    // a hundred particle steps a step
    double steps = 0, particles = 0;
    ASSERT_EQ(
        std::sscanf(end.c_str(), "Progress = 100 %%, %lf steps/s, %lf", &steps, &particles), 2);
    EXPECT_NEAR(particles/steps, 100, 0.01);
    EXPECT_EQ(captured([&]() { clock.log(1, 0, 1); }), "");     // counts anew
}
