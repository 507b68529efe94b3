// SPDX-License-Identifier: GPL-3.0-or-later
/*  Entries that are read one by one: values, defaults, and the message of each that is wrong. */

#include "checkedDictionary.H"
#include "dimensionSets.H"
#include "scratchCase.hpp"
#include "singleValues.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    using Read = std::function<void(checkedDictionary&)>;

    std::string said(const std::string& text, const Read& read)
    {
        const dictionary dict(entries(text));
        checkedDictionary checked(dict);
        return messageOf([&]() { read(checked); });
    }

    template<class T>
    T value(const std::string& text, const std::function<T(checkedDictionary&)>& read)
    {
        const dictionary dict(entries(text));
        checkedDictionary checked(dict);
        return read(checked);
    }

    scalar number(const std::string& text, const std::function<scalar(checkedDictionary&)>& read)
    {
        return value<scalar>(text, read);
    }
}

TEST(CheckedDictionary, numbers)
{
    const Read positive = [](checkedDictionary& d) { d.positive("a"); };
    EXPECT_EQ(said("a 1e-18;", positive), "");
    EXPECT_EQ(said("a 0;", positive), "Entry a is 0: it must be positive");
    EXPECT_EQ(said("a 1e-19;", positive), "Entry a is 1e-19: it must be at least 1e-18");
    EXPECT_EQ(said("a 1e21;", positive), "Entry a is 1e+21: it must be at most 1e20");
    EXPECT_TRUE(holds(said("", positive), "Entry 'a' not found")) << said("", positive);
    EXPECT_EQ(said("a { b 1; }", positive), "Entry a must be a value, not a dictionary");
    EXPECT_NE(said("a 1 2;", positive), "");
    EXPECT_NE(said("a word;", positive), "");
    EXPECT_EQ(number("a 3;", [](checkedDictionary& d) { return d.positive("a", 7); }), 3);
    EXPECT_EQ(number("", [](checkedDictionary& d) { return d.positive("a", 7); }), 7);
    EXPECT_EQ(number("", [](checkedDictionary& d) { return d.notNegative("a", 7); }), 7);
    EXPECT_EQ(said("a -1;", [](checkedDictionary& d) { d.notNegative("a", 0); }),
        "Entry a is -1: it must be zero or positive");
    EXPECT_EQ(said("a 3;", [](checkedDictionary& d) { d.between("a", 0, -1, 2); }),
        "Entry a is 3: it must be from -1 to 2");
    EXPECT_EQ(said("a 1.5;", [](checkedDictionary& d) { d.whole("a", 0, -1, 2); }),
        "Entry a is 1.5: it must be a whole number");
    EXPECT_EQ(said("a (1e6 0 0);", [](checkedDictionary& d) { d.velocity("a"); }),
        "Entry a is 1e+06: it must be a velocity of at most 1e5 m/s");
}

TEST(CheckedDictionary, wordsInPlaceOfNumbers)
{
    const auto none = [](checkedDictionary& d) { return d.notNegativeOrNone("a", 7); };
    const auto automatic = [](checkedDictionary& d) { return d.positiveOrAuto("a"); };
    EXPECT_EQ(number("a none;", none), 0);
    EXPECT_EQ(number("a 2;", none), 2);
    EXPECT_EQ(number("", none), 7);
    EXPECT_EQ(number("a auto;", automatic), 0);
    EXPECT_EQ(number("", automatic), 0);
    EXPECT_EQ(number("a 2;", automatic), 2);
    EXPECT_TRUE(holds(said("a nome;", none), "Entry a has the unknown word nome; valid are "));
    EXPECT_TRUE(holds(said("a autom;", automatic), "did you mean auto?"));
}

TEST(CheckedDictionary, dimensions)
{
    const auto rho = [](checkedDictionary& d) { return d.positive("rho", dimDensity); };
    EXPECT_EQ(number("rho 5;", rho), 5);
    EXPECT_EQ(number("rho [1 -3 0 0 0 0 0] 5;", rho), 5);
    EXPECT_EQ(number("rho rho [1 -3 0 0 0 0 0] 5;", rho), 5);
    EXPECT_EQ(said("rho [0 2 -1 0 0 0 0] 5;", rho),
        "Entry rho has the dimensions [0 2 -1 0 0 0 0]: they must be [1 -3 0 0 0 0 0]");
    EXPECT_TRUE(holds(said("rho heavy;", rho), "Entry rho has the unknown word heavy"));
    EXPECT_EQ(said("rho -5;", rho), "Entry rho is -5: it must be positive");
    EXPECT_NE(said("rho 5 6;", rho), "");
}

TEST(CheckedDictionary, choicesAndWhatIsLeft)
{
    const Enum<int> names({{1, "one"}, {2, "two"}});
    const auto choice = [&](checkedDictionary& d) { return d.choice("a", names, 7); };
    EXPECT_EQ(value<int>("a two;", choice), 2);
    EXPECT_EQ(value<int>("", choice), 7);
    EXPECT_EQ(said("a tow;", choice),
        "Entry a has the unknown word tow; valid are (one two); did you mean two?");
    const auto either = [](checkedDictionary& d) { return d.either("a", "yes", "no", false); };
    EXPECT_TRUE(value<bool>("a yes;", either));
    EXPECT_FALSE(value<bool>("a no;", either));
    EXPECT_TRUE(holds(said("a on;", either), "Entry a has the unknown word on; valid are ("));
    const Read sub = [](checkedDictionary& d) { d.subDict("a"); d.end(); };
    EXPECT_EQ(said("a { b 1; }", sub), "");
    EXPECT_EQ(said("", sub), "");
    EXPECT_EQ(said("a 1;", sub), "Entry a must be a dictionary: a { ... }");
    EXPECT_EQ(said("a { } aa 3;", sub), "Unknown entry aa; valid are (a)");
}

TEST(SingleValues, oneValueAnEntry)
{
    for (const char* one : {"1", "word", "(1 2 3)", "3(1 2 3)", "((1 2) (3 4))",
             "a [0 1 0 0 0 0 0] 3", "[0 1 0 0 0 0 0] (1 2 3)", "\"text\"", "table ((0 1) (1 2))"})
    {
        const dictionary dict(entries(std::string("x ") + one + ';'));
        EXPECT_TRUE(isSingleValue(dict.lookup("x"))) << one;
    }
    for (const char* more : {"1 2", "(1 2) 3", "[0 1 0 0 0 0 0] 1 2", "1 y 2"})
    {
        const dictionary dict(entries(std::string("x ") + more + ';'));
        EXPECT_FALSE(isSingleValue(dict.lookup("x"))) << more;
    }
    EXPECT_EQ(messageOf([]() { requireSingleValues(entries("a 1; b { c 1 2; }"), "Motion m"); }),
        "Motion m: entry c holds more than its value");
}
