// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a time's particles were made from, compared with what the dictionary says now. */

#include "scratchCase.hpp"
#include "setParticlesRecord.H"
#include "IOdictionary.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(SetParticlesRecord, differences)
{
    const auto of = [](const char* then, const char* now)
    { return differences(entries(then), entries(now)); };
    EXPECT_TRUE(of("a 1; b { c (1 2); } d word;", "d word; b { c (1 2); } a 1;").empty());
    EXPECT_TRUE(of("a 0.123456789;", "a 0.1234567;").empty());
    EXPECT_EQ(of("a 0.01;", "a 0.02;"), wordList(1, word("a: 0.02, was 0.01", false)));
    EXPECT_EQ(of("b { c { d 1; } }", "b { c { d 2; } }"),
        wordList(1, word("b/c/d: 2, was 1", false)));
    EXPECT_EQ(of("a 1; b 2;", "b 2; c 3;"),
        wordList({word("a: not there, was 1", false), word("c: 3, was not there", false)}));
    EXPECT_EQ(of("a (1 2);", "a (1 2 3);").size(), 1);
    EXPECT_EQ(of("a one;", "a two;").size(), 1);
}

TEST(SetParticlesRecord, ofACase)
{
    ScratchCase c;
    const auto write = [&](const std::string& text)
    { c.writeDict("system/setParticlesDict", text); };
    const auto record = [&]()
    {
        const IOdictionary dict
        (
            IOobject("setParticlesDict", "system", c.time(), IOobject::MUST_READ,
                IOobject::NO_WRITE, false)
        );
        recordSetParticles(c.time(), dict);
    };
    const auto said = [&]() { return messageOf([&]() { requireSetParticles(c.time()); }); };
    EXPECT_EQ(said(), "");                              // nothing to compare
    const std::string regions("regions ( a { set fluid; source sphere; radius 0.1; } );");
    write("spacing 0.01; " + regions);
    record();
    EXPECT_EQ(said(), "");
    // numbers of the user's own count where they are used
    write("mine 3; spacing 0.01; " + regions);
    EXPECT_EQ(said(), "");
    write("spacing 0.02; regions ( a { set fluid; source sphere; radius 0.2; } );");
    EXPECT_TRUE(holds(said(), "spacing: 0.02, was 0.01")) << said();
    EXPECT_TRUE(holds(said(), "regions/a/radius: 0.2, was 0.1")) << said();
    EXPECT_TRUE(holds(said(), "Run setParticles, or remove that file"));
    rm(c.path()/"system/setParticlesDict");
    EXPECT_EQ(said(), "");
}
