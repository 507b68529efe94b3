// SPDX-License-Identifier: GPL-3.0-or-later
/*  Manifests of written times: what has been changed, damaged, left out since. */

#include "scratchCase.hpp"
#include "timeManifest.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string foamEnd("\n// " + std::string(73, '*') + " //\n");

    struct WrittenTime : ScratchCase
    {
        fileName folder() const { return path()/"2"; }

        //- As OpenFOAM writes them
        void foam(const std::string& name, const std::string& text) const
        {
            write("2/" + name, "/*---*/\n" + text + foamEnd);
        }

        WrittenTime()
        {
            timeManifest::begin(folder());
            for (const char* file : {"positions", "U", "p"}) foam(lagrangian(file), "1(5)");
            foam("uniform/riprap/state", "2(1 2)");
            foam("uniform/lagrangian/fluid/cloudProperties", "geometry positions;");
            foam("p", "3(1 2 3)");
            write("2/notes.txt", "text");
            timeManifest::finish(folder(), fileSums());
        }

        static std::string lagrangian(const std::string& file)
        {
            return "lagrangian/fluid/" + file;
        }

        //- Compared anew
        const timeManifest& manifest() const
        {
            timeManifest::of(path());
            return timeManifest::of(folder());
        }

        std::string required() const
        {
            timeManifest::of(path());
            return messageOf([&]() { requireWholeTime(dictionary(), folder()); });
        }

        std::string thrown(const fileNameList& files = fileNameList()) const
        {
            try { timeManifest::finish(folder(), fileSums(), false, files); }
            catch (const std::runtime_error& e) { return e.what(); }
            return "";
        }

        //- What is said where it is damaged so
        std::string damage(const std::string& why) const
        {
            return "Time 2 is damaged (" + why + "): remove the folder \"" + folder()
                + "/uniform/riprap\" to continue from the fields of the cloud where these are "
                  "good, "
                  "or start from another time: startFrom latestTime takes the latest whole one";
        }
    };

    using kind = timeManifest::kind;
}

TEST(Manifest, aWholeTime)
{
    const WrittenTime t;
    EXPECT_EQ(int(t.manifest().is), int(kind::whole));
    EXPECT_TRUE(t.manifest().changed.empty());
    EXPECT_FALSE(t.manifest().redistributed);
    EXPECT_EQ(t.required(), "");
    EXPECT_TRUE(hasParticles(t.folder()));
    EXPECT_FALSE(hasParticles(t.path()));
    // bytes and name of each file
    const std::string text(t.read("2/uniform/riprap/manifest"));
    EXPECT_TRUE(holds(text, " other notes.txt\n")) << text;
    EXPECT_TRUE(holds(text, " foam lagrangian/fluid/positions\n")) << text;
    EXPECT_TRUE(holds(text, "\n4 "));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 8);
    EXPECT_EQ(int(timeManifest::of(t.path()).is), int(kind::none));
}

//- Fields that were written anew are told; those that a run reads are named
TEST(Manifest, whatWasChanged)
{
    const WrittenTime t;
    t.foam(t.lagrangian("U"), "1(6)");
    t.foam(t.lagrangian("p"), "1(66)");
    t.foam("p", "3(1 2 4)");
    EXPECT_EQ(int(t.manifest().is), int(kind::whole));
    EXPECT_EQ(t.manifest().changed.size(), 3);
    EXPECT_EQ(t.manifest().changedSince("fluid"), "U");
    EXPECT_EQ(t.manifest().changedSince("solids"), "");
    t.foam("uniform/lagrangian/fluid/cloudProperties", "geometry coordinates;");
    EXPECT_EQ(t.manifest().changedSince("fluid"), "U cloudProperties");
    testing::internal::CaptureStdout();
    EXPECT_EQ(t.required(), "");
    const std::string said(testing::internal::GetCapturedStdout());
    EXPECT_TRUE(holds(said, "Changed since riprapFoam wrote time 2: (")) << said;
    // what is gone and no state, and positions that became coordinates
    EXPECT_TRUE(rm(t.path()/"2/notes.txt"));
    EXPECT_TRUE(mv(t.path()/"2/lagrangian/fluid/positions",
        t.path()/"2/lagrangian/fluid/coordinates"));
    EXPECT_EQ(int(t.manifest().is), int(kind::whole));
    EXPECT_EQ(t.manifest().changedSince("fluid"), "U positions cloudProperties");
    EXPECT_TRUE(hasParticles(t.folder()));
}

