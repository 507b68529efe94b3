// SPDX-License-Identifier: GPL-3.0-or-later
/*  Where particles leave: the nearest patch, openings before walls; and how many may. */

#include "boxMesh.hpp"
#include "escapeCount.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- A tank with an open top, empty along y
    BoxMesh tank()
    {
        BoxMesh box;
        box.divide(0, 0, 2, 4);
        box.divide(2, 0, 1, 2);
        box.sides(1, "empty");
        box.type[5] = "patch";
        return box;
    }

    struct Report
    {
        double time = 0.5;
        std::vector<riprap::Vector3> escaped{{{-0.1, 0.5, 0.5}}};
        std::vector<int> escapedId{7};
    };

    struct Counts { int64_t escaped = 0, outflow = 0, initialParticles = 100, steps = 12; };
}

TEST(NearestPatch, whereAParticleLeft)
{
    const auto mesh = tank().make(testTime());
    const nearestPatch patches(mesh());
    EXPECT_EQ(patches.patch({-0.2, 0.5, 0.4}), "xMin");
    EXPECT_EQ(patches.patch({2.1, 0.5, 0.4}), "xMax");
    EXPECT_EQ(patches.patch({1, 0.5, 1.7}), "zMax");
    EXPECT_EQ(patches.patch({1, 0.5, -1}), "zMin");
    // from within, and never by the empty ones
    EXPECT_EQ(patches.patch({1.1, 0.99, 0.8}), "zMax");
    EXPECT_EQ(patches.patch({1.8, 0.01, 0.5}), "xMax");
    // the rim of a wall: as near to the opening
    EXPECT_EQ(patches.patch({-0.3, 0.5, 1.4}), "zMax");
    EXPECT_EQ(patches.patch({2.3, 0.5, 1.4}), "zMax");
    EXPECT_TRUE(patches.byOpening({2.3, 0.5, 1.4}));
    EXPECT_FALSE(patches.byOpening({2.3, 0.5, 0.9}));
    EXPECT_EQ(patches.particle(3, {{1, 0.5, 2}}), "particle 3 at (1 0.5 2) (nearest patch: zMax)");
}

TEST(NearestPatch, withoutOpenings)
{
    BoxMesh box(tank());
    box.type[5] = "wall";
    const auto mesh = box.make(testTime());
    const nearestPatch patches(mesh());
    EXPECT_EQ(patches.patch({1, 0.5, 2}), "zMax");
    EXPECT_FALSE(patches.byOpening({1, 0.5, 2}));
}

TEST(EscapeCount, byPatch)
{
    const auto mesh = tank().make(testTime());
    const nearestPatch patches(mesh());
    escapeCount count(patches);
    count.add({{{-1, 0.5, 0.5}}, {{1, 0.5, 2}}, {{1, 0.5, 3}}});
    count.add({{{-1, 0.5, 0.4}}});
    EXPECT_EQ(count.outflow(), 2);
    testing::internal::CaptureStdout();
    count.log(1, 4, 2);
    EXPECT_EQ(testing::internal::GetCapturedStdout(),
        "Escaped 1 particles (4 in all), by nearest patch: xMin 2 zMax 2\n"
        "Escaped through walls in all: 2\n");
}

TEST(EscapeCount, stopsAboveTheShare)
{
    const auto mesh = tank().make(testTime());
    const nearestPatch patches(mesh());
    const escapeCount count(patches);
    const auto said = [&](int64_t escaped, int64_t outflow, scalar allowed)
    {
        Counts run;
        run.escaped = escaped;
        run.outflow = outflow;
        testing::internal::CaptureStdout();
        std::string message
        (
            messageOf([&]() { count.stopAbove(allowed, Report(), run, "advice"); })
        );
        testing::internal::GetCapturedStdout();
        return message;
    };
    EXPECT_EQ(said(1, 0, 0.01), "");
    EXPECT_EQ(said(52, 51, 0.01), "");
    EXPECT_EQ(said(2, 0, 0.01),
        "Guard at time 0.5 s, particle step 12: 2 particles of 100 have left the domain through "
        "walls, the last one, 7, at (-0.1 0.5 0.5); guards/escape and guards/maxEscaped allow 1 "
        "%\nadvice");
    // `escape stop;`: by openings, too
    EXPECT_TRUE(holds(said(1, 1, 0), "1 particles of 100 have left the domain, the last one"));
}

TEST(EscapeCount, guards)
{
    const auto read = [](const std::string& text)
    {
        const dictionary dict(entries(text));
        checkedDictionary checked(dict);
        escapeGuard guard;
        guard.read(checked);
        checked.end();
        return guard;
    };
    EXPECT_EQ(read("").allowed(), 0.01);
    EXPECT_EQ(read("maxEscaped 0.2;").allowed(), 0.2);
    EXPECT_EQ(read("escape stop; maxEscaped 0.2;").allowed(), 0);
    EXPECT_EQ(messageOf([&]() { read("escape halt;"); }),
        "Entry escape has the unknown word halt; valid are (stop warn)");
    EXPECT_TRUE(holds(messageOf([&]() { read("maxEscaped 2;"); }), "Entry maxEscaped is 2"));
}
