// SPDX-License-Identifier: GPL-3.0-or-later
/*  Points spread over a piece of surface: number, place, distance of neighbours. */

#include "pointGrid.H"
#include "sheetSampling.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- Triangles of n x m squares, each corner at map(u, v), u and v from 0 to 1
    template<class Map>
    triSurface sheet(label n, label m, const Map& map)
    {
        pointField points((n + 1)*(m + 1));
        forAll(points, i)
        {
            const label row = i/(n + 1);
            points[i] = map(scalar(i % (n + 1))/n, scalar(row)/m);
        }
        List<labelledTri> faces;
        for (label j = 0; j < m; ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                const label a = i + (n + 1)*j, b = a + n + 1;
                faces.append(labelledTri(a, a + 1, b + 1, 0));
                faces.append(labelledTri(a, b + 1, b, 0));
            }
        }
        return triSurface(faces, geometricSurfacePatchList(), points);
    }

    const vector e1(normalised(vector(1, 2, 2))), e2(normalised(vector(2, 1, -2)));

    double nearestTwo(const sheetPoints& points, double spacing)
    {
        const pointGrid grid(spacing, points.position);
        double least = spacing;
        forAll(points.position, i)
            least = min(least, grid.nearest(points.position[i], i));
        return least;
    }
}

TEST(SheetSampling, knowsRectangles)
{
    const vector corner(3, -1, 2);
    const triSurface whole
    (
        sheet(3, 2, [&](scalar u, scalar v) { return corner + 3*u*e1 + 0.7*v*e2; })
    );
    point at;
    vector side1, side2;
    ASSERT_TRUE(isRectangle(whole, at, side1, side2));
    // from one of its four corners, along its sides
    EXPECT_NEAR(mag(side1)*mag(side2), 2.1, 1e-12);
    EXPECT_NEAR(side1 & side2, 0, 1e-12);
    const point middle(at + 0.5*(side1 + side2));
    EXPECT_LT(mag(middle - (corner + 1.5*e1 + 0.35*e2)), 1e-12);

    const auto sheared = [&](scalar u, scalar v) { return (u + 0.1*v)*e1 + v*e2; };
    EXPECT_FALSE(isRectangle(sheet(3, 2, sheared), at, side1, side2));
    const auto bent = [&](scalar u, scalar v) { return point(u, v, 0.05*u*u); };
    EXPECT_FALSE(isRectangle(sheet(3, 2, bent), at, side1, side2));
}

TEST(SheetSampling, latticeOfRectangles)
{
    const sheetPoints points(latticeOnRectangle({1, 2, 3}, {1.04, 0, 0}, {0, 0, 0.46}, 0.1));
    ASSERT_EQ(points.position.size(), 10*5);
    forAll(points.position, i)
    {
        const vector p(points.position[i] - point(1, 2, 3));
        const label row = i/10;
        EXPECT_NEAR(p.x(), 0.104*(i % 10 + 0.5), 1e-12);
        EXPECT_NEAR(p.z(), 0.092*(row + 0.5), 1e-12);
    }
}

//- A quarter of a cylinder's wall and a cap of a paraboloid: as many points as spacings^2 go in, on
//  the sheet, and evenly
TEST(SheetSampling, relaxesOnAnyShape)
{
    const double pi = std::acos(-1.0), spacing = 0.1;
    const triSurface quarter
    (
        sheet(20, 4, [=](scalar u, scalar v)
            { return point(std::cos(0.5*pi*u), std::sin(0.5*pi*u), v); })
    );
    const triSurface disk
    (
        sheet(12, 12, [=](scalar u, scalar v)
            {
                // a disk by concentric squares
                const scalar x = 2*u - 1, y = 2*v - 1, r = max(mag(x), mag(y));
                const scalar length = max(std::hypot(x, y), SMALL);
                return point(r*x/length, r*y/length, 0.2*r*r);
            })
    );
    for (const triSurface* s : {&quarter, &disk})
    {
        const sheetPoints points(relaxedOnSheet(*s, spacing));
        const double area = sum(mag(s->faceAreas()));
        EXPECT_EQ(points.position.size(), label(area/sqr(spacing) + 0.5));
        // Even: hexagons would be 1.07 spacings apart; random points not a tenth of one
        EXPECT_GT(nearestTwo(points, spacing), 0.65*spacing);
        forAll(points.position, i)
        {
            const point& p = points.position[i];
            ASSERT_EQ(points.face[i] >= 0 && points.face[i] < s->size(), true);
            const labelledTri& t = s->localFaces()[points.face[i]];
            EXPECT_LT(t.nearestPoint(p, s->localPoints()).distance(), 1e-9);
        }
    }
}

//- Points end half a spacing before the edge
TEST(SheetSampling, staysOffTheEdge)
{
    const double spacing = 0.1;
    const triSurface square
    (
        sheet(1, 1, [](scalar u, scalar v) { return point(u + 0.3*v, v, 0); })
    );
    const sheetPoints points(relaxedOnSheet(square, spacing));
    EXPECT_EQ(points.position.size(), 100);
    double nearest = 1, mean = 0;
    for (const point& p : points.position)
    {
        nearest = min(nearest, min(p.y(), 1 - p.y()));
        mean += (p.y() - 0.5)/100;
    }
    EXPECT_GT(nearest, 0.25*spacing);
    EXPECT_LT(nearest, 0.75*spacing);
    EXPECT_NEAR(mean, 0, 0.1*spacing);
    EXPECT_EQ(relaxedOnSheet(square, 5).position.size(), 0);
}
