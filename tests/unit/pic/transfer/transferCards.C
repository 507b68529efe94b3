/*  What each transfer scheme's card says, over the whole table: word and entries, the choice by
    words, what is refused, the user's guide. picTransfers.hpp: what the schemes do. A scheme that
    is added to the table is tested by these.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <map>
#include <set>
#include <gtest/gtest.h>
#include "guide.hpp"
#include "pic/openings/kinds.hpp"
#include "pic/terms/viscousSchemes.hpp"
#include "solvers/pic/transfer/picTransfers.hpp"

namespace riprap
{
namespace
{

//- Entries without a name of their own would be lost, a default that the struct does not have would
//  not be taken
TEST(TransferCards, EntriesAreComplete)
{
    std::set<std::string> words;
    for (const TransferCard& card : transfers())
    {
        EXPECT_TRUE(words.insert(card.word).second) << card.word << " is there twice";
        EXPECT_GT(std::string(card.text).size(), 10u) << card.word;
        EXPECT_FALSE(card.orders.empty()) << card.word;
        std::set<std::string> names;
        for (const TransferEntry& e : card.entries)
        {
            EXPECT_TRUE(names.insert(e.name).second) << card.word << " " << e.name;
            EXPECT_GT(std::string(e.what).size(), 0u) << e.name;
            if (e.yesNo || !e.required)
            {
                EXPECT_EQ(e.value(TransferProperties()), e.otherwise) << card.word << " " << e.name;
            }
            if (!e.yesNo) { EXPECT_TRUE(e.allows(e.typical)) << card.word << " " << e.name; }
            if (!e.yesNo) { EXPECT_FALSE(e.allows(-1)) << card.word << " " << e.name; }
            TransferProperties p;
            e.set(p, 0.25);
            EXPECT_EQ(e.value(p), e.yesNo ? 1 : 0.25) << card.word << " " << e.name;
        }
    }
}

//- The same entry means the same in all schemes that have it
TEST(TransferCards, SharedEntriesAgree)
{
    std::map<std::string, TransferEntry> seen;
    for (const TransferCard& card : transfers())
        for (const TransferEntry& e : card.entries)
        {
            const auto [at, isNew] = seen.emplace(e.name, e);
            if (isNew) continue;
            EXPECT_TRUE(at->second.number == e.number && at->second.yesNo == e.yesNo
                && at->second.range == e.range)
                << e.name;
            EXPECT_STREQ(at->second.unit, e.unit) << e.name;
        }
    EXPECT_EQ(seen.size(), allTransferEntries().size());
}

//- The scheme's typical numbers
PicConfig with(const TransferCard& card)
{
    PicConfig c;
    c.transfer = card.word;
    c.splineOrder = card.orders.back();
    for (const TransferEntry& e : card.entries) if (!e.yesNo) e.set(c.transferNumbers, e.typical);
    return c;
}

std::string whyNot(const PicConfig& c)
{
    try { transferOf(c); }
    catch (const std::invalid_argument& e) { return e.what(); }
    return "";
}

TEST(TransferCards, WordsFindTheirSchemes)
{
    for (const TransferCard& card : transfers())
        EXPECT_STREQ(transferOf(with(card)).word, card.word);
    PicConfig c;
    c.transfer = "harmonic";
    for (const TransferCard& card : transfers())
        EXPECT_NE(whyNot(c).find(card.word), std::string::npos) << whyNot(c);
}

TEST(TransferCards, WhatDoesNotGoIsRefused)
{
    for (const TransferCard& card : transfers())
    {
        for (const SplineCard& spline : splines())
        {
            PicConfig c = with(card);
            c.splineOrder = spline.order;
            const bool goes = std::count(card.orders.begin(), card.orders.end(), spline.order) > 0;
            EXPECT_EQ(whyNot(c).empty(), goes) << card.word << " " << spline.word;
            if (!goes) { EXPECT_NE(whyNot(c).find(spline.word), std::string::npos) << whyNot(c); }
        }
        PicConfig c = with(card);
        c.splineOrder = 9;
        EXPECT_NE(whyNot(c).find('9'), std::string::npos) << card.word;
        for (const TransferEntry& e : card.entries)
        {
            if (e.yesNo) continue;
            c = with(card);
            e.set(c.transferNumbers, -1);
            EXPECT_NE(whyNot(c).find(e.name), std::string::npos) << card.word;
        }
        const double longest = card.timeStep(with(card).transferNumbers);
        EXPECT_GT(longest, 0) << card.word;
        c = with(card);
        c.adjustTimeStep = false;
        c.fixedTimeStep = 0.5*longest;
        EXPECT_EQ(whyNot(c), "");
        c.fixedTimeStep = 2*longest;
        EXPECT_NE(whyNot(c).find(card.word), std::string::npos) << whyNot(c);
    }
}

//- Always, where `affine` asks for it, or never
TEST(TransferCards, TheGradientIsAChoiceOrNot)
{
    for (const TransferCard& card : transfers())
    {
        PicConfig c = with(card);
        EXPECT_EQ(keepsGradient(card, c.transferNumbers), card.gradient || card.has("affine"))
            << card.word;
        c.transferNumbers.affine = false;
        EXPECT_EQ(keepsGradient(card, c.transferNumbers), card.gradient) << card.word;
        EXPECT_FALSE(card.gradient && card.has("affine")) << card.word << " leaves no choice";
    }
}

//- The user's guide has each word and each entry
TEST(TransferCards, GuideHasThem)
{
    const Guide guide("docs/pic.md");
    if (guide.empty()) GTEST_SKIP() << "RIPRAP_DIR is not set";
    for (const auto& words : {wordsOf(transfers()), wordsOf(splines()), wordsOf<ViscousSchemes>(),
             wordsOf<OpeningKinds>()})
        guide.expectWords(words);
    for (const TransferEntry& e : allTransferEntries()) guide.expectEntry(e);
}

//- Other words of picProperties: another is refused with those there are
TEST(TransferCards, OtherFamilies)
{
    for (const std::string& w : wordsOf<ViscousSchemes>()) EXPECT_EQ(viscousSchemeOf(w).word, w);
    EXPECT_THROW(viscousSchemeOf("other"), std::invalid_argument);
    EXPECT_THROW(givenAt("other"), std::invalid_argument);
    for (const ViscousScheme& s : cardsOf<ViscousScheme, ViscousSchemes>())
    {
        // what limits the step never leaves the explicit scheme, what does not act has none
        if (s.limitsStep || !s.acts) { EXPECT_FALSE(s.implicit(2, 1)) << s.word; }
        else { EXPECT_TRUE(s.implicit(2, 1)) << s.word << " in too long a step"; }
    }
}

} // namespace
} // namespace riprap
