/*  What tests of water in cells on several ranks share: scenes that one process and ranks, threads
    here, run alike, and what they lead to, to the bit.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <functional>
#include <mutex>
#include "picSceneTest.hpp"
#include "core/threadRanks.hpp"
#include "api/wholePicScene.hpp"

namespace riprap
{

//- What a scene is made of
struct RankScene
{
    PicConfig config;
    FluidInput water;
    PicWalls walls;
    std::vector<PicObstacle> obstacles;
    std::shared_ptr<const PicSolids> solids = nullptr;
    WallMotion motion = nullptr;

    std::unique_ptr<PicScene> on(Transport* ranks) const
    {
        PicConfig own = config;
        own.ranks = ranks;
        PicInside inside;
        inside.obstacles = obstacles;
        inside.solids = solids;
        inside.motion = motion;
        return createPicScene(own, water, walls, nullptr, std::move(inside));
    }
};

//- What a run leads to; particles by their ids
struct RankOutcome
{
    std::map<std::int32_t, std::array<double, 7>> particles;    // place, velocity, pressure
    PicGridState grid;
    std::vector<std::int32_t> escaped;
    std::vector<Vector3> escapedAt;
    std::vector<double> numbers;            // of reports, the same on all ranks
    std::vector<double> forces;             // on walls: part, pressure, viscous
    FluidEnergy energy;
    double speed = 0;
    std::size_t most = 0;                   // particles of a rank
    std::vector<std::int32_t> state;

    void include(const PicReport& r)
    {
        numbers.insert(numbers.end(),
            {r.time, r.lastTimeStep, r.minTimeStep, r.maxTimeStep, double(r.steps), r.maxSpeed,
                r.maxCourant, r.volume, r.volumeError, r.volumeDrift, double(r.fluid),
                double(r.flying), double(r.pressureIterations), r.largestResidual, double(r.stop),
                double(r.stopId), double(r.viscosityConverged)});
        for (const PicPassage& p : r.passed)
            numbers.insert(numbers.end(), {double(p.in), double(p.out), p.volume, p.pending});
        escaped.insert(escaped.end(), r.escapedId.begin(), r.escapedId.end());
        escapedAt.insert(escapedAt.end(), r.escaped.begin(), r.escaped.end());
    }

    //- whole: the scene, or that of all ranks
    void read(PicScene& s, PicScene& whole)
    {
        const FluidState f = s.fluid();
        most = f.id.size();
        for (std::size_t i = 0; i < f.id.size(); ++i)
        {
            std::array<double, 7> p;
            for (int d = 0; d < 3; ++d)
            {
                p[d] = f.position[3*i + d];
                p[3 + d] = f.velocity[3*i + d];
            }
            p[6] = f.pressure[i];
            EXPECT_TRUE(particles.emplace(f.id[i], p).second) << "particle " << f.id[i];
        }
        grid = s.grid();
        for (const FluidForce& force : whole.forcesOnWalls())
        {
            forces.push_back(force.part);
            for (int d = 0; d < 3; ++d) forces.push_back(force.pressure[d]);
            for (int d = 0; d < 3; ++d) forces.push_back(force.viscous[d]);
        }
        energy = s.energy();
        speed = s.extremes().speed;
    }
};

class PicRankScene : public PicSceneTest
{
protected:

    using Course = std::function<void(PicScene&, RankOutcome&)>;

    void SetUp() override
    {
        PicSceneTest::SetUp();
        if (GetParam().device == DeviceKind::gpu) GTEST_SKIP() << "ranks of PIC are of CPUs";
    }

    //- Few, as each rank of the gathered pressure does what one process does
    int steps() const { return D() == 2 ? 12 : 3; }

    static Course stepsOf(int n)
    {
        return [n](PicScene& s, RankOutcome& o) { o.include(s.advance(1e9, n)); };
    }

    //- A box off the origin. With three units of bricks along a direction not all of it is in the
    //  part of a rank
    PicConfig basin(int nx, int ny, int nz) const
    {
        PicConfig c = config(32);
        const int n[3] = {nx, ny, D() == 2 ? 1 : nz};
        for (int d = 0; d < 3; ++d)
        {
            c.cells[d] = n[d];
            c.domainMin[d] = d < D() ? 0.37*(d + 1) : 0;
            c.domainMax[d] = d < D() ? c.domainMin[d] + n[d]*c.cellSize : 1;
        }
        return c;
    }
    PicConfig basin() const { return D() == 2 ? basin(96, 24, 1) : basin(32, 24, 8); }

    //- So many of the plane; in space there are three bricks
    std::vector<int> ranks(int plane) const { return {D() == 2 ? plane : std::min(plane, 3)}; }

    //- Between parts of the box's sides
    static FluidInput water(const PicConfig& c, const Vector3& low, const Vector3& high)
    {
        Vector3 from, to;
        for (int d = 0; d < 3; ++d)
        {
            const double length = c.domainMax[d] - c.domainMin[d];
            from[d] = c.domainMin[d] + low[d]*length;
            to[d] = c.domainMin[d] + high[d]*length;
        }
        return box(c, from, to, [](double, double) { return true; });
    }

    //- So that water soon comes to others' bricks
    static void move(FluidInput& f, const Vector3& v)
    {
        for (std::size_t i = 0; i < f.velocity.size(); ++i) f.velocity[i] = v[i % 3];
    }

    static FluidInput column(const PicConfig& c)
    {
        FluidInput f = water(c, {{0, 0, 0}}, {{0.45, 0.7, 0.6}});
        move(f, {{1.5, 1, c.dimensions == 3 ? 0.7 : 0}});
        return f;
    }

    //- All faces of the sides are of part 2 d (lower) and 2 d + 1 (upper)
    PicWalls sides(const PicConfig& c) const
    {
        PicWalls w;
        eachFace(c, [&](int d, const std::array<int, 3>& at)
        {
            w.part[d].push_back(at[d] == 0 ? 2*d : at[d] == c.cells[d] ? 2*d + 1 : -1);
        });
        return w;
    }

    //- f(direction, indices), in the order of UniformGrid
    template<class F>
    void eachFace(const PicConfig& c, const F& f) const
    {
        for (int d = 0; d < D(); ++d)
        {
            int n[3] = {c.cells[0], c.cells[1], c.cells[2]};
            ++n[d];
            for (int k = 0; k < n[2]; ++k)
                for (int j = 0; j < n[1]; ++j)
                    for (int i = 0; i < n[0]; ++i) f(d, std::array<int, 3>{{i, j, k}});
        }
    }

    static RankOutcome onOne(const RankScene& scene, const Course& course)
    {
        RankOutcome o;
        const auto s = scene.on(nullptr);
        course(*s, o);
        o.read(*s, *s);
        return o;
    }

    //- Of all ranks together
    static RankOutcome onSeveral(int ranks, const RankScene& scene, const Course& course)
    {
        RankOutcome all;
        std::map<std::int32_t, std::array<double, 7>> particles;
        std::size_t most = 0;
        std::mutex mutex;
        onRanks(ranks, [&](Transport& t)
        {
            RankOutcome o;
            const auto s = scene.on(&t);
            course(*s, o);
            o.read(*s, *wholePicScene(*s, t));
            std::lock_guard<std::mutex> lock(mutex);
            for (const auto& p : o.particles)
                EXPECT_TRUE(particles.insert(p).second) << "particle on two ranks";
            most = std::max(most, o.most);
            if (t.rank() == 0) all = o;
        });
        all.particles.swap(particles);
        all.most = most;
        return all;
    }

    static void expectSame(const RankOutcome& a, const RankOutcome& b)
    {
        ASSERT_EQ(a.particles.size(), b.particles.size());
        for (auto i = a.particles.begin(), j = b.particles.begin(); i != a.particles.end();
             ++i, ++j)
        {
            ASSERT_EQ(i->first, j->first);
            ASSERT_EQ(i->second, j->second) << "particle " << i->first;
        }
        EXPECT_EQ(a.numbers, b.numbers);
        EXPECT_EQ(a.escaped, b.escaped);
        EXPECT_EQ(a.escapedAt, b.escapedAt);
        EXPECT_EQ(a.grid.pressure, b.grid.pressure);
        EXPECT_EQ(a.grid.velocity, b.grid.velocity);
        EXPECT_EQ(a.grid.water, b.grid.water);
        EXPECT_EQ(a.grid.distance, b.grid.distance);
        EXPECT_EQ(a.forces, b.forces);
        EXPECT_EQ(a.speed, b.speed);
        EXPECT_NEAR(a.energy.kinetic, b.energy.kinetic, 1e-12*std::abs(a.energy.kinetic));
        EXPECT_NEAR(a.energy.potential, b.energy.potential, 1e-12*std::abs(a.energy.potential));
    }

    void compare(
        const RankScene& scene, const Course& course, const std::vector<int>& ranks) const
    {
        const RankOutcome one = onOne(scene, course);
        for (const int n : ranks)
        {
            SCOPED_TRACE(std::to_string(n) + " ranks");
            expectSame(one, onSeveral(n, scene, course));
        }
    }

    //- Each number of ranks goes on with the state of the one before. sameWords: states are the
    //  same, too
    void compareStates(const RankScene& scene, const std::vector<int>& ranks, std::int64_t steps,
        bool sameWords = false) const
    {
        std::vector<std::int32_t> one, many;
        const auto goOn = [&](const std::vector<std::int32_t>& from)
        {
            return Course([&from, steps](PicScene& s, RankOutcome& o)
            {
                if (!from.empty()) s.loadState(from);
                o.include(s.advance(1e9, steps));
                o.state = s.saveState();
            });
        };
        for (const int n : ranks)
        {
            SCOPED_TRACE(std::to_string(n) + " ranks");
            const RankOutcome a = onOne(scene, goOn(one)), b = onSeveral(n, scene, goOn(many));
            expectSame(a, b);
            EXPECT_EQ(a.state.size(), b.state.size());
            EXPECT_TRUE(!sameWords || a.state == b.state);
            one = a.state;
            many = b.state;
        }
    }

    //- Where the equation of the pressure is divided, sums by rank differ by round-off: places by
    //  no more than this part of the box, pressures and forces of the largest
    void compareDivided(RankScene scene, const Course& course, const std::vector<int>& ranks,
        double places, double pressures) const
    {
        scene.config.gatheredCells = 0;
        const RankOutcome one = onOne(scene, course);
        for (const int n : ranks)
        {
            SCOPED_TRACE(std::to_string(n) + " ranks");
            const RankOutcome many = onSeveral(n, scene, course);
            ASSERT_EQ(one.particles.size(), many.particles.size());
            double off = 0, pressure = 0, most = 0;
            for (auto i = one.particles.begin(), j = many.particles.begin();
                 i != one.particles.end(); ++i, ++j)
            {
                ASSERT_EQ(i->first, j->first);
                for (int d = 0; d < D(); ++d)
                    off = std::max(off, std::abs(i->second[d] - j->second[d]));
                pressure = std::max(pressure, std::abs(i->second[6] - j->second[6]));
                most = std::max(most, std::abs(i->second[6]));
            }
            RecordProperty("places" + std::to_string(n), testing::PrintToString(off));
            RecordProperty("pressure" + std::to_string(n), testing::PrintToString(pressure/most));
            EXPECT_LT(off, places);
            EXPECT_LT(pressure, pressures*most);
            EXPECT_EQ(one.numbers[4], many.numbers[4]);
            EXPECT_NEAR(one.numbers[12], many.numbers[12], 1 + 0.05*one.numbers[12]);
            // so little changes that no piece of a wall gets wet or dry
            ASSERT_EQ(one.forces.size(), many.forces.size());
            const double force = most*std::pow(scene.config.cellSize, D() - 1);
            double forceOff = 0;
            for (std::size_t k = 0; k < one.forces.size(); ++k)
                forceOff = std::max(forceOff, std::abs(one.forces[k] - many.forces[k]));
            EXPECT_LT(forceOff, 10*pressures*force);
        }
    }
    void compareDivided(
        const RankScene& scene, const Course& course, const std::vector<int>& ranks) const
    {
        compareDivided(scene, course, ranks, mixed() ? 1e-4 : 1e-10, mixed() ? 1e-2 : 1e-8);
    }
};

} // namespace riprap
