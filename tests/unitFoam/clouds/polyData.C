// SPDX-License-Identifier: GPL-3.0-or-later
/*  Points and lines for ParaView, read back number by number, and their series. */

#include "lineSeries.H"
#include "particleCloudIO.H"
#include "scratchCase.hpp"
#include "timeWriter.H"

#include <cstring>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    std::string decoded(const std::string& text)
    {
        const std::string digits(
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
        std::string bytes;
        int value = 0, bits = 0;
        for (const char c : text)
        {
            const std::size_t d = digits.find(c);
            if (d == std::string::npos) continue;
            value = (value << 6 | int(d)) & 0xffffff;
            bits += 6;
            if (bits < 8) continue;
            bits -= 8;
            bytes += char(value >> bits & 255);
        }
        return bytes;
    }

    //- Numbers of an array of a file: after their size in bytes
    template<class T>
    std::vector<T> arrayOf(const std::string& file, const std::string& name)
    {
        const std::size_t at = file.find("Name='" + name + "'");
        const std::size_t begin = file.find('>', at) + 1;
        EXPECT_NE(at, std::string::npos) << name;
        const std::string bytes(decoded(file.substr(begin, file.find('<', begin) - begin)));
        uint64_t size = 0;
        std::memcpy(&size, bytes.data(), sizeof(size));
        EXPECT_EQ(size + sizeof(size), bytes.size()) << name;
        std::vector<T> values(size/sizeof(T));
        std::memcpy(values.data(), bytes.data() + sizeof(size), size);
        return values;
    }

    struct Fields
    {
        const pointField points = pointField({{0, 0.5, 0.25}, {1, 2, 3}, {-4, 5, 1e6}});
        lineFields of;

        explicit Fields(label n)
        {
            of.labels.set("id", labelField(n, 7));
            scalarField p(n);
            vectorField U(n);
            forAll(p, i)
            {
                p[i] = 0.5*i;
                U[i] = vector(i, -i, 0.25);
            }
            of.scalars.set("p", p);
            of.vectors.set("U", U);
        }
    };

    void expectFields(const std::string& file, label n)
    {
        EXPECT_EQ(arrayOf<std::int32_t>(file, "id"), std::vector<std::int32_t>(n, 7));
        const auto p = arrayOf<float>(file, "p"), U = arrayOf<float>(file, "U");
        ASSERT_EQ(label(U.size()), 3*n);
        for (label i = 0; i < n; ++i)
        {
            EXPECT_EQ(p[i], 0.5f*i);
            EXPECT_EQ(U[3*i], float(i));
            EXPECT_EQ(U[3*i + 1], -float(i));
            EXPECT_EQ(U[3*i + 2], 0.25f);
        }
    }

    const edgeList lines({edge(0, 1), edge(2, 0)});
}

TEST(PolyData, points)
{
    ScratchCase c;
    const Fields f(3);
    writePolyData(c.path()/"VTK/a.vtp", f.points, f.of.labels, f.of.scalars, f.of.vectors);
    const std::string file(c.read("VTK/a.vtp"));
    EXPECT_TRUE(holds(file, "<Piece NumberOfPoints='3' NumberOfVerts='3'>"));
    EXPECT_EQ(arrayOf<float>(file, "Points"),
        (std::vector<float>{0, 0.5f, 0.25f, 1, 2, 3, -4, 5, 1e6f}));
    EXPECT_EQ(arrayOf<std::int32_t>(file, "connectivity"), (std::vector<std::int32_t>{0, 1, 2}));
    EXPECT_EQ(arrayOf<std::int32_t>(file, "offsets"), (std::vector<std::int32_t>{1, 2, 3}));
    EXPECT_TRUE(holds(file, "<PointData>"));
    expectFields(file, 3);
}

TEST(PolyData, lines)
{
    ScratchCase c;
    const Fields f(2);
    writePolyLines(c.path()/"b.vtp", f.points, lines, f.of.labels, f.of.scalars, f.of.vectors);
    const std::string file(c.read("b.vtp"));
    EXPECT_TRUE(holds(file, "<Piece NumberOfPoints='3' NumberOfLines='2'>"));
    EXPECT_EQ(arrayOf<std::int32_t>(file, "connectivity"), (std::vector<std::int32_t>{0, 1, 2, 0}));
    EXPECT_EQ(arrayOf<std::int32_t>(file, "offsets"), (std::vector<std::int32_t>{2, 4}));
    EXPECT_TRUE(holds(file, "<CellData>"));
    expectFields(file, 2);
}

TEST(PolyData, onAFullDisk)
{
    // what stays in the buffer until the end, too
    for (const label n : {3, 10000})
    {
        const pointField points(n, point(1, 2, 3));
        std::string said;
        try { writePolyData("/dev/full", points, {}, {}, {}); }
        catch (const std::runtime_error& e) { said = e.what(); }
        EXPECT_EQ(said, "Cannot write /dev/full: is the disk full?") << n;
    }
}

//- All files of the series that are there, in the order of times
TEST(LineSeries, ofAllTimes)
{
    ScratchCase c("deltaT 0.5;");
    const Fields f(2);
    c.write("VTK/chains/chains_10.vtp", "of a run before");
    c.write("VTK/chains/chains_x.vtp", "of somebody else");
    c.write("VTK/chains/other_1.vtp", "");
    const auto write = [&]()
    {
        ++c.time();
        writeLineSeries(c.time(), "chains", f.points, lines, f.of);
        timeWriter::ofRun().wait();
    };
    write();
    write();
    EXPECT_EQ(c.read("VTK/chains.vtp.series"),
        "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n"
        "    { \"name\" : \"chains/chains_0.5.vtp\", \"time\" : 0.5 },\n"
        "    { \"name\" : \"chains/chains_1.vtp\", \"time\" : 1 },\n"
        "    { \"name\" : \"chains/chains_10.vtp\", \"time\" : 10 }\n  ]\n}\n");
    expectFields(c.read("VTK/chains/chains_1.vtp"), 2);
    {
        const timeWriter::trial nothingIsWritten;
        write();
    }
    EXPECT_FALSE(isFile(c.path()/"VTK/chains/chains_1.5.vtp"));
}
