// SPDX-License-Identifier: GPL-3.0-or-later
/*  Shapes of rigid bodies: volume, centre, moments, axes and distances in closed form. */

#include "exactShapes.H"
#include "principalAxes.H"
#include "scratchCase.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);
    const int plane[3] = {0, 2, 1};

    clumpShape outline(const std::string& points)
    {
        const dictionary dict(entries("outline " + points + ';'));
        checkedDictionary checked(dict);
        return outlineShape(checked, plane);
    }
}

TEST(ExactShapes, box)
{
    const clumpShape s(boxShape(boundBox(point(1, 2, 3), point(2, 4, 6))));
    EXPECT_NEAR(s.volume, 6, 1e-14);
    EXPECT_EQ(s.middle, point(1.5, 3, 4.5));
    EXPECT_LT(mag(s.moments - 6.0/12*vector(4 + 9, 9 + 1, 1 + 4)), 1e-13);
    EXPECT_EQ(s.longest(), 3);
    const scalarField d
    (
        s.distance(pointField({{1.5, 3, 4.5}, {1.1, 3, 4}, {0, 3, 4}, {0, 1, 4}, {3, 5, 7}}))
    );
    const double expected[] = {-0.5, -0.1, 1, std::sqrt(2.0), std::sqrt(3.0)};
    forAll(d, i) EXPECT_NEAR(d[i], expected[i], 1e-14) << i;
    EXPECT_NEAR(boxDistance({2, 0.5, 9}, {1, 1, 1}, 2), 1, 1e-14);
}

TEST(ExactShapes, sphere)
{
    const clumpShape s(sphereShape({1, 2, 3}, 0.5));
    EXPECT_NEAR(s.volume, pi/6, 1e-14);
    EXPECT_LT(mag(s.moments - 0.1*pi/6*vector::one), 1e-14);
    EXPECT_NEAR(s.distance(pointField(1, point(1, 2, 5)))[0], 1.5, 1e-14);
    EXPECT_EQ(s.box.min(), point(0.5, 1.5, 2.5));
}

TEST(ExactShapes, cylinder)
{
    const point a(1, 1, 1), b(1, 2, 3);
    const double L = std::sqrt(5.0), r = 0.3, V = pi*r*r*L;
    const clumpShape s(cylinderShape(a, b, r));
    EXPECT_NEAR(s.volume, V, 1e-13);
    EXPECT_LT(mag(s.middle - point(1, 1.5, 2)), 1e-14);
    EXPECT_LT(mag(s.moments - V*vector((3*r*r + L*L)/12, (3*r*r + L*L)/12, r*r/2)), 1e-13);
    // a rotation whose third column is the axis
    EXPECT_LT(mag((s.axes & vector(0, 0, 1)) - (b - a)/L), 1e-14);
    EXPECT_LT(mag((s.axes & s.axes.T()) - tensor::I), 1e-14);
    EXPECT_NEAR(det(s.axes), 1, 1e-14);
    const vector n((b - a)/L), across(1, 0, 0);
    const scalarField d
    (
        s.distance(pointField({s.middle, a - 0.5*n, s.middle + across, a - 0.4*n + 0.6*across}))
    );
    const double expected[] = {-0.3, 0.5, 0.7, 0.5};
    forAll(d, i) EXPECT_NEAR(d[i], expected[i], 1e-14) << i;
    // the box just holds it
    EXPECT_NEAR(s.box.max().x(), 1.3, 1e-14);
    EXPECT_NEAR(s.box.max().y(), 2 + 0.3*2/L, 1e-14);
    EXPECT_NEAR(s.box.min().z(), 1 - 0.3*1/L, 1e-14);
}

TEST(ExactShapes, byWord)
{
    const auto of = [](const std::string& text)
    {
        const dictionary dict(entries(text));
        checkedDictionary checked(dict);
        const clumpShape s(exactShape(checked));
        checked.found("source");
        checked.end();
        return s.volume;
    };
    EXPECT_NEAR(of("source box; box (2 3 4) (1 1 1);"), 6, 1e-14);
    EXPECT_NEAR(of("source cylinder; p1 (0 0 0); p2 (0 0 2); radius 1;"), 2*pi, 1e-14);
    EXPECT_NEAR(of("source sphere; centre (0 0 0); radius 1;"), 4*pi/3, 1e-14);
    EXPECT_EQ(messageOf([&]() { of("source sphre; centre (0 0 0); radius 1;"); }),
        "Entry source has the unknown word sphre; valid are (box cylinder sphere); did you mean "
        "sphere?");
    EXPECT_EQ(messageOf([&]() { of("source sphere; centre (0 0 0); radius -1;"); }),
        "Entry radius is -1: it must be positive");
}

