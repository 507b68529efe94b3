/*  A disk's part of a square, and a ball's of the faces of a grid: closed forms, and lines across.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <gtest/gtest.h>
#include <map>
#include <random>
#include "bodyReference.hpp"
#include "pic/bodies/bodyShape.hpp"

namespace riprap
{
namespace
{

//- By lines along y, whose lengths are known; between the points where these bend, at places that
//  crowd towards the ends
SolidPart<3> byLines(double x, double y, double r)
{
    constexpr int lines = 400;
    std::vector<double> ends{x, x + 1};
    const auto add = [&](double at) { if (at > x && at < x + 1) ends.push_back(at); };
    for (const double s : {-1.0, 1.0})
    {
        add(s*r);
        for (const double side : {y, y + 1})
            if (r > std::abs(side)) add(s*std::sqrt(r*r - side*side));
    }
    std::sort(ends.begin(), ends.end());
    SolidPart<3> sum{0, {0, 0}};
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        for (int i = 0; i < lines; ++i)
        {
            const double angle = M_PI*(i + 0.5)/lines, a = ends[k], b = ends[k + 1],
                         at = a + 0.5*(b - a)*(1 - std::cos(angle)),
                         width = 0.5*(b - a)*M_PI/lines*std::sin(angle);
            if (!(r > std::abs(at))) continue;
            const double half = std::sqrt(r*r - at*at), from = std::max(y, -half),
                         to = std::min(y + 1, half);
            if (!(to > from)) continue;
            sum.share += width*(to - from);
            sum.moment[0] += width*(to - from)*(at - x);
            sum.moment[1] += width*(0.5*(to*to - from*from) - y*(to - from));
        }
    return sum;
}

TEST(DiskInSquare, IsWhatLinesAcrossFind)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    int cut = 0;
    for (int k = 0; k < 4000; ++k)
    {
        const double r = k % 2 ? 1.2*unit(random) : 12*unit(random),
                     angle = 2*M_PI*unit(random), off = r + 2.4*(unit(random) - 0.5);
        const double x = off*std::cos(angle) - unit(random), y = off*std::sin(angle) - unit(random);
        const SolidPart<3> a = diskInSquare(x, y, r*r), b = byLines(x, y, r);
        constexpr double sums = 1e-5;       // of lines: their distance squared
        ASSERT_NEAR(a.share, b.share, sums) << x << " " << y << " " << r;
        for (int m = 0; m < 2; ++m)
            ASSERT_NEAR(a.moment[m], b.moment[m], sums) << x << " " << y << " " << r;
        cut += a.share > 0 && a.share < 1;
    }
    EXPECT_GT(cut, 1000);
}

TEST(DiskInSquare, QuartersHalvesAndSegments)
{
    for (const double r : {0.01, 0.3, 0.7, 1.0})
    {
        const SolidPart<3> quarter = diskInSquare(0, 0, r*r);
        EXPECT_NEAR(quarter.share, M_PI*r*r/4, 1e-15);
        for (int m = 0; m < 2; ++m) EXPECT_NEAR(quarter.moment[m], r*r*r/3, 1e-15);
    }
    for (const double r : {0.1, 0.49, 0.5})
    {
        const SolidPart<3> half = diskInSquare(0, -0.5, r*r), whole = diskInSquare(-0.5, -0.5, r*r);
        EXPECT_NEAR(half.share, M_PI*r*r/2, 1e-15);
        EXPECT_NEAR(half.moment[0], 2*r*r*r/3, 1e-15);
        EXPECT_NEAR(half.moment[1], 0.5*half.share, 1e-15);
        EXPECT_NEAR(whole.share, M_PI*r*r, 1e-15);
        EXPECT_NEAR(whole.moment[0], 0.5*whole.share, 1e-15);
    }
    // a segment of height r - c, from beside the square; its moment about the disk's middle is 2/3
    // of half its chord cubed
    for (const double r : {0.5, 3.0, 40.0})
    {
        const double height = 0.02*std::min(1.0, 1/r), c = r - height, half2 = height*(r + c),
                     area = r*r*std::asin(std::sqrt(half2)/r) - c*std::sqrt(half2);
        const SolidPart<3> part = diskInSquare(c, -0.5, r*r);
        EXPECT_NEAR(part.share, area, 1e-15*r*r);
        EXPECT_NEAR(part.moment[0], 2.0/3*std::pow(half2, 1.5) - c*area, 1e-15*r*r*r);
    }
}

//- Squares of a lattice have the whole of it between them, its middle included, wherever it lies:
//  on their sides and corners, and through corners, too
TEST(DiskInSquare, SquaresShareItOut)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 400; ++k)
    {
        double r = k % 3 ? 10*unit(random) : unit(random), x = unit(random), y = unit(random);
        if (k % 5 == 0) x = 0;
        if (k % 7 == 0) y = 0.5;
        if (k % 4 == 0) r = std::hypot(3 - x, 2 - y);
        if (k % 9 == 0) r = std::ceil(r) - x;
        double area = 0, moment[2] = {0, 0};
        for (int i = -12; i < 14; ++i)
            for (int j = -12; j < 14; ++j)
            {
                const SolidPart<3> p = diskInSquare(i - x, j - y, r*r);
                area += p.share;
                moment[0] += p.moment[0] + i*p.share;
                moment[1] += p.moment[1] + j*p.share;
            }
        const double exact = M_PI*r*r, roundOff = 1e-13*(1 + r*r*r);
        ASSERT_NEAR(area, exact, roundOff) << x << " " << y << " " << r;
        ASSERT_NEAR(moment[0], exact*x, roundOff) << x << " " << y << " " << r;
        ASSERT_NEAR(moment[1], exact*y, roundOff) << x << " " << y << " " << r;
    }
}

std::vector<FaceShare<3>> sharesBy(
    const BodyShape<3>& shape, const Vec<3, double>& centre, double reach, double h)
{
    UniformGrid<3> grid{};
    grid.h = h;
    for (int d = 0; d < 3; ++d) { grid.n[d] = 14; grid.origin[d] = 0; }
    std::vector<FaceShare<3>> shares;
    sharesOf(grid, FreeBody<3, BodyShape<3>>{shape, centre, reach, {}}, 0, shares);
    return shares;
}

//- Is there nothing of the mean over planes in this face? It is taken beside the poles
//  (pic/bodies/inBody.hpp)
bool awayFromPoles(const UniformGrid<3>& grid, const Ball<3>& ball, const FaceShare<3>& s)
{
    const Vec<3, double> middle = middleOfFace(
        NodeGrid<3>{grid}.position(grid.faceIndex(s.d, s.face)), s.d, grid.h);
    return ball.behindPole(middle, s.d) >= grid.h;
}

//- Away from a ball's poles faces have disks' parts, to round-off; a clump of twice the same ball
//  goes by distances, and comes to nearly the same there. The volume on which buoyancy acts, the
//  sum of all, is within
//  0.07 (h/R)^2 of the ball's: where planes touch both poles disks alone are 0.25 (h/R)^2 off
TEST(DiskInSquare, FacesOfABallAreDisks)
{
    constexpr double h = 0.5;
    constexpr int places = 16;
    UniformGrid<3> grid{};
    grid.h = h;
    for (int d = 0; d < 3; ++d) { grid.n[d] = 14; grid.origin[d] = 0; }
    for (const double cells : {2.25, 3.0, 3.75, 4.0, 5.0})
    {
        const double R = cells*h, exact = 4*M_PI/3*R*R*R;
        double mean = 0;
        for (int k = 0; k < places; ++k)
        {
            const Vec<3, double> c{{3.5 + std::fmod(0.618*k, 1)*h, 3.5 + k*h/places,
                3.5 + 0.29*h*(k % 3)}};
            BodyShape<3> ball, clump;
            ball.balls.balls.assign(1, Ball<3>{c, R});
            clump.balls.balls.assign(2, Ball<3>{c, R});
            double volume = 0, differ = 0, cut = 0;
            int disks = 0;
            std::map<std::pair<int, int>, double> byFace;
            for (const FaceShare<3>& s : sharesBy(ball, c, R, h))
            {
                if (s.d == 1) volume += s.share*h*h*h;
                if (!awayFromPoles(grid, {c, R}, s)) continue;
                const SolidPart<3> disk = inBall(
                    Ball<3>{c, R}, NodeGrid<3>{grid}.position(grid.faceIndex(s.d, s.face)), s.d, h);
                EXPECT_NEAR(s.share, disk.share, 1e-13);
                ++disks;
                byFace[{s.d, s.face}] += s.share;
                cut += s.share < 1;
            }
            EXPECT_GT(disks, 0);
            for (const FaceShare<3>& s : sharesBy(clump, c, R, h))
                if (awayFromPoles(grid, {c, R}, s)) byFace[{s.d, s.face}] -= s.share;
            for (const auto& f : byFace) differ += std::abs(f.second);
            // chords of a quarter of a cell are up to (1/4)^2/(8 R) deep: 0.35 % at 2.25, and more
            // in the smaller disks
            EXPECT_LT(differ, 0.01*cut) << cells << " " << k;
            EXPECT_NEAR(volume/exact, 1, 0.07/(cells*cells)) << cells << " " << k;
            mean += volume/exact/places;
        }
        EXPECT_NEAR(mean, 1, 0.04/(cells*cells)) << cells;
    }
}

} // namespace
} // namespace riprap
