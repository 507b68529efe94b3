// SPDX-License-Identifier: GPL-3.0-or-later
/*  Lattices in parts: the points of all, each with its number. */

#include "boxMesh.hpp"
#include "latticeRows.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>
#include <map>

using namespace Foam;

namespace
{
    using kind = particlePacking::kind;
    const boundBox everywhere(point(-10, -10, -10), point(10, 10, 10));

    particlePacking packing(int D, kind k)
    {
        BoxMesh box;
        if (D == 2) box.sides(1, "empty");
        const auto mesh = box.make(testTime());
        return particlePacking(mesh(), k, 0.1, vector(0, 0, -9.81));
    }

    using numbered = std::map<std::int64_t, point>;

    //- Adds those of a part; none may be there twice
    void add(const latticeRows& rows, const boundBox& part, std::int64_t first, std::int64_t end,
        numbered& all)
    {
        rows.each(part, first, end, [&](const point& p, std::int64_t n)
        {
            EXPECT_GE(n, first);
            EXPECT_LT(n, end);
            EXPECT_TRUE(all.emplace(n, p).second);
        });
    }

    void expectSame(const pointField& points, const numbered& all)
    {
        ASSERT_EQ(std::size_t(points.size()), all.size());
        label i = 0;
        for (const auto& entry : all) EXPECT_EQ(points[i++], entry.second);
    }
}

TEST(LatticeRows, partsAreTheWhole)
{
    const boundBox box(point(-0.33, 0, -1), point(1.54, 1, 0.5));
    const boundBox limits(point(-0.2, -5, -0.72), point(1.2, 5, 5));
    for (const int D : {2, 3})
    {
        for (const kind k : {kind::square, kind::hexagonal})
        {
            const particlePacking p(packing(D, k));
            const latticeRows rows(p, box, limits);
            const pointField points(p.fill(box, limits));
            ASSERT_GT(points.size(), 50);

            // By numbers, of which some blocks end within rows
            numbered byNumber;
            for (std::int64_t first = 0; first < rows.numbers(); first += 37)
                add(rows, everywhere, first, std::min(first + 37, rows.numbers()), byNumber);
            expectSame(points, byNumber);

            // By place: points on neither of the faces between
            numbered byPlace;
            for (const scalar x : {-10.0, 0.4321})
            {
                for (const scalar z : {-10.0, -0.1234})
                {
                    const boundBox part(point(x, -10, z),
                        point(x < 0 ? 0.4321 : 10, 10, z < -1 ? -0.1234 : 10));
                    add(rows, part, 0, rows.numbers(), byPlace);
                }
            }
            expectSame(points, byPlace);
        }
    }
}

TEST(LatticeRows, nothingOffThePlane)
{
    const particlePacking p(packing(2, kind::square));
    const latticeRows rows(p, boundBox(point(0, 3, 0), point(1, 4, 1)), everywhere);
    EXPECT_EQ(rows.numbers(), 0);
    EXPECT_TRUE(rows.points().empty());
}
