// SPDX-License-Identifier: GPL-3.0-or-later
/*  What riprap's function objects share: tables, entries, what a restart is given. */

#include "functionTable.hpp"
#include "particleCase.hpp"
#include "fvMesh.H"
#include "runningScenes.H"
#include "sceneFunctionObject.H"
#include "timeWriter.H"

#include <gtest/gtest.h>

using namespace Foam;
using functionObjects::sceneFunctionObject;

namespace
{
    //- Writes what the test says
    struct Scripted : sceneFunctionObject
    {
        int executed = 0;
        wordList columns{"a", "b"};
        List<string> comments;

        Scripted(const Time& time, const std::string& text)
        :
            sceneFunctionObject("f", time, ::entries(text))
        {
            read(::entries(text));
        }

        wordList entries() const override { return wordList({"fields", "axis", "part"}); }
        bool executeSample() override { return ++executed; }

        bool writeSample() override
        {
            OFstream& os = row("scripted", columns, comments);
            forAll(columns, k) add(os, time_.value() + k);
            os << endl;
            return true;
        }

        using sceneFunctionObject::direction;
        using sceneFunctionObject::fieldNames;
        using sceneFunctionObject::fraction;
        using sceneFunctionObject::notNegative;
        using sceneFunctionObject::saved;
        using sceneFunctionObject::writeAtStart;
    };

    struct SceneCase : ParticleCase
    {
        autoPtr<fvMesh> fv;

        explicit SceneCase(const BoxMesh& box = BoxMesh()) : ParticleCase(box, "deltaT 0.25;")
        {
            mesh.clear();
            fv = box.make<fvMesh>(time());
        }

        std::string read(const std::string& file, const char* begin = "0") const
        {
            return ScratchCase::read(std::string("postProcessing/f/") + begin + '/' + file);
        }
    };

    //- y is empty
    BoxMesh flat()
    {
        BoxMesh box;
        box.sides(1, "empty");
        return box;
    }

    template<class F>
    std::string said(const std::string& text, const F& f, const BoxMesh& box = BoxMesh())
    {
        SceneCase c(box);
        Scripted object(c.time(), "");
        return messageOf([&]() { f(object, entries(text)); });
    }
}

//- The digits of numbers are ten at least
TEST(SceneFunctionObject, table)
{
    SceneCase c;
    Scripted f(c.time(), "");
    f.comments = List<string>({"of a test", "second"});
    f.write();
    ++c.time();
    f.write();
    const FunctionTable table(c.read("scripted.dat"));
    EXPECT_EQ(table.comments, (std::vector<std::string>{"of a test", "second"}));
    EXPECT_EQ(table.columns, (std::vector<std::string>{"Time", "a", "b"}));
    EXPECT_EQ(table.rows,
        (std::vector<std::vector<double>>{{0, 0, 1}, {0.25, 0.25, 1.25}}));
    EXPECT_TRUE(holds(c.read("scripted.dat"), "\t1.2500000000e+00 "));
}

TEST(SceneFunctionObject, digits)
{
    SceneCase c;
    Scripted(c.time(), "writePrecision 3;").write();
    EXPECT_TRUE(holds(c.read("scripted.dat"), "\t1.000e+00 ")) << c.read("scripted.dat");
}

//- Other columns, where the dictionary was edited, begin a file in the folder of that time
TEST(SceneFunctionObject, columnsThatChange)
{
    SceneCase c;
    Scripted f(c.time(), "");
    f.write();
    ++c.time();
    f.columns = wordList({"a", "b", "c"});
    f.write();
    ++c.time();
    f.write();
    EXPECT_EQ(FunctionTable(c.read("scripted.dat")).rows.size(), 1u);
    const FunctionTable later(c.read("scripted.dat", "0.25"));
    EXPECT_EQ(later.columns, (std::vector<std::string>{"Time", "a", "b", "c"}));
    EXPECT_EQ(later.rows,
        (std::vector<std::vector<double>>{{0.25, 0.25, 1.25, 2.25}, {0.5, 0.5, 1.5, 2.5}}));
}

//- writeToFile no, on trial: the rows go nowhere
TEST(SceneFunctionObject, writesNothing)
{
    SceneCase c;
    Scripted(c.time(), "writeToFile no;").write();
    {
        const timeWriter::trial trial;
        Scripted(c.time(), "").write();
    }
    EXPECT_EQ(c.read("scripted.dat"), "");
}

