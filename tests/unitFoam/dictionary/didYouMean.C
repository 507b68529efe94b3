// SPDX-License-Identifier: GPL-3.0-or-later
/*  Hints for misspelt words: near ones alone. */

#include "checkedDictionary.H"
#include "didYouMean.H"
#include "error.H"
#include "testTime.H"
#include "wordList.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    std::string hint(const char* typed, const wordList& valid) { return didYouMean(typed, valid); }
}


TEST(DidYouMean, SlipsAreCounted)
{
    EXPECT_EQ(slips("spacing", "spacing"), 0);
    EXPECT_EQ(slips("spaceing", "spacing"), 1);
    EXPECT_EQ(slips("spcaing", "spacing"), 1);
    EXPECT_EQ(slips("spcaing", "spacing", false), 2);
    EXPECT_EQ(slips("", "dem"), 3);
    EXPECT_EQ(slips("kitten", "sitting"), 3);
}


TEST(DidYouMean, NamesTheNearest)
{
    EXPECT_EQ(hint("solid", {"fluid", "solids"}), "; did you mean solids?");
    EXPECT_EQ(hint("wendlandc2", {"cubicSpline", "wendlandC2", "wendlandC4"}),
        "; did you mean wendlandC2?");
    EXPECT_EQ(hint("dme", {"dem", "sphDem", "picDem"}), "; did you mean dem?");
    EXPECT_EQ(hint("e", {"rho", "E", "nu"}), "; did you mean E?");
}


TEST(DidYouMean, IsSilentWhereNothingIsNearOrTwoAreAlike)
{
    EXPECT_EQ(hint("cone", {"box", "cylinder", "sphere"}), "");
    EXPECT_EQ(hint("wendlandC3", {"wendlandC2", "wendlandC4"}), "");
    EXPECT_EQ(hint("mu", {"nu", "rho"}), "");
    EXPECT_EQ(hint("numbers", {"<number>"}), "");
    EXPECT_EQ(hint("spacing", wordList()), "");
    // Twice the same word is one
    EXPECT_EQ(hint("wals", {"walls", "walls"}), "; did you mean walls?");
}


TEST(DidYouMean, StandsBehindTheValidWords)
{
    const dictionary dict(entries("spaceing 1; set solid;"));
    const bool before = FatalIOError.throwExceptions();
    std::string entry, value;
    checkedDictionary checked(dict);
    checked.found("set");
    checked.found("spacing");
    try { checked.end(); }
    catch (const IOerror& e) { entry = e.message(); }
    try { checked.unknownWord("set", "solid", {"fluid", "solids"}); }
    catch (const IOerror& e) { value = e.message(); }
    FatalIOError.throwExceptions(before);
    EXPECT_EQ(entry, "Unknown entry spaceing; valid are (set spacing); did you mean spacing?");
    EXPECT_EQ(value,
        "Entry set has the unknown word solid; valid are (fluid solids); did you mean solids?");
}
