// SPDX-License-Identifier: GPL-3.0-or-later
/*  The text of dictionaries, before OpenFOAM reads it: what is an error, and what users may do. */

#include "inputFile.H"
#include "error.H"
#include "OSspecific.H"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace
{
    //- Of this program's own; it goes with it
    struct Scratch
    {
        Foam::fileName folder;

        Scratch()
        {
            char name[] = "/tmp/unitTestsFoamXXXXXX";
            folder = mkdtemp(name);
        }

        ~Scratch()
        {
            Foam::rmDir(folder);
        }
    };

    const Scratch scratch;
    const Foam::fileName& folder = scratch.folder;

    void file(const std::string& name, const std::string& text)
    {
        std::ofstream(folder/name) << text;
    }

    //- The message, empty if there is none
    std::string check(const std::string& text, double largest = 1e300)
    {
        file("case", text);
        const bool before = Foam::FatalIOError.throwExceptions();
        std::string said;
        try
        {
            Foam::checkInputFile(folder/"case", largest);
        }
        catch (const Foam::IOerror& e)
        {
            said = e.message() + " at " + Foam::fileName(e.ioFileName()).name() + ':'
                + std::to_string(e.ioStartLineNumber());
        }
        Foam::FatalIOError.throwExceptions(before);
        return said;
    }
}

TEST(InputFile, twoEntriesOfOneNameAreAnError)
{
    EXPECT_EQ(
        check("a 1;\nb 2;\na 1;\n"), "Entry a is there twice: in line 1 and in line 3 at case:3");
    EXPECT_EQ(check("walls { spacing 1; layers 2;\nspacing 1; }"),
        "Entry walls/spacing is there twice: in line 1 and in line 2 at case:2");
    EXPECT_EQ(check("walls { a 1; }\nwalls { b 2; }"),
        "Entry walls is there twice: in line 1 and in line 2 at case:2");
    EXPECT_EQ(check("regions ( a { x 1; } b { x 1;\n x 2; } );"),
        "Entry regions/b/x is there twice: in line 1 and in line 2 at case:2");
    EXPECT_EQ(check("regions ( a { x 1; }\na { y 1; } );"),
        "Entry regions/a is there twice: in line 1 and in line 2 at case:2");
    EXPECT_EQ(check("\"a.*\" 1;\n\"a.*\" 2;"),
        "Entry a.* is there twice: in line 1 and in line 2 at case:2");
    file("twice", "c 1; c 2;");
    EXPECT_EQ(
        check("#include \"twice\""), "Entry c is there twice: in line 1 and in line 1 at twice:1");
}

TEST(InputFile, whatCasesOverrideOnPurposeIsNone)
{
    file("defaults", "FoamFile { version 2.0; } a 1; walls { layers 3; }");
    for (const char* text :
    {
        "#include \"defaults\"\na 2; walls { spacing 1; }",
        "#include \"defaults\"\n#include \"defaults\"\n",
        "base { a 1; } x { $base; a 2; } y { ${base}; a 3; }",
        "\"a.*\" 1; a 2; ab 3;",
        "a 1;\n#remove a\na 2;",
        "a 1;\n#remove (a b)\na 2;",
        "n 1;\n#ifeq $n 1\na 1; n 2;\n#else\na 2;\n#endif\na 3;",
        "#inputMode merge\na 1; a 2;",
        "a { x 1; } b { x 1; }",
        "l ( { x 1; } { x 1; } ); m ( hex (0 1 2) (1 1 1) hex (0 1 2) (1 1 1) );",
        "$key { x 1; } $key { x 1; }"
    })
    {
        EXPECT_EQ(check(text), "") << text;
    }
}

TEST(InputFile, whatOpenFoamCanReadIsNoError)
{
    for (const char* text : {"", "// a 1e400; {\n/* ( */ a \"( { 1e400 ;\"; b \"a \\\" (\";",
             "a #calc \"1 + $b\"; c #eval{ sin(1) }; d #eval \"2*$a\"; code #codeStream { code #{ "
             "int x; int x; ) #}; };",
             "div(phi,U) Gauss linear; s ($x ${y} $:z.w); d [0 1 -2 0 0 0 0] (0 -9.81 0); u [s^-1] "
             "1; v [ m s^-1 ] 2;",
             "a -1e-5; b .5; c 1.; d 1e+3; e information; f nano; g infinite;",
             "#includeEtc \"caseDicts/a\"\n#includeFunc cellMax\n#includeIfPresent \"none\"\na 1;",
             "3 ( inlet { type patch; } outlet { type patch; } )"})
    {
        EXPECT_EQ(check(text), "") << text;
    }
}

TEST(InputFile, numbersMustBeFinite)
{
    EXPECT_EQ(check("w { a (0\n1e400 0); }"),
        "Entry w/a holds 1e400: numbers up to 1e+300 are valid at case:2");
    EXPECT_EQ(check("a -1e999;"), "Entry a holds -1e999: numbers up to 1e+300 are valid at case:1");
    EXPECT_EQ(check("a nan;"), "Entry a holds nan: it must be a finite number at case:1");
    EXPECT_EQ(check("a (0 -Inf 0);"), "Entry a holds -Inf: it must be a finite number at case:1");
    EXPECT_EQ(check("a 1e-400;"), "");
    EXPECT_EQ(check("a 2e20;", Foam::largestNumber),
        "Entry a holds 2e20: numbers up to 1e+20 are valid at case:1");
    EXPECT_EQ(check("a -1e20;", Foam::largestNumber), "");
}

TEST(InputFile, bracketsMustMatch)
{
    EXPECT_EQ(check("a\n{ b 1;"), "Entry a has a bracket { that nothing closes at case:2");
    EXPECT_EQ(
        check("a (0 0 1;\nb 2;"), "Entry a, line 1, has a bracket ( that nothing closes at case:1");
    EXPECT_EQ(
        check("a (0 0 1)); b 2;"), "Entry a, line 1, has a bracket ) that nothing opens at case:1");
    EXPECT_EQ(check("a [0 1 -2 0 0 0 0; b 2;"),
        "Entry a, line 1, has a bracket [ that nothing closes at case:1");
    EXPECT_EQ(check("a 1; }\nb 2;"), "The file has a bracket } that nothing opens at case:1");
    EXPECT_EQ(check("a { b 1 }"), "Entry a/b has no semicolon at its end at case:1");
    EXPECT_EQ(check("a 1;\nb 2"), "Entry b has no semicolon at its end at case:2");
    EXPECT_EQ(check("r ( a { x 1; );"),
        "Entry r/a has a bracket ) that nothing opens, or a semicolon is missing before it at "
        "case:1");
}

TEST(InputFile, aFileMustNotIncludeItself)
{
    EXPECT_EQ(
        check("a 1;\n#include \"case\""), "The file includes itself: case includes case at case:2");
    EXPECT_EQ(
        check("a { #include \"case\" }"), "The file includes itself: case includes case at case:1");
    EXPECT_EQ(check("l ( #include \"case\" );"),
        "The file includes itself: case includes case at case:1");
    file("other", "#include \"case\"");
    EXPECT_EQ(check("#include \"other\""),
        "The file includes itself: case includes other includes case at other:1");
    file("plain", "b 1;");
    EXPECT_EQ(check("x { #include \"plain\" } y { #include \"plain\" }"), "");
}
