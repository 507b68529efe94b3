// SPDX-License-Identifier: GPL-3.0-or-later
/*  Files of the exact state: round trips, and damage of every kind. */

#include "sceneState.H"
#include "scratchCase.hpp"
#include "timeWriter.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    struct StateCase : ScratchCase
    {
        //- Both files of a run with these words
        StateCase()
        {
            IOdictionary run(stateObject(time(), "run"));
            run.add("steps", exact(scalar(12)));
            writeState(run);
            writeStateWords(time(), "words", riprap::knownWords({1, -2, 2147483647}));
            timeWriter::ofRun().wait();
        }

        std::string said()
        {
            return messageOf(
                [&]()
                {
                    if (!hasState(time(), "run", "words")) return;
                    stateDictionary(stateObject(time(), "run", IOobject::MUST_READ));
                    readStateWords(time(), "words");
                });
        }
    };

    const std::string folder("0/uniform/riprap/");
}

TEST(SceneState, numbersToTheBit)
{
    for (const scalar x : {0.1, 1.0/3, -1e-300, 1.7976931348623157e308, 5e-324, 123456789.0})
    {
        EXPECT_EQ(std::strtod(exact(x).c_str(), nullptr), x);
    }
    const scalarList list({0.1, -1.0/3, 1e300});
    dictionary dict;
    dict.add("list", exact(list));
    EXPECT_EQ(exactList(dict, "list"), list);
    EXPECT_EQ(exactList(dict, "none"), scalarList());
    EXPECT_EQ(count(entries("n 9007199254740991;"), "n"), (int64_t(1) << 53) - 1);
}

TEST(SceneState, comesBack)
{
    StateCase c;
    ASSERT_TRUE(hasState(c.time(), "run", "words"));
    EXPECT_FALSE(hasState(c.time(), "runs", "wordss"));
    EXPECT_EQ(c.said(), "");
    const dictionary run(stateDictionary(stateObject(c.time(), "run", IOobject::MUST_READ)));
    EXPECT_EQ(count(run, "steps"), 12);
    EXPECT_EQ(readStateWords(c.time(), "words"), (std::vector<std::int32_t>{1, -2, 2147483647}));
}

TEST(SceneState, damage)
{
    const auto damaged = [](const std::string& said)
    {
        return holds(said, "The exact state of the particles is damaged (")
            && holds(said, "uniform/riprap\" to continue from the fields of the cloud");
    };
    {
        StateCase c;
        rm(c.path()/(folder + "words"));
        EXPECT_TRUE(damaged(c.said()));
        EXPECT_TRUE(holds(c.said(), "one of its two files is missing or empty"));
    }
    {
        StateCase c;
        c.write(folder + "run", "");
        EXPECT_TRUE(damaged(c.said()));
    }
    const std::string good(StateCase().read(folder + "words"));
    const std::size_t first = good.rfind('(') + 1, last = good.rfind(')') - 1;
    ASSERT_EQ(last - first, 4*5u - 1);
    for (const std::size_t at : {first, first + 4, first + 8, last})
    {
        StateCase c;
        std::string bad(good);
        bad[at] ^= 1;
        c.write(folder + "words", bad);
        EXPECT_TRUE(damaged(c.said())) << at;
        EXPECT_TRUE(holds(c.said(), "its check sum is wrong")) << c.said();
    }
    for (const std::size_t length : {last - 1, first + 2})
    {
        StateCase c;
        c.write(folder + "words", good.substr(0, length));
        EXPECT_TRUE(damaged(c.said())) << length;
    }
}

TEST(SceneState, orDamagedLetsOtherErrorsThrough)
{
    ScratchCase c;
    const IOobject io(stateObject(c.time(), "run"));
    EXPECT_EQ(messageOf([&]() { orDamaged(io, []() {}); }), "");
    EXPECT_TRUE(holds(messageOf([&]()
        {
            orDamaged(io, []() { FatalIOErrorInFunction("f") << "why" << exit(FatalIOError); });
        }),
        "is damaged (why): remove the folder"));
    EXPECT_EQ(messageOf([&]()
        {
            orDamaged(io, []() { FatalErrorInFunction << "else" << exit(FatalError); });
        }),
        "else");
}
