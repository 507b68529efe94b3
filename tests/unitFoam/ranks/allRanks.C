// SPDX-License-Identifier: GPL-3.0-or-later
/*  One process alone: its own is the answer. */

#include "allRanks.H"
#include "boxMesh.hpp"
#include "dividedCloud.H"
#include "pstreamTransport.H"
#include "scratchCase.hpp"
#include "wholeBoundary.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(AllRanks, ofOneProcess)
{
    EXPECT_TRUE(onAnyRank(true));
    EXPECT_FALSE(onAnyRank(false));
    EXPECT_TRUE(onAllRanks(true));
    EXPECT_FALSE(onAllRanks(false));
    EXPECT_EQ(sumOfRanks((int64_t(1) << 60) + 1), (int64_t(1) << 60) + 1);
    EXPECT_EQ(textsOfRanks("a"), std::vector<std::string>{"a"});
    EXPECT_EQ(firstTextOfRanks("b"), "b");
    EXPECT_EQ(firstTextOfRanks(""), "");
    EXPECT_EQ(textOfMaster("c"), "c");
    EXPECT_EQ(constantOfCase(testTime()), "constant");
}

TEST(AllRanks, errorsEndAll)
{
    EXPECT_EQ(messageOf([]() { stopIfAny(""); }), "");
    EXPECT_EQ(messageOf([]() { stopIfAny("full"); }), "full");
}

TEST(AllRanks, transportToItself)
{
    pstreamTransport t;
    EXPECT_EQ(t.rank(), 0);
    EXPECT_EQ(t.size(), 1);
    std::vector<std::int64_t> sums{3, -4};
    t.sum(sums);
    EXPECT_EQ(sums, (std::vector<std::int64_t>{3, -4}));
    std::vector<double> largest{1.5, -2};
    t.largest(largest);
    EXPECT_EQ(largest, (std::vector<double>{1.5, -2}));
    const std::vector<riprap::RankBytes> out{{1, 2, 3}};
    std::vector<riprap::RankBytes> in;
    t.exchange(out, in);
    EXPECT_EQ(in, out);
}

TEST(WholeBoundary, isTheMeshItself)
{
    BoxMesh box;
    box.divide(0, 0, 1, 3);
    const auto mesh = box.make(testTime());
    EXPECT_EQ(&wholeBoundary(mesh()), &mesh());
    EXPECT_EQ(inAnyCell(mesh(), pointField({{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}})),
        boolList({true, false}));
    particleCloud cloud("fluid", 2);
    cloud.position = pointField({{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}});
    EXPECT_EQ(sendToCells(mesh(), cloud), 1);
    EXPECT_EQ(cloud.cell, labelList({1, 2}));
}
