// SPDX-License-Identifier: GPL-3.0-or-later
/*  functions of system/controlDict: what is refused before a run, and that nothing is written. */

#include "checkFunctionObjects.H"
#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string libs(" libs (\"libriprapFoam.so\"); ");

    //- A case with a sphere, whose functions these are; controlDict is there as a file, too
    struct FunctionsCase : RunningSolids
    {
        explicit FunctionsCase(const std::string& functions)
        :
            RunningSolids(rock(), BoxMesh(), "(0 0 -10)", "adjustTimeStep yes; " + functions)
        {
            writeDict("system/controlDict", functions);
            add(point(0.5, 0.5, 0.5), 0.1);
            start();
        }
    };

    std::string said(const std::string& functions)
    {
        FunctionsCase c("functions { " + functions + " }");
        return messageOf([&]() { checkFunctionObjects(c.time()); });
    }
}

TEST(CheckFunctionObjects, thoseThatAreOn)
{
    FunctionsCase c("functions { libs (\"libriprapFoam.so\"); a { type solidEnergies;" + libs
        + "} b { type groupMotion; enabled no;" + libs
        + "} c { type probes; libs "
          "(\"libOpenFOAM.so\"); } d { type brokenBonds; functionObjectLibs "
          "(\"libriprapFoam.so\"); "
          "} }");
    const std::vector<functionDict> all(functionDicts(c.time()));
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].name, "a");
    EXPECT_TRUE(all[0].ofRiprap);
    EXPECT_EQ(all[0].dict.get<word>("type"), "solidEnergies");
    EXPECT_EQ(all[1].name, "c");
    EXPECT_FALSE(all[1].ofRiprap);
    EXPECT_EQ(all[2].name, "d");
    EXPECT_TRUE(all[2].ofRiprap);
    FunctionsCase none("");
    EXPECT_TRUE(functionDicts(none.time()).empty());
}

//- They are made, whatever they do when they are made, and neither write nor log
TEST(CheckFunctionObjects, makesThemQuietly)
{
    FunctionsCase c("functions { a { type particleForces; patches (zMin); log yes;" + libs + "} }");
    testing::internal::CaptureStdout();
    checkFunctionObjects(c.time());
    const auto made = makeFunctionObject(functionDicts(c.time()).at(0), c.time());
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_FALSE(isDir(c.path()/"postProcessing"));
    EXPECT_EQ(made->type(), "particleForces");
    EXPECT_FALSE(functionObject::postProcess);
    c.run(0.01);
    ASSERT_TRUE(const_cast<functionObject&>(*made).write());
    EXPECT_EQ(c.table("force", "0", "a").rows.size(), 1u);
}

TEST(CheckFunctionObjects, mistakes)
{
    EXPECT_EQ(said("a { type solidEnergies;" + libs + "}"), "");
    const std::string unknown(said("a { type solidEnergie;" + libs + "}"));
    EXPECT_TRUE(holds(unknown, "Entry type has the unknown word solidEnergie; valid are ("));
    EXPECT_TRUE(holds(unknown, "); did you mean solidEnergies?")) << unknown;
    EXPECT_TRUE(holds(said("a { type solidEnergies; average 1;" + libs + "}"),
        "Unknown entry average; valid are"));
    EXPECT_EQ(said("a { type solidWallForce; average -1;" + libs + "}"),
        "Entry average of function object a is -1: it must not be negative");
    // of other libraries they are not made
    EXPECT_EQ(said("a { type what; libs (\"libOpenFOAM.so\"); }"), "");
    EXPECT_EQ(said("a { type { } }"), "Entry type must be a value, not a dictionary");
}

//- A value stands among the functions where it is used as a macro
TEST(CheckFunctionObjects, valuesAmongThem)
{
    const std::string a("a { type solidWallForce; average $width;" + libs + "}");
    EXPECT_EQ(said("width 0.1; " + a), "");
    EXPECT_EQ(said("width 0.1; height 1; " + a),
        "Entry height of functions must be a dictionary: height { type ..; }. A value may stand "
        "there where the file uses it as $height");
    EXPECT_EQ(said("errors warn; useNamePrefix no; width 1; " + a), "");
}
