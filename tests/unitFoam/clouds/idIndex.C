// SPDX-License-Identifier: GPL-3.0-or-later
/*  Particles by their ids; fields of a cloud as a scene is given them. */

#include "idIndex.H"
#include "scratchCase.hpp"
#include "toStdVector.H"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace Foam;

TEST(IdIndex, whereEachIs)
{
    // few missing; many missing; below zero
    for (const std::vector<std::int32_t>& ids : std::vector<std::vector<std::int32_t>>{
             {4, 0, 7, 2}, {5, 2000000000, 9}, {3, -7, 0}})
    {
        const idIndex at(ids);
        for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(at(ids[i]), label(i));
        for (const std::int32_t other : {-1, 1, 8, 1000, 2000000001}) EXPECT_EQ(at(other), -1);
    }
    EXPECT_EQ(idIndex({})(0), -1);
}

TEST(IdIndex, orderOfIds)
{
    EXPECT_EQ(orderOf(labelList({4, 0, 7, 2})), labelList({1, 3, 0, 2}));
    EXPECT_EQ(orderOf(labelList({5, 2000000000, 9})), labelList({0, 2, 1}));
    EXPECT_EQ(orderOf(labelList({3, -7, 0})), labelList({1, 2, 0}));
    EXPECT_EQ(orderOf(labelList()), labelList());
}

TEST(IdIndex, sortedCloudsTakeAllAlong)
{
    particleCloud c("fluid", 3);
    c.position = pointField({{3, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    c.cell = labelList({30, 10, 20});
    c.labels.set("id", labelField({3, 1, 2}));
    c.scalars.set("rho", scalarField({0.3, 0.1, 0.2}));
    c.vectors.set("U", vectorField({{0, 3, 0}, {0, 1, 0}, {0, 2, 0}}));
    sortByLabel(c, "id");
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_EQ(c.labels["id"][i], i + 1);
        EXPECT_EQ(c.position[i].x(), i + 1);
        EXPECT_EQ(c.cell[i], 10*(i + 1));
        EXPECT_EQ(c.scalars["rho"][i], i == 2 ? 0.3 : 0.1*(i + 1));
        EXPECT_EQ(c.vectors["U"][i].y(), i + 1);
    }
}

TEST(ToStdVector, numbersInTheirOrder)
{
    EXPECT_EQ(toStdVector("fluid", "U", vectorField({{1, 2, 3}, {4, 5, 6}})),
        (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(
        toStdVector("fluid", "p", scalarField(scalarList({-1, 2}))), (std::vector<double>{-1, 2}));
    EXPECT_EQ(toStdVectorPositive("fluid", "rho", scalarField(scalarList({1, 2}))),
        (std::vector<double>{1, 2}));
    EXPECT_EQ(
        uniqueIds("fluid", "id", labelField({7, 0, 3})), (std::vector<std::int32_t>{7, 0, 3}));
}

//- The first bad number is named, whatever the number of threads
TEST(ToStdVector, badNumbers)
{
    scalarField many(50000, 1.0);
    many[49990] = many[20001] = -2;
    EXPECT_EQ(messageOf([&]() { toStdVectorPositive("fluid", "rho", many); }),
        "lagrangian/fluid/rho has the value -2 at entry 20001: it must be positive");
    many[31] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(messageOf([&]() { toStdVector("fluid", "p", many); }),
        "lagrangian/fluid/p has the value inf at entry 31");
    vectorField U(3, vector(1, 2, 3));
    U[2].y() = std::nan("");
    EXPECT_EQ(messageOf([&]() { toStdVector("solids", "U", U); }),
        "lagrangian/solids/U has the value nan at entry 2");
    EXPECT_EQ(messageOf(
                  [&]() {
                      toStdVectorPositive("fluid", "h", scalarField(scalarList({1, 0})));
                  }),
        "lagrangian/fluid/h has the value 0 at entry 1: it must be positive");
}

TEST(ToStdVector, idsMustBeUnique)
{
    EXPECT_EQ(messageOf([]() { uniqueIds("fluid", "id", labelField({7, 0, 7, 7})); }),
        "lagrangian/fluid/id: 2 ids occur more than once, the smallest is 0: ids must be unique "
        "and not negative");
    EXPECT_EQ(messageOf([]() { uniqueIds("fluid", "id", labelField({5, 2000000000, 5})); }),
        "lagrangian/fluid/id: 1 ids occur more than once, the smallest is 5: ids must be unique "
        "and not negative");
    EXPECT_EQ(messageOf([]() { uniqueIds("fluid", "id", labelField(labelList({3, -1}))); }),
        "lagrangian/fluid/id: 0 ids occur more than once, the smallest is -1: ids must be unique "
        "and not negative");
}
