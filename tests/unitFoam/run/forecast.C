// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a dry run foretells: how often things are done, and files that are formatted but not
    written. */

#include "OSspecific.H"
#include "runForecast.H"
#include "scalarField.H"
#include "testTime.H"
#include "timeWriter.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- In 2 s of 100 samples, of which 4 are written times
    scalar times(const std::string& text, const char* what = "write")
    {
        return timesOf(entries(text), what, 2, 100, 4);
    }

    writtenFile tenThousandNumbers()
    {
        scalarField values(10000);
        forAll(values, i) values[i] = i + 0.25;
        writtenFile file
        (
            IOobject("numbers", "1", testTime(), IOobject::NO_READ, IOobject::NO_WRITE, false),
            "scalarField", IOstream::ASCII, IOstream::UNCOMPRESSED
        );
        file.add(listBody(std::move(values)));
        return file;
    }
}


TEST(Forecast, TimesByControl)
{
    EXPECT_EQ(times(""), 100);
    EXPECT_EQ(times("writeControl timeStep; writeInterval 7;"), 14);
    EXPECT_EQ(times("writeControl adjustableRunTime; writeInterval 0.1;"), 20);
    EXPECT_EQ(times("writeControl runTime; writeFrequency 0.3;"), 6);
    EXPECT_EQ(times("writeControl writeTime;"), 4);
    EXPECT_EQ(times("writeControl outputTime; writeInterval 2;"), 2);
    EXPECT_EQ(times("writeControl onEnd;"), 1);
    EXPECT_EQ(times("writeControl none;"), 0);
    EXPECT_EQ(times("outputControl runTime; outputInterval 0.5;"), 4);
    EXPECT_EQ(times("writeControl none; executeInterval 10;", "execute"), 10);
}


TEST(Forecast, TrialFormatsAndWritesNothing)
{
    const writtenFile file(tenThousandNumbers());
    int64_t bytes = 0;
    {
        const timeWriter::trial trial;
        timeWriter::ofRun().put(tenThousandNumbers());
        bool done = false;
        timeWriter::ofRun().put(timeWriter::job([&]() { done = true; }));
        {
            const timeWriter::trial within;
            EXPECT_EQ(within.bytes(), 0);
        }
        EXPECT_TRUE(timeWriter::ofRun().onTrial());
        EXPECT_FALSE(done);
        EXPECT_GT(trial.seconds(), 0);
        bytes = trial.bytes();
    }
    EXPECT_FALSE(timeWriter::ofRun().onTrial());
    EXPECT_FALSE(isDir(file.path().path()));

    timeWriter::ofRun().put(tenThousandNumbers());
    EXPECT_EQ(fileSize(file.path()), bytes);
    rmDir(testTime().path());
}
