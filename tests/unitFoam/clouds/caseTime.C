// SPDX-License-Identifier: GPL-3.0-or-later
/*  Times of a case: which one a run starts from, and what is left of those that it writes. */

#include "boxMesh.hpp"
#include "caseTime.H"
#include "commandLine.hpp"
#include "pictures.H"
#include "scratchCase.hpp"
#include "sceneCloud.H"
#include "timeManifest.H"
#include "timeWriter.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- A case on disk, with times of some kinds
    struct TimesCase : ScratchCase
    {
        autoPtr<caseTime> run;

        void control(const std::string& entries) const
        {
            writeDict("system/controlDict",
                "endTime 4; deltaT 1; writeControl timeStep; writeInterval 1; " + entries);
        }

        //- Whole, as riprap writes it
        void whole(const std::string& name, bool picture = false) const
        {
            timeManifest::begin(path()/name);
            writeDict(name + "/lagrangian/fluid/positions", "// **** //");
            write(name + "/lagrangian/fluid/positions",
                "/*--*/\n0()\n// " + std::string(73, '*') + " //\n");
            timeManifest::finish(path()/name, fileSums(), picture);
        }

        void start()
        {
            run.clear();
            run = caseTime::New(arguments(path()), false);
        }

        std::string said()
        {
            return messageOf([&]() { start(); });
        }

        bool there(const std::string& name) const { return isDir(path()/name); }
    };

    //- Three particles
    class Three : public sceneCloud
    {
        void fill(particleCloud& p) const override
        {
            p.position = pointField({{0.5, 0.5, 0.5}, {0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}});
            p.labels.set("id", labelField({2, 0, 1}));
            p.scalars.set("p", scalarField(3, 5));
        }

        void addProperties(dictionary&) const override {}

        void writeState(bool picture) const override
        {
            if (picture) return;
            IOdictionary state(IOobject("state", time().timeName(), "uniform/riprap", time(),
                IOobject::NO_READ, IOobject::NO_WRITE, false));
            state.add("value", time().value());
            state.regIOobject::write();
        }

    public:

        using sceneCloud::sceneCloud;
        wordList stateFiles() const override { return wordList({"state"}); }
    };

    //- A run that writes them
    struct WrittenRun : TimesCase
    {
        autoPtr<polyMesh> mesh;
        autoPtr<Three> cloud;

        explicit WrittenRun(const std::string& entries)
        {
            control("startFrom startTime; startTime 0; " + entries);
            start();
            mesh = BoxMesh().make(run());
            mesh->setInstance("constant");
            cloud.reset(new Three(mesh(), "fluid"));
        }

        //- What the log says
        std::string step()
        {
            ++run();
            testing::internal::CaptureStdout();
            run->write();
            run->finishWrite();
            run->settle();
            return testing::internal::GetCapturedStdout();
        }

        ~WrittenRun()
        {
            // tests that follow write whole times
            pictures::ofRun().next(run(), true);
            cloud.clear();
            mesh.clear();
            run.clear();
        }
    };
}

TEST(CaseTime, startsFromTheLatestWholeOne)
{
    TimesCase c;
    c.control("startFrom latestTime;");
    c.whole("0");
    c.whole("1.5");
    c.start();
    EXPECT_EQ(c.run->value(), 1.5);
    timeManifest::begin(c.path()/"2");
    c.whole("3", true);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    c.start();
    const std::string said(testing::internal::GetCapturedStdout()
        + testing::internal::GetCapturedStderr());
    EXPECT_EQ(c.run->value(), 1.5);
    EXPECT_EQ(c.run->controlDict().get<word>("startFrom"), "startTime");
    EXPECT_TRUE(holds(said,
        "Time 2 is passed over: the run that wrote it was stopped before the last file")) << said;
    EXPECT_TRUE(holds(said,
        "Time 3 is passed over: it is a picture, without the state to start from")) << said;
    // as it is told; and any, where times are selected by options
    c.control("startFrom firstTime;");
    c.start();
    EXPECT_EQ(c.run->value(), 0);
    c.control("startFrom startTime; startTime 2;");
    c.run = caseTime::New(arguments(c.path()), true);
    EXPECT_EQ(c.run->value(), 2);
}

TEST(CaseTime, timesThatAreNoStart)
{
    TimesCase c;
    c.control("startFrom startTime; startTime 2;");
    EXPECT_EQ(c.said(), "");
    timeManifest::begin(c.path()/"2");
    EXPECT_EQ(c.said(),
        "Time 2 is not whole: the run that wrote it was stopped before the last file. Remove the "
        "directory \"" + c.path() + "/2\", or start from another time: startFrom latestTime takes "
        "the latest whole one");
    c.whole("2", true);
    EXPECT_EQ(c.said(),
        "Time 2 is a picture, without the state to start from (stateInterval): start from another "
        "time, startFrom latestTime takes the latest that has it");
    c.control("startFrom latestTime;");
    EXPECT_TRUE(holds(c.said(), "Time 2 is a picture"));
    c.whole("2");
    c.write("2/lagrangian/fluid/positions", "/*--*/\n");
    EXPECT_TRUE(holds(c.said(),
        "Time 2 is damaged (lagrangian/fluid/positions is cut short: 7 of 91 bytes): remove the "
        "folder ")) << c.said();
}

