/*  Solids in the water of several ranks, threads here: each rank moves all of them, and their part
    in the equation of the pressure is summed over ranks.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <random>
#include "picRankScene.hpp"
#include "rankObstacles.hpp"

namespace riprap
{
namespace
{

//- What solids lead to: places, velocities, and the water's force on all of them
struct SolidOutcome
{
    std::vector<double> places, velocities;
    Vector3 force{{0, 0, 0}};
};

class PicRankSolids : public PicRankScene
{
protected:

    //- Balls at random that keep apart, of densities in a range
    std::shared_ptr<PicSolids> balls(
        const PicConfig& c, unsigned seed, int count, double light, double heavy) const
    {
        auto s = noSolids(c, 1e5, 0.3);
        s->config.gravity = c.gravity;
        s->input.pairs[0].properties.friction = 0.4;
        std::mt19937 engine(seed);
        std::vector<double>& x = s->input.particles.position;
        std::vector<double>& radius = s->input.particles.radius;
        for (int tries = 0; tries < 10000 && int(radius.size()) < count; ++tries)
        {
            const double r = uniform(engine, 2.1, 3.4)*c.cellSize;
            double at[3] = {0, 0, 0};
            for (int d = 0; d < D(); ++d)
                at[d] = uniform(engine, c.domainMin[d] + r, c.domainMax[d] - r);
            bool apart = true;
            for (std::size_t k = 0; k < radius.size(); ++k)
            {
                double distance = 0;
                for (int d = 0; d < D(); ++d)
                    distance += (at[d] - x[3*k + d])*(at[d] - x[3*k + d]);
                apart = apart && std::sqrt(distance) > r + radius[k];
            }
            if (!apart) continue;
            x.insert(x.end(), at, at + 3);
            radius.push_back(r);
            const double density = uniform(engine, light, heavy);
            s->input.particles.mass.push_back(
                density*(D() == 2 ? M_PI*r*r : 4*M_PI/3*r*r*r));
            for (int d = 0; d < 3; ++d)
                s->input.particles.velocity.push_back(d < D() ? uniform(engine, -0.5, 0.5) : 0);
        }
        EXPECT_EQ(int(radius.size()), count);
        return s;
    }

    RankScene scene(unsigned seed, double light, double heavy) const
    {
        const PicConfig c = basin();
        RankScene s{c, water(c, {{0, 0, 0}}, {{0.8, 0.8, 1}}), sides(c), {}, {}, {}};
        s.solids = balls(c, seed, D() == 2 ? 8 : 3, light, heavy);
        s.config.gatheredCells = 0;
        s.config.pressureTolerance = mixed() ? 1e-8 : 1e-12;
        move(s.water, {{1.2, 0.6, D() == 3 ? 0.5 : 0.0}});
        return s;
    }

    static SolidOutcome solidsOf(PicScene& s)
    {
        const DemState now = s.solids()->particles();
        return {now.position, now.velocity, s.coupling().force};
    }

    //- Water and solids as on one process, but for round-off
    void compareSolids(const RankScene& scene, const Course& course, const std::vector<int>& ranks,
        double places, double forces) const
    {
        SolidOutcome one;
        const RankOutcome water = onOne(scene, [&](PicScene& s, RankOutcome& o)
        {
            course(s, o);
            one = solidsOf(s);
        });
        for (const int n : ranks)
        {
            SCOPED_TRACE(std::to_string(n) + " ranks");
            std::mutex mutex;
            std::vector<SolidOutcome> many;
            const RankOutcome of = onSeveral(n, scene, [&](PicScene& s, RankOutcome& o)
            {
                course(s, o);
                const SolidOutcome here = solidsOf(s);
                std::lock_guard<std::mutex> lock(mutex);
                many.push_back(here);
            });
            ASSERT_EQ(water.particles.size(), of.particles.size());
            double off = 0, solid = 0, most = 0;
            for (auto i = water.particles.begin(), j = of.particles.begin();
                 i != water.particles.end(); ++i, ++j)
                for (int d = 0; d < D(); ++d)
                    off = std::max(off, std::abs(i->second[d] - j->second[d]));
            for (const SolidOutcome& o : many)
            {
                EXPECT_EQ(o.places, many[0].places) << "all ranks have the same bits";
                EXPECT_EQ(o.velocities, many[0].velocities);
                EXPECT_EQ(o.force, many[0].force);
            }
            ASSERT_EQ(one.places.size(), many[0].places.size());
            for (std::size_t k = 0; k < one.places.size(); ++k)
                solid = std::max(solid, std::abs(one.places[k] - many[0].places[k]));
            double force = 0;
            for (int d = 0; d < 3; ++d)
            {
                most = std::max(most, std::abs(one.force[d]));
                force = std::max(force, std::abs(one.force[d] - many[0].force[d]));
            }
            RecordProperty("water" + std::to_string(n), testing::PrintToString(off));
            RecordProperty("solids" + std::to_string(n), testing::PrintToString(solid));
            RecordProperty("force" + std::to_string(n), testing::PrintToString(force/most));
            EXPECT_GT(most, 0);
            EXPECT_LT(off, places);
            EXPECT_LT(solid, places);
            EXPECT_LT(force, forces*most);
            EXPECT_NEAR(water.energy.kinetic, of.energy.kinetic, forces*water.energy.kinetic);
        }
    }
    void compareSolids(
        const RankScene& scene, const Course& course, const std::vector<int>& ranks) const
    {
        compareSolids(scene, course, ranks, mixed() ? 1e-4 : 1e-9, mixed() ? 1e-2 : 1e-7);
    }
    int few() const { return D() == 2 ? 8 : 3; }
};

//- Heavy ones, in any brick and across borders
TEST_P(PicRankSolids, heavy)
{
    for (const unsigned seed : {1u, 2u, 3u})
    {
        SCOPED_TRACE(seed);
        compareSolids(scene(seed, 11, 15), stepsOf(few()), ranks(int(seed) + 2));
    }
}

//- One process takes their slow modes away, ranks iterate for longer: the same solution
TEST_P(PicRankSolids, light)
{
    compareSolids(scene(4, 0.3, 1.5), stepsOf(few()), ranks(4));
}

//- Not solved for with the pressure
TEST_P(PicRankSolids, weaklyCoupled)
{
    RankScene s = scene(5, 2, 3);
    auto weak = std::make_shared<PicSolids>(*s.solids);
    weak->weak = true;
    s.solids = weak;
    compareSolids(s, stepsOf(few()), ranks(3));
}

//- Water that sticks to them drags them; between those that touch it is slowed
TEST_P(PicRankSolids, viscous)
{
    RankScene s = scene(6, 1.5, 3);
    s.config.viscosity = 2;
    s.config.noSlip = true;
    auto slowed = std::make_shared<PicSolids>(*s.solids);
    slowed->contactVelocity = 0.3;
    s.solids = slowed;
    compareSolids(s, stepsOf(few()), ranks(4));
}

//- Among surfaces that rest
TEST_P(PicRankSolids, obstacles)
{
    RankScene s = scene(7, 2, 5);
    s.obstacles = randomObstacles(s.config, 3);
    compareSolids(s, stepsOf(few()), ranks(4), mixed() ? 1e-3 : 1e-7, mixed() ? 5e-2 : 1e-5);
}

//- A surface that moves, with nothing else inside: with the gathered pressure the bits of one
//  process
TEST_P(PicRankSolids, movingSurface)
{
    const PicConfig c = basin();
    RankScene s{c, water(c, {{0, 0, 0}}, {{0.8, 0.8, 1}}), sides(c), {}, {}, {}};
    PicObstacle o = ballObstacle(D(),
        {{c.domainMin[0] + 0.34*(c.domainMax[0] - c.domainMin[0]), c.domainMin[1] + 0.3,
            c.domainMin[2] + 0.12}}, 0.11);
    o.part = 10;
    o.body = 0;
    s.obstacles = {o};
    s.motion = [](int, double t)
    {
        WallPose p;
        p.translation = {{0.8*t, 0.4*t*t, 0}};
        return p;
    };
    compare(s, stepsOf(few()), ranks(4));
    compareDivided(s, stepsOf(2), ranks(4));
}

//- 2 ranks go on with the state of 4, or 3, as one process with its own
TEST_P(PicRankSolids, savedStates)
{
    const RankScene s = scene(8, 1.5, 4);
    std::vector<std::int32_t> ofOne, ofMany;
    SolidOutcome one;
    const auto goOn = [&](std::vector<std::int32_t>& state, int steps, Transport* ranks)
    {
        const auto scene = s.on(ranks);
        if (!state.empty()) scene->loadState(state);
        EXPECT_EQ(scene->advance(1e9, steps).stop, StopReason::none);
        const SolidOutcome now = solidsOf(*scene);
        const std::vector<std::int32_t> words = scene->saveState();
        if (!ranks || ranks->rank() == 0) return std::make_pair(now, words);
        EXPECT_TRUE(words.empty());
        return std::make_pair(now, state);
    };
    for (const int n : {ranks(4)[0], 2, 1})
    {
        SCOPED_TRACE(std::to_string(n) + " ranks");
        std::tie(one, ofOne) = goOn(ofOne, 3, nullptr);
        SolidOutcome many;
        const std::vector<std::int32_t> before = ofMany;
        onRanks(n, [&](Transport& t)
        {
            std::vector<std::int32_t> own = t.rank() == 0 || before.empty()
                ? before
                : std::vector<std::int32_t>(1, 0);
            const auto [now, words] = goOn(own, 3, &t);
            if (t.rank() == 0) { many = now; ofMany = words; }
        });
        EXPECT_EQ(ofOne.size(), ofMany.size());
        for (std::size_t k = 0; k < one.places.size(); ++k)
            EXPECT_NEAR(one.places[k], many.places[k], mixed() ? 1e-4 : 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(, PicRankSolids, testing::ValuesIn(setups({2, 3})), setupName);

} // namespace
} // namespace riprap
