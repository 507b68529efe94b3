/*  Openings of the sides of PIC: steady flow in a channel, a basin that is filled, water that
    follows the level beyond, exact restart.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "picSceneTest.hpp"
#include "pic/openings/inflow.hpp"

namespace riprap
{
namespace
{

class PicOpenings : public PicSceneTest
{
protected:

    static bool everywhere(double, double) { return true; }

    //- Which opening each face of the lower and the upper side along x belongs to, -1: none
    PicWalls sides(const PicConfig& c, int lower, int upper) const
    {
        PicWalls w;
        const int n = c.cells[0], rows = c.cells[1]*c.cells[2];
        w.opening[0].assign((n + 1)*rows, -1);
        for (int j = 0; j < rows; ++j)
        {
            w.opening[0][(n + 1)*j] = lower;
            w.opening[0][(n + 1)*j + n] = upper;
        }
        return w;
    }

    static std::function<double(double)> constant(double value)
    {
        return [value](double) { return value; };
    }

    static PicOpening level(const char* name, double height)
    {
        PicOpening o;
        o.name = name;
        o.kind = "level";
        o.level = constant(height);
        return o;
    }

    static PicOpening flow(const char* name, double rate)
    {
        PicOpening o;
        o.name = name;
        o.kind = "flowRate";
        o.flowRate = constant(rate);
        return o;
    }

    static PicOpening velocity(const char* name, double along)
    {
        PicOpening o;
        o.name = name;
        o.kind = "velocity";
        o.velocity = [along](double) { return Vector3{{along, 0, 0}}; };
        return o;
    }

    static std::unique_ptr<PicScene> open(
        const PicConfig& c, const FluidInput& f, const PicWalls& w)
    {
        return createPicScene(c, f, w);
    }

    static double fastest(PicScene& s)
    {
        double v = 0;
        for (const double u : s.fluid().velocity) v = std::max(v, std::abs(u));
        return v;
    }

    //- Height at which half of the water is air, above (x, z)
    static double surface(PicScene& s, double x, double z)
    {
        double low = 0, high = 1;
        for (int k = 0; k < 40; ++k)
        {
            const double y = 0.5*(low + high);
            (s.sample({x, y, z}).volumeFraction[0] > 0.5 ? low : high) = y;
        }
        return low;
    }
};

RIPRAP_ALL_SETUPS(PicOpenings);

//- A stream of uniform velocity and depth is a solution: given on one side, held by the level or
//  carried off on the other. Whatever the level's place in a cell; water changes once
TEST_P(PicOpenings, AStreamStaysUniform)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    constexpr double u = 0.8;
    for (const double depth : {0.5, 0.52, 0.545})
        for (const bool byFlow : {true, false})
        {
            PicConfig c = config(D() == 2 ? 16 : 8);
            c.spacing = 0.1*c.cellSize;
            if (D() == 3)
            {
                c.spacing = 0.25*c.cellSize;
                if (depth != 0.5) continue;
            }
            c.openings = byFlow
                ? std::vector<PicOpening>{flow("river", u*depth), level("sea", depth)}
                : std::vector<PicOpening>{velocity("river", u), velocity("weir", u)};
            FluidInput f = box(c, {{0, 0, 0}}, {{1, depth, 1}}, everywhere);
            for (std::size_t i = 0; i < f.position.size()/3; ++i) f.velocity[3*i] = u;
            const auto s = open(c, f, sides(c, 0, 1));
            const std::size_t before = s->fluid().id.size();
            const double t = 1.25;
            const PicReport r = s->advance(t);
            const FluidState state = s->fluid();
            double worst = 0;
            for (std::size_t i = 0; i < state.id.size(); ++i)
                for (int d = 0; d < D(); ++d)
                    worst = std::max(worst, std::abs(state.velocity[3*i + d] - (d ? 0 : u)));
            EXPECT_LT(worst, 0.02*u) << depth << ' ' << byFlow;
            EXPECT_NEAR(surface(*s, 0.5, 0.5), depth, 0.1*c.cellSize) << depth << ' ' << byFlow;
            ASSERT_EQ(r.passed.size(), 2u);
            EXPECT_TRUE(r.escaped.empty());
            const double all = double(before)*u*t;
            EXPECT_NEAR(double(r.passed[0].in), all, 0.02*all) << depth << ' ' << byFlow;
            EXPECT_NEAR(double(r.passed[1].out), all, 0.04*all) << depth << ' ' << byFlow;
            EXPECT_EQ(r.passed[0].out + r.passed[1].in, 0);
            EXPECT_EQ(std::int64_t(state.id.size()),
                std::int64_t(before) + r.passed[0].in - r.passed[1].out);
        }
}

//- dh/dt = Q/A
TEST_P(PicOpenings, ABasinIsFilled)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(D() == 2 ? 16 : 8);
    c.openings = {flow("pump", 0.1)};
    const auto s = open(c, box(c, {{0, 0, 0}}, {{1, 0.25, 1}}, everywhere), sides(c, 0, -1));
    const PicReport r = s->advance(2);
    EXPECT_NEAR(r.passed[0].volume, 0.2, 1e-6*0.2);
    EXPECT_NEAR(r.volume, 0.45, 1e-3*0.45);
    EXPECT_LT(std::abs(r.volumeError), 1e-3);
    double mean = 0;
    for (const double x : {0.3, 0.5, 0.7, 0.9}) mean += 0.25*surface(*s, x, 0.5);
    EXPECT_NEAR(mean, 0.45, 0.3*c.cellSize);
    std::vector<std::int32_t> id = s->fluid().id;
    std::sort(id.begin(), id.end());
    EXPECT_TRUE(std::adjacent_find(id.begin(), id.end()) == id.end());
}

//- Ids have 31 bits: what comes in beyond them would be others' namesakes
TEST_P(PicOpenings, IdsThatAreUsedUpEndTheRun)
{
    PicConfig c = config(8);
    c.openings = {flow("pump", 0.1)};
    c.seedsPerDirection = 0;
    FluidInput f = box(c, {{0, 0, 0}}, {{1, 0.25, 1}}, everywhere);
    for (std::size_t i = 0; i < f.size(); ++i) f.id.push_back(std::int32_t(i));
    f.id.back() = std::numeric_limits<std::int32_t>::max() - 3;
    const auto s = open(c, f, sides(c, 0, -1));
    try
    {
        s->advance(2);
        FAIL() << "ids above 2147483647";
    }
    catch (const std::runtime_error& e)
    {
        EXPECT_NE(std::string(e.what()).find("ids of 31 bits"), std::string::npos) << e.what();
    }
}

//- As much beyond as inside: rest
TEST_P(PicOpenings, EqualLevelsRest)
{
    for (const double depth : {0.5, 0.53})
    {
        PicConfig c = config(D() == 2 ? 16 : 8);
        c.spacing = (D() == 2 ? 0.08 : 0.25)*c.cellSize;
        const double filled = std::lround(depth/c.spacing)*c.spacing;
        c.openings = {level("sea", filled)};
        const auto s = open(c, box(c, {{0, 0, 0}}, {{1, filled, 1}}, everywhere), sides(c, -1, 0));
        const PicReport r = s->advance(1);
        EXPECT_LT(fastest(*s), 1e-6) << depth;
        EXPECT_EQ(r.passed[0].in + r.passed[0].out, 0);
    }
}

//- A basin beside water that stands higher, or lower, takes its level: it swings about it, and less
//  than at first; the mean of ten seconds is the level
TEST_P(PicOpenings, ABasinTakesTheLevelBeyond)
{
    if (D() == 3) GTEST_SKIP() << "nothing that 2D does not have";
    for (const double beyond : {0.55, 0.35})
    {
        PicConfig c = config(16);
        c.viscosity = 1000*0.02;
        c.openings = {level("sea", beyond)};
        const auto s = open(c, box(c, {{0, 0, 0}}, {{1, 0.45, 1}}, everywhere), sides(c, -1, 0));
        double mean = 0;
        const int samples = 21;
        for (int k = 0; k < samples; ++k)
        {
            const PicReport r = s->advance(5 + 0.5*k);
            mean += (r.volume - beyond)/samples;
            // 1.6 cells at first
            EXPECT_NEAR(r.volume, beyond, 1.2*c.cellSize) << beyond << " at " << r.time;
            EXPECT_LT(std::abs(r.volumeError), 2e-3);
        }
        EXPECT_NEAR(mean, 0, 0.15*c.cellSize) << beyond;
    }
}

//- The same in two runs, to the bit, though a new scene begins with the particles of the first
//  instant
TEST_P(PicOpenings, ARunContinuesToTheBit)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(8);
    c.jitter = 0.3;
    c.openings = {flow("river", 0.4), level("sea", 0.5)};
    FluidInput f = box(c, {{0, 0, 0}}, {{1, 0.5, 1}}, everywhere);
    const auto once = open(c, f, sides(c, 0, 1));
    once->advance(0.4);
    const auto saved = once->saveState();
    once->advance(0.8);
    const auto again = open(c, f, sides(c, 0, 1));
    again->loadState(saved);
    again->advance(0.8);
    EXPECT_EQ(once->saveState(), again->saveState());
}

//- From the particles alone: what has passed goes on, and what has come in but is no particles yet
//  comes in: volume = Q t across the two runs
TEST_P(PicOpenings, CountsGoOnFromTheParticles)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    constexpr double rate = 0.4;
    PicConfig c = config(8);
    c.openings = {flow("river", rate), level("sea", 0.5)};
    const FluidInput f = box(c, {{0, 0, 0}}, {{1, 0.5, 1}}, everywhere);
    const auto first = open(c, f, sides(c, 0, 1));
    const PicReport half = first->advance(0.4);
    ASSERT_EQ(half.passed.size(), 2u);
    EXPECT_GT(half.passed[0].in, 0);
    EXPECT_NEAR(half.passed[0].volume, rate*0.4, 1e-6*rate);
    EXPECT_NE(half.passed[0].pending, 0);

    const FluidState state = first->fluid();
    FluidInput written;
    written.position = state.position;
    written.velocity = state.velocity;
    written.id = state.id;
    PicConfig again = c;
    again.startTime = half.time;
    again.seedsPerDirection = 0;
    for (std::size_t k = 0; k < 2; ++k) again.openings[k].before = half.passed[k];
    const auto second = open(again, written, sides(c, 0, 1));
    const PicReport same = second->advance(half.time);
    for (std::size_t k = 0; k < 2; ++k)
    {
        EXPECT_EQ(same.passed[k].in, half.passed[k].in);
        EXPECT_EQ(same.passed[k].out, half.passed[k].out);
        EXPECT_NEAR(same.passed[k].volume, half.passed[k].volume, 1e-14);
        EXPECT_NEAR(same.passed[k].pending, half.passed[k].pending, 1e-14);
    }
    EXPECT_EQ(second->fluid().id.size(), state.id.size());
    const PicReport end = second->advance(0.8);
    EXPECT_TRUE(end.escaped.empty());
    EXPECT_NEAR(end.passed[0].volume, rate*0.8, 1e-6*rate);
    const std::int64_t more = end.passed[0].in - half.passed[0].in + end.passed[1].in
        - half.passed[1].in - (end.passed[0].out - half.passed[0].out)
        - (end.passed[1].out - half.passed[1].out);
    EXPECT_EQ(std::int64_t(second->fluid().id.size()), std::int64_t(state.id.size()) + more);
}

//- A state written on the GPU is that of the CPU, and the other way round
TEST_P(PicOpenings, AStateGoesToTheOtherDevice)
{
    if (GetParam().device == DeviceKind::cpu) GTEST_SKIP() << "with a GPU";
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    const double round = mixed() ? 1e-4 : 1e-10;
    for (const DeviceKind from : {DeviceKind::cpu, DeviceKind::gpu})
    {
        PicConfig c = config(8), other = c;
        c.openings = {flow("river", 0.4), level("sea", 0.5)};
        other.openings = c.openings;
        c.device = from;
        other.device = from == DeviceKind::cpu ? DeviceKind::gpu : DeviceKind::cpu;
        const FluidInput f = box(c, {{0, 0, 0}}, {{1, 0.5, 1}}, everywhere);
        const auto one = open(c, f, sides(c, 0, 1)), two = open(other, f, sides(c, 0, 1));
        one->advance(0.4);
        two->loadState(one->saveState());
        EXPECT_EQ(two->time(), one->time());
        const auto inOrder = [](PicScene& s)
        {
            const FluidState all = s.fluid();
            std::vector<std::size_t> order(all.id.size());
            for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
            std::sort(order.begin(), order.end(),
                [&](std::size_t a, std::size_t b) { return all.id[a] < all.id[b]; });
            std::vector<double> x;
            for (const std::size_t i : order)
            {
                x.push_back(all.id[i]);
                x.insert(x.end(), &all.position[3*i], &all.position[3*i] + 3);
            }
            return x;
        };
        EXPECT_EQ(inOrder(*one), inOrder(*two));
        // the next steps: the same but for rounding
        const PicReport a = one->advance(0.41), b = two->advance(0.41);
        EXPECT_EQ(a.passed[0].in, b.passed[0].in);
        EXPECT_NEAR(a.passed[0].volume, b.passed[0].volume, round);
        EXPECT_NEAR(a.volumeDrift, b.volumeDrift, round);
        const std::vector<double> x = inOrder(*one), y = inOrder(*two);
        ASSERT_EQ(x.size(), y.size());
        double worst = 0;
        for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, std::abs(x[i] - y[i]));
        EXPECT_LT(worst, round);
    }
}

//- Volumes that enter are kept to the last bit, and particles lie where the flow has taken them
TEST(PicInflow, KeepsVolume)
{
    UniformGrid<2> g{};
    g.h = 0.1;
    g.n[0] = g.n[1] = 4;
    OpenFace<2> f{};
    f.direction = 0;
    f.corner.c[1] = 0.2;
    f.wet = 0.6;
    f.extent = g.h;
    const double volume = 0.0025, q = 0.3, dt = 0.01;
    std::vector<Vec<2, double>> places;
    for (int k = 0; k < 1000; ++k) enter(f, g, q, dt, volume, 2, 1, true, 1e-4, places);
    EXPECT_NEAR(double(places.size())*volume + f.kept, q*0.6*g.h*1000*dt, 1e-12);
    EXPECT_LT(f.kept, volume);
    for (const auto& x : places)
    {
        EXPECT_GT(x.c[0], 0);
        EXPECT_LE(x.c[0], q*dt + 1e-12);
        EXPECT_GT(x.c[1], 0.2);
        EXPECT_LT(x.c[1], 0.26);
    }
    enter(f, g, -q, dt, volume, 2, 1, true, 1e-4, places);
    EXPECT_NEAR(double(places.size())*volume + f.kept, q*0.6*g.h*1000*dt, 1e-12);
}

} // namespace
} // namespace riprap
