/*  Water in cells on several ranks, threads here: the same bits as on one, whatever crosses
    borders.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <set>
#include "picRankScene.hpp"
#include "pic/ranks/gridBricks.hpp"
#include "pic/ranks/rankMeter.hpp"

namespace riprap
{
namespace
{

class PicRanks : public PicRankScene
{
protected:

    RankScene damBreak() const
    {
        const PicConfig c = basin();
        return {c, column(c), {}, {}};
    }
};

TEST_P(PicRanks, damBreak)
{
    RankScene s = damBreak();
    if (D() == 3) s.config = basin(32, 16, 16);
    s.water = column(s.config);
    compare(s, stepsOf(steps()), {D() == 2 ? 5 : 4});
}

//- The equation of the pressure divided, too
TEST_P(PicRanks, dividedPressure)
{
    compareDivided(damBreak(), stepsOf(D() == 2 ? 8 : 2), ranks(4));
}

//- Without a surface
TEST_P(PicRanks, dividedWithoutASurface)
{
    RankScene s = damBreak();
    FluidInput& f = s.water = water(s.config, {{0, 0, 0}}, {{1, 1, 1}});
    for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] = std::sin(9*f.position[3*i + 1]);
    compareDivided(s, stepsOf(2), ranks(4));
}

//- Sides that water sticks to, one of which slides
TEST_P(PicRanks, viscousWater)
{
    RankScene s = damBreak();
    PicConfig& c = s.config;
    c.viscosity = 2;
    c.noSlip = true;
    c.slide[1][0] = {{3, 0, 0}};             // which limits the step
    c.viscousScheme = "explicit";
    c.absorbers.push_back(
        PicAbsorber{"beach", c.domainMin, {{c.domainMax[0], c.domainMin[1], c.domainMin[2]}}, 4});
    s.walls = sides(c);
    compare(s, stepsOf(steps()), {3});
}

//- A pool on the floor: the ranks above it have no water until some of it is thrown up to them
TEST_P(PicRanks, emptyRanks)
{
    RankScene s = damBreak();
    FluidInput& f = s.water = water(s.config, {{0, 0, 0}}, {{1, 0.31, 1}});
    for (std::size_t i = 0; i < f.size(); ++i)
        if (f.position[3*i] < s.config.domainMin[0] + 0.5) f.velocity[3*i + 1] = 5;
    std::mutex mutex;
    bool filled = false;
    onRanks(ranks(4)[0], [&](Transport& t)
    {
        const auto part = s.on(&t);
        const std::size_t first = part->fluid().id.size();
        part->advance(1e9, 5);
        const std::size_t then = part->fluid().id.size();
        std::lock_guard<std::mutex> lock(mutex);
        filled = filled || (first == 0 && then > 0);
    });
    EXPECT_TRUE(filled);
    compare(s, stepsOf(5), ranks(4));
}

//- A drop in the middle of a brick's corner, and nothing else
TEST_P(PicRanks, drop)
{
    const PicConfig c = D() == 2 ? basin() : basin(96, 8, 8);
    RankScene s{c, water(c, {{0.3, 0.3, 0.3}}, {{0.45, 0.7, 0.7}}), {}, {}};
    move(s.water, {{2, -1, 0}});
    s.config.reflection = 0;
    s.config.advectionOrder = 2;
    compare(s, stepsOf(steps()), {3});
}

//- Around periodic sides, which are not cut; water comes back at the other end
TEST_P(PicRanks, periodicSides)
{
    RankScene s = damBreak();
    s.config.periodic[0] = true;
    s.config.periodic[2] = D() == 3;
    s.config.transfer = "apic";
    move(s.water, {{-2, 0.5, D() == 3 ? 1.0 : 0.0}});
    compare(s, stepsOf(steps()), {3});
}

//- No surface anywhere: p is known up to a constant
TEST_P(PicRanks, closedBox)
{
    RankScene s = damBreak();
    FluidInput& f = s.water = water(s.config, {{0, 0, 0}}, {{1, 1, 1}});
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        f.velocity[3*i] = std::sin(9*f.position[3*i + 1]);
        f.velocity[3*i + 1] = std::sin(7*f.position[3*i]);
    }
    compare(s, stepsOf(2), {3});
}

//- Drops that go nearly as far in a step as a particle may
TEST_P(PicRanks, longSteps)
{
    RankScene s = damBreak();
    PicConfig& c = s.config;
    c.adjustTimeStep = false;
    c.fixedTimeStep = 4.4*c.cellSize/10;
    c.maxCourantEver = 6;
    std::mt19937 engine(5);
    FluidInput& f = s.water = water(c, {{0.1, 0.1, 0}}, {{0.9, 0.9, 1}});
    std::vector<double> kept, velocity;
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        // drops and holes of some cells
        const double* x = &f.position[3*i];
        if (std::sin(19*x[0])*std::sin(23*x[1]) > 0.3) continue;
        kept.insert(kept.end(), x, x + 3);
        velocity.insert(velocity.end(),
            {9*std::sin(3*x[1]), 9*std::cos(4*x[0]), D() == 3 ? 3*std::sin(5*x[0]) : 0});
    }
    f.position = kept;
    f.velocity = velocity;
    compare(s, stepsOf(D() == 2 ? 4 : 2), ranks(5));
}

//- The lid and a side are open: what leaves is told by all ranks, in the order of one process
TEST_P(PicRanks, particlesLeave)
{
    RankScene s = damBreak();
    PicConfig& c = s.config;
    c.transfer = "flipPic";
    c.splineOrder = 3;
    eachFace(c, [&](int d, const std::array<int, 3>& at)
    {
        const bool inner = at[d] > 0 && at[d] < c.cells[d],
                   lid = d == 1 && at[1] == c.cells[1], side = d == 0 && at[0] == c.cells[0];
        s.walls.aperture[d].push_back(inner || lid || side ? 1 : 0);
    });
    // up to the lid and the side: it leaves from the first step on, from bricks whose ranks are not
    // in the order of their cells
    FluidInput& f = s.water = water(c, {{0.2, 0, 0}}, {{1, 1, 0.6}});
    for (std::size_t i = 0; i < f.size(); ++i)
    {
        f.velocity[3*i] = 5;
        f.velocity[3*i + 1] = 4 + 2*std::sin(20*f.position[3*i]);
    }
    const Course course = stepsOf(D() == 2 ? 6 : 2);
    EXPECT_GT(onOne(s, course).escaped.size(), 20u);
    compare(s, course, ranks(4));
}

//- Particles as given, linear splines, steps of a given length to given times
TEST_P(PicRanks, givenParticles)
{
    RankScene s = damBreak();
    PicConfig& c = s.config;
    c.seedsPerDirection = 0;
    c.splineOrder = 1;
    c.positionCorrection = 0;
    c.adjustTimeStep = false;
    c.fixedTimeStep = 4e-3;
    std::mt19937 engine(3);
    FluidInput& f = s.water;
    for (double& x : f.position) x += c.cellSize*uniform(engine, 0, 0.2);
    for (std::size_t i = 0; D() == 2 && i < f.size(); ++i) f.position[3*i + 2] = 0;
    const Course run = [this](PicScene& scene, RankOutcome& o)
    {
        for (int k = 1; k <= 3; ++k)
        {
            o.include(scene.advance((D() == 2 ? 0.018 : 0.006)*k));
            RankOutcome between;
            between.read(scene, scene);
        }
    };
    compare(s, run, {3});
}

//- 2 ranks go on with the state of 4, or 3
TEST_P(PicRanks, savedStates)
{
    compareStates(damBreak(), {ranks(4)[0], 2}, D() == 2 ? 6 : 2);
}

//- All stop at the same particle
TEST_P(PicRanks, guards)
{
    RankScene s = damBreak();
    s.config.maxSpeed = 2.2;
    const RankOutcome one = onOne(s, stepsOf(200));
    EXPECT_EQ(one.numbers[14], double(StopReason::tooFast));
    EXPECT_GT(one.numbers[4], 0) << "not in the first step";
    expectSame(one, onSeveral(3, s, stepsOf(200)));
}

//- What ranks tell apart is together what one process tells
TEST_P(PicRanks, readings)
{
    RankScene scene = damBreak();
    const PicConfig& c = scene.config;
    std::vector<double> points;
    for (int i = 0; i < 40; ++i)
        for (int d = 0; d < 3; ++d)
            points.push_back(c.domainMin[d] + (c.domainMax[d] - c.domainMin[d])*(i + 0.5)/40);
    std::mutex mutex;
    const auto read = [&](PicScene& s)
    {
        s.advance(1e9, 3);
        const SampleResult r = s.sample(points);
        std::vector<double> v(r.pressure);
        v.insert(v.end(), r.velocity.begin(), r.velocity.end());
        v.insert(v.end(), r.volumeFraction.begin(), r.volumeFraction.end());
        return v;
    };
    const auto ends = [](const FluidEnd& e, std::set<std::array<double, 3>>& places)
    {
        for (std::size_t i = 0; i < e.position.size()/3; ++i)
            places.insert({{e.position[3*i], e.position[3*i + 1], e.position[3*i + 2]}});
    };
    std::set<std::array<double, 3>> far, farOfRanks;
    Vector3 force{{0, 0, 0}}, forceOfRanks{{0, 0, 0}};
    scene.walls = sides(c);
    const auto add = [](const std::vector<FluidForce>& all, Vector3& sum)
    {
        for (const FluidForce& g : all) for (int d = 0; d < 3; ++d) sum[d] += g.pressure[d];
    };
    const auto s = scene.on(nullptr);
    const std::vector<double> one = read(*s);
    const FluidEnd end = s->farEnd({{1, 0, 0}}, 0.02);
    ends(end, far);
    const std::size_t forceCount = s->forcesOnWalls().size();
    add(s->forcesOnWalls(), force);
    const FluidState all = s->fluid();
    std::vector<double> position;
    for (const std::size_t i : byId(all))
        position.insert(position.end(), &all.position[3*i], &all.position[3*i] + 3);
    EXPECT_GT(far.size(), 0u);
    EXPECT_LT(force[1], -1);
    std::size_t particles = 0;
    onRanks(3, [&](Transport& t)
    {
        const auto part = scene.on(&t);
        const std::vector<double> v = read(*part);
        const FluidEnd e = part->farEnd({{1, 0, 0}}, 0.02);
        const std::vector<FluidForce> forces = part->forcesOnWalls();
        // the same seen as one scene, each rank asking for other points
        const auto whole = wholePicScene(*part, t);
        const FluidState state = whole->fluid();
        const std::size_t wholeForces = whole->forcesOnWalls().size(),
                          farOnes = whole->farEnd({{1, 0, 0}}, 0.02).particles;
        const std::size_t first = 3*std::size_t(t.rank());
        const SampleResult some = whole->sample(
            std::vector<double>(points.begin() + first, points.begin() + first + 3));
        EXPECT_THROW(part->watchMomentum(true), std::invalid_argument);
        const RankReport rank = part->advance(1e9, 1).rank;
        std::vector<std::int64_t> sums{std::int64_t(rank.owned), rank.arrivals};
        t.sum(sums);
        EXPECT_EQ(sums[0], std::int64_t(end.particles));
        EXPECT_GT(sums[1], 0);
        EXPECT_EQ(rank.owned, part->fluid().id.size());
        EXPECT_GT(rank.ghosts, 0u);
        EXPECT_GT(rank.bytesInSteps, 0);
        EXPECT_GT(rank.atWork, 0);
        std::lock_guard<std::mutex> lock(mutex);
        EXPECT_EQ(one, v);
        EXPECT_EQ(some.pressure[0], one[t.rank()]);
        EXPECT_EQ(state.position, position);
        EXPECT_EQ(state.id.size(), end.particles);
        EXPECT_TRUE(std::is_sorted(state.id.begin(), state.id.end()));
        EXPECT_EQ(farOnes, end.particles);
        EXPECT_EQ(wholeForces, forceCount);
        ends(e, farOfRanks);
        particles += e.particles;
        add(forces, forceOfRanks);
    });
    EXPECT_EQ(far, farOfRanks);
    EXPECT_EQ(particles, end.particles);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(force[d], forceOfRanks[d], 1e-12*std::abs(force[1]));
}

INSTANTIATE_TEST_SUITE_P(, PicRanks, testing::ValuesIn(setups({2, 3})), setupName);

//- What is not there yet is refused by all ranks
TEST(PicRanksRefused, whatOneProcessHas)
{
    const auto refused = [](const std::function<void(PicConfig&)>& change)
    {
        std::string text;
        onRanks(2, [&](Transport& t)
        {
            PicConfig c;
            c.dimensions = 2;
            c.cells[0] = c.cells[1] = 32;
            c.cellSize = 1.0/32;
            c.spacing = 0.5*c.cellSize;
            c.density = 1000;
            c.ranks = &t;
            change(c);
            FluidInput f;
            for (int i = 0; i < 16; ++i)
                for (int j = 0; j < 16; ++j)
                    f.position.insert(
                        f.position.end(), {(i + 0.5)*c.spacing, (j + 0.5)*c.spacing, 0});
            // a box of half a cell fills none
            if (c.jitter > 0) f.position.resize(3);
            f.velocity.assign(f.position.size(), 0.0);
            try { createPicScene(c, f, PicWalls()); }
            catch (const std::invalid_argument& e) { if (t.rank() == 0) text = e.what(); }
        });
        return text;
    };
    using C = PicConfig;
    EXPECT_EQ(refused([](C&) {}), "");
    EXPECT_EQ(refused([](C& c) { c.jitter = 0.1; }), "the fluid fills no cell");
    EXPECT_NE(refused([](C& c) { c.maxCourantEver = 8; }).find("guards/Courant"),
        std::string::npos);
    EXPECT_NE(
        refused([](C& c) { c.periodic[0] = c.periodic[1] = true; }).find("too many"),
        std::string::npos);
}

//- And where the case says it, known before a scene is made
TEST(PicRanksRefused, partsOfTheInput)
{
    onRanks(2, [](Transport& t)
    {
        struct : LinearSolver
        {
            PressureReport solve(ReducedSystem&) override { return PressureReport(); }
        } others;
        const auto refused = [&](const std::function<void(PicConfig&)>& change,
                                 const LinearSolver* solver = nullptr, bool several = true)
        {
            PicConfig c;
            c.ranks = several ? &t : nullptr;
            change(c);
            try { checkPicRanks(c, solver); }
            catch (const PicRefusal& e) { return int(e.input); }
            return -1;
        };
        using C = PicConfig;
        const auto nothing = [](C&) {};
        EXPECT_EQ(refused(nothing), -1);
        EXPECT_EQ(refused(nothing, &others), int(PicInput::solver));
        EXPECT_EQ(refused(nothing, &others, false), -1);
        EXPECT_EQ(refused([](C& c) { c.device = DeviceKind::gpu; }),
            int(PicInput::device));
        EXPECT_EQ(refused([](C& c) { c.maxCourantEver = 7; }), int(PicInput::guards));
        EXPECT_EQ(refused([](C& c) { c.maxCourantEver = 6; }), -1);
        EXPECT_EQ(refused([](C& c) { c.slowInterval = 2; }), int(PicInput::multirate));
    });
}

//- What is sent and done between steps is not theirs; what a rank keeps is sent to nobody
TEST(RankMeter, countsSteps)
{
    onRanks(3, [](Transport& transport)
    {
        const int me = transport.rank();
        RankMeter meter(transport);
        const auto send = [&](std::size_t bytes)
        {
            std::vector<RankBytes> in;
            meter.exchange(std::vector<RankBytes>(3, RankBytes(bytes)), in);
            EXPECT_EQ(in[(me + 1) % 3].size(), bytes + (me + 1) % 3 - me);
        };
        meter.arrivals = 5 + me;
        for (int k = 1; k <= 2; ++k)
        {
            send(1000 + me);
            meter.begin();
            send(10 + me);
            unsigned char byte = static_cast<unsigned char>(me), other = 9;
            std::vector<RankMessage> out{{(me + 1) % 3, &byte, 1}}, in{{(me + 2) % 3, &other, 1}};
            meter.swap(out, in);
            EXPECT_EQ(int(other), (me + 2) % 3);
            const RankReport report = meter.end(7, 2);
            EXPECT_EQ(report.bytesInSteps, k*(2*(10 + me) + 1));
            EXPECT_EQ(report.bytesAtRebuilds, 0);
            EXPECT_EQ(report.owned, 7u);
            EXPECT_EQ(report.ghosts, 2u);
            EXPECT_EQ(report.arrivals, 5 + me);
            EXPECT_GE(report.atWork, 0);
        }
        std::vector<std::int64_t> sum(1, me);
        meter.sum(sum);
        EXPECT_EQ(sum[0], 3);
        std::vector<double> most(1, me);
        meter.largest(most);
        EXPECT_EQ(most[0], 2);
    });
}

//- Bricks share out all cells; each has its share of the water, and what is around it
TEST(GridBricks, shareOutTheCells)
{
    UniformGrid<3> grid{};
    grid.h = 1;
    const int cells[3] = {100, 50, 40};
    for (int d = 0; d < 3; ++d) grid.n[d] = cells[d];
    grid.periodic[2] = true;
    std::vector<double> x;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 50; ++j) x.insert(x.end(), {i + 0.5, j + 0.5, 3.5});
    onRanks(5, [&](Transport& t)
    {
        const GridBricks<3> bricks(t, grid, x, 1);
        std::vector<int> seen(grid.cells(), 0);
        std::vector<double> water(5, 0);
        for (int r = 0; r < 5; ++r)
        {
            const CellBox b = bricks.brick(r), part = bricks.part(r);
            EXPECT_EQ(b.low[2], 0);
            EXPECT_EQ(b.high[2], 40);
            UniformGrid<3>::Index c;
            for (c.c[2] = b.low[2]; c.c[2] < b.high[2]; ++c.c[2])
                for (c.c[1] = b.low[1]; c.c[1] < b.high[1]; ++c.c[1])
                    for (c.c[0] = b.low[0]; c.c[0] < b.high[0]; ++c.c[0])
                    {
                        ++seen[grid.cell(c)];
                        EXPECT_EQ(bricks.owner(c), r);
                    }
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_EQ(b.low[d] % GridBricks<3>::unit(d), 0);
                EXPECT_EQ(part.low[d] % GridBricks<3>::unit(d), 0);
                EXPECT_TRUE(part.low[d] == 0 || part.low[d] <= b.low[d] - 16);
                EXPECT_TRUE(part.high[d] == cells[d] || part.high[d] >= b.high[d] + 16);
            }
            for (std::size_t p = 0; p < x.size()/3; ++p)
            {
                const int at[3] = {int(x[3*p]), int(x[3*p + 1]), int(x[3*p + 2])};
                if (b.has(at)) water[r] += 1;
            }
        }
        for (const int s : seen) EXPECT_EQ(s, 1);
        EXPECT_LT(*std::max_element(water.begin(), water.end()), 0.45*double(x.size())/3);
        UniformGrid<3> small = grid;
        small.n[0] = 32;
        small.n[1] = 16;
        EXPECT_THROW(GridBricks<3>(t, small, {}, 1), TooManyRanks);
    });
}

} // namespace
} // namespace riprap
