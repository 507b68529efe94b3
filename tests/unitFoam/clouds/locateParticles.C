// SPDX-License-Identifier: GPL-3.0-or-later
/*  Cells that particles are in: those of the block, whatever the hint. */

#include "boxMesh.hpp"
#include "cellLattice.H"
#include "particleCloudIO.H"
#include "testTime.H"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

using namespace Foam;

namespace
{
    constexpr int n = 7;

    BoxMesh block()
    {
        BoxMesh box;
        box.divide(0, -1, 1, n);
        box.divide(1, 0, 0.5, n);
        box.divide(2, 3, 7, n);
        return box;
    }

    //- So many, of which a third is on faces or edges
    pointField randomPoints(label size)
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> in(0, 1);
        pointField points(size);
        forAll(points, i)
        {
            double u[3];
            for (double& x : u) x = in(random);
            if (i % 3 == 0) u[i % 2] = std::floor(n*u[i % 2])/n;
            points[i] = point(-1 + 2*u[0], 0.5*u[1], 3 + 4*u[2]);
        }
        return points;
    }

    //- The cells that a point may be in, to a billionth of a cell
    bool mayBe(const point& p, label cell)
    {
        const double x[3] = {(p.x() + 1)/2*n, p.y()/0.5*n, (p.z() - 3)/4*n};
        const int at[3] = {cell % n, cell/n % n, cell/(n*n)};
        bool good = cell >= 0;
        for (int d = 0; d < 3; ++d) good = good && std::abs(x[d] - at[d] - 0.5) < 0.5 + 1e-7;
        return good;
    }
}

TEST(LocateParticles, inTheBlock)
{
    const auto mesh = block().make(testTime());
    const pointField points(randomPoints(9000));
    const cellLattice walks{};
    const labelList none(locateParticles(mesh(), points, labelList(), false, &walks));
    EXPECT_EQ(none, locateParticles(mesh(), points, labelList(), false));
    std::mt19937 random(3);
    labelList wild(points.size());
    for (label& c : wild) c = label(random() % (2*n*n*n)) - n;
    const labelList hinted(locateParticles(mesh(), points, wild, false, &walks));
    forAll(points, i)
    {
        ASSERT_TRUE(mayBe(points[i], none[i])) << i << ' ' << none[i];
        ASSERT_EQ(none[i], hinted[i]) << i;
    }
}

TEST(LocateParticles, onFacesInTheFirst)
{
    const auto mesh = block().make(testTime());
    const point corner(-1 + 2.0*3/n, 0.5*2/n, 3 + 4.0*5/n);
    const label first = 2 + n*1 + n*n*4;
    const cellLattice walks{};
    for (const label hint : {-1, 0, first, first + 1 + n + n*n, n*n*n - 1})
    {
        EXPECT_EQ(
            locateParticles(mesh(), pointField(1, corner), labelList(1, hint), false, &walks)[0],
            first);
    }
}

//- Many points at once are found by their place where all cells are equal boxes, one by one through
//  faces: the same cells, also beside faces and on the boundary, and in meshes that are no lattice
TEST(LocateParticles, manyAsOneByOne)
{
    const auto rounded = [](const point& p)
    {
        point q;
        for (direction d = 0; d < 3; ++d) q[d] = std::round(1e6*p[d])*1e-6;
        return q;
    };
    const std::vector<std::function<point(const point&)>> maps
    {
        [](const point& p) { return p; },
        rounded,
        [](const point& p) { return point(p.x(), p.y() + 0.1*p.y()*p.y(), p.z()); },
        [](const point& p) { return point(p.x() + 0.3*p.y(), p.y(), p.z()); },
        [](const point& p) { return point(p.x(), p.y(), p.z() + (p.x() > 0.9 ? 1e-3 : 0)); }
    };
    const double beside[] = {0, 1e-13, 1e-11, 1e-8, 1e-6, -1e-13, -1e-11, -1e-8};
    for (std::size_t m = 0; m < maps.size(); ++m)
    {
        BoxMesh box(block());
        box.map = maps[m];
        const auto mesh = box.make(testTime());
        EXPECT_EQ(bool(cellLattice(mesh())), m < 2) << "map " << m;
        pointField points(randomPoints(900));
        forAll(points, i)
        {
            const double off = beside[i % 8];
            if (i % 5 == 1) points[i].x() = i % 2 ? 1 + off : -1 - off;
            points[i] = maps[m](points[i] + vector(off, 0, i % 7 ? off : 0));
        }
        const labelList together(locateParticles(mesh(), points, labelList(), true));
        const cellLattice none{};
        forAll(points, i)
        {
            const labelList alone(
                locateParticles(mesh(), pointField(1, points[i]), labelList(), true, &none));
            // outside, several cells may be as near
            const auto far = [&](label c) { return mag(mesh->cellCentres()[c] - points[i]); };
            const bool inside = locateParticles(
                mesh(), pointField(1, points[i]), labelList(), false, &none)[0] >= 0;
            if (inside) { ASSERT_EQ(together[i], alone[0]) << "map " << m << ", point " << i; }
            else { ASSERT_NEAR(far(together[i]), far(alone[0]), 1e-9) << m << ", point " << i; }
        }
    }
}

TEST(LocateParticles, outside)
{
    const auto mesh = block().make(testTime());
    const pointField points({{-1.2, 0.01, 3.1}, {0.99, 0.49, 9}, {0, 0.2, 5}});
    EXPECT_EQ(locateParticles(mesh(), points, labelList(), false),
        labelList({-1, -1, n/2 + n*label(0.2/0.5*n) + n*n*(n/2)}));
    const labelList nearest(locateParticles(mesh(), points, labelList(), true));
    EXPECT_EQ(nearest[0], 0);
    EXPECT_EQ(nearest[1], n*n*n - 1);
}

//- Where cells are left out, walks end at their faces: the search tree decides
TEST(LocateParticles, roundAHole)
{
    BoxMesh box(block());
    box.there = [](int i, int j, int k) { return i != 3 || j == 0 || k < 2; };
    const std::vector<int> number(box.numbers());
    const auto mesh = box.make(testTime());
    const pointField points(randomPoints(900));
    labelList last(points.size(), number[0]);
    const labelList cell(locateParticles(mesh(), points, last, false));
    forAll(points, i)
    {
        if (i % 3 == 0) continue;
        const point& p = points[i];
        const int at[3] = {int((p.x() + 1)/2*n), int(p.y()/0.5*n), int((p.z() - 3)/4*n)};
        EXPECT_EQ(cell[i], number[at[0] + n*(at[1] + n*at[2])]) << i;
    }
}

//- Warped faces are not walked through: OpenFOAM's own search says where
TEST(LocateParticles, inWarpedCells)
{
    BoxMesh box(block());
    box.map = [](const point& p)
    {
        return point(p.x() + 0.05*std::sin(7*p.y() + p.z()), p.y(), p.z() + 0.1*p.x()*p.y());
    };
    const auto mesh = box.make(testTime());
    pointField points(randomPoints(200));
    for (point& p : points) p = box.map(point(0.99*p.x(), 0.99*p.y() + 1e-3, 5 + 0.99*(p.z() - 5)));
    const labelList cell(locateParticles(mesh(), points, labelList(), false));
    forAll(points, i)
    {
        if (i % 3 == 0) continue;
        EXPECT_TRUE(mesh->pointInCell(points[i], cell[i])) << i;
    }
}
