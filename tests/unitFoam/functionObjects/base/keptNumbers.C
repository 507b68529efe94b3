// SPDX-License-Identifier: GPL-3.0-or-later
/*  What function objects keep for a run that goes on: all digits of it. */

#include "runningSolids.hpp"
#include "sceneFunctionObject.H"
#include "sceneState.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- One whose kept numbers a test sees
    struct Keeper : functionObjects::sceneFunctionObject
    {
        using sceneFunctionObject::keep;
        using sceneFunctionObject::saved;
        using sceneFunctionObject::sceneFunctionObject;
        using sceneFunctionObject::stateDict;
        bool writeSample() override { return true; }
    };
}

//- By way of a file, as a run that goes on reads them
TEST(KeptNumbers, manyComeBackFromAFile)
{
    RunningSolids c(rock());
    Keeper keeper("keeper", c.time(), entries("type keeper;"));
    for (const label n : {0, 1, 40, 41, 1000})
    {
        scalarList numbers(n);
        forAll(numbers, i) numbers[i] = (i % 2 ? -1 : 1)*std::exp(300.0*std::sin(i + 1.0))/3;
        keeper.keep("values", numbers);
        EXPECT_EQ(keeper.saved("values"), numbers) << n;
        OStringStream file;
        keeper.stateDict().dictionary::write(file, false);
        const dictionary back(IStringStream(file.str())());
        EXPECT_EQ(exactList(back.subDict("keeper"), "values"), numbers) << n;
    }
}

TEST(KeptNumbers, ofVersionsWithFewerDigits)
{
    const dictionary old(entries("one 3.5; several 3(1 2 -3e-5); equal 2{7}; none 0(); "
                                 "vectors 2((1 2 3) (4 5 6)); same 2{(1 2 3)};"));
    EXPECT_EQ(exactList(old, "one"), scalarList({3.5}));
    EXPECT_EQ(exactList(old, "several"), scalarList({1, 2, -3e-5}));
    EXPECT_EQ(exactList(old, "equal"), scalarList({7, 7}));
    EXPECT_EQ(exactList(old, "none"), scalarList());
    EXPECT_EQ(exactList(old, "vectors"), scalarList({1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(exactList(old, "same"), scalarList({1, 2, 3, 1, 2, 3}));
    EXPECT_EQ(exactList(old, "absent"), scalarList());
}

//- Late in a run times differ in digits that a file of six has not
TEST(KeptNumbers, meanGoesOn)
{
    RammedFloor c;
    c.time().setTime(100.0, 0);
    c.settings.config.startTime = 100;
    c.start();
    const std::string text("type solidWallForce; average 0.001;");
    auto f = c.function(text);
    const auto sampled = [&](functionObject& object, int i)
    {
        c.run(100 + 1e-4*i);
        c.sample(object);
    };
    for (int i = 1; i <= 20; ++i) sampled(f(), i);
    f.clear();
    auto after = c.function(text);
    for (int i = 21; i <= 23; ++i)
    {
        sampled(after(), i);
        // the force grows with the time: the mean is that of the middle
        const FunctionTable table(c.table("solidWallForceMean_0", "0"));
        EXPECT_NEAR(table.last("zMinFz"), -c.rate*(1e-4*i - 0.0005), 1e-4*c.rate*1e-3) << i;
    }
}

TEST(KeptNumbers, placesAtTheStart)
{
    RunningSolids c(rock(), BoxMesh(), "(0 0 0)");
    c.add(point(0.123456789, 0.5, 0.5), 0.05);
    c.start();
    const std::string text("type particleDisplacement; origIds (0);");
    auto f = c.function(text);
    f->read(entries(text));
    c.run(0.1);
    c.sample(f());
    EXPECT_NEAR(c.table("particleDisplacement").last("0Dx"), 0, 1e-9);
}
