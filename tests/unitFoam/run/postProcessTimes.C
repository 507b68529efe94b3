// SPDX-License-Identifier: GPL-3.0-or-later
/*  Option -postProcess: which times are taken, and what is done at each. */

#include "boxMesh.hpp"
#include "commandLine.hpp"
#include "postProcessTimes.H"
#include "scratchCase.hpp"
#include "scriptedModule.hpp"
#include "timeManifest.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- With the options of -postProcess, as a program that has them
    const argList& optionsOf(const fileName& path, std::vector<std::string> options)
    {
        static bool added = false;
        if (!added)
        {
            std::string program("unitTests"), word("-postProcess");
            char* words[] = {&program[0], &word[0], nullptr};
            EXPECT_FALSE(addPostProcessOptions(1, words));
            EXPECT_TRUE(addPostProcessOptions(2, words));
            EXPECT_TRUE(functionObject::postProcess);
            added = true;
        }
        functionObject::postProcess = false;
        options.insert(options.begin(), "-postProcess");
        return arguments(path, options);
    }

    struct WrittenCase : ScratchCase
    {
        autoPtr<fvMesh> mesh;
        ScriptedModule module;

        WrittenCase()
        {
            for (const char* time : {"0", "1", "2", "3", "4"}) write(std::string(time) + "/U", "");
            timeManifest::begin(path()/"2");
            timeManifest::begin(path()/"3");
            timeManifest::finish(path()/"3", fileSums(), true);
            writeDict("system/controlDict", "functions {}");
            mesh = BoxMesh().make<fvMesh>(time());
            mesh->setInstance("constant");
            mesh->write();
        }

        //- Their names; what was warned of
        std::string selected(const std::vector<std::string>& options, std::string& warnings)
        {
            std::string names;
            testing::internal::CaptureStderr();
            testing::internal::CaptureStdout();
            for (const instant& t : selectPostProcessTimes(time(), optionsOf(path(), options)))
                names += t.name() + ' ';
            warnings = testing::internal::GetCapturedStdout()
                + testing::internal::GetCapturedStderr();
            return names;
        }
    };
}

TEST(PostProcessTimes, wholeOnesAreTaken)
{
    WrittenCase c;
    std::string warnings;
    EXPECT_EQ(c.selected({}, warnings), "0 1 4 ");
    EXPECT_TRUE(holds(warnings,
        "Time 2 is passed over: the run that wrote it was stopped before the last file\n"));
    EXPECT_TRUE(
        holds(warnings, "Time 3 is passed over: it is a picture, without the state to start from"));
    EXPECT_EQ(c.selected({"-time", "1:3"}, warnings), "1 ");
    EXPECT_EQ(c.selected({"-latestTime"}, warnings), "4 ");
    EXPECT_EQ(messageOf([&]() { c.selected({"-time", "2"}, warnings); }),
        "Option -postProcess: no written time is selected; there are (0 1 2 3 4)");
    testing::internal::GetCapturedStderr();
    testing::internal::GetCapturedStdout();
    EXPECT_TRUE(holds(
        messageOf([&]() {
            selectPostProcessTimes(c.time(), optionsOf(c.path(), {"-func", "noSuch(a=1)"}));
        }),
        "Option -postProcess: Function object noSuch has no file: neither system/noSuch nor one "
        "below caseDicts/postProcessing in "));
}

//- Errors of one time are warnings, and told at the end
TEST(PostProcessTimes, eachTime)
{
    WrittenCase c;
    const argList& args = optionsOf(c.path(), {});
    std::vector<double> times;
    c.module.begin = [&]() { times.push_back(c.time().value()); };
    instantList all(2);
    all[0] = instant(1, "1");
    all[1] = instant(4, "4");
    testing::internal::CaptureStdout();
    EXPECT_EQ(messageOf([&]() { postProcessTimes(args, c.time(), c.mesh(), c.module, all); }), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "Time = 1\n\n\nTime = 4\n\n\n");
    EXPECT_EQ(times, (std::vector<double>{1, 4}));
    EXPECT_EQ(c.module.updates, 2);
    c.module.begin = [&]()
    {
        if (c.time().value() < 2) FatalErrorInFunction << "no particles" << exit(FatalError);
        else FatalIOErrorInFunction(c.time().controlDict()) << "no grid" << exit(FatalIOError);
    };
    testing::internal::CaptureStdout();
    EXPECT_EQ(messageOf([&]() { postProcessTimes(args, c.time(), c.mesh(), c.module, all); }),
        "2 of 2 times could not be processed: see the warnings above");
    const std::string told(testing::internal::GetCapturedStdout());
    std::size_t at = 0;
    for (const char* text : {"Time = 1\n", "no particles", "Time = 4\n", "no grid"})
    {
        at = told.find(text, at);
        ASSERT_NE(at, std::string::npos) << text << " is missing or late in\n" << told;
    }
}
