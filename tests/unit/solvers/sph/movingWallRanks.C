/*  Walls that move in water, on several ranks (threads here): the bits of one process, whichever
    rank's cells the walls come to.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "rankedTank.hpp"

namespace riprap
{
namespace
{

class MovingWallRanks : public RankedTank
{
protected:

    static constexpr double pi = 3.14159265358979323846;

    //- Room for walls that leave the tank
    SphConfig basin() const
    {
        SphConfig c = damBreak(D() == 2 ? 0.025 : 0.05);
        c.maxDensityDeviation = 0.5;
        for (int d = 0; d < D(); ++d) { c.domainMin[d] -= 0.2; c.domainMax[d] += 0.2; }
        return c;
    }

    //- Poses are tables over a call of advance: it ends at a time, not after some steps
    static Course course()
    {
        return [](SphScene& s, Outcome& o) { include(o, s.advance(s.time() + 0.03)); };
    }

    //- Water in [0, 1] x [0, 0.4] that is on its way
    FluidInput pool(const SphConfig& c) const
    {
        FluidInput f = lattice(c, {{0, 0, 0}}, {{1, 0.4, D() == 3 ? 0.5 : 0.0}});
        disturb(c, f, 0.05, 0.2, 0.001);
        for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] += 1;
        return f;
    }

    //- A block of points in the tank, group 0, in place of water
    void addBlock(const SphConfig& c, const Vector3& lower, const Vector3& upper, WallInput& w,
        FluidInput& f) const
    {
        if (w.body.empty()) w.body.assign(w.size(), -1);
        w.nBodies = 1;
        const std::vector<double> x = lattice(c, lower, upper).position;
        w.position.insert(w.position.end(), x.begin(), x.end());
        for (std::size_t i = 0; i < x.size(); i += 3)
            w.normal.insert(w.normal.end(), {1, 0, 0});
        w.body.resize(w.size(), 0);
        clear(c, lower, upper, f);
    }

    double depth() const { return D() == 3 ? 0.5 : 0; }

    //- Gets up to a speed within 0.01 s
    static double way(double speed, double t) { return speed*(t - 0.01*(1 - std::exp(-100*t))); }
    static WallMotion along(const std::function<Vector3(double)>& way)
    {
        return [way](int body, double t)
        {
            WallPose p;
            if (body == 0) p.translation = way(t);
            return p;
        };
    }

    //- By an angle about z, at (x, y)
    static WallMotion about(double x, double y, const std::function<double(double)>& angle)
    {
        return [=](int, double t)
        {
            const double c = std::cos(angle(t)), s = std::sin(angle(t));
            WallPose p;
            p.rotation = {{c, -s, 0, s, c, 0, 0, 0, 1}};
            p.translation = {{x - c*x + s*y, y - s*x - c*y, 0}};
            return p;
        };
    }

    //- The walls do work, nothing stops the run, and ranks change none of it
    void expectMoved(const SphConfig& c, const FluidInput& f, const WallInput& w,
        const WallMotion& motion, const std::vector<int>& ranks, bool moves = true) const
    {
        const Outcome one = alone(c, f, w, course(), motion);
        EXPECT_EQ(one.report.stop, StopReason::none);
        EXPECT_NE(one.energy.wallWork, 0);
        EXPECT_NE(one.walls.position, w.position);
        compare(c, f, w, course(), ranks, moves, motion);
    }
};

TEST_P(MovingWallRanks, piston)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
    {
        SphConfig c = basin();
        c.integrator = integrator;
        WallInput w = walls(c);
        makePiston(w);
        const WallMotion push = along([](double t) { return Vector3{{way(1.5, t), 0, 0}}; });
        expectMoved(c, pool(c), w, push, {1, 3}, false);
    }
}

//- A plate that turns in the water passes through the bricks of all ranks
TEST_P(MovingWallRanks, paddle)
{
    for (const std::string model : {"extrapolated", "stationary"})
    {
        SphConfig c = basin();
        c.wallModel = model;
        WallInput w = walls(c);
        FluidInput f = pool(c);
        addBlock(c, {{0.45, 0.05, 0}}, {{0.55, 0.35, depth()}}, w, f);
        expectMoved(c, f, w, about(0.5, 0.2, [](double t) { return 12*t; }), {3});
    }
}

//- A gate rises out of the water, and beyond the domain
TEST_P(MovingWallRanks, gateThatLeaves)
{
    const SphConfig c = basin();
    WallInput w = walls(c);
    FluidInput f = pool(c);
    addBlock(c, {{0.45, 0.35, 0}}, {{0.55, 1.5, depth()}}, w, f);
    const WallMotion rise = along([](double t) { return Vector3{{0, way(5, t), 0}}; });
    const Outcome one = alone(c, f, w, course(), rise);
    const std::size_t top = w.size() - 1,
        bottom = std::find(w.body.begin(), w.body.end(), 0) - w.body.begin();
    EXPECT_LT(one.walls.position[3*top + 1], w.position[3*top + 1] + 0.05) << "at the box's end";
    EXPECT_GT(one.walls.position[3*bottom + 1], 0.45) << "out of the water";
    expectMoved(c, f, w, rise, {2, 3});
}

//- All walls are one body that rolls, in both time schemes
TEST_P(MovingWallRanks, rollingTank)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
    {
        SphConfig c = basin();
        c.integrator = integrator;
        WallInput w = walls(c);
        w.nBodies = 1;
        w.body.assign(w.size(), 0);
        const auto roll = [](double t) { return 0.1*(1 - std::cos(25*t)); };
        expectMoved(c, pool(c), w, about(0.5, 0.3, roll), {3}, false);
    }
}

//- A block goes through the water along the tank
TEST_P(MovingWallRanks, blockCrossesBorders)
{
    const SphConfig c = basin();
    WallInput w = walls(c);
    FluidInput f = pool(c);
    addBlock(c, {{0.35, 0.1, 0}}, {{0.45, 0.3, depth()}}, w, f);
    const WallMotion go = along([](double t) { return Vector3{{way(5, t), 0, 0}}; });
    expectMoved(c, f, w, go, {2, 4, 7});
}

//- Through a periodic side, too
TEST_P(MovingWallRanks, blockCrossesPeriodicSides)
{
    SphConfig c = basin();
    c.domainMin = {{0, -0.2, 0}};
    c.domainMax = {{1, 1, 0.5}};
    c.periodic[0] = true;
    c.periodic[2] = D() == 3;
    WallInput w = floorOf(c, 1, 0, layers);
    FluidInput f = pool(c);
    addBlock(c, {{0.8, 0.1, 0}}, {{0.9, 0.3, depth()}}, w, f);
    const WallMotion go = along([](double t) { return Vector3{{way(5, t), 0, way(2, t)}}; });
    expectMoved(c, f, w, go, {2, 3});
}

//- Particles that faces of a moving wall push back, where it has no points
TEST_P(MovingWallRanks, facesThatMove)
{
    const SphConfig c = basin();
    WallInput w = floorOf(c, 1, 0, layers);
    w.nBodies = 1;
    w.body.assign(w.size(), -1);
    w.faces.point = {0, -0.1, -0.2, 0, 0.8, -0.2, 0, 0.8, 0.8, 0, -0.1, 0.8};
    const auto add = [&](std::vector<int> vertices)
    {
        w.faces.vertex.insert(w.faces.vertex.end(), vertices.begin(), vertices.end());
        w.faces.normal.insert(w.faces.normal.end(), {1, 0, 0});
        w.faces.body.push_back(0);
        w.faces.part.push_back(0);
        w.faces.halfThickness.push_back(0);
    };
    if (D() == 2) add({0, 1, 0});
    else { add({0, 1, 2}); add({0, 2, 3}); }
    FluidInput f = pool(c);
    for (std::size_t i = 0; i < f.size(); ++i)
        if (f.position[3*i] < 0.06) f.velocity[3*i] = -3;
    const WallMotion push = along([](double t) { return Vector3{{way(2, t), 0, 0}}; });
    EXPECT_GT(alone(c, f, w, course(), push).faces.count, 2);
    compare(c, f, w, course(), {2, 3}, false, push);
}

//- Walls that carry the water to one side: bricks are cut anew as they move
TEST_P(MovingWallRanks, bricksFollowTheWater)
{
    if (D() == 3) GTEST_SKIP() << "pieces of rows are coarse in a small scene";
    SphConfig c = basin();
    c.domainMax[0] = 2.5;
    c.maxVelocity = 4;
    c.soundSpeed = 40;
    WallInput w = walls(c);
    w.nBodies = 1;
    w.body.assign(w.size(), 0);
    const FluidInput f = pool(c);
    const WallMotion go = along([](double t) { return Vector3{{10*t*t, 0, 0}}; });
    const Course run = [](SphScene& s, Outcome& o) { include(o, s.advance(0.2)); };
    const Outcome one = alone(c, f, w, run, go), four = onSeveral(4, c, f, w, run, go);
    EXPECT_EQ(one.report.stop, StopReason::none);
    expectSame(one, four);
    EXPECT_GT(four.divisions, 2);
}

//- 3, 1, 2 and 4 ranks go on with each other's states, and end with the words of one process: the
//  work on each point is there, whichever ranks added it up
TEST_P(MovingWallRanks, savedStates)
{
    const SphConfig c = basin();
    WallInput w = walls(c);
    FluidInput f = pool(c);
    addBlock(c, {{0.2, 0.1, 0}}, {{0.3, 0.3, depth()}}, w, f);
    const WallMotion go = along([](double t) { return Vector3{{way(5, t), 0, 0}}; });
    compareGoingOn(c, f, w, {3, 1, 2, 4}, course(), go);
}

//- In pieces, with states saved and all that is read back between: the same run
TEST_P(MovingWallRanks, piecesAndReadings)
{
    const SphConfig c = basin();
    WallInput w = walls(c);
    FluidInput f = pool(c);
    addBlock(c, {{0.45, 0.05, 0}}, {{0.55, 0.35, depth()}}, w, f);
    const Course run = [](SphScene& s, Outcome& o)
    {
        for (int k = 1; k <= 3; ++k)
        {
            include(o, s.advance(0.008*k));
            s.saveState();
            Outcome between;
            readBack(between, s);
        }
    };
    compare(c, f, w, run, {3}, false, about(0.5, 0.2, [](double t) { return 12*t; }));
}

} // namespace

RIPRAP_ALL_SETUPS(MovingWallRanks);

} // namespace riprap
