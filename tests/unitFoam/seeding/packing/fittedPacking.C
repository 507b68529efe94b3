// SPDX-License-Identifier: GPL-3.0-or-later
/*  Shapes in 2D and 3D as regions are made of, and packings that follow them. */

#include "boxMesh.hpp"
#include "fittedPacking.H"
#include "regionShapes.H"
#include "scratchCase.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    particlePacking frame(int D, double spacing = 0.1)
    {
        BoxMesh box;
        if (D == 2) box.sides(1, "empty");
        const auto mesh = box.make(testTime());
        return particlePacking(mesh(), particlePacking::kind::square, spacing, vector(0, 0, -9.81));
    }

    double nearestTwo(const pointField& x)
    {
        double least = GREAT;
        forAll(x, i)
            for (label j = 0; j < i; ++j) least = min(least, mag(x[i] - x[j]));
        return least;
    }
}

//- The mid-plane is y = 0.5
TEST(RegionShapes, sectionsIn2D)
{
    const particlePacking plane(frame(2));
    const dictionary none;
    const clumpShape box(boxShape(boundBox(point(1, 0, 2), point(2, 1, 5)), plane));
    EXPECT_NEAR(box.volume, 3, 1e-14);
    EXPECT_LT(mag(box.middle - point(1.5, 0.5, 3.5)), 1e-14);
    EXPECT_NEAR(box.moments[2], 3*(1 + 9)/12.0, 1e-13);
    EXPECT_NEAR(box.distance(pointField(1, point(3, 8, 6)))[0], std::sqrt(2.0), 1e-14);

    // a ball that the plane cuts off its middle
    const clumpShape ball(sphereShape({1, 0.2, 3}, 0.5, plane));
    EXPECT_NEAR(ball.volume, pi*0.16, 1e-14);
    EXPECT_NEAR(ball.moments[2], 0.5*pi*0.16*0.16, 1e-14);
    EXPECT_NEAR(ball.distance(pointField(1, point(1, 0.5, 4)))[0], 0.6, 1e-14);

    const clumpShape pile(cylinderShape({1, -1, 3}, {1, 2, 3}, 0.5, plane, none));
    EXPECT_NEAR(pile.volume, pi*0.25, 1e-14);
    // lying in the plane, cut 0.3 off its axis: a rectangle
    const clumpShape log(cylinderShape({0, 0.2, 0}, {3, 0.2, 4}, 0.5, plane, none));
    EXPECT_NEAR(log.volume, 5*0.8, 1e-13);
    EXPECT_NEAR(log.moments[2], 4*(25 + 0.64)/12, 1e-12);
    EXPECT_NEAR(log.distance(pointField(1, point(1.5, 0, 2)))[0], -0.4, 1e-13);
    EXPECT_EQ(messageOf([&]() { cylinderShape({0, 0, 0}, {1, 1, 0}, 0.5, plane, none); }),
        "Entries p1 and p2: in this 2D case a cylinder must lie along the empty direction or "
        "across it");
}

TEST(RegionShapes, inertiaAndNormals)
{
    const particlePacking space(frame(3));
    const clumpShape s(cylinderShape({0, 0, 0}, {0, 2, 0}, 0.5, space, dictionary()));
    const tensor J(inertiaOf(s));
    EXPECT_NEAR(J.yy(), s.volume*0.125, 1e-13);
    EXPECT_NEAR(J.xx(), s.volume*(0.75 + 4)/12, 1e-13);
    EXPECT_NEAR(J.xy(), 0, 1e-13);
    const vectorField n
    (
        normalsOf(s, pointField({{0.4, 1, 0.3}, {0, 1.9, 0.1}}), 1e-3, space)
    );
    EXPECT_LT(mag(n[0] - vector(0.8, 0, 0.6)), 1e-6);
    EXPECT_LT(mag(n[1] - vector(0, 1, 0)), 1e-6);
}

//- In a disk and a ball: as many as go in, half a spacing off the surface, and none too near
TEST(FittedPacking, fillsRoundShapes)
{
    for (const int D : {2, 3})
    {
        const double dp = 0.1, r = D == 2 ? 0.45 : 0.3;
        const particlePacking lattice(frame(D, dp));
        const clumpShape s(sphereShape({0.5, 0.5, 0.5}, r, lattice));
        const fittedPacking packing{s, lattice, dp, 0.5*dp, true};
        const pointField x(packing.fill());
        EXPECT_EQ(x.size(), std::lround(s.volume/std::pow(dp, D)));
        const scalarField depth(packing.depth(x));
        EXPECT_GT(min(depth), (0.5 - 1e-3)*dp);
        EXPECT_LT(min(depth), 0.6*dp);
        EXPECT_GT(nearestTwo(x), (D == 2 ? 0.8 : 0.7)*dp);
        vector middle(Zero);
        for (const point& p : x) middle += p/x.size();
        EXPECT_LT(mag(middle - point(0.5, 0.5, 0.5)), 0.1*dp);
        // the kernel's sum in the middle is that of a lattice
        double sum = 0;
        for (const point& p : x)
        {
            const double q = mag(p - middle)/(1.25*dp);
            const double alpha = (D == 2 ? 7/(4*pi) : 21/(16*pi))/std::pow(1.25, D);
            if (q < 2) sum += alpha*std::pow(1 - 0.5*q, 4)*(1 + 2*q);
        }
        EXPECT_NEAR(sum, 1, 0.12);
    }
}

//- Around a shape: what is held stays, and the others stay off
TEST(FittedPacking, outsideAndHeld)
{
    const double dp = 0.1;
    const particlePacking lattice(frame(2, dp));
    const clumpShape s(boxShape(boundBox(point(0, 0, 0), point(1, 1, 1)), lattice));
    const fittedPacking packing{s, lattice, dp, 0.5*dp, false};
    EXPECT_NEAR(packing.depth(pointField(1, point(1.3, 0.5, 0.5)))[0], 0.3, 1e-14);
    pointField x({{1.01, 0.5, 0.5}, {1.01, 0.5, 0.55}});
    const pointField held(1, point(1.05, 0.5, 0.4));
    packing.relax(x, held, scalarField(1, 1.0), false);
    for (const point& p : x)
    {
        EXPECT_GT(p.x(), 1.05 - 1e-3*dp);
        EXPECT_GT(mag(p - held[0]), dp);
        EXPECT_NEAR(p.y(), 0.5, 1e-14);
    }
    EXPECT_GT(mag(x[0] - x[1]), dp);
}