TEST(SceneFunctionObject, writesAtTheStartAlone)
{
    SceneCase c;
    Scripted f(c.time(), "");
    f.writeAtStart();
    ++c.time();
    f.writeAtStart();
    f.execute();
    f.execute();
    EXPECT_EQ(FunctionTable(c.read("scripted.dat")).rows.size(), 1u);
    EXPECT_EQ(f.executed, 2);
}

TEST(SceneFunctionObject, unknownEntries)
{
    SceneCase c;
    const auto said = [&](const std::string& text)
    { return messageOf([&]() { Scripted(c.time(), text); }); };
    EXPECT_EQ(said("type x; libs (); writeControl writeTime; timeStart 1; part 0.5; log no;"), "");
    const std::string message(said("parts 1;"));
    EXPECT_TRUE(holds(message, "Unknown entry parts; valid are")) << message;
    EXPECT_TRUE(holds(message, "part")) << message;
}

TEST(SceneFunctionObject, directions)
{
    const auto ask = [](const std::string& text, const BoxMesh& box = BoxMesh())
    {
        SceneCase c(box);
        return Scripted(c.time(), "").direction(entries(text), "axis", vector(0, 0, 2));
    };
    EXPECT_EQ(ask(""), vector(0, 0, 1));
    EXPECT_LT(mag(ask("axis (3 0 -4);") - vector(0.6, 0, -0.8)), 1e-15);
    EXPECT_LT(mag(ask("axis (3 12 -4);") - vector(3, 12, -4)/13), 1e-15);
    EXPECT_LT(mag(ask("axis (3 12 -4);", flat()) - vector(0.6, 0, -0.8)), 1e-15);
    const auto f = [](Scripted& s, const dictionary& d)
    { s.direction(d, "axis", vector(0, 0, 1)); };
    EXPECT_EQ(said("axis (0 0 0);", f), "Entry axis of function object f has no length");
    EXPECT_EQ(said("axis (0 1 0);", f), "");
    EXPECT_EQ(said("axis (0 1 0);", f, flat()),
        "Entry axis of function object f has no length in the plane of the 2D mesh");
}

TEST(SceneFunctionObject, numbers)
{
    SceneCase c;
    const Scripted s(c.time(), "");
    EXPECT_EQ(s.notNegative(entries("part 2;"), "part", 1), 2);
    EXPECT_EQ(s.notNegative(entries(""), "part", 1), 1);
    EXPECT_EQ(s.fraction(entries("part 0.2;"), "part", 1), 0.2);
    EXPECT_EQ(s.fraction(entries(""), "part", 0.7), 0.7);
    EXPECT_EQ(said("part 1.2;",
        [](Scripted& f, const dictionary& d) { f.fraction(d, "part", 1); }),
        "Entry part is 1.2: it must be from 0 to 1");
    EXPECT_EQ(said("part -2;",
        [](Scripted& f, const dictionary& d) { f.notNegative(d, "part", 1); }),
        "Entry part of function object f is -2: it must not be negative");
}

TEST(SceneFunctionObject, fields)
{
    const wordList valid({"p", "U", "rho"});
    SceneCase c;
    const Scripted s(c.time(), "");
    EXPECT_EQ(s.fieldNames(entries(""), wordList({"U"}), valid), wordList({"U"}));
    EXPECT_EQ(s.fieldNames(entries("fields (rho p);"), valid, valid), wordList({"rho", "p"}));
    const auto f = [&](Scripted& s, const dictionary& d) { s.fieldNames(d, valid, valid); };
    EXPECT_EQ(said("fields ();", f),
        "Entry fields of function object f is empty; valid are (p U rho)");
    EXPECT_EQ(said("fields (p rhoo);", f),
        "Entry fields of function object f: unknown field rhoo; valid are (p U rho); did you "
        "mean rho?");
}

//- Numbers by name, each function object its own
TEST(SceneFunctionObject, keepsNumbers)
{
    SceneCase c;
    Scripted before(c.time(), "");
    EXPECT_TRUE(before.saved("numbers").empty());
    before.setProperty("numbers", scalarList({0.25, -2e20}));
    const Scripted after(c.time(), "");
    EXPECT_EQ(after.saved("numbers"), scalarList({0.25, -2e20}));
    EXPECT_TRUE(after.saved("others").empty());
}

TEST(RunningScenes, none)
{
    SceneCase c;
    EXPECT_EQ(functionObjects::runningFluid(c.fv()), nullptr);
    EXPECT_EQ(functionObjects::runningSolids(c.fv()), nullptr);
}
