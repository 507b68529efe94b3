/*  Obstacles as surfaces: distances, thin walls that hold water, moving walls.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "backendTest.hpp"
#include "pic/cutCells/cutObstacles.hpp"
#include "pic/shapes/shapes.hpp"

namespace riprap
{
namespace
{

using Vec2 = Vec<2, double>;
using Vec3 = Vec<3, double>;

//- A closed line, or two nested ones that are the surface of a ring
Obstacle<2> polygon(const std::vector<Vec2>& outer, const std::vector<Vec2>& inner = {})
{
    Obstacle<2> o;
    for (const auto* line : {&outer, &inner})
    {
        const int first = int(o.vertices.size()), n = int(line->size());
        for (int i = 0; i < n; ++i)
        {
            o.vertices.push_back((*line)[i]);
            o.elements.push_back({{first + i, first + (i + 1) % n}});
        }
    }
    return o;
}

std::vector<Vec2> circle(const Vec2& c, double r, int n)
{
    std::vector<Vec2> v;
    for (int i = 0; i < n; ++i)
        v.push_back(
            {{c[0] + r*std::cos(2*M_PI*i/n), c[1] + r*std::sin(2*M_PI*i/n)}});
    return v;
}

std::vector<Vec2> rectangle(const Vec2& c, double a, double b, double angle)
{
    std::vector<Vec2> v;
    for (const auto& s : {Vec2{{-a, -b}}, Vec2{{a, -b}}, Vec2{{a, b}}, Vec2{{-a, b}}})
        v.push_back({{c[0] + s[0]*std::cos(angle) - s[1]*std::sin(angle),
            c[1] + s[0]*std::sin(angle) + s[1]*std::cos(angle)}});
    return v;
}

//- A sphere as triangles
Obstacle<3> sphere(const Vec3& c, double r, int n)
{
    Obstacle<3> o;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i < 2*n; ++i)
        {
            const double t = M_PI*j/n, f = M_PI*i/n;
            o.vertices.push_back({{c[0] + r*std::sin(t)*std::cos(f),
                c[1] + r*std::sin(t)*std::sin(f), c[2] + r*std::cos(t)}});
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < 2*n; ++i)
        {
            const int k = (i + 1) % (2*n), a = j*2*n + i, b = j*2*n + k,
                      e = (j + 1)*2*n + i, f = (j + 1)*2*n + k;
            if (j > 0) o.elements.push_back({{a, e, b}});
            if (j < n - 1) o.elements.push_back({{b, e, f}});
        }
    return o;
}

template<int D>
UniformGrid<D> grid(int n, double h)
{
    UniformGrid<D> g;
    g.h = h;
    for (int d = 0; d < D; ++d) { g.n[d] = n; g.origin[d] = 0; }
    return g;
}

template<int D>
CutGrid<D> cutBy(const UniformGrid<D>& g, const std::vector<Obstacle<D>>& o, double dt = 1)
{
    CutGrid<D> c;
    for (int d = 0; d < D; ++d) c.aperture[d].assign(g.faces(d), 1);
    cutObstacles(g, o, dt, c);
    return c;
}

//- Cells that water reaches from one, through open faces
template<int D>
std::vector<char> reached(const UniformGrid<D>& g, const CutGrid<D>& c, int from)
{
    std::vector<char> wet(g.cells(), 0);
    std::vector<int> todo{from};
    wet[from] = 1;
    while (!todo.empty())
    {
        const int cell = todo.back();
        todo.pop_back();
        const auto x = g.cellIndex(cell);
        for (int d = 0; d < D; ++d)
            for (int side = 0; side < 2; ++side)
            {
                const int n = g.neighbour(x, d, side ? 1 : -1);
                if (n < 0 || wet[n] || !(c.aperture[d][g.faceOf(d, x, side)] > 0)) continue;
                wet[n] = 1;
                todo.push_back(n);
            }
    }
    return wet;
}

TEST(Obstacles, DistancesOfADiskAndASphere)
{
    const UniformGrid<2> g = grid<2>(20, 0.05);
    const Ball<2> disk{{{0.51, 0.47}}, 0.283};
    const auto d2 = obstacleDistance(g, polygon(circle(disk.centre, disk.radius, 2000)));
    const NodeGrid<2> n2{g};
    for (int i = 0; i < n2.count(); ++i)
    {
        const double exact = disk.distance(n2.position(i)), band = bandNodes*g.h;
        // the polygon's sagitta: r (pi/n)^2/2
        ASSERT_NEAR(d2[i], std::max(-band, std::min(exact, band)), 1e-6);
    }
    const UniformGrid<3> g3 = grid<3>(14, 0.07);
    const Ball<3> ball{{{0.5, 0.47, 0.52}}, 0.3};
    const auto d3 = obstacleDistance(g3, sphere(ball.centre, ball.radius, 60));
    const NodeGrid<3> n3{g3};
    for (int i = 0; i < n3.count(); ++i)
    {
        const double exact = ball.distance(n3.position(i)), band = bandNodes*g3.h;
        ASSERT_NEAR(d3[i], std::max(-band, std::min(exact, band)), 1e-3);
    }
}

TEST(Obstacles, ABasinIsSolidOutside)
{
    const UniformGrid<2> g = grid<2>(10, 0.1);
    Obstacle<2> o = polygon(rectangle({{0.5, 0.5}}, 0.25, 0.3, 0));
    const auto solid = obstacleDistance(g, o);
    o.solidOutside = true;
    const auto basin = obstacleDistance(g, o);
    for (std::size_t i = 0; i < solid.size(); ++i) ASSERT_DOUBLE_EQ(solid[i], -basin[i]);
    const CutGrid<2> c = cutBy<2>(g, {o});
    EXPECT_NEAR(c.aperture[0][g.face(0, {{5, 2, 0}})], 1, 1e-12);
    // the side of the basin halves it
    EXPECT_NEAR(c.aperture[1][g.face(1, {{2, 5, 0}})], 0.5, 1e-12);
    EXPECT_EQ(c.aperture[0][g.face(0, {{1, 5, 0}})], 0);
}

//- Sheets and shells thinner than a cell, anywhere and at any angle
TEST(Obstacles, ThinWallsHoldWaterIn2D)
{
    const UniformGrid<2> g = grid<2>(24, 0.1);
    Random random(2);
    for (int k = 0; k < 60; ++k)
    {
        const Vec2 c{{1.2 + random(-0.2, 0.2), 1.2 + random(-0.2, 0.2)}};
        const double angle = k < 20 ? 0.25*M_PI*(k % 4) : random(0, 3),
                     thickness = k % 3 == 0 ? 0.1 : random(0.001, 0.1);
        Obstacle<2> o;
        if (k % 2)
            o = polygon(rectangle(c, 0.7, 0.6, angle),
                rectangle(c, 0.7 - thickness, 0.6 - thickness, angle));
        else
        {
            // through centres of cells, at 45 degrees too
            o = polygon(rectangle(k < 20 ? Vec2{{1.25, 1.25}} : c, 0.7, 0.5, angle));
            o.closed = false;
        }
        const CutGrid<2> cutGrid = cutBy<2>(g, {o});
        const auto inside = reached(g, cutGrid, g.cell({{12, 12, 0}}));
        EXPECT_FALSE(inside[g.cell({{0, 0, 0}})]) << "wall " << k << " leaks";
        int cells = 0;
        for (const char w : inside) cells += w;
        EXPECT_GT(cells, 80) << "wall " << k << " has closed what it holds";
    }
}

TEST(Obstacles, ThinWallsHoldWaterIn3D)
{
    const UniformGrid<3> g = grid<3>(16, 0.1);
    Random random(2);
    for (int k = 0; k < 6; ++k)
    {
        Obstacle<3> o = sphere(
            {{0.8 + random(-0.1, 0.1), 0.8 + random(-0.1, 0.1), 0.8 + random(-0.1, 0.1)}}, 0.5,
            6 + k);
        const Obstacle<3> inner = sphere({{0.8, 0.8, 0.8}}, 0.38, 12);
        if (k % 2)
        {
            o = sphere({{0.8, 0.8, 0.8}}, 0.45, 12);
            const int first = int(o.vertices.size());
            for (const auto& v : inner.vertices) o.vertices.push_back(v);
            for (const auto& e : inner.elements)
                o.elements.push_back({{first + e[0], first + e[1], first + e[2]}});
        }
        else o.closed = false;
        const auto inside = reached(g, cutBy<3>(g, {o}), g.cell({{8, 8, 8}}));
        EXPECT_FALSE(inside[0]) << "wall " << k << " leaks";
    }
}

//- A thick body is not taken for a wall, whatever its corners part
TEST(Obstacles, ThickBodiesOnlyCut)
{
    const UniformGrid<2> g = grid<2>(20, 0.1);
    const CutGrid<2> c = cutBy<2>(g, {polygon(rectangle({{1.03, 0.98}}, 0.44, 0.37, 0))});
    // left side at 0.59, lower side at 0.61
    EXPECT_NEAR(c.aperture[0][g.face(0, {{8, 6, 0}})], 0.1, 1e-9);
    EXPECT_NEAR(c.aperture[1][g.face(1, {{5, 7, 0}})], 0.9, 1e-9);
    EXPECT_EQ(c.aperture[0][g.face(0, {{7, 8, 0}})], 0);
    EXPECT_FALSE(c.moves);
}

//- A rigid motion carries no volume into a cell: open and closed parts together
TEST(Obstacles, MovingWallsCarryTheirVelocity)
{
    const UniformGrid<2> g = grid<2>(16, 0.1);
    Obstacle<2> o = polygon(rectangle({{0.83, 0.78}}, 0.4, 0.33, 0.3));
    const double dt = 1e-4, spin = 2, vx = 0.5, vy = -0.7;
    const Vec2 pivot{{0.1, 0.2}};
    for (const Vec2& v : o.vertices)
    {
        const Vec2 r = v - pivot;
        const double s = std::sin(spin*dt), c = std::cos(spin*dt);
        o.next.push_back(
            {{pivot[0] + c*r[0] - s*r[1] + vx*dt, pivot[1] + s*r[0] + c*r[1] + vy*dt}});
    }
    const CutGrid<2> c = cutBy<2>(g, {o}, dt);
    EXPECT_TRUE(c.moves);
    int cut = 0;
    for (int d = 0; d < 2; ++d)
        for (int f = 0; f < g.faces(d); ++f)
        {
            const double a = c.aperture[d][f];
            if (a > 0.999 || a < 0.001) continue;
            ++cut;
            const SolidPart<2> part = solidOfFace(
                NodeGrid<2>{g}, d, g.faceIndex(d, f), c.distance.data());
            const Vec2 x = solidMiddle(NodeGrid<2>{g}, d, g.faceIndex(d, f), part);
            const double expected = d == 0 ? vx - spin*(x[1] - pivot[1])
                                           : vy + spin*(x[0] - pivot[0]);
            // the mean velocity of the step: order dt
            EXPECT_NEAR(c.wallVelocity[d][f], expected, 1e-3);
        }
    EXPECT_GT(cut, 15);
    // deep inside, a cell's fluxes sum to zero
    const auto x = g.cellIndex(g.cell({{8, 8, 0}}));
    double sum = 0;
    for (int d = 0; d < 2; ++d)
        for (int side = 0; side < 2; ++side)
            sum += (side ? 1 : -1)*c.wallVelocity[d][g.faceOf(d, x, side)];
    EXPECT_NEAR(sum, 0, 1e-12);
}

//- A sheet that moves pushes at the faces that it closes; walls of the domain keep what they had
TEST(Obstacles, SheetsPush)
{
    const UniformGrid<2> g = grid<2>(10, 0.1);
    Obstacle<2> o;
    o.closed = false;
    o.vertices = {{{0.42, 0.2}}, {{0.42, 0.8}}};
    o.next = {{{0.43, 0.2}}, {{0.43, 0.8}}};
    o.elements = {{{0, 1}}};
    CutGrid<2> c;
    for (int d = 0; d < 2; ++d)
    {
        c.aperture[d].assign(g.faces(d), 1);
        c.wallVelocity[d].assign(g.faces(d), 0);
    }
    c.aperture[0][g.face(0, {{0, 5, 0}})] = 0;
    c.wallVelocity[0][g.face(0, {{0, 5, 0}})] = 3;
    cutObstacles<2>(g, {o}, 0.1, c);
    EXPECT_EQ(c.aperture[0][g.face(0, {{4, 5, 0}})], 0);
    EXPECT_NEAR(c.wallVelocity[0][g.face(0, {{4, 5, 0}})], 0.1, 1e-12);
    EXPECT_EQ(c.aperture[0][g.face(0, {{4, 1, 0}})], 1);
    EXPECT_EQ(c.aperture[0][g.face(0, {{5, 5, 0}})], 1);
    EXPECT_EQ(c.wallVelocity[0][g.face(0, {{0, 5, 0}})], 3);
}

} // namespace
} // namespace riprap
