/*  Solids of the dem library in the water of a PIC scene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <future>
#include "pic/bodyReference.hpp"
#include "picSolidScene.hpp"
#include "pic/bodies/ballUnion.hpp"
#include "pic/bodies/contactArea.hpp"
#include "pic/grid/extrapolate.hpp"

namespace riprap
{
namespace
{

RIPRAP_ALL_SETUPS(PicSolidScene);

//- From rest: (rho_s - rho_f)/(rho_s + C rho_f) g, C of concentric circles and spheres (Lamb,
//  Hydrodynamics, 68 and 93)
TEST_P(PicSolidScene, StartsAgainstItsAddedMass)
{
    const double R = 0.45, a = 0.2, dt = 1e-3, g = 9.81;
    const double C = D() == 2 ? (R*R + a*a)/(R*R - a*a) : 0.5*(R*R*R + 2*a*a*a)/(R*R*R - a*a*a);
    PicConfig c = config(D() == 2 ? 60 : 28);           // 12 and 5.6 cells a radius
    c.seedsPerDirection = 1;
    c.adjustTimeStep = false;
    c.fixedTimeStep = dt;
    const FluidInput water = box(c, {{0, 0, 0}}, {{1, 1, 1}}, [](double, double) { return true; });
    for (const double ratio : {0.01, 2.7, 1000.0})
    {
        PicInside inside;
        inside.obstacles.push_back(roundTank(D(), R));
        inside.solids = balls(c, {{{0.5, 0.5, 0.5}}}, a, 1000*ratio);
        const auto s = createPicScene(c, water, PicWalls(), &solver, std::move(inside));
        s->advance(dt);
        const double theory = (ratio - 1)/(ratio + C)*g;
        const double computed = -s->solids()->particles().velocity[1]/dt;
        EXPECT_NEAR(computed, theory, (D() == 2 ? 0.005 : 0.02)*std::abs(theory)) << ratio;
    }
}

//- Who is interrupted ends the step in hand, with its solids, and goes on as others do
TEST_P(PicSolidScene, AnInterruptedStepIsWhole)
{
    if (D() == 3) GTEST_SKIP() << "nothing that 2D does not have";
    PicConfig c = config(24);
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.6, 1}}, [](double, double) { return true; });
    std::unique_ptr<PicScene> scenes[2];
    for (auto& s : scenes) s = withSolids(c, water, balls(c, {{{0.5, 0.7, 0.5}}}, 0.1, 2000));
    for (auto& s : scenes) ASSERT_EQ(s->advance(1, 5).steps, 5);
    scenes[0]->interrupt();
    EXPECT_EQ(scenes[0]->advance(1, 0).steps, 1);
    scenes[1]->advance(1, 1);
    for (int k = 0; k < 2; ++k)
    {
        const DemState a = scenes[0]->solids()->particles(), b = scenes[1]->solids()->particles();
        EXPECT_EQ(a.position, b.position);
        EXPECT_EQ(a.velocity, b.velocity);
        for (auto& s : scenes) s->advance(1, 3);
    }
    EXPECT_EQ(scenes[0]->saveState(), scenes[1]->saveState());
}

//- One that is held bears what it displaces (Archimedes); one that is moved, ever faster, its added
//  mass (as above)
TEST_P(PicSolidScene, HeldAndMovedOnesBearTheWater)
{
    const double R = 0.45, a = 0.2, dt = 1e-3, rate = 2;
    const double C = D() == 2 ? (R*R + a*a)/(R*R - a*a) : 0.5*(R*R*R + 2*a*a*a)/(R*R*R - a*a*a);
    const double displaced = 1000*(D() == 2 ? M_PI*a*a : 4*M_PI/3*a*a*a);
    PicConfig c = config(D() == 2 ? 60 : 28);           // 12 and 5.6 cells a radius
    c.seedsPerDirection = 1;
    c.adjustTimeStep = false;
    c.fixedTimeStep = dt;
    const FluidInput water = box(c, {{0, 0, 0}}, {{1, 1, 1}}, [](double, double) { return true; });
    const auto after = [&](bool moved)
    {
        PicInside inside;
        inside.obstacles.push_back(roundTank(D(), R));
        auto solids = balls(c, {{{0.5, 0.5, 0.5}}}, a, 2700);
        solids->input.groups.resize(1);
        if (moved)
        {
            solids->input.groups[0].motion = 0;
            solids->input.groupMotion = [rate](int, double t)
            {
                RigidMotion m;
                m.velocity[0] = rate*t;
                m.centre = {{0.5 + 0.5*rate*t*t, 0.5, 0.5}};
                return m;
            };
        }
        else for (bool& held : solids->input.groups[0].held) held = true;
        inside.solids = solids;
        auto s = createPicScene(c, water, PicWalls(), &solver, std::move(inside));
        EXPECT_EQ(s->advance(5*dt).stop, StopReason::none);
        return s;
    };
    const double bound = (D() == 2 ? 0.005 : 0.02)*displaced;
    const auto held = after(false), moved = after(true);
    EXPECT_NEAR(held->coupling().force[1], displaced*9.81, bound*9.81);
    EXPECT_NEAR(held->coupling().force[0], 0, 1e-3*bound*9.81);
    EXPECT_NEAR(held->solids()->particles().position[1], 0.5, 1e-12);
    EXPECT_NEAR(moved->coupling().force[0], -C*displaced*rate, bound*C*rate);
    EXPECT_NEAR(moved->coupling().force[1], displaced*9.81, bound*9.81);
    EXPECT_NEAR(moved->solids()->particles().position[0], 0.5 + 0.5*rate*25*dt*dt, 1e-9);
}

//- The wall that a light body is to water that does not feel it give way grows without bound
TEST_P(PicSolidScene, HoldsAtAnyDensityWhereWeakCouplingDoesNot)
{
    if (D() == 3) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(32);
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; });
    for (const double ratio : {0.01, 0.5, 1.0})
        for (const bool weak : {false, true})
        {
            PicInside inside;
            inside.solids = balls(c, {{{0.5, 0.4, 0.5}}}, 5.0/32, 1000*ratio, weak);
            const auto s = createPicScene(c, water, PicWalls(), &solver, std::move(inside));
            const PicReport r = s->advance(0.15, 100);
            const std::vector<double> x = s->solids()->particles().position;
            const double y = x.empty() ? 1e300 : x[1];          // blown out of the domain
            if (weak)
                EXPECT_TRUE(
                    r.stop != StopReason::none || r.time < 0.15 || !(std::abs(y - 0.4) < 0.15))
                    << ratio;
            else
            {
                EXPECT_EQ(r.stop, StopReason::none) << ratio;
                EXPECT_LT(std::abs(r.volumeError), 1e-3);
                // slower than in no more water than it displaces, by its added mass of at least its
                // volume
                const double most = 0.5*9.81*(1 - ratio)/(1 + ratio)*0.15*0.15;
                EXPECT_GT(y, ratio == 1 ? 0.399 : 0.4);
                EXPECT_LT(y, 0.4 + most + 1e-3);
            }
        }
}

//- Bodies of given velocity in the first solution would do work there that nothing pays for: energy
//  grew by 15 and 13 % of the body's
TEST_P(PicSolidScene, LightOnesThatHitReflectingWaterBringNoEnergy)
{
    if (D() == 3) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(40);
    c.reflection = 1;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.5, 1}}, [](double, double) { return true; });
    for (const double ratio : {0.05, 0.1})
    {
        auto ball = balls(c, {{{0.52, 0.62, 0.5}}}, 0.1, 1000*ratio);
        ball->input.particles.velocity = {0, -3, 0};
        const auto s = withSolids(c, water, ball);
        const auto energy = [&]
        {
            const auto e = s->energy();
            return e.kinetic + e.potential + s->solids()->energy().total();
        };
        const double start = energy(), brought = s->solids()->energy().translation;
        for (int k = 0; k < 12; ++k)
        {
            ASSERT_EQ(s->advance(1e30, 1).stop, StopReason::none) << k;
            EXPECT_LT(energy() - start, 0.02*brought) << ratio << ", step " << k;
        }
        EXPECT_LT(energy() - start, -0.2*brought) << "it has hit the water";
    }
}

//- The water of a cell that a body nearly fills, and whose only opening is to the air, weighs as
//  much as a body this light. Solved for with the body's velocity as given, it threw one of 33 back
//  and forth, 2.4 times as fast in each step
TEST_P(PicSolidScene, SliversOnTopOfLightOnesMoveWithThem)
{
    if (D() == 3) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(40);
    c.reflection = 1;
    c.fixedTimeStep = 1e-3;
    const double h = c.cellSize, radius = 4.5*h, level = 0.5;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, level, 1}}, [](double, double) { return true; });
    for (int k = 0; k < 33; ++k)
    {
        const double out = (-0.1 + 0.02*(k % 11))*h, x = 0.5 + 0.31*k*h;
        const auto s = withSolids(c, water,
            balls(
                c, {{{x - 0.5*std::floor(2*x - 0.5), level + out - radius, 0.5}}}, radius, 1));
        ASSERT_EQ(s->advance(1e30, 10).stop, StopReason::none) << k;
        const std::vector<double> v = s->solids()->particles().velocity;
        EXPECT_LT(std::hypot(v[0], v[1]), 4*9.81*s->time()) << k;
    }
}

//- Heavy ones, whose equation our solver takes as they are in the grid, as with a solver on the
//  host; and the same bits every time, water between them slowed
TEST_P(PicSolidScene, MovesHeavyOnesWhereTheGridIs)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(D() == 2 ? 32 : 16);
    c.pressureTolerance = 1e-11;
    c.adjustTimeStep = false;
    c.fixedTimeStep = 2e-3;
    const double a = 2.6*c.cellSize;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; });
    const auto run = [&](LinearSolver* of, double beta, double time = 0)
    {
        PicInside inside;
        const auto solids = balls(c, {{{0.45, 0.4, 0.5}}, {{0.45 + 2.05*a, 0.41, 0.5}}}, a, 2700);
        solids->input.pairs[0].properties.gap = 0.5*c.cellSize;
        solids->contactVelocity = beta;
        solids->contactVelocityTime = time;
        inside.solids = solids;
        auto s = createPicScene(c, water, PicWalls(), of, std::move(inside));
        EXPECT_EQ(s->advance(0.04).stop, StopReason::none);
        return s;
    };
    const auto host = run(&solver, 1), here = run(nullptr, 1), slowed = run(nullptr, 0.5),
               again = run(nullptr, 0.5);
    const std::vector<double> there = host->solids()->particles().velocity,
                              v = here->solids()->particles().velocity;
    ASSERT_EQ(v.size(), there.size());
    EXPECT_LT(v[1], -0.1);
    for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(v[i], there[i], 1e-5);
    EXPECT_EQ(slowed->saveState(), again->saveState());
    EXPECT_NE(slowed->saveState(), here->saveState());

    // in the time of a step: the same; in a longer time: between
    const std::vector<double> aStep = slowed->solids()->particles().velocity,
                              timed = run(nullptr, 0.5, 2e-3)->solids()->particles().velocity;
    for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(timed[i], aStep[i], 1e-5);
    EXPECT_NE(run(nullptr, 0.5, 2e-2)->saveState(), slowed->saveState());
}

//- Two heavy balls fall on the floor and on each other, come to rest a gap apart, and the water
//  with them
TEST_P(PicSolidScene, RestsOnTheFloorAndContinuesToTheBit)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(D() == 2 ? 32 : 16);
    const double a = 2.6*c.cellSize, gap = 2*c.cellSize;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; });
    const auto make = [&]
    {
        auto solids = balls(
            c, {{{0.5, a + gap + 0.01, 0.5}}, {{0.5 + 0.3*a, 3.2*a + 2*gap, 0.5}}}, a, 2700);
        solids->input.pairs[0].properties.gap = gap;
        solids->input.pairs[0].properties.friction = 0.3;
        for (int side = 0; side < 4; ++side)
        {
            DemWall w;
            w.plane = true;
            const int axis = side/2 ? 0 : 1;
            w.normal = {{0, 0, 0}};
            w.normal[axis] = side % 2 ? -1 : 1;
            w.point[axis] = side % 2;
            solids->input.walls.push_back(w);
        }
        PicInside inside;
        inside.solids = solids;
        return createPicScene(c, water, PicWalls(), &solver, std::move(inside));
    };
    const auto first = make(), second = make();
    EXPECT_EQ(first->advance(0.1).stop, StopReason::none);
    const std::vector<std::int32_t> state = first->saveState();
    second->loadState(state);
    const auto words = first->savedState(true);
    const Later<FluidState> fluid = first->fluidLater();
    auto wordsThen = std::async(std::launch::async, words.take);
    auto fluidThen = std::async(std::launch::async, fluid.take);
    const FluidState fluidNow = first->fluid();
    EXPECT_EQ(first->advance(0.2).stop, StopReason::none);
    second->advance(0.2);
    expectSameBits(first->fluid(), second->fluid());
    // what is taken while the scene moves on is what it was
    EXPECT_EQ(words.size, state.size());
    EXPECT_EQ(wordsThen.get(), state);
    EXPECT_EQ(fluid.size, fluidNow.id.size());
    expectSameBits(fluidThen.get(), fluidNow);
    EXPECT_EQ(first->solids()->particles().position, second->solids()->particles().position);
    EXPECT_EQ(first->saveState(), second->saveState());
    if (D() == 3) return;

    const PicReport r = first->advance(1.2);
    EXPECT_EQ(r.stop, StopReason::none);
    const DemState q = first->solids()->particles();
    const double apart = std::hypot(q.position[3] - q.position[0], q.position[4] - q.position[1]);
    for (int i = 0; i < 2; ++i) EXPECT_GT(q.position[3*i + 1], a + gap - 0.1*c.cellSize);
    EXPECT_GT(apart, 2*a + gap - 0.1*c.cellSize);
    EXPECT_LT(std::abs(r.volumeError), 1e-3);
}

//- Without a gap: three disks that touch trap water between them, which gets out; they come to rest
//  on each other and on the floor
TEST_P(PicSolidScene, TouchAtTheirTrueSurfaces)
{
    if (D() == 3) GTEST_SKIP() << "balls trap nothing";
    PicConfig c = config(32);
    const double a = 2.6*c.cellSize;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; });
    auto solids = balls(c,
        {{{0.5 - a, a, 0.5}}, {{0.5 + a, a, 0.5}}, {{0.5, a*(1 + std::sqrt(3.0)), 0.5}}}, a,
        2700);
    solids->input.pairs[0].properties.friction = 0.5;
    DemWall floor;
    floor.plane = true;
    floor.normal = {{0, 1, 0}};
    solids->input.walls.push_back(floor);
    const auto s = withSolids(c, water, solids);
    const PicReport r = s->advance(0.5);
    EXPECT_EQ(r.stop, StopReason::none);
    EXPECT_LT(r.maxSpeed, 0.5);
    const DemState q = s->solids()->particles();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j)
            EXPECT_GT(std::hypot(q.position[3*i] - q.position[3*j],
                          q.position[3*i + 1] - q.position[3*j + 1]),
                2*a - 0.1*c.cellSize);
}

//- Water, solids and walls: what one gets the others give, in each step. Balls of like and unlike
//  densities press on the floor and on each other, and one rises
TEST_P(PicSolidScene, MomentumIsBalancedInEachStep)
{
    constexpr double dt = 1e-3, g = 9.81;
    for (const bool reflects : {false, true})
    {
        PicConfig c = config(D() == 2 ? 32 : 16);
        c.adjustTimeStep = false;
        c.fixedTimeStep = dt;
        c.reflection = reflects;
        const double a = 2.6*c.cellSize, gap = 2*c.cellSize, first = a + gap - 0.02*c.cellSize;
        auto solids = balls(c,
            {{{0.4, first, 0.45}}, {{0.4 + 0.5*a, first + 1.7*a + gap, 0.45}},
                {{0.75, 0.4, 0.6}}},
            a, 1000);
        const double ratio[3] = {2.7, 1.5, 0.3};
        double weight = 0;
        for (int b = 0; b < 3; ++b) weight += g*(solids->input.particles.mass[b] *= ratio[b]);
        solids->input.particles.velocity = {0.2, -0.1, 0, -0.3, -0.2, 0.1, 0.1, 0.2, -0.2};
        solids->input.pairs[0].properties.gap = gap;
        // one step of the solids in each of the water's
        solids->input.pairs[0].properties.normalStiffness = 1e4;
        solids->input.pairs[0].properties.friction = 0.3;
        DemWall floor;
        floor.plane = true;
        floor.normal = {{0, 1, 0}};
        solids->input.walls.push_back(floor);
        const std::vector<double> mass = solids->input.particles.mass;
        PicInside inside;
        inside.solids = solids;
        const auto s = createPicScene(c,
            box(c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; }), PicWalls(),
            &solver, std::move(inside));
        s->watchMomentum(true);
        const auto ofSolids = [&]
        {
            Vector3 sum{{0, 0, 0}};
            const DemState q = s->solids()->particles();
            for (std::size_t i = 0; i < q.id.size(); ++i)
                for (int d = 0; d < 3; ++d) sum[d] += mass[q.id[i]]*q.velocity[3*i + d];
            return sum;
        };
        // with reflection, what particles were left ahead by is a gradient about the surface of a
        // step ago (1e-6), and at faces that were all but closed then and are not now (leastKnown
        // of pic/grid/extrapolate.hpp; 2e-5 in 3D) it is what stood beside them
        const double exact = mixed() ? 1e-5 : 1e-10,
                     across = !reflects ? exact
            : D() == 3 ? 3e-5
            : mixed() ? 1e-5
                                        : 2e-6;
        Vector3 held{}, lastForce{}, lastWall{};
        double transferred = 0, kicks = 0;
        for (int step = 0; step < 20; ++step)
        {
            ASSERT_EQ(s->advance((step + 1)*dt, 1).stop, StopReason::none);
            ASSERT_EQ(s->coupling().subcycles, 1);
            const PicMomentum m = s->momentum();
            const Vector3 force = s->coupling().force, now = ofSolids(),
                          wall = s->solids()->wallForces()[0].force;
            EXPECT_LT(wall[1], 0) << step;
            const double kick = step ? dt : 0.5*dt, scale = kick*(weight + 9810);
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_NEAR(m.water[d], m.gravity[d] + m.other[d] - m.walls[d] - m.solids[d],
                    across*scale)
                    << step << ' ' << d;
                EXPECT_NEAR(m.solids[d], kick*force[d], 1e-12*scale);
                EXPECT_NEAR(m.other[d], 0, exact*scale);
                transferred += std::abs(m.particles[d] - m.water[d]);
                kicks += std::abs(m.walls[d] + m.solids[d]) + std::abs(m.gravity[d]);
                if (!step) continue;
                // solids: the water's force, half of its change at once (picBodies.hpp), their
                // weight, and the mean of what the floor gives before and after
                const double impulse = dt
                        *(force[d] - (d == 1 ? weight : 0) - 0.5*(wall[d] + lastWall[d]))
                    + 0.5*dt*(force[d] - lastForce[d]);
                EXPECT_NEAR(now[d] - held[d], impulse, exact*scale) << step << ' ' << d;
            }
            held = now;
            lastForce = force;
            lastWall = wall;
        }
        // particles have the mass that they have where they lie, not that of the faces
        EXPECT_LT(transferred, 0.02*kicks);
    }
}

//- A ball on the floor and one that is held above it until it begins to move
constexpr double begins = 0.6;
std::shared_ptr<PicSolids> sleeperAndMover(std::shared_ptr<PicSolids> solids)
{
    solids->input.pairs[0].properties.friction = 0.5;
    DemWall floor;
    floor.plane = true;
    floor.normal = {{0, 1, 0}};
    solids->input.walls.push_back(floor);
    solids->input.groups.resize(2);
    solids->input.groups[1].motion = 0;
    solids->input.particles.group = {0, 1};
    solids->input.groupMotion = [](int, double t)
    {
        RigidMotion m;
        m.centre = {{0.2 + 0.5*std::max(0.0, t - begins), 0.2, 0.5}};
        m.velocity[0] = t < begins ? 0 : 0.5;
        return m;
    };
    solids->config.sleepSpeed = 0.02;
    solids->config.sleepAfter = 0.1;
    return solids;
}

//- A ball on the floor falls asleep in still water; a wave that another one makes, which begins to
//  move far away, wakes it before anything touches it
TEST_P(PicSolidScene, SleepsAtRestAndWakesByFlow)
{
    if (D() == 3) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(32);
    const double a = 2.6*c.cellSize;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.5, 1}}, [](double, double) { return true; });
    PicInside inside;
    inside.solids = sleeperAndMover(balls(c, {{{0.7, a, 0.5}}, {{0.2, 0.2, 0.5}}}, a, 2700));
    const auto s = createPicScene(c, water, PicWalls(), &solver, std::move(inside));
    EXPECT_EQ(s->advance(begins).stop, StopReason::none);
    EXPECT_EQ(s->solids()->lastReport().asleep, 1u);
    s->advance(begins + 0.3);
    EXPECT_EQ(s->solids()->lastReport().asleep, 0u);
    const DemState now = s->solids()->particles();
    const int sleeper = now.id[0] == 0 ? 0 : 1, mover = 1 - sleeper;
    EXPECT_GT(std::abs(now.position[3*sleeper] - 0.7), 1e-4);
    EXPECT_GT(now.position[3*sleeper] - now.position[3*mover], 3*a) << "not by contact";
}

//- A state that was saved while a ball slept: it sleeps on, and wakes, to the bit
TEST_P(PicSolidScene, SleepersContinueToTheBit)
{
    if (D() == 3 && !mixed()) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(D() == 2 ? 32 : 14);
    const double a = 2.6*c.cellSize;
    const FluidInput water = box(
        c, {{0, 0, 0}}, {{1, 0.5, 1}}, [](double, double) { return true; });
    const auto make = [&]
    {
        PicInside inside;
        inside.solids = sleeperAndMover(balls(c, {{{0.7, a, 0.5}}, {{0.2, 0.2, 0.5}}}, a, 2700));
        return createPicScene(c, water, PicWalls(), &solver, std::move(inside));
    };
    const auto first = make(), second = make();
    EXPECT_EQ(first->advance(0.5).stop, StopReason::none);
    ASSERT_EQ(first->solids()->lastReport().asleep, 1u);
    second->loadState(first->saveState());
    for (const double t : {0.55, begins + 0.3})
    {
        first->advance(t);
        second->advance(t);
        EXPECT_EQ(first->solids()->lastReport().asleep, t < begins ? 1u : 0u);
        EXPECT_EQ(second->solids()->lastReport().asleep, t < begins ? 1u : 0u);
        expectSameBits(first->fluid(), second->fluid());
        EXPECT_EQ(first->solids()->particles().position, second->solids()->particles().position);
        EXPECT_EQ(first->saveState(), second->saveState());
    }
}

//- Of a solid across a periodic side the grid would see a part alone
TEST_P(PicSolidScene, IsStoppedAtAPeriodicSide)
{
    if (D() == 3) GTEST_SKIP() << "seconds saved";
    PicConfig c = config(16);
    c.gravity = {{0, 0, 0}};
    c.periodic[0] = true;
    auto solids = balls(c, {{{0.8, 0.5, 0.5}}}, 0.15, 1000);
    solids->input.particles.velocity = {0.5, 0, 0};
    PicInside inside;
    inside.solids = solids;
    const auto s = createPicScene(c,
        box(c, {{0, 0, 0}}, {{1, 0.75, 1}}, [](double, double) { return true; }), PicWalls(),
        &solver, std::move(inside));
    EXPECT_EQ(s->advance(0.05).stop, StopReason::none);
    const PicReport r = s->advance(1);
    EXPECT_EQ(r.stop, StopReason::solids);
    EXPECT_LT(r.time, 0.3);
}

//- From rest, in mixed precision, walls that slide are all that moves the water
TEST_P(PicSolidScene, ShearFromRestTurnsANeutralCylinder)
{
    if (D() == 3) GTEST_SKIP() << "a plane flow";
    PicConfig c = config(32);
    c.gravity = {{0, 0, 0}};
    c.periodic[0] = true;
    c.noSlip = true;
    c.viscosity = 0.02*c.density;
    c.maxTimeStep = 0.02;
    c.slide[1][0] = {{-0.5, 0, 0}};
    c.slide[1][1] = {{0.5, 0, 0}};
    PicInside inside;
    inside.solids = balls(c, {{{0.5, 0.5, 0.5}}}, 0.125, 1000);
    const auto s = createPicScene(c,
        box(c, {{0, 0, 0}}, {{1, 1, 1}}, [](double, double) { return true; }), PicWalls(), &solver,
        std::move(inside));
    EXPECT_EQ(s->advance(3).stop, StopReason::none);
    const DemState q = s->solids()->particles();
    EXPECT_NEAR(q.position[0], 0.5, 1e-3);
    EXPECT_NEAR(q.position[1], 0.5, 1e-3);
    // less than half the shear rate, which is that of wide and slow shear: walls are near, and
    // shear takes H^2/(pi^2 nu) = 5 s to settle
    EXPECT_LT(-q.spin[2], 0.5);
    EXPECT_GT(-q.spin[2], 0.35);
}

//- Water between a turning cylinder and a round tank that it sticks to (Couette): velocity, and the
//  moment 4 pi mu w r^2 R^2/(R^2 - r^2)
TEST_P(PicSolidScene, FeelsTheMomentOfWaterThatSticks)
{
    if (D() == 3) GTEST_SKIP() << "a plane flow";
    const double R = 0.45, r = 0.2, w = 1, nu = 0.02;
    for (const int n : {24, 48})
    {
        PicConfig c = config(n);
        c.gravity = {{0, 0, 0}};
        c.noSlip = true;
        c.viscosity = nu*c.density;
        c.maxTimeStep = 0.05;
        PicInside inside;
        inside.obstacles.push_back(roundTank(2, R));
        auto solids = balls(c, {{{0.5, 0.5, 0.5}}}, r, 1000);
        solids->input.groups.resize(1);
        solids->input.groups[0].motion = 0;
        solids->input.groupMotion = [&](int, double)
        {
            RigidMotion m;
            m.spin[2] = w;
            m.centre = {{0.5, 0.5, 0.5}};
            return m;
        };
        inside.solids = solids;
        const auto s = createPicScene(c,
            box(c, {{0, 0, 0}}, {{1, 1, 1}}, [](double, double) { return true; }), PicWalls(),
            &solver, std::move(inside));
        s->forcesOnWalls();                     // from now on somebody asks
        EXPECT_EQ(s->advance(3).stop, StopReason::none);
        const double at = 0.3, theory = w*r*r/(R*R - r*r)*(R*R/at - at),
                     moment = 4*M_PI*nu*c.density*w*r*r*R*R/(R*R - r*r);
        const SampleResult q = s->sample({0.5 + at, 0.5, 0.5, 0.5, 0.5 - at, 0.5});
        const double coarse = n == 24 ? 3 : 1;
        EXPECT_NEAR(q.velocity[1], theory, 0.02*coarse*theory);
        EXPECT_NEAR(q.velocity[3], theory, 0.02*coarse*theory);
        EXPECT_NEAR(s->solids()->particles().moment[2], -moment, 0.02*coarse*moment);
        // what the body has given the tank gets, but for what the pressure's rough velocities in
        // cut cells carry: 1.4 % at 48 cells
        double onTank = 0;
        for (const FluidForce& f : s->forcesOnWalls())
            onTank += (f.place[0] - 0.5)*f.viscous[1] - (f.place[1] - 0.5)*f.viscous[0];
        EXPECT_NEAR(onTank, -s->solids()->particles().moment[2], 0.02*moment);
        EXPECT_NEAR(s->forcesOnSolids()[0].viscousMoment[2], -moment, 0.02*coarse*moment);
    }
}

//- Without water they do what they do in a scene of their own, to the bit
TEST_P(PicSolidScene, AloneAreAsInASceneOfTheirOwn)
{
    PicConfig c = config(16);
    auto solids = balls(c, {{{0.4, 0.5, 0.5}}, {{0.55, 0.75, 0.5}}}, 0.125, 2700);
    DemWall floor;
    floor.plane = true;
    floor.normal = {{0, 1, 0}};
    floor.point = {{0, 0.3, 0}};
    solids->input.walls.push_back(floor);
    DemConfig alone = solids->config;
    alone.device = c.device;
    alone.dimensions = c.dimensions;
    alone.precision = c.precision;
    alone.gravity = c.gravity;
    const auto dem = createDemScene(alone, solids->input);
    const auto pic = withSolids(c, FluidInput(), solids);
    for (const double t : {0.1, 0.3})
    {
        dem->advance(t);
        EXPECT_EQ(pic->advance(t).stop, StopReason::none);
    }
    EXPECT_EQ(pic->time(), dem->time());
    EXPECT_EQ(pic->solids()->particles().position, dem->particles().position);
    EXPECT_EQ(pic->solids()->particles().velocity, dem->particles().velocity);
    EXPECT_EQ(pic->fluid().id.size(), 0u);
    for (const double w : pic->grid().water) EXPECT_EQ(w, 0);
}

//- Steps in which the same time passes leave the same, however many they are; one of beta's own
//  what the paper has, to the bit
TEST(PicSolids, ContactsSlowByTimeNotBySteps)
{
    for (const double C : {0.0, 0.1, 0.5, 0.93, 1.0})
    {
        EXPECT_EQ(keptVelocity(C, 1), C);
        EXPECT_NEAR(keptVelocity(C, 0.5)*keptVelocity(C, 0.5), C, 1e-15);
        double product = 1;
        for (const double part : {0.125, 0.0625, 0.3125, 0.25, 0.25})
            product *= keptVelocity(C, part);
        EXPECT_NEAR(product, C, 1e-15);
        EXPECT_NEAR(keptVelocity(C, 3), C*C*C, 1e-15);
    }
}

//- Wherever it lies: what chords cut off a ball would be missing in what the water carries of it
TEST(PicSolids, SlitsTellNothingOfTheWater)
{
    UniformGrid<2> g{};
    g.h = 1;
    g.n[0] = g.n[1] = 4;
    const int slit = g.face(0, {{2, 1, 0}}), atSide = g.face(0, {{0, 1, 0}});
    std::vector<unsigned char> wet(g.cells(), 1), layer(g.faces(0), closedFace);
    std::vector<double> aperture(g.faces(0), 1.0);
    aperture[slit] = aperture[atSide] = 0.005;
    const MarkByWetCells<2, double> mark{g, wet.data(), aperture.data(), nullptr, 0, layer.data()};
    for (int i = 0; i < g.faces(0); ++i)
    {
        mark(i);
        EXPECT_EQ(layer[i], i == slit ? unknownFace : 0) << i;
    }
}

TEST(PicSolids, BallsHaveTheirVolume)
{
    constexpr double R = 3.75, volume = 4*M_PI/3*R*R*R;
    constexpr int places = 12;
    double mean = 0;
    for (int k = 0; k < places; ++k)
    {
        UniformGrid<3> grid{};
        grid.h = 1;
        for (int d = 0; d < 3; ++d) grid.n[d] = 14;
        FreeBody<3, BallUnion<3>> body;
        Ball<3> ball;
        for (int d = 0; d < 3; ++d)
            body.centre[d] = ball.centre[d] = 6.5 + std::fmod((k + 1)*(0.618 + 0.137*d), 1);
        ball.radius = body.reach = R;
        body.shape.balls = {ball};
        body.velocity.assign(6, 0.0);
        BodyGrid<3> cut;
        for (int d = 0; d < 3; ++d) cut.aperture[d].assign(grid.faces(d), 1.0);
        cutBodies(grid, std::vector<FreeBody<3, BallUnion<3>>>{body}, k % 3, cut);
        const double error = cut.terms[0].volume/volume - 1;
        // circles in the planes of faces, where a plane nearly touches the ball
        EXPECT_LT(std::abs(error), 0.015) << k;
        mean += error/places;
    }
    EXPECT_LT(std::abs(mean), 0.005);
}

} // namespace
} // namespace riprap
