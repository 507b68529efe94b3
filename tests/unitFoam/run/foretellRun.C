// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a dry run says a run will take, of a module whose times are known. */

#include "runForecast.H"
#include "runningFluid.hpp"
#include "scratchCase.hpp"
#include "scriptedModule.hpp"

#include <gtest/gtest.h>
#include <sstream>

using namespace Foam;

namespace
{
    struct Forecast
    {
        ScratchCase c;
        ScriptedModule module;
        std::string said;

        explicit Forecast(const std::string& control) : c("endTime 2; deltaT 1; " + control) {}

        void of(const runEffort& effort, double sampleInterval, bool fieldsAreRead = false)
        {
            testing::internal::CaptureStdout();
            foretellRun(c.time(), module, effort, sampleInterval, 3, fieldsAreRead);
            said = testing::internal::GetCapturedStdout();
        }

        //- Seconds and number in a row of the table
        double number(const std::string& row, int column = 0) const
        {
            const std::size_t at = said.find("    " + row + ' ');
            EXPECT_NE(at, std::string::npos) << row << " in " << said;
            if (at == std::string::npos) return NAN;
            std::istringstream rest(said.substr(at + 4 + row.size()));
            std::string word;
            for (int k = 0; k <= column; ++k) rest >> word;
            return std::atof(word.c_str());
        }
    };
}

TEST(ForetellRun, table)
{
    Forecast f("writeControl runTime; writeInterval 0.5;");
    f.module.fields = true;
    f.module.fieldSeconds = 0.01;
    f.module.written = 1000;
    f.of({0.001, 10000}, 0.1);
    EXPECT_EQ(f.number("start"), 3);
    EXPECT_EQ(f.number("solver"), 10);
    EXPECT_EQ(f.number("solver", 2), 0);
    EXPECT_EQ(f.number("solver", 3), 20);
    EXPECT_NEAR(f.number("fields"), 0.04, 0.03);
    EXPECT_EQ(f.number("fields", 3), 4);
    EXPECT_EQ(f.number("function objects"), 0);
    EXPECT_NEAR(f.number("all"), 13 + f.number("fields") + f.number("writing"), 0.02);
    EXPECT_NEAR(f.number("start", 1), 100*3/f.number("all"), 0.1);
    EXPECT_TRUE(holds(f.said, "\nFiles: 4 times 865 B, formatted but not on disk\n")) << f.said;
    EXPECT_FALSE(holds(f.said, "Costs much")) << f.said;
    // a first time, and one that is timed
    EXPECT_EQ(f.module.updates, 2);
    // as a run of one step a sample
    f.of({0.001, 5000}, 0);
    EXPECT_EQ(f.number("solver"), 5);
    EXPECT_EQ(f.number("solver", 3), 5000);
    f.of({0, 5000}, 0.1);
    EXPECT_EQ(f.said, "");
}

TEST(ForetellRun, whatCostsMuch)
{
    Forecast f("writeControl runTime; writeInterval 0.5; writeAsynchronously no;");
    f.module.fieldSeconds = 0.01;
    f.module.writeSeconds = 0.02;
    f.of({0.001, 60}, 0.1, true);
    EXPECT_TRUE(holds(f.said,
        "Costs much: sampleInterval 0.1 s of system/controlDict is 3 steps; the solver is fastest "
        "where samples are farther apart\n")) << f.said;
    EXPECT_TRUE(holds(f.said, "Costs much: fields take ")) << f.said;
    EXPECT_TRUE(holds(f.said, " times the solver's time: they are brought to OpenFOAM at each "
                              "sample, for a function object of another library\n")) << f.said;
    EXPECT_TRUE(holds(f.said, "Costs much: writing takes ")) << f.said;
    EXPECT_TRUE(holds(f.said, " s a time: write less often by writeInterval, or pictures between "
                              "the states by stateInterval and pictureFields\n")) << f.said;
    EXPECT_NEAR(f.number("writing"), 0.08, 0.05);
    EXPECT_EQ(f.number("written meanwhile"), 0);
    f.of({0.001, 6000}, 0.1);
    EXPECT_FALSE(holds(f.said, "Costs much")) << f.said;
}

//- Those of riprap are timed and write nothing; others are named
TEST(ForetellRun, functionObjects)
{
    RunningSph run(tank(2, 1, 1, 10), "maxVelocity 2;",
        "endTime 2; writeControl none; functions { balance { type energyBalance; libs "
        "(\"libriprapFoam.so\"); writeControl runTime; writeInterval 0.5; timeStart 1; } rest { "
        "type fieldMinMax; } off { type none; enabled no; } }");
    run.start(0.1, {{point(0, 0, 0), point(1, 1, 0.5), Zero, 0.5}});
    ScriptedModule module;
    testing::internal::CaptureStdout();
    foretellRun(run.time(), module, {1e-8, 100}, 0.1, 0, false);
    const std::string said(testing::internal::GetCapturedStdout());
    EXPECT_TRUE(holds(said, "Not timed, since they may write: (rest)\n")) << said;
    EXPECT_TRUE(holds(said, "Costs much: function object balance takes ")) << said;
    EXPECT_TRUE(holds(said, "        balance ")) << said;
    // two in the second half of the run, and one at the start
    EXPECT_TRUE(holds(said, "  3 times\n")) << said;
    EXPECT_FALSE(isDir(run.path()/"postProcessing"));
    EXPECT_EQ(module.steps, 3);
}
