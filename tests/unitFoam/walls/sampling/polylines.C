// SPDX-License-Identifier: GPL-3.0-or-later
/*  Lines from edges, and their even division; who is near on a grid. */

#include "pointGrid.H"
#include "polylines.H"

#include <gtest/gtest.h>
#include <random>
#include <set>

using namespace Foam;

namespace
{
    bool never(label, label, label) { return false; }

    //- Every edge in one line, and joined as the line says
    void expectLines(const edgeList& edges, const List<polyline>& lines)
    {
        labelList used(edges.size(), Zero);
        for (const polyline& line : lines)
        {
            ASSERT_EQ(line.points.size(), line.edges.size() + 1);
            forAll(line.edges, i)
            {
                ++used[line.edges[i]];
                EXPECT_EQ(edge::compare(edges[line.edges[i]],
                              edge(line.points[i], line.points[i + 1])) != 0, true);
            }
            EXPECT_EQ(line.closed, line.points.first() == line.points.last());
        }
        for (const label n : used) EXPECT_EQ(n, 1);
    }
}

TEST(Polylines, aChainInAnyOrder)
{
    const edgeList edges({edge(3, 2), edge(0, 1), edge(3, 4), edge(2, 1)});
    const List<polyline> lines(linkEdges(edges, never));
    ASSERT_EQ(lines.size(), 1);
    expectLines(edges, lines);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_EQ(min(lines[0].points.first(), lines[0].points.last()), 0);
    EXPECT_EQ(max(lines[0].points.first(), lines[0].points.last()), 4);
}

TEST(Polylines, aRingAndABranch)
{
    const edgeList ring({edge(0, 1), edge(2, 1), edge(2, 3), edge(3, 0)});
    List<polyline> lines(linkEdges(ring, never));
    ASSERT_EQ(lines.size(), 1);
    expectLines(ring, lines);
    EXPECT_TRUE(lines[0].closed);

    // Three edges at point 1: as many lines
    const edgeList branch({edge(0, 1), edge(1, 2), edge(3, 1), edge(2, 4)});
    lines = linkEdges(branch, never);
    EXPECT_EQ(lines.size(), 3);
    expectLines(branch, lines);
}

TEST(Polylines, endsWhereAsked)
{
    const edgeList ring({edge(0, 1), edge(2, 1), edge(2, 3), edge(3, 0)});
    const auto lines(linkEdges(ring, [](label p, label, label) { return p == 1 || p == 3; }));
    ASSERT_EQ(lines.size(), 2);
    expectLines(ring, lines);
    for (const polyline& line : lines) EXPECT_EQ(line.points.first() + line.points.last(), 4);
}

TEST(Polylines, dividedEvenly)
{
    // 1 long at 0.3: three parts of 1/3, middles at 1/6, 1/2 and 5/6, in pieces of 0.2, 0 and 0.8
    const auto parts(divideEvenly(scalarField({0.2, 0, 0.8}), 0.3));
    ASSERT_EQ(parts.size(), 3);
    const double at[] = {1.0/6, 0.5, 5.0/6};
    EXPECT_EQ(parts[0].first(), 0);
    EXPECT_NEAR(parts[0].second(), at[0]/0.2, 1e-14);
    for (label i = 1; i < 3; ++i)
    {
        EXPECT_EQ(parts[i].first(), 2);
        EXPECT_NEAR(parts[i].second(), (at[i] - 0.2)/0.8, 1e-14);
    }
    EXPECT_EQ(divideEvenly(scalarField(1, 0.14), 0.3).size(), 0);
    EXPECT_EQ(divideEvenly(scalarField(1, 0.16), 0.3).size(), 1);
    EXPECT_EQ(divideEvenly(scalarField(5, 0.6), 0.3).size(), 10);
}

//- Those that all pairs give, on both sides of the origin
TEST(PointGrid, findsWhoIsNear)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> in(-1, 1);
    pointField points(300);
    for (point& p : points) p = point(in(random), in(random), in(random));
    const double radius = 0.31;
    const pointGrid grid(radius, points);
    forAll(points, i)
    {
        std::set<label> near, expected;
        grid.near(points[i],
            [&](label j, const vector& away, scalar d)
            {
                EXPECT_TRUE(near.insert(j).second);
                EXPECT_EQ(away, points[i] - points[j]);
                EXPECT_EQ(d, mag(points[i] - points[j]));
            });
        double least = radius;
        forAll(points, j)
        {
            const double d = mag(points[i] - points[j]);
            if (d < radius) expected.insert(j);
            if (j != i) least = min(least, d);
        }
        EXPECT_EQ(near, expected);
        EXPECT_EQ(grid.nearest(points[i], i), least);
    }
    EXPECT_EQ(grid.nearest(point(5, 5, 5), -1), radius);
}