TEST(CaseTime, olderTimesGo)
{
    WrittenRun w("purgeWrite 2; endTime 5;");
    for (int k = 1; k <= 4; ++k)
    {
        EXPECT_EQ(w.step(), "Written " + std::to_string(k) + ": 3 particles\n\n");
        EXPECT_EQ(int(timeManifest::of(w.path()/name(k)).is), int(timeManifest::kind::whole));
        EXPECT_TRUE(w.there(name(k)));
        EXPECT_EQ(w.there(name(k - 2)), false) << k;
        EXPECT_EQ(w.there(name(k - 1)), k > 1) << k;
    }
    const particleCloud back(readParticleCloud(w.mesh(), "fluid"));
    EXPECT_EQ(back.labels["id"], labelField({0, 1, 2}));
    EXPECT_NEAR(mag(back.position[2] - point(0.5, 0.5, 0.5)), 0, 1e-12);
}

//- Of pictures the latest two are kept, and the state that a run could go on from
TEST(CaseTime, picturesBetweenStates)
{
    for (const std::string asynchronous : {"yes", "no"})
    {
        WrittenRun w("purgeWrite 1; stateInterval 3; pictureFields (id); endTime 10; "
                     "writeAsynchronously " + asynchronous + ';');
        EXPECT_EQ(messageOf([&]() { pictures::check(w.run()); }), "");
        pictures::ofRun().requireState();
        EXPECT_EQ(w.step(), "Written 1: 3 particles\n\n");
        EXPECT_EQ(w.step(), "Written 2: 3 particles, a picture\n\n");
        EXPECT_FALSE(isFile(w.path()/"2/lagrangian/fluid/p"));
        EXPECT_TRUE(isFile(w.path()/"2/lagrangian/fluid/id"));
        EXPECT_FALSE(isFile(w.path()/"2/uniform/riprap/state"));
        EXPECT_EQ(int(timeManifest::of(w.path()/"2").is), int(timeManifest::kind::picture));
        w.step();
        EXPECT_TRUE(w.there("1"));
        EXPECT_FALSE(w.there("2"));
        EXPECT_EQ(w.step(), "Written 4: 3 particles\n\n");
        EXPECT_TRUE(isFile(w.path()/"4/uniform/riprap/state"));
        EXPECT_TRUE(isFile(w.path()/"4/lagrangian/fluid/p"));
        EXPECT_FALSE(w.there("1"));
        EXPECT_FALSE(w.there("3"));
    }
}

TEST(CaseTime, theLastTimeHoldsTheState)
{
    WrittenRun w("stateInterval 5; endTime 2;");
    pictures::ofRun().requireState();
    w.step();
    EXPECT_TRUE(isFile(w.path()/"1/uniform/riprap/state"));
    w.step();
    EXPECT_TRUE(isFile(w.path()/"2/uniform/riprap/state"));
    WrittenRun u(
        "stateInterval 5; endTime 1; deltaT 0.1; writeControl runTime; writeInterval 0.4;");
    pictures::ofRun().requireState();
    for (int k = 0; k < 4; ++k) u.step();
    EXPECT_TRUE(isFile(u.path()/"0.4/uniform/riprap/state"));
    for (int k = 0; k < 4; ++k) u.step();
    EXPECT_TRUE(isFile(u.path()/"0.8/uniform/riprap/state"));
}

TEST(CaseTime, whatIsTold)
{
    WrittenRun w("stateInterval 2; pictureFields (id pp);");
    EXPECT_EQ(messageOf([&]() { pictures::check(w.run()); }),
        "Entry pictureFields names pp, which no cloud has; there are (id p)");
    ++w.run();
    EXPECT_EQ(messageOf([&]() { w.run->requireWritten(); }),
        "Time 1 was due to be written, but OpenFOAM v" + std::to_string(foamVersion::api)
        + " has not asked for its files: riprap was built for v" + std::to_string(OPENFOAM));
    testing::internal::CaptureStdout();
    w.run->write();
    EXPECT_EQ(messageOf([&]() { w.run->requireWritten(); }), "");
    // a guard has stopped the run
    w.run->finishAtStop();
    testing::internal::GetCapturedStdout();
    EXPECT_EQ(int(timeManifest::of(w.path()/"1").is), int(timeManifest::kind::picture));
    EXPECT_EQ(messageOf([&]() { w.run->checkWriting(); }), "");
}
