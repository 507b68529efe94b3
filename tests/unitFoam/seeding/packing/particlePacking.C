// SPDX-License-Identifier: GPL-3.0-or-later
/*  Regular packings: as many particles as volumes go in, neighbours where the lattice has them. */

#include "boxMesh.hpp"
#include "particlePacking.H"
#include "scratchCase.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    using kind = particlePacking::kind;
    const boundBox everywhere(point(-10, -10, -10), point(10, 10, 10));

    particlePacking packing(int D, kind k, double spacing, const vector& g = vector(0, 0, -9.81))
    {
        BoxMesh box;
        if (D == 2) box.sides(1, "empty");
        const auto mesh = box.make(testTime());
        return particlePacking(mesh(), k, spacing, g);
    }

    //- How many neighbours each inner point has at distance a, and how near the nearest is
    void expectNeighbours(const pointField& points, double a, label expected)
    {
        const boundBox all(points, false);
        label inner = 0;
        for (const point& p : points)
        {
            bool in = true;
            for (direction d = 0; d < 3; ++d)
                in = in && (all.span()[d] < a
                    || min(p[d] - all.min()[d], all.max()[d] - p[d]) > 1.1*a);
            if (!in) continue;
            ++inner;
            label n = 0;
            for (const point& q : points)
            {
                const double r = mag(p - q);
                EXPECT_TRUE(r == 0 || r > a*(1 - 1e-9));
                n += r > 0 && r < a*(1 + 1e-9);
            }
            EXPECT_EQ(n, expected);
        }
        EXPECT_GT(inner, 5);
    }
}

TEST(ParticlePacking, squareFromTheCorner)
{
    const boundBox box(point(0.5, 0, -1), point(1.54, 1, -0.5));
    for (const int D : {2, 3})
    {
        const particlePacking p(packing(D, kind::square, 0.1));
        EXPECT_NEAR(p.volume(), std::pow(0.1, D), 1e-15);
        const pointField points(p.fill(box, everywhere));
        // a particle whose middle is beyond the box is none
        ASSERT_EQ(points.size(), 10*5*(D == 2 ? 1 : 10));
        for (const point& x : points)
        {
            for (const direction d : {0, 2})
            {
                const double cell = (x[d] - box.min()[d])/0.1 - 0.5;
                EXPECT_NEAR(cell, std::round(cell), 1e-9);
            }
            if (D == 2) { EXPECT_NEAR(x.y(), 0.5, 1e-14); }
        }
        expectNeighbours(points, 0.1, 2*D);
    }
}

TEST(ParticlePacking, hexagonalHasItsNeighboursAndItsDensity)
{
    for (const int D : {2, 3})
    {
        const double s = 0.1;
        const double a = D == 2 ? s*std::sqrt(2/std::sqrt(3.0)) : s*std::pow(2, 1.0/6);
        const particlePacking p(packing(D, kind::hexagonal, s));
        const boundBox box(point(0, 0, 0), point(1.3, 1.1, 1.2));
        const pointField points(p.fill(box, everywhere));
        const double volume = D == 2 ? 1.3*1.2 : 1.3*1.1*1.2;
        EXPECT_NEAR(points.size()*p.volume()/volume, 1, 0.06);
        expectNeighbours(points, a, D == 2 ? 6 : 12);
    }
}

TEST(ParticlePacking, boxesSideBySideShareNone)
{
    for (const kind k : {kind::square, kind::hexagonal})
    {
        const particlePacking p(packing(3, k, 0.1));
        const pointField a(p.fill(boundBox(point(0, 0, 0), point(0.5, 1, 1)), everywhere));
        const pointField b(p.fill(boundBox(point(0.5, 0, 0), point(1, 1, 1)), everywhere));
        for (const point& x : a) EXPECT_LT(x.x(), 0.5);
        for (const point& x : b) EXPECT_GT(x.x(), 0.5);
        if (k == kind::square) { EXPECT_EQ(a.size() + b.size(), 1000); }
    }
}

TEST(ParticlePacking, limitsCutAndMoveNothing)
{
    for (const kind k : {kind::square, kind::hexagonal})
    {
        const particlePacking p(packing(3, k, 0.1));
        const boundBox box(point(-3, 0, 0), point(1, 1, 1));
        const boundBox limits(point(0.22, 0.3, -1), point(0.9, 0.81, 0.5));
        const pointField all(p.fill(box, everywhere)), some(p.fill(box, limits));
        label n = 0;
        for (const point& x : all)
        {
            if (!limits.contains(x)) continue;
            ASSERT_LT(n, some.size());
            EXPECT_LT(mag(some[n++] - x), 1e-12);
        }
        EXPECT_EQ(n, some.size());
        const double guess = p.estimate(box, limits);
        EXPECT_GT(guess, 0.5*n);
        EXPECT_LT(guess, 2*n);
    }
}

TEST(ParticlePacking, layersAcrossGravity)
{
    EXPECT_EQ(packing(3, kind::hexagonal, 0.1, {0, -9.81, 0}).axis(2), 1);
    EXPECT_EQ(packing(3, kind::hexagonal, 0.1, {3, -1, 2}).axis(2), 0);
    EXPECT_EQ(packing(3, kind::hexagonal, 0.1, {0, 0, 0}).axis(2), 2);
    const particlePacking flat(packing(2, kind::hexagonal, 0.1, {1, 0, 0}));
    EXPECT_EQ(flat.axis(0), 2);
    EXPECT_EQ(flat.axis(1), 0);
    EXPECT_EQ(flat.axis(2), 1);
    EXPECT_EQ(flat.inPlane({1, 7, 2}), point(1, 0.5, 2));
    // a box beside the mid-plane holds none
    EXPECT_TRUE(flat.fill(boundBox(point(0, 0.6, 0), point(1, 1, 1)), everywhere).empty());
    EXPECT_EQ(flat.with(0.2).spacing(), 0.2);
}
