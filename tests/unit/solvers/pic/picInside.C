/*  PIC scenes with obstacles: water at rest on an oblique floor stays at rest, and none leaks
    through a thin wall.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picSceneTest.hpp"

namespace riprap
{
namespace
{

class PicInsideScene : public PicSceneTest {};
RIPRAP_ALL_SETUPS(PicInsideScene);

//- Solid below a line through `point` with this slope, far beyond the block on all sides
PicObstacle obliqueFloor(int dimensions, double x, double y, double slope)
{
    const double far = 3;
    PicObstacle o;
    o.name = "floor";
    const double corner[4][2] = {{x - far, y - far*slope}, {x - far, y - 2*far},
        {x + far, y - 2*far}, {x + far, y + far*slope}};
    if (dimensions == 2)
    {
        for (const auto& c : corner) o.vertices.insert(o.vertices.end(), {c[0], c[1], 0});
        o.elements = {0, 1, 1, 2, 2, 3, 3, 0};
        return o;
    }
    for (const double z : {-far, far})
        for (const auto& c : corner) o.vertices.insert(o.vertices.end(), {c[0], c[1], z});
    o.elements = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6};
    for (int k = 0; k < 4; ++k)
    {
        const int a = k, b = (k + 1) % 4;
        o.elements.insert(o.elements.end(), {a, b, b + 4, a, b + 4, a + 4});
    }
    return o;
}

TEST_P(PicInsideScene, WaterRestsOnAnObliqueFloor)
{
    const int n = D() == 2 ? 32 : 16;
    PicConfig c = config(n);
    c.jitter = 0.9;
    const double level = (0.625*n + 0.5)/n, g = 9.81;        // in the middle of a row of cells
    PicInside inside;
    inside.obstacles.push_back(obliqueFloor(D(), 0.5, 0.27, 0.3));
    const auto s = scene(c,
        box(c, {{0, 0, 0}}, {{1, level, 1}},
            [](double x, double y) { return y > 0.27 + 0.3*(x - 0.5); }),
        std::move(inside));
    const PicReport r = s->advance(0.25);
    EXPECT_LT(r.maxSpeed, 1e-4*std::sqrt(g*level));
    EXPECT_LT(std::abs(r.volumeError), mixed() ? 1e-5 : 1e-9);
    EXPECT_EQ(r.escaped.size(), 0u);
    // pressure: linear in depth, to the surface's place, which cells at the wall know to a fraction
    // of their size
    const SampleResult at = s->sample({0.2, 0.3, 0.5, 0.8, 0.5, 0.5, 0.5, 0.3, 0.5, 0.2, 0.1, 0.5});
    EXPECT_NEAR(at.pressure[0], 1000*g*(level - 0.3), 0.02*1000*g*c.cellSize);
    EXPECT_NEAR(at.pressure[1], 1000*g*(level - 0.5), 0.02*1000*g*c.cellSize);
    EXPECT_NEAR(at.pressure[2], 1000*g*(level - 0.3), 0.02*1000*g*c.cellSize);
    EXPECT_EQ(at.volumeFraction[3], 0);         // in the solid
}

//- A surface over a broken line in the plane, of all depths in 3D; closed: the last point is joined
//  to the first
PicObstacle prism(int dimensions, const std::vector<std::array<double, 2>>& line, bool closed)
{
    PicObstacle o;
    o.name = "prism";
    o.closed = closed;
    const int n = int(line.size()), edges = closed ? n : n - 1;
    for (int layer = 0; layer < (dimensions == 3 ? 2 : 1); ++layer)
        for (const auto& p : line)
            o.vertices.insert(
                o.vertices.end(), {p[0], p[1], dimensions == 3 ? 4.0*layer - 1.5 : 0.0});
    for (int k = 0; k < edges; ++k)
    {
        const int a = k, b = (k + 1) % n;
        if (dimensions == 2) o.elements.insert(o.elements.end(), {a, b});
        else o.elements.insert(o.elements.end(), {a, b, b + n, a, b + n, a + n});
    }
    for (int layer = 0; dimensions == 3 && closed && layer < 2; ++layer)
        for (int k = 1; k + 1 < n; ++k)
            o.elements.insert(o.elements.end(), {n*layer, n*layer + k, n*layer + k + 1});
    return o;
}

//- Water falls against a wall that leans and is thinner than a cell, or has no thickness at all
TEST_P(PicInsideScene, NoneLeaksThroughAThinWall)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    for (const double thickness : {0.0, 0.4, 1.0})
    {
        PicConfig c = config(D() == 2 ? 24 : 12);
        const double x0 = 0.47, lean = 0.21, t = thickness*c.cellSize;
        const auto side = [&](double x, double y) { return x - (x0 + lean*y); };
        PicInside inside;
        if (thickness > 0)
            inside.obstacles.push_back(prism(D(),
                {{x0, -0.2}, {x0 + t, -0.2}, {x0 + t + 1.2*lean, 1.3}, {x0 + 1.2*lean, 1.3}},
                true));
        else
            inside.obstacles.push_back(
                prism(D(), {{x0 - 0.2*lean, -0.2}, {x0 + 1.3*lean, 1.3}}, false));
        // a column that is held by nothing on its right
        FluidInput f = box(c, {{0, 0, 0}}, {{0.25, 0.75, D() == 3 ? 0.5 : 1.0}},
            [](double, double) { return true; });
        const auto s = scene(c, f, std::move(inside));
        const PicReport r = s->advance(D() == 2 ? 0.8 : 0.4);
        EXPECT_EQ(r.stop, StopReason::none);
        EXPECT_GT(r.maxSpeed, 1);
        EXPECT_EQ(r.escaped.size(), 0u);
        const FluidState now = s->fluid();
        double beyond = -1;
        for (std::size_t i = 0; i < now.id.size(); ++i)
            beyond = std::max(beyond, side(now.position[3*i], now.position[3*i + 1]) - t);
        // a closed face stands for the wall where it passes between the centres of two cells
        EXPECT_LT(beyond, c.cellSize);
        EXPECT_GT(beyond, -0.1);                // it has come to the wall
        for (const double v : s->grid().water) EXPECT_TRUE(v >= 0 && v <= 1);
    }
}

//- A body is pushed into still water: what it displaces raises the level, and no particle is left
//  in it
TEST_P(PicInsideScene, AMovingBodyPushesWaterAside)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(D() == 2 ? 24 : 12);
    const double a = 0.22, depth = 0.5, speed = 0.5, time = 0.6;
    PicInside inside;
    PicObstacle o = prism(
        D(), {{0.39, 0.74}, {0.39 + a, 0.74}, {0.39 + a, 0.74 + a}, {0.39, 0.74 + a}}, true);
    o.body = 0;
    inside.obstacles.push_back(o);
    inside.motion = [&](int, double t) { WallPose p; p.translation[1] = -speed*t; return p; };
    const auto s = scene(c,
        box(c, {{0, 0, 0}}, {{1, depth, 1}}, [](double, double) { return true; }),
        std::move(inside));
    const PicReport r = s->advance(time);
    EXPECT_EQ(r.stop, StopReason::none);
    EXPECT_LT(std::abs(r.volumeError), 0.02);
    const double bottom = 0.74 - speed*time;            // 0.44: 0.06 deep
    const FluidState now = s->fluid();
    int in = 0;
    for (std::size_t i = 0; i < now.id.size(); ++i)
    {
        // corners are round on the scale of a cell
        const double x = now.position[3*i], y = now.position[3*i + 1], e = 0.25*c.cellSize;
        in += x > 0.39 + e && x < 0.39 + a - e && y > bottom + e && y < bottom + a - e;
    }
    EXPECT_EQ(in, 0);
}

//- Solid between two heights, or to the left of a line
PicObstacle block(int dimensions, double x0, double y0, double x1, double y1)
{
    PicObstacle o = prism(dimensions, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, true);
    o.body = 0;
    return o;
}

double energy(PicScene& s)
{
    const FluidEnergy e = s.energy();
    return e.kinetic + e.potential;
}

//- A floor that rises lifts the water on it: its work is the weight times the way
TEST_P(PicInsideScene, AFloorThatRisesDoesTheWorkOfTheLift)
{
    for (const double reflection : {0.0, 1.0})
    {
        PicConfig c = config(D() == 2 ? 32 : 12);
        c.reflection = reflection;
        const double floor = 0.17, depth = 0.4, lift = 0.1, time = 1, g = 9.81, pi = std::acos(-1);
        PicInside inside;
        inside.obstacles.push_back(block(D(), -1, -1, 2, floor));
        inside.motion = [&](int, double t)
        {
            WallPose p;
            p.translation[1] = 0.5*lift*(1 - std::cos(pi*std::min(t, time)/time));
            return p;
        };
        const auto s = scene(c,
            box(c, {{0, floor, 0}}, {{1, floor + depth, 1}}, [](double, double) { return true; }),
            std::move(inside));
        EXPECT_EQ(s->energy().wallWork, 0);
        const double before = energy(*s);
        ASSERT_EQ(s->advance(time).stop, StopReason::none);
        const double work = s->energy().wallWork, expected = c.density*depth*g*lift;
        // to the first order of the cells, which are large in 3D
        const double close = (D() == 2 ? 0.01 : 0.02)*expected;
        EXPECT_NEAR(work, expected, close) << reflection;
        EXPECT_NEAR(energy(*s) - before, work, close) << reflection;
    }
}

//- A piston pushes water up in front of it: the water has got what the piston gave, less what the
//  steps dissipate
TEST_P(PicInsideScene, APistonsWorkIsWhatTheWaterGets)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    for (const double reflection : {0.0, 1.0})
    {
        PicConfig c = config(D() == 2 ? 48 : 16);
        c.reflection = reflection;
        const double stroke = 0.15, time = 0.5, x0 = 0.11, pi = std::acos(-1);
        PicInside inside;
        inside.obstacles.push_back(block(D(), -1, -1, x0, 2));
        inside.motion = [&](int, double t)
        {
            WallPose p;
            p.translation[0] = 0.5*stroke*(1 - std::cos(pi*std::min(t, time)/time));
            return p;
        };
        const auto s = scene(c,
            box(c, {{x0, 0, 0}}, {{1, 0.4, 1}}, [](double, double) { return true; }),
            std::move(inside));
        const double before = energy(*s);
        ASSERT_EQ(s->advance(time).stop, StopReason::none);
        const double work = s->energy().wallWork, gained = energy(*s) - before;
        if (D() == 2)
        {
            EXPECT_GT(work, gained) << reflection;
        }
        EXPECT_NEAR(gained, work, 0.03*work) << reflection;
    }
}

} // namespace
} // namespace riprap
