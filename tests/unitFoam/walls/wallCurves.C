// SPDX-License-Identifier: GPL-3.0-or-later
/*  2D walls of any shape: layers along curves, corners up to the mitre. */

#include "laidWalls.hpp"
#include "testTime.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    constexpr int layers = 3;
    const double pi = std::acos(-1.0);

    //- In the plane of x and y
    BoxMesh flatBox(double x, double y, int n, int m)
    {
        BoxMesh box;
        box.divide(0, 0, x, n);
        box.divide(1, 0, y, m);
        box.divide(2, -0.5, 0.5, 1);
        box.sides(2, "empty");
        return box;
    }

    //- A ring sector: x is the angle, 1 + y the radius
    BoxMesh sector(double angle, const char* ends)
    {
        BoxMesh box(flatBox(angle, 1, 60, 5));
        box.sides(0, ends);
        box.map = [](const point& p)
        {
            const double r = 1 + p.y();
            return point(r*std::sin(p.x()), r*std::cos(p.x()), p.z());
        };
        return box;
    }

    label within(const UList<point>& points, double least, double most)
    {
        label n = 0;
        for (const point& p : points) n += mag(p) > least && mag(p) < most;
        return n;
    }
}

TEST(WallCurves, layersOfARing)
{
    const double dp = 0.05, angle = 0.5*pi;
    const auto mesh = sector(angle, "patch").make(testTime());
    const wallPoints w(laid(mesh(), wallControls(dp, layers)));
    // A polygon of 60 sides, whose middles are nearer by 1 - cos of half their angle; moved by d
    // its sides are longer or shorter, but not where they end
    const double half = 0.5*angle/60, sag = 2*(1 - std::cos(half)) + 1e-9;
    const auto expected = [&](double R, double d)
    {
        const double length
            = 2*59*(R*std::cos(half) + d)*std::tan(half) + 2*R*std::sin(half);
        return std::lround(length/dp);
    };
    label all = 0;
    for (int layer = 0; layer < layers; ++layer)
    {
        const double d = (layer + 0.5)*dp;
        EXPECT_EQ(within(w.position, 2 + d - sag, 2 + d + sag), expected(2, d));
        EXPECT_EQ(within(w.position, 1 - d - sag, 1 - d + sag), expected(1, -d));
        all += label(expected(2, d) + expected(1, -d));
    }
    EXPECT_EQ(w.size(), all);
    for (label i = 0; i < w.size(); ++i)
    {
        const point& p = w.position[i];
        const vector out(p.x()/mag(p), p.y()/mag(p), 0);
        EXPECT_GT((mag(p) > 1.5 ? -1 : 1)*(w.normal[i] & out), std::cos(angle/60));
        EXPECT_NEAR(p.z(), 0, 1e-12);
        // in the sector: layers end where the wall does
        EXPECT_GT(p.x(), 0);
        EXPECT_GT(p.y(), 0);
    }
    EXPECT_GT(nearestTwo(w.position), 0.9*dp);
}

//- Given first offsets; walls that are a straight channel, whose layers are then lines
TEST(WallCurves, offsetOfTheFirstLayer)
{
    BoxMesh box(flatBox(1, 0.5, 10, 5));
    box.sides(0, "patch");
    const auto mesh = box.make(testTime());
    for (const double offset : {0.0, 0.02, 0.1})
    {
        const wallPoints w(laid(mesh(), wallControls(0.1, layers, offset)));
        ASSERT_EQ(w.size(), offset > 0 ? 2*10*layers : w.size());
        for (const point& p : w.position)
        {
            const double behind = p.y() < 0.25 ? -p.y() : p.y() - 0.5;
            const double layer = (behind - offset)/0.1;
            EXPECT_NEAR(layer, std::round(layer), 1e-9);
            const double column = p.x()/0.1 - 0.5;
            EXPECT_NEAR(column, std::round(column), 1e-9);
        }
    }
}

//- A parallelogram: two sharp corners and two blunt ones. The band behind its walls has as many
//  points as its area, and no holes: kernel sums beside the wall and in the corners
TEST(WallCurves, cornersAreFilledToTheMitre)
{
    const double dp = 0.02, slope = 0.6, h = 1.3*dp;
    BoxMesh box(flatBox(1, 0.5, 10, 5));
    box.map = [=](const point& p) { return point(p.x() + slope*p.y(), p.y(), p.z()); };
    const auto mesh = box.make(testTime());
    const wallPoints w(laid(mesh(), wallControls(dp, layers)));

    const double side = 0.5*std::sqrt(1 + slope*slope), d = layers*dp;
    const double half = 0.5*std::atan2(1, slope);               // of the angle at the origin
    // a mitred corner: d^2 cot of half the angle inside
    const double corners = 2*d*d*(1/std::tan(half) + std::tan(half));
    const double band = 2*(1 + side)*d + corners;
    EXPECT_NEAR(w.size()*dp*dp/band, 1, 0.02);
    EXPECT_GT(nearestTwo(w.position), 0.65*dp);

    // Fluid: rows along x, sheared with the walls
    pointField all(w.position);
    pointField fluid(middles({0, 0, 0}, {1, 0.5, 0}, {{50, 25, 1}}));
    for (point& p : fluid) p.x() += slope*p.y();
    all.append(fluid);
    for (const point& p : {point(0.5, 0, 0), point(0.4, 0.5, 0), point(0.15, 0.25, 0)})
        EXPECT_NEAR(kernelSum(all, p, dp, h, 2), 1, 0.06) << p.x() << ' ' << p.y();
    // Without them a corner would lack a sixth (blunt) or a third (sharp) of its support, and more
    for (const point& p : {point(0, 0, 0), point(1, 0, 0), point(1.3, 0.5, 0), point(0.3, 0.5, 0)})
        EXPECT_NEAR(kernelSum(all, p, dp, h, 2), 1, 0.15) << p.x() << ' ' << p.y();
}

//- A ring that closes on itself, by cyclic ends or by a plate that is bent to a full circle
TEST(WallCurves, seamsAreLaidAlongTheCyclicPatch)
{
    const double dp = 0.05;
    BoxMesh box(flatBox(1, 0.5, 20, 5));
    box.sides(0, "cyclic");
    // The bed rises as a sine that meets its image with a slope
    box.map = [](const point& p)
    {
        return point(p.x(), p.y() + 0.1*std::sin(2*pi*p.x())*(1 - 2*p.y()), p.z());
    };
    const auto mesh = box.make(testTime());
    const wallPoints w(laid(mesh(), wallControls(dp, layers)));
    pointField images(w.position);
    for (const double x : {-1, 1})
    {
        pointField moved(w.position + vector(x, 0, 0));
        images.append(moved);
    }
    for (const point& p : w.position)
    {
        EXPECT_GT(p.x(), -0.2*dp);
        EXPECT_LT(p.x(), 1 + 0.2*dp);
    }
    EXPECT_GT(nearestTwo(images), 0.6*dp);
    // Evenly about the seam: half of the support behind the bed is full, as in the middle
    for (const double x : {0.0, 0.01, 0.99, 0.5})
    {
        const point bed(x, 0.1*std::sin(2*pi*x), 0);
        EXPECT_NEAR(kernelSum(images, bed, dp, 1.2*dp, 2), 0.5, 0.06) << x;
    }
}
