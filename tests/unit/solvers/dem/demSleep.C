/*  Sleep of particles at rest: who sleeps, what it costs in accuracy and gains in time, what wakes
    them, restart with sleepers.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <ctime>
#include "dem/demTest.hpp"

namespace riprap
{
namespace
{

using DemSleep = DemTest;

constexpr double radius = 0.01, gravity = 9.81;

//- Spheres in a box, layer upon layer in the pits of the one below, that only have to settle
DemInput pit(DemConfig& c, int side, int layers)
{
    c.gravity = Vector3{{0, 0, -gravity}};
    c.tangential = "history";
    // so many contacts with strong dashpots: at longer steps spins swing from half step to half
    // step
    c.stepFraction = 0.03;
    c.sleepAfter = 0.01;
    DemInput in = oneMaterial();
    PairProperties& p = in.pairs[0].properties;
    p.friction = 0.5;
    p.restitution = 0.3;
    const double half = side*radius;
    for (int d = 0; d < 2; ++d)
        for (const double s : {-1.0, 1.0})
        {
            Vector3 x{{0, 0, 0}}, n{{0, 0, 0}};
            x[d] = s*half;
            n[d] = -s;
            in.walls.push_back(planeWall(x, n));
        }
    in.walls.push_back(planeWall({{0, 0, -0.4}}, {{0, 0, 1}}));
    for (int l = 0; l < layers; ++l)
        for (int k = 0, n = side - l % 2; k < n*n; ++k)
            addParticle(in,
                {{radius*(2*(k % n) + 1 - n), radius*(2*(k/n) + 1 - n),
                    -0.4 + radius*(1 + std::sqrt(2.0)*l)}});
    return in;
}

double largestDifference(const DemState& a, const DemState& b)
{
    double most = 0;
    for (std::size_t i = 0; i < a.id.size(); ++i)
        for (int d = 0; d < 3; ++d)
            most = std::max(
                most, std::abs(a.position[3*i + d] - b.position[3*find(b, a.id[i]) + d]));
    return most;
}

//- The settled pile sleeps where the other lies awake, apart by far less than the way v_s t that
//  sleepers could still have gone. Who falls asleep slows down from v_s within sleepAfter: forces
//  are out of balance by no more than some m v_s/sleepAfter, 1 % of the weight
TEST_P(DemSleep, PileFallsAsleepWhereItLies)
{
    DemConfig c = config(3);
    DemInput in = pit(c, 6, 5);
    auto awake = createDemScene(c, in);
    c.sleepSpeed = 1e-3;
    auto sleeping = createDemScene(c, in);
    const DemReport a = awake->advance(0.5), b = sleeping->advance(0.5);
    ASSERT_EQ(b.stop, DemStop::none) << b.stopMessage;
    EXPECT_EQ(a.asleep, 0u);
    EXPECT_EQ(b.asleep, in.particles.size());
    EXPECT_LT(largestDifference(awake->particles(), sleeping->particles()), 1e-3*radius);
    EXPECT_EQ(sleeping->energy().translation, 0);
    const double weight = double(in.particles.size())*0.01*gravity;
    double load = 0;
    for (const DemWallForce& w : sleeping->wallForces()) load += w.force[2];
    EXPECT_NEAR(load, -weight, 0.03*weight);
    EXPECT_NEAR(sleeping->energy().total(), awake->energy().total(),
        1e-3*std::abs(awake->energy().total()));
}

//- What comes near wakes those that it is about to hit, and they carry the impact on; later all
//  sleep again
TEST_P(DemSleep, WhatMovesNearWakes)
{
    DemConfig c = config(3);
    DemInput in = pit(c, 5, 4);
    addParticle(in, {{0.003, 0.002, 0.1}});                 // falls 0.4 m: there after 0.28 s
    auto awake = createDemScene(c, in);
    c.sleepSpeed = 1e-3;
    auto scene = createDemScene(c, in);
    DemReport r = scene->advance(0.25);
    EXPECT_EQ(r.asleep, in.particles.size() - 1);
    std::size_t least = r.asleep;
    for (int k = 1; k <= 20; ++k)
    {
        r = scene->advance(0.25 + 0.005*k);
        ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
        least = std::min(least, r.asleep);
    }
    EXPECT_LT(least, in.particles.size()/2);
    r = scene->advance(1.2);
    awake->advance(1.2);
    EXPECT_EQ(r.asleep, in.particles.size());
    // the same pile but for where the last one came to lie
    DemState s = scene->particles(), w = awake->particles();
    double mean = 0, other = 0;
    for (std::size_t i = 0; i < s.id.size(); ++i)
    {
        mean += s.position[3*i + 2];
        other += w.position[3*i + 2];
    }
    EXPECT_NEAR(mean, other, 0.02*radius*double(s.id.size()));
}

//- A force from outside that could lift the pile wakes it; one that changes nothing does not
TEST_P(DemSleep, ForcesFromOutsideWake)
{
    DemConfig c = config(3);
    DemInput in = pit(c, 4, 3);
    c.sleepSpeed = 1e-3;
    auto scene = createDemScene(c, in);
    const std::size_t n = in.particles.size();
    std::vector<double> force(3*n, 0.0);
    scene->setExternalForces(force, {});
    DemReport r = scene->advance(0.3);
    ASSERT_EQ(r.asleep, n);
    for (std::size_t i = 0; i < n; ++i) force[3*i + 2] = 1e-7;
    scene->setExternalForces(force, {});
    r = scene->advance(0.31);
    EXPECT_EQ(r.asleep, n);
    for (std::size_t i = 0; i < n; ++i) force[3*i + 2] = 2*0.01*gravity;
    scene->setExternalForces(force, {});
    r = scene->advance(0.36);
    EXPECT_EQ(r.asleep, 0u);
    const DemState s = scene->particles();
    // walls hold them back by friction
    for (std::size_t i = 0; i < n; ++i) EXPECT_GT(s.velocity[3*i + 2], 0.05);
}

//- A state with sleepers goes on to the bit
TEST_P(DemSleep, RestartIsExact)
{
    DemConfig c = config(3);
    DemInput in = pit(c, 5, 4);
    addParticle(in, {{0.003, 0.002, 0.1}});
    c.sleepSpeed = 1e-3;
    auto first = createDemScene(c, in), second = createDemScene(c, in);
    ASSERT_GT(first->advance(0.27).asleep, 0u);
    second->loadState(first->saveState());
    const DemReport a = first->advance(0.33), b = second->advance(0.33);
    EXPECT_EQ(a.asleep, b.asleep);
    const DemState s = first->particles(), t = second->particles();
    EXPECT_EQ(s.position, t.position);
    EXPECT_EQ(s.velocity, t.velocity);
}

//- Steps of a sleeping pile take a fraction of the time
TEST_P(DemSleep, SavesTime)
{
    if (GetParam().device == DeviceKind::gpu)
        GTEST_SKIP() << "so few particles take a GPU no longer awake than asleep";
    DemConfig c = config(3);
    DemInput in = pit(c, 12, 7);
    double used[2];
    for (const int sleeps : {0, 1})
    {
        c.sleepSpeed = sleeps ? 1e-3 : 0;
        auto scene = createDemScene(c, in);
        const DemReport r = scene->advance(0.2);
        ASSERT_EQ(r.stop, DemStop::none) << r.stopMessage;
        if (sleeps) { EXPECT_GT(r.asleep, in.particles.size()*9/10); }
        const std::clock_t before = std::clock();
        scene->advance(1e9, 400);
        used[sleeps] = double(std::clock() - before);
    }
    EXPECT_LT(used[1], 0.5*used[0]);
}

RIPRAP_DEM_CASES(DemSleep);

} // namespace
} // namespace riprap