TEST(Manifest, whatIsDamaged)
{
    const auto expectDamage = [](const std::function<void(const WrittenTime&)>& f,
                                  const std::string& why)
    {
        const WrittenTime t;
        f(t);
        EXPECT_EQ(int(t.manifest().is), int(kind::damaged));
        EXPECT_EQ(t.manifest().why, why);
        EXPECT_EQ(t.required(), t.damage(why));
    };
    expectDamage([](const WrittenTime& t) { EXPECT_TRUE(rm(t.folder()/t.lagrangian("U"))); },
        "lagrangian/fluid/U is missing");
    const std::string size(std::to_string(8 + 4 + foamEnd.size()));
    expectDamage([](const WrittenTime& t) { t.write("2/lagrangian/fluid/U", "/*---*/\n1("); },
        "lagrangian/fluid/U is cut short: 10 of " + size + " bytes");
    expectDamage([](const WrittenTime& t) { t.foam("uniform/riprap/state", "2(1 3)"); },
        "uniform/riprap/state is not what was written: its check sum is wrong");
    expectDamage(
        [](const WrittenTime& t)
        {
            const std::string text(t.read("2/uniform/riprap/manifest"));
            t.write("2/uniform/riprap/manifest", text + "12\n");
        },
        "uniform/riprap/manifest has the line 12");
}

TEST(Manifest, whatCannotBeFinished)
{
    const WrittenTime t;
    EXPECT_EQ(t.thrown({"uniform/riprap/state"}), "");
    EXPECT_EQ(t.thrown({"uniform/riprap/state", "uniform/riprap/other"}),
        "Time 2 has been written without its file uniform/riprap/other: no run could go on from "
        "it. Earlier times are whole");
    t.write("2/uniform/riprap/state", "/*---*/\n2(");
    EXPECT_EQ(t.thrown(),
        "File " + t.folder()
            + "/uniform/riprap/state was not written to its end, "
              "but for 10 bytes: is the disk full? This time is not whole, earlier ones are");
    timeManifest::begin(t.folder());
    EXPECT_EQ(int(t.manifest().is), int(kind::unfinished));
    // what stood there is another run's
    EXPECT_FALSE(isFile(t.folder()/"uniform/riprap/state"));
    EXPECT_FALSE(isDir(t.folder()/"lagrangian/fluid"));
    EXPECT_TRUE(isFile(t.folder()/"p"));
}

//- Times without a manifest are taken where they have particles
TEST(Manifest, latestWholeTime)
{
    const WrittenTime t;
    t.write("1/lagrangian/fluid/positions", "any");
    t.write("3/U", "any");
    instantList times(3);
    for (label i = 0; i < 3; ++i) times[i] = instant(i + 1, name(i + 1));
    instant latest;
    const auto warned = [&](bool expected)
    {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        EXPECT_EQ(latestWholeTime(t.path(), times, latest), expected);
        return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
    };
    EXPECT_TRUE(holds(warned(true), "Time 3 is passed over: it holds no particles"));
    EXPECT_EQ(latest.name(), "2");
    timeManifest::begin(t.folder());
    EXPECT_TRUE(holds(warned(true), "Time 2 is passed over: the run that wrote it was stopped"));
    EXPECT_EQ(latest.name(), "1");
    times = instantList(1, instant(3, "3"));
    warned(false);
}
