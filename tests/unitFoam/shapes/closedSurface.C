// SPDX-License-Identifier: GPL-3.0-or-later
/*  Surfaces and tables that a region names: read, turned outwards, and refused with the reason. */

#include "closedSurface.H"
#include "clumpShape.H"
#include "csvFile.H"
#include "scratchCase.hpp"

#include <array>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- A box (0 0 0) to (1 2 3), by its vertices and faces; inwards if asked, or with a hole
    std::string boxOff(bool inwards = false, bool hole = false)
    {
        const int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3},
            {0, 2, 3, 1}, {4, 5, 7, 6}};
        std::string text("OFF\n8 " + std::to_string(hole ? 11 : 12) + " 0\n");
        for (int v = 0; v < 8; ++v)
            text += std::to_string(v & 1) + ' ' + std::to_string(2*(v >> 1 & 1)) + ' '
                + std::to_string(3*(v >> 2)) + '\n';
        int n = 0;
        for (const auto& q : quads)
        {
            for (const auto& t : {std::array<int, 3>{q[0], q[1], q[2]},
                     std::array<int, 3>{q[0], q[2], q[3]}})
            {
                if (hole && ++n == 12) continue;
                text += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[inwards ? 2 : 1])
                    + ' ' + std::to_string(t[inwards ? 1 : 2]) + '\n';
            }
        }
        return text;
    }

    struct FileCase : ScratchCase
    {
        FileCase()
        {
            write("constant/triSurface/box.off", boxOff());
            write("constant/triSurface/back.off", boxOff(true));
            write("constant/triSurface/open.off", boxOff(false, true));
            write("constant/triSurface/text.off", "no surface\n");
        }

        autoPtr<triSurface> surface(const std::string& text)
        {
            const dictionary dict(entries(text));
            checkedDictionary checked(dict);
            return readClosedSurface(checked, time());
        }

        std::string said(const std::string& text)
        {
            return messageOf([&]() { surface(text); });
        }

        csvFile table(const dictionary& dict)
        {
            checkedDictionary checked(dict);
            return csvFile(checked, time());
        }
    };
}

TEST(ClosedSurface, outwardsWhicheverWayItWas)
{
    FileCase c;
    for (const char* file :
        {"file \"box.off\";", "file \"back.off\";", "file \"box.off\"; scale 2;"})
    {
        const auto s = c.surface(file);
        double volume = 0;
        for (const labelledTri& t : s())
        {
            const pointField& p = s->points();
            volume += (p[t[0]] & (p[t[1]] ^ p[t[2]]))/6;
        }
        EXPECT_NEAR(volume, holds(file, "scale") ? 48 : 6, 1e-12) << file;
    }
}

TEST(ClosedSurface, whatIsRefused)
{
    FileCase c;
    const std::string missing = c.said("file \"bxo.off\";");
    EXPECT_TRUE(holds(missing, "constant/triSurface holds (")) << missing;
    EXPECT_TRUE(holds(missing, "did you mean box.off?")) << missing;
    EXPECT_TRUE(holds(c.said("file \"open.off\";"), "is not closed (an edge has 1 triangles): it "
                                                    "holds no volume"));
    EXPECT_TRUE(holds(c.said("file \"text.off\";"), "cannot be read as a surface: "));
    c.write("constant/triSurface/box.xyz", "1");
    EXPECT_TRUE(holds(c.said("file \"box.xyz\";"), "unknown file extension xyz, valid are "));
    EXPECT_EQ(c.said("file \"box.off\"; scale 0;"), "Entry scale is 0: it must be positive");
}

TEST(ClosedSurface, shapeOfASurface)
{
    FileCase c;
    const int axes[3] = {0, 1, 2};
    const dictionary dict(entries("file \"back.off\"; centreOfMass (0.5 1 1);"));
    const clumpShape s(keptShape(dict, c.time(), 3, axes));
    EXPECT_NEAR(s.volume, 6, 1e-12);
    EXPECT_EQ(s.middle, point(0.5, 1, 1));
    double sum = 0, product = 1;
    for (direction d = 0; d < 3; ++d) { sum += s.moments[d]; product *= s.moments[d]; }
    EXPECT_NEAR(sum, 6.0/12*2*(1 + 4 + 9), 1e-9);
    EXPECT_NEAR(product, 6.5*5*2.5, 1e-9);
    const scalarField d(s.distance(pointField({{0.5, 1, 1.5}, {0.5, 1, -2}, {0.9, 1, 2}})));
    EXPECT_NEAR(d[0], -0.5, 1e-12);
    EXPECT_NEAR(d[1], 2, 1e-12);
    EXPECT_NEAR(d[2], -0.1, 1e-12);
    EXPECT_EQ(shapeEntries(entries("file a; mass 2; scale 3;")).toc(), wordList({"file", "scale"}));
}

TEST(CsvFile, columnsAndNumbers)
{
    FileCase c;
    c.write("list.csv", "x, \"y\" ,z\r\n1,2,3e-2\r\n\n -4 ,.5,\"6\"\n");
    const dictionary dict(entries("file \"list.csv\";"));
    const csvFile t(c.table(dict));
    EXPECT_EQ(t.head(), (std::vector<std::string>{"x", "y", "z"}));
    ASSERT_EQ(t.size(), 2);
    EXPECT_EQ(t.column("y"), 1);
    EXPECT_EQ(t.column("w"), -1);
    EXPECT_EQ(t.number(0, 2), 0.03);
    EXPECT_EQ(t.number(1, 0), -4);
    EXPECT_EQ(t.number(1, 2), 6);
}

TEST(CsvFile, messagesNameTheLine)
{
    FileCase c;
    const dictionary dict(entries("file \"list.csv\";"));
    const auto said = [&](const std::string& text)
    {
        c.write("list.csv", text);
        return messageOf([&]() { c.table(dict).number(0, 0); });
    };
    const std::string list(" of \"" + c.path() + "/list.csv\": ");
    EXPECT_EQ(said("x,y\n1,2\n\n3\n"), "Entry file: line 4" + list + "1 values, not 2");
    EXPECT_EQ(said("x,y\n\n1e,2\n"), "Entry file: line 3" + list + "'1e' is no number");
    for (const char* text : {"nan", "inf", "1e999", "", "1 2"})
        EXPECT_EQ(said(std::string("x,y\n") + text + ",2\n"),
            "Entry file: line 2" + list + '\'' + text + "' is no number");
    EXPECT_EQ(messageOf([&]() { c.table(entries("file \"none.csv\";")); }),
        "Entry file: there is no \"" + c.path() + "/none.csv\"");
}
