// SPDX-License-Identifier: GPL-3.0-or-later
/*  Signals, unknown solvers, what a program says of itself. */

#include "boxMesh.hpp"
#include "buildInfo.H"
#include "documentation.H"
#include "foamVersions/foamVersions.H"
#include "scratchCase.hpp"
#include "scriptedModule.hpp"
#include "stopSignals.H"
#include "StringStream.H"

#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>

using namespace Foam;

namespace
{
    //- With a word of the command line
    void show(const std::string& option, const fileName& page, const fileName& source)
    {
        std::string program("riprap"), word(option);
        char* words[] = {&program[0], &word[0], nullptr};
        showDocumentation(2, words, page, source);
    }

    //- Where riprap is, as the program that shows and ends finds it: it begins anew, and is told by
    //  the environment
    struct Documents
    {
        std::unique_ptr<ScratchCase> c;
        const std::string before;

        Documents() : before(getEnv("RIPRAP_DIR"))
        {
            GTEST_FLAG_SET(death_test_style, "threadsafe");
            // however it was called
            std::vector<std::string> words(testing::internal::GetInjectableArgvs());
            words[0] = std::filesystem::read_symlink("/proc/self/exe").string();
            testing::internal::SetInjectableArgvs(words);
            if (testing::internal::InDeathTestChild()) return;
            c = std::make_unique<ScratchCase>();
            c->write("docs/glossary.md", "text");
            c->write("src/riprapFoam/run/documentation.C", "source");
            setEnv("RIPRAP_DIR", c->path(), true);
        }

        ~Documents()
        {
            setEnv("RIPRAP_DIR", before, true);
            unsetenv("FOAM_DOC_BROWSER");
            testing::internal::ClearInjectableArgvs();
        }

        std::string shown(const std::string& file) const { return c ? c->read(file) : ""; }

        void browse(const std::string& command) const
        {
            if (c) setEnv("FOAM_DOC_BROWSER", command + " " + c->path() + "/shown", true);
        }

        void expectEnd(const char* option, int code) const
        {
            EXPECT_EXIT
            (
                show(option, "docs/glossary", "src/riprapFoam/run/documentation.C"),
                testing::ExitedWithCode(code), ""
            );
        }
    };
}

TEST(StopSignals, theFirstAsksAndTheOldActionComesBack)
{
    static int before = 0;
    const auto old = std::signal(SIGTERM, [](int) { ++before; });
    ScriptedModule module;
    for (const int signal : {SIGTERM, SIGINT})
    {
        const stopSignals signals(module);
        EXPECT_EQ(signals.received(), nullptr);
        module.interrupts = 0;
        std::raise(signal);
        EXPECT_EQ(module.interrupts, 1);
        EXPECT_STREQ(signals.received(), signal == SIGTERM ? "SIGTERM" : "SIGINT");
        // the second kills
        EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_DFL);
        EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL);
    }
    EXPECT_EQ(before, 0);
    std::raise(SIGTERM);
    EXPECT_EQ(before, 1);
    EXPECT_EQ(module.interrupts, 1);
    std::signal(SIGTERM, old);
}

//- Those of riprap's libraries and of the user's are named
TEST(SolverModule, unknownNames)
{
    ScratchCase c;
    const std::string folders[2] = {getEnv("RIPRAP_LIBBIN"), getEnv("FOAM_USER_LIBBIN")};
    c.write("riprap/libsphDemSolver.so", "");
    c.write("riprap/libSolver.so", "");
    c.write("user/libmineSolver.so", "");
    c.write("user/libother.so", "");
    setEnv("RIPRAP_LIBBIN", c.path()/"riprap", true);
    setEnv("FOAM_USER_LIBBIN", c.path()/"user", true);
    autoPtr<fvMesh> mesh(BoxMesh().make<fvMesh>(c.time()));
    const std::string said(messageOf([&]() { solverModule::New("sphDm", c.time(), mesh()); }));
    setEnv("RIPRAP_LIBBIN", folders[0], true);
    setEnv("FOAM_USER_LIBBIN", folders[1], true);
    EXPECT_EQ(said,
        "Unknown solver sphDm (entry solver, or option -solver): library "
        "\"libsphDmSolver.so\" cannot be loaded or has none of that name; available are "
        "(mine sphDem); did you mean sphDem?");
}

TEST(BuildInfo, threeLines)
{
    OStringStream os;
    writeBuildInfo(os);
    const std::string said(os.str());
    EXPECT_EQ(said.find("riprap : "), 0u) << said;
    EXPECT_TRUE(holds(said, ", for OpenFOAM v" + std::to_string(OPENFOAM) + "\nFlags  : "));
    EXPECT_TRUE(holds(said, "\nGPU    : "));
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 4);
}

//- Shown by the browser, and the program ends
TEST(DocumentationDeathTest, pagesAndSources)
{
    const Documents d;
    // no such option: nothing happens
    show("-case", "docs/glossary", "src/riprapFoam/run/documentation.C");
    d.browse("cp %f");
    d.expectEnd("-doc", 0);
    EXPECT_EQ(d.shown("shown"), d.c ? "text" : "");
    // the site's page, where it was made
    if (d.c) d.c->write("platforms/docs/docs/glossary.html", "site");
    d.expectEnd("-doc", 0);
    EXPECT_EQ(d.shown("shown"), d.c ? "site" : "");
    d.expectEnd("-doc-source", 0);
    EXPECT_EQ(d.shown("shown"), d.c ? "source" : "");
    if (d.c) { EXPECT_TRUE(rm(d.c->path()/"src/riprapFoam/run/documentation.C")); }
    d.expectEnd("-doc-source", 1);
}
