// SPDX-License-Identifier: GPL-3.0-or-later
/*  Entries that stand in a file for the sake of others: $name, and what is included. */

#include "checkedDictionary.H"
#include "IFstream.H"
#include "macroUse.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- What is said of a file that has the entry length
    struct MacroFile : ScratchCase
    {
        std::string warnings;

        std::string said(const std::string& text, const wordList& elsewhere = wordList())
        {
            write("file", text);
            IFstream is(path()/"file");
            const dictionary dict(is);
            checkedDictionary checked(dict);
            checked.found("length");
            testing::internal::CaptureStdout();
            testing::internal::CaptureStderr();
            std::string error(messageOf([&]() { checked.endButMacros(elsewhere); }));
            warnings = testing::internal::GetCapturedStdout()
                + testing::internal::GetCapturedStderr();
            return error;
        }
    };

    std::string unknown(const std::string& entry, const std::string& more = "")
    {
        return "Unknown entry " + entry
            + "; valid are (length), and numbers and words that the file uses as $name" + more;
    }
}

TEST(Macros, whatTheFileUses)
{
    MacroFile f;
    for (const char* text : {"h 0.5;\nlength $h;\n", "h wide;\nlength ${h};\n",
             "h 2; length $:h;", "h 2; length ${:h};"})
    {
        EXPECT_EQ(f.said(text), "") << text;
        EXPECT_EQ(f.warnings, "") << text;
    }
}

TEST(Macros, whatItDoesNotUse)
{
    MacroFile f;
    EXPECT_EQ(f.said("length 1; colour blue;"), unknown("colour"));
    EXPECT_EQ(f.said("length 1; colour blue; // as $colour\n"), unknown("colour"));
    EXPECT_EQ(f.said("length 1; colour blue; /* $colour */"), unknown("colour"));
    EXPECT_EQ(f.said("colours 3; length $colours; colour blue;"), unknown("colour"));
    EXPECT_EQ(f.said("length 1; lenght 2;"), unknown("lenght", "; did you mean length?"));
    EXPECT_EQ(f.said("length 1; spacing 2;", wordList({"spacing"})), unknown("spacing"));
    EXPECT_EQ(f.said("length 1; part { a 1; }"), unknown("part"));
    EXPECT_EQ(f.said("length 1; depth 2; height 3;"), "");
    EXPECT_TRUE(holds(f.warnings, "Numbers that nothing uses: (depth height) (foamDictionary "
                                  "replaces $name by its value); entries of this dictionary are "
                                  "(length)")) << f.warnings;
}

TEST(Macros, whatIsIncluded)
{
    MacroFile f;
    f.write("more", "depth 3; colour blue;");
    EXPECT_EQ(f.said("#include \"more\"\nlength $depth;\n"),
        unknown("colour", "; it stands in a file that is included (more)"));
    f.write("more", "depth 3; height 4;");
    EXPECT_EQ(f.said("#include \"more\"\nlength $depth;\n"), "");
    EXPECT_EQ(f.warnings, "");
    // the directive itself is no use
    f.write("colour", "depth 3;");
    EXPECT_EQ(f.said("#include \"colour\"\nlength 1; colour blue;"), unknown("colour"));
}

TEST(Macros, heldForNothing)
{
    MacroFile f;
    f.write("file", "b 3; c $b; d 4; // $d\n");
    EXPECT_FALSE(heldForNothing(f.path()/"file", "b"));
    EXPECT_TRUE(heldForNothing(f.path()/"file", "c"));
    EXPECT_TRUE(heldForNothing(f.path()/"file", "d"));
    EXPECT_FALSE(heldForNothing(f.path()/"file", "e"));
    EXPECT_FALSE(heldForNothing(f.path()/"none", "d"));
}
