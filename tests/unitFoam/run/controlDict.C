// SPDX-License-Identifier: GPL-3.0-or-later
/*  system/controlDict: what is taken, and what is said of the rest. */

#include "checkControlDict.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    std::string said(const std::string& text)
    {
        ScratchCase c;
        c.writeDict("system/controlDict", text);
        return messageOf([&]() { checkControlDict(c.path()/"system/controlDict"); });
    }
}

TEST(CheckControlDict, whatIsTaken)
{
    EXPECT_EQ(said("endTime 3; deltaT 1; writeControl runTime; writeInterval 0.5; purgeWrite 0; "
                   "writeFormat binary; writeCompression uncompressed; timeFormat scientific; "
                   "runTimeModifiable 1; sampleInterval 0; stateInterval 3; pictureFields (U); "
                   "writePrecision 12; timePrecision 8; writeAsynchronously no; \"ma.*Co\" 1; "
                   "myOwnNumber 5; a 1;"), "");
    EXPECT_EQ(said("runTimeModifiable none;"), "");
    ScratchCase c;
    EXPECT_EQ(messageOf([&]() { checkControlDict(c.path()/"system/none"); }), "");
}

TEST(CheckControlDict, slips)
{
    EXPECT_EQ(said("endTme 3;"), "Unknown entry endTme: is endTime meant?");
    EXPECT_EQ(said("writeIntervl 3;"), "Unknown entry writeIntervl: is writeInterval meant?");
    EXPECT_EQ(said("lib (a);"), "Unknown entry lib: is libs meant?");
    EXPECT_EQ(said("maxHeight 3;"), "");
}

TEST(CheckControlDict, wordsAndNumbers)
{
    EXPECT_EQ(said("writeFormat binry;"), "Entry writeFormat has the unknown word binry; valid are "
                                          "(ascii binary); did you mean binary?");
    EXPECT_EQ(said("writeCompression gzip;"),
        "Entry writeCompression has the unknown word gzip; valid are (on off yes no true false "
        "compressed uncompressed)");
    EXPECT_EQ(said("runTimeModifiable maybe;"),
        "Entry runTimeModifiable has the unknown word maybe; valid are (on off yes no true false y "
        "n t f none)");
    EXPECT_EQ(said("timeFormat genral;"), "Entry timeFormat has the unknown word genral; valid are "
                                          "(general fixed scientific); did you mean general?");
    EXPECT_TRUE(
        holds(said("stateInterval 0;"), "Entry stateInterval is 0: it must be from 1 to 2"));
    EXPECT_TRUE(holds(said("purgeWrite -1;"), "Entry purgeWrite is -1: it must be from 0 to 2"));
    EXPECT_EQ(said("writePrecision 101;"), "Entry writePrecision is 101: it must be from 1 to 100");
    EXPECT_EQ(said("pictureFields (U);"),
        "Entry pictureFields without stateInterval: every written time holds the state and all "
        "fields");
    EXPECT_EQ(said("sampleInterval -1;"), "Entry sampleInterval is -1: it must be zero (every "
                                          "particle step) or positive, at least 1e-12");
    EXPECT_EQ(said("writeControl runTime; writeInterval 0;"),
        "Entry writeInterval is 0: it must be positive");
}
