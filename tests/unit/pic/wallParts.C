/*  Forces of the pressure on parts of walls: obstacles in water at rest, wherever they lie in the
    grid; parts that share faces.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cmath>
#include <gtest/gtest.h>
#include "pic/cutCells/wallParts.hpp"

namespace riprap
{
namespace
{

using Vec2 = Vec<2, double>;

constexpr double rhoG = 1000*9.81, surface = 0.9;

//- A convex polygon
Obstacle<2> polygon(const std::vector<Vec2>& points)
{
    Obstacle<2> o;
    o.vertices = points;
    for (int i = 0; i < int(points.size()); ++i)
        o.elements.push_back({{i, (i + 1) % int(points.size())}});
    return o;
}

//- Half sides a, b
Obstacle<2> rectangle(const Vec2& centre, double a, double b, double angle = 0)
{
    std::vector<Vec2> points;
    for (const Vec2& s : {Vec2{{-a, -b}}, Vec2{{a, -b}}, Vec2{{a, b}}, Vec2{{-a, b}}})
        points.push_back({{centre[0] + s[0]*std::cos(angle) - s[1]*std::sin(angle),
            centre[1] + s[0]*std::sin(angle) + s[1]*std::cos(angle)}});
    return polygon(points);
}

struct Sum { double force[2] = {0, 0}, moment = 0; };

//- The unit square in n x n cells: sides are parts 0 left, 1 right, 2 floor, obstacles 10 and so on
struct Tank
{
    UniformGrid<2> grid;
    WallParts<2> parts;
    std::vector<double> sides[2];

    Tank(int n, const std::vector<Obstacle<2>>& obstacles)
    {
        grid.h = 1.0/n;
        std::vector<int> partOf[2];
        CutGrid<2> all;
        for (int d = 0; d < 2; ++d)
        {
            grid.n[d] = n;
            grid.origin[d] = 0;
        }
        for (int d = 0; d < 2; ++d)
        {
            sides[d].assign(grid.faces(d), 1);
            partOf[d].assign(grid.faces(d), -1);
            for (int f = 0; f < grid.faces(d); ++f)
            {
                const int layer = grid.faceIndex(d, f).c[d];
                if (layer != 0 && (layer != n || d == 1)) continue;
                sides[d][f] = 0;
                partOf[d][f] = d == 1 ? 2 : layer == 0 ? 0 : 1;
            }
            all.aperture[d] = sides[d];
        }
        cutObstacles(grid, obstacles, 1, all);
        for (int d = 0; d < 2; ++d) parts.aperture[d] = all.aperture[d];
        parts.distance = all.distance;
        for (int k = 0; k < int(obstacles.size()); ++k)
            addObstacle(grid, obstacles[k], 10 + k, parts);
        dropCovered(grid, obstacles, parts);
        addSides(grid, sides, partOf, parts);
    }

    //- In cells that are open, up to the surface on either side of x = 0.5
    std::vector<double> pressure(double left = surface, double right = surface) const
    {
        std::vector<double> p(grid.cells(), 0.0);
        for (int i = 0; i < grid.cells(); ++i)
        {
            const auto c = grid.cellIndex(i);
            const double level = grid.h*(c.c[0] + 0.5) < 0.5 ? left : right,
                         y = grid.h*(c.c[1] + 0.5);
            bool open = false;
            for (int d = 0; d < 2; ++d)
                for (int side = 0; side < 2; ++side)
                    open = open || parts.aperture[d][grid.faceOf(d, c, side)] > 0;
            if (open && y < level) p[i] = rhoG*(level - y);
        }
        return p;
    }

    //- Of each part; moments about the origin
    std::vector<Sum> forces(const std::vector<double>& p) const
    {
        std::vector<Sum> sums(20);
        for (const WallPiece<2>& piece : parts.pieces)
        {
            const Vec2 f = pressureForce(grid, piece, p, Vec2{{0, -rhoG}});
            Sum& s = sums[piece.part];
            for (int d = 0; d < 2; ++d) s.force[d] += f[d];
            s.moment += piece.middle[0]*f[1] - piece.middle[1]*f[0];
        }
        return sums;
    }

    std::vector<Sum> forces() const { return forces(pressure()); }
};

TEST(WallParts, SidesOfATank)
{
    const auto s = Tank(20, {}).forces();
    EXPECT_NEAR(s[0].force[0], -rhoG*surface*surface/2, 1e-8);
    EXPECT_NEAR(s[1].force[0], rhoG*surface*surface/2, 1e-8);
    EXPECT_NEAR(s[2].force[1], -rhoG*surface, 1e-8);
    // a face's own moment is left out: h^2/(2 H^2) of it
    EXPECT_NEAR(s[1].moment, -rhoG*std::pow(surface, 3)/6, 0.002*rhoG*std::pow(surface, 3)/6);
    EXPECT_NEAR(s[2].moment, -rhoG*surface/2, 1e-8);
}

//- No step from one layer of cells to the next: the force is the same at any height, and the weight
//  of what is displaced
TEST(WallParts, ABoxFeelsArchimedesAnywhereInTheGrid)
{
    constexpr double a = 0.15, b = 0.1, weight = rhoG*4*a*b;
    for (int k = 0; k <= 40; ++k)
    {
        const Vec2 centre{{0.4 + 0.01*k/7, 0.4 + 0.1*k/40}};
        const Sum s = Tank(20, {rectangle(centre, a, b)}).forces()[10];
        EXPECT_NEAR(s.force[1], weight, 1e-9*weight) << k;
        EXPECT_NEAR(s.force[0], 0, 1e-9*weight) << k;
        // a piece's own moment is left out
        EXPECT_NEAR(s.moment, centre[0]*weight, 1e-3*weight) << k;
    }
}

TEST(WallParts, ATiltedBoxToo)
{
    constexpr double a = 0.2, b = 0.12, weight = rhoG*4*a*b;
    for (int k = 0; k <= 10; ++k)
    {
        const Vec2 centre{{0.5 + 0.005*k, 0.4 + 0.003*k}};
        const Sum s = Tank(20, {rectangle(centre, a, b, 0.13*k)}).forces()[10];
        EXPECT_NEAR(s.force[1], weight, 1e-9*weight) << k;
        EXPECT_NEAR(s.force[0], 0, 1e-9*weight) << k;
        EXPECT_NEAR(s.moment, centre[0]*weight, 1e-3*weight) << k;
    }
}

//- On the floor no water is below: it presses from above and from the sides, and the floor gets
//  what the box leaves of it
TEST(WallParts, ABoxOnTheFloorIsPressedDown)
{
    constexpr double width = 0.233, height = 0.317;
    const auto s = Tank(
        20, {rectangle({{0.487, 0.5*height - 0.1}}, 0.5*width, 0.5*height + 0.1)})
                       .forces();
    const double load = rhoG*width*(surface - height);
    EXPECT_NEAR(s[10].force[1], -load, 1e-9*load);
    EXPECT_NEAR(s[2].force[1], -rhoG*surface*(1 - width), 1e-9*rhoG*surface);
    EXPECT_NEAR(s[10].force[0], 0, 1e-9*load);
}

//- What of a slope lies below the floor is dry, although water is less than a cell before it
TEST(WallParts, ASlopeEndsAtTheFloor)
{
    for (int k = 0; k < 5; ++k)
    {
        const double foot = 0.2 + 0.011*k, length = 1 - foot;
        const auto s = Tank(
            20, {polygon({Vec2{{foot - 1, -0.5}}, Vec2{{foot + 2, -0.5}}, Vec2{{foot + 2, 1}}})})
                           .forces();
        const double load = rhoG*(length*surface - 0.25*length*length);
        EXPECT_NEAR(s[10].force[1], -load, 1e-3*load) << k;
        EXPECT_NEAR(s[10].force[0], 0.5*load, 1e-3*load) << k;
        EXPECT_NEAR(s[0].force[0] + s[1].force[0] + s[10].force[0], 0, 1e-3*load) << k;
    }
}

//- A thin plate across the tank is pressed from both sides, by what stands there
TEST(WallParts, AThinPlateIsPressedFromBothSides)
{
    for (const bool closed : {false, true})
    {
        Obstacle<2> plate = rectangle({{0.512, 0.43}}, 0.007, 0.53, 0.02);
        if (!closed)
        {
            plate.closed = false;
            plate.vertices = {{{0.504, -0.1}}, {{0.52, 0.95}}};
            plate.elements = {{{0, 1}}};
        }
        const Tank tank(20, {plate});
        const double left = rhoG*surface*surface/2;
        EXPECT_NEAR(tank.forces()[10].force[0], 0, 0.01*left) << closed;
        EXPECT_NEAR(tank.forces(tank.pressure(surface, 0.6))[10].force[0],
            left - rhoG*0.6*0.6/2, 0.01*left)
            << closed;
    }
}

//- A basin: the water is inside
TEST(WallParts, ABasinHoldsItsWater)
{
    Obstacle<2> basin = rectangle({{0.5, 0.55}}, 0.31, 0.42);
    basin.solidOutside = true;
    const Sum s = Tank(20, {basin}).forces()[10];
    EXPECT_NEAR(s.force[1], -rhoG*0.62*(surface - 0.13), 1e-6);
    EXPECT_NEAR(s.force[0], 0, 1e-6);
}

//- Two boxes that touch within cells: what both get is what one that is their union gets
TEST(WallParts, PartsShareWhatTheyCloseTogether)
{
    const Obstacle<2> left = rectangle({{0.4, 0.43}}, 0.113, 0.1),
                      right = rectangle({{0.626, 0.43}}, 0.113, 0.1),
                      whole = rectangle({{0.513, 0.43}}, 0.226, 0.1);
    const auto two = Tank(20, {left, right}).forces(), one = Tank(20, {whole}).forces();
    const double weight = one[10].force[1];
    EXPECT_NEAR(two[10].force[1] + two[11].force[1], weight, 1e-9*weight);
    EXPECT_NEAR(two[10].force[1], 0.5*weight, 1e-9*weight);
    // each is pressed against the other: where they touch they are dry
    EXPECT_NEAR(two[10].force[0], rhoG*0.2*(surface - 0.43), 1e-9*weight);
    EXPECT_NEAR(two[11].force[0], -two[10].force[0], 1e-9*weight);
}

//- A tetrahedron and its mirror image, whose triangles are turned the other way
TEST(WallParts, InThreeDimensions)
{
    UniformGrid<3> grid;
    grid.h = 0.1;
    for (int d = 0; d < 3; ++d) { grid.n[d] = 10; grid.origin[d] = 0; }
    for (const bool mirrored : {false, true})
    {
        Obstacle<3> o;
        for (const Vec<3, double>& x : {Vec<3, double>{{0.213, 0.2, 0.247}}, {{0.81, 0.31, 0.2}},
                 {{0.35, 0.77, 0.31}}, {{0.44, 0.4, 0.8}}})
            o.vertices.push_back(mirrored ? Vec<3, double>{{1 - x[0], x[1], x[2]}} : x);
        o.elements = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
        const auto side = [&](int k) { return o.vertices[k] - o.vertices[0]; };
        const double volume = std::abs(dot(side(1), cross(side(2), side(3))))/6;
        WallParts<3> parts;
        CutGrid<3> cut;
        for (int d = 0; d < 3; ++d) cut.aperture[d].assign(grid.faces(d), 1);
        cutObstacles(grid, std::vector<Obstacle<3>>{o}, 1, cut);
        addObstacle(grid, o, 0, parts);
        std::vector<double> p(grid.cells(), 0.0);
        for (int i = 0; i < grid.cells(); ++i)
        {
            const auto c = grid.cellIndex(i);
            bool open = false;
            for (int d = 0; d < 3; ++d)
                for (int end = 0; end < 2; ++end)
                    open = open || cut.aperture[d][grid.faceOf(d, c, end)] > 0;
            if (open) p[i] = rhoG*(1 - grid.h*(c.c[2] + 0.5)) + 1;
        }
        Vec<3, double> force = filled<3>(0.0);
        for (const WallPiece<3>& piece : parts.pieces)
            force = force + pressureForce(grid, piece, p, Vec<3, double>{{0, 0, -rhoG}});
        EXPECT_NEAR(force[2], rhoG*volume, 1e-9*rhoG*volume);
        EXPECT_NEAR(force[0], 0, 1e-9*rhoG*volume);
        EXPECT_NEAR(force[1], 0, 1e-9*rhoG*volume);
    }
}

//- Water that ends below a part makes no suction on it
TEST(WallParts, NoSuctionAboveTheSurface)
{
    // its bottom at 0.588, in the cells from 0.55 to 0.6
    const Tank tank(20, {rectangle({{0.5, 0.7}}, 0.2, 0.112)});
    EXPECT_EQ(tank.forces(tank.pressure(0.578, 0.578))[10].force[1], 0);
    EXPECT_NEAR(tank.forces(tank.pressure(0.6, 0.6))[10].force[1], rhoG*0.4*0.012, 1e-6);
}

} // namespace
} // namespace riprap