//- A right triangle and an L, in the plane of x and z, either way round
TEST(ExactShapes, outlines)
{
    for (const char* points : {"((1 0 1) (4 0 1) (1 0 3))", "((1 0 3) (4 7 1) (1 0 1))"})
    {
        const clumpShape s(outline(points));
        EXPECT_NEAR(s.volume, 3, 1e-14);
        EXPECT_LT(mag(s.middle - point(2, 0, 5.0/3)), 1e-14);
        // b h (b^2 + h^2)/36 about the centre
        EXPECT_NEAR(s.moments[2], 3*2*(9 + 4)/36.0, 1e-13);
        EXPECT_NEAR(s.distance(pointField(1, point(1.5, 9, 1.25)))[0], -0.25, 1e-14);
        EXPECT_NEAR(s.distance(pointField(1, point(0, 0, 0)))[0], std::sqrt(2.0), 1e-14);
    }
    const clumpShape L(outline("((0 0 0) (2 0 0) (2 0 1) (1 0 1) (1 0 2) (0 0 2))"));
    EXPECT_NEAR(L.volume, 3, 1e-14);
    EXPECT_LT(mag(L.middle - point(2.5/3, 0, 2.5/3)), 1e-14);
    EXPECT_NEAR(L.distance(pointField(1, point(1.5, 0, 1.5)))[0], 0.5, 1e-14);
    EXPECT_EQ(messageOf([]() { outline("((0 0 0) (1 0 0))"); }),
        "Entry outline needs at least three points");
    EXPECT_EQ(messageOf([]() { outline("((0 0 0) (1 0 1) (1 0 0) (0 0 1))"); }),
        "Entry outline crosses itself");
    EXPECT_EQ(messageOf([]() { outline("((0 0 0) (1 0 0) (1 3 0) (0 0 1))"); }),
        "Entry outline has the same point twice in a row");
}

//- A turned tensor gives its moments back, equal ones too; axes are a rotation
TEST(PrincipalAxes, ofTurnedTensors)
{
    const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.9), e = std::sin(1.9);
    const tensor turn
    (
        tensor(c, -s, 0, s, c, 0, 0, 0, 1) & tensor(1, 0, 0, 0, d, -e, 0, e, d)
    );
    for (const vector& moments : {vector(1, 2, 5), vector(3, 3, 1), vector(2, 2, 2),
             vector(1e-12, 1, 1e6), vector(0, 0, 4)})
    {
        const tensor J
        (
            turn & tensor(moments.x(), 0, 0, 0, moments.y(), 0, 0, 0, moments.z()) & turn.T()
        );
        tensor axes;
        const vector found(principalMoments(J, axes));
        const double size = mag(J);
        EXPECT_LT(mag((axes & axes.T()) - tensor::I), 1e-13);
        EXPECT_NEAR(det(axes), 1, 1e-13);
        const tensor back
        (
            axes & tensor(found.x(), 0, 0, 0, found.y(), 0, 0, 0, found.z()) & axes.T()
        );
        EXPECT_LT(mag(back - J), 1e-13*size);
        double sorted[3] = {found.x(), found.y(), found.z()};
        double expected[3] = {moments.x(), moments.y(), moments.z()};
        std::sort(sorted, sorted + 3);
        std::sort(expected, expected + 3);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(sorted[i], expected[i], 1e-13*size);
    }
}

TEST(ShapeLattice, evenAndInTheMiddle)
{
    const pointField p(shapeLattice(boundBox(point(0, 0, 0), point(1, 0.5, 0.24)), 10));
    EXPECT_EQ(p.size(), 11*6*3);
    EXPECT_LT(mag(boundBox(p, false).midpoint() - point(0.5, 0.25, 0.12)), 1e-14);
    EXPECT_NEAR(mag(p[1] - p[0]), 0.1, 1e-14);
}
