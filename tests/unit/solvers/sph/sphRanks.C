/*  SPH scenes on several ranks, threads here: the same bits as on one, whatever crosses borders.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "rankedTank.hpp"

namespace riprap
{
namespace
{

class SphRanks : public RankedTank {};

TEST_P(SphRanks, damBreak)
{
    const SphConfig c = damBreak();
    // GPUs seek neighbours less often, and particles change their ranks then
    compare(c, water(c), walls(c), stepsOf(D() == 2 || gpu() ? 150 : 50), {2, 3, 4});
}

TEST_P(SphRanks, leapfrogAndStationaryWalls)
{
    SphConfig c = damBreak();
    c.integrator = "leapfrog";
    c.wallModel = "stationary";
    c.variableSmoothing = false;
    c.viscosityModel = "artificial";
    c.shifting = "fickian";
    compare(c, water(c), walls(c), stepsOf(D() == 2 ? 80 : 25), {3}, D() == 2);
}

TEST_P(SphRanks, leapfrogAndExtrapolatedWalls)
{
    SphConfig c = damBreak();
    c.integrator = "leapfrog";
    c.xsph = 0;
    compare(c, water(c), walls(c), stepsOf(D() == 2 ? 80 : 25), {3}, D() == 2);
}

//- Fast fluid without walls crosses borders and periodic sides all the time, also at corners
TEST_P(SphRanks, periodicBox)
{
    SphConfig c = config();
    c.integrator = "symplectic";
    c.variableSmoothing = true;
    c.xsph = 0.2;
    c.diffusion = "molteni";
    c.viscosityModel = "artificial";
    c.spacing = D() == 2 ? 0.05 : 1.0/12;
    c.maxDensityDeviation = 10;
    for (int d = 0; d < D(); ++d) c.periodic[d] = true;
    FluidInput f = lattice(c, {{0, 0, 0}}, {{1, 1, D() == 3 ? 1.0 : 0.0}});
    disturb(c, f, 0.1, 2, 0.01, 3);
    compare(c, f, WallInput(), stepsOf(D() == 2 || gpu() ? 60 : 30), {2, 8});
}

//- No floor: all leave, some ranks become empty
TEST_P(SphRanks, fluidLeavesTheDomain)
{
    SphConfig c = damBreak(0.05);
    c.domainMin[1] = -0.02;
    FluidInput f = water(c);
    for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i + 1] -= 2;
    const Course fall = [](SphScene& s, Outcome& o)
    {
        for (int k = 1; k <= 4; ++k) include(o, s.advance(0.03*k));
    };
    const Outcome one = alone(c, f, WallInput(), fall);
    EXPECT_GT(one.escaped.size(), 20u);
    EXPECT_GT(one.fluid.id.size(), 10u);
    compare(c, f, WallInput(), fall, {4}, false);
}

//- Particles that run wild are taken out on whichever rank they are, at borders too
TEST_P(SphRanks, wildParticles)
{
    SphConfig c = damBreak(0.05);
    c.removeWild = true;
    c.maxSpeedRatio = 1.2;
    FluidInput f = water(c);
    for (std::size_t i = 5; i < f.size(); i += 17) f.velocity[3*i] = 4*(i % 2 ? 1 : -1);
    const Outcome one = alone(c, f, walls(c), stepsOf(30));
    EXPECT_GT(one.wild.size(), 2u);
    if (!gpu() || D() == 2) return compare(c, f, walls(c), stepsOf(30), {3}, false);
    // lists of one process do not fit here, and are made once more before the first forces: without
    // the wild ones, so that lanes add up in another order. 30 steps are no time for that to grow
    const Outcome three = onSeveral(3, c, f, walls(c), stepsOf(30));
    EXPECT_EQ(one.fluid.id, three.fluid.id);
    EXPECT_EQ(std::set<int>(one.wild.begin(), one.wild.end()),
        std::set<int>(three.wild.begin(), three.wild.end()));
    EXPECT_EQ(one.steps, three.steps);
    for (std::size_t k = 0; k < one.fluid.position.size(); ++k)
        EXPECT_NEAR(one.fluid.position[k], three.fluid.position[k], 30*30*epsilon());
}

//- Faces of walls without points
TEST_P(SphRanks, facesOfWalls)
{
    SphConfig c = damBreak(0.05);
    WallInput w;
    WallFaceInput& faces = w.faces;
    faces.point = {-0.2, 0, -0.2, 1.2, 0, -0.2, 1.2, 0, 0.8, -0.2, 0, 0.8};
    const auto add = [&](const std::vector<int>& vertices)
    {
        faces.vertex.insert(faces.vertex.end(), vertices.begin(), vertices.end());
        faces.normal.insert(faces.normal.end(), {0, 1, 0});
        faces.body.push_back(-1);
        faces.part.push_back(0);
        faces.halfThickness.push_back(0);
    };
    if (D() == 2) add({0, 1, 0});
    else { add({0, 1, 2}); add({0, 2, 3}); }
    FluidInput f = water(c);
    for (std::size_t i = 0; i < f.size(); ++i)
        if (f.position[3*i + 1] < 0.06) f.velocity[3*i + 1] = -2;
    const Course course = stepsOf(60);
    EXPECT_GT(alone(c, f, w, course).faces.count, 2);
    compare(c, f, w, course, {2, 3}, false);
}

TEST_P(SphRanks, moreRanksThanParticles)
{
    const SphConfig c = damBreak(0.05);
    FluidInput f = oneParticle(D(), {{0.3, 0.1, 0.2}}, {{0.5, 0, 0}});
    const FluidInput other = oneParticle(D(), {{0.37, 0.1, 0.2}}, {{-0.5, 0, 0}});
    for (int d = 0; d < 3; ++d)
    {
        f.position.push_back(other.position[d]);
        f.velocity.push_back(other.velocity[d]);
    }
    f.density.push_back(1001);
    compare(c, f, walls(c), stepsOf(60), {5}, false);
}

//- Water that runs to one side: bricks follow it
TEST_P(SphRanks, bricksFollowTheLoad)
{
    if (D() == 3) GTEST_SKIP() << "pieces of rows are coarse in a small scene";
    SphConfig c = damBreak(0.025);
    c.gravity = {{20, -9.81, 0}};
    c.maxVelocity = 4;
    const FluidInput f = water(c);
    const Course run = [](SphScene& s, Outcome& o) { include(o, s.advance(0.2)); };
    const Outcome one = alone(c, f, walls(c), run), four = onSeveral(4, c, f, walls(c), run);
    expectSame(one, four);
    EXPECT_GT(four.divisions, 2);
    EXPECT_LT(four.mostOwned, 1.35*double(f.size())/4);
}

//- In pieces, with states saved and all that is read back between: the same run
TEST_P(SphRanks, piecesAndSavedStates)
{
    const SphConfig c = damBreak(0.05);
    const Course run = [](SphScene& s, Outcome& o)
    {
        for (int k = 1; k <= 4; ++k)
        {
            include(o, s.advance(0.03*k));
            s.saveState();
            Outcome between;
            readBack(between, s);
        }
    };
    compare(c, water(c), walls(c), run, {3});
}

//- 4, 1 and 3 ranks go on with each other's states, and end with the bits of one process that does
//  the same
TEST_P(SphRanks, savedStates)
{
    SphConfig c = damBreak(0.05);
    const FluidInput f = water(c);
    compareGoingOn(c, f, walls(c), {4, 1, 3},
        [](SphScene& scene, Outcome& o) { include(o, scene.advance(1e9, 30)); });
}

//- Each rank asks for places of its own, one of them for none; some see past planes
TEST_P(SphRanks, placesOfEachRank)
{
    const SphConfig c = damBreak(D() == 2 ? 0.05 : 0.1);
    const FluidInput f = water(c);
    const WallInput w = walls(c);
    const auto points = [](int rank)
    {
        std::vector<double> x;
        for (int i = 0; i < 5*rank; ++i) x.insert(x.end(), {0.02 + 0.03*i, 0.05 + 0.1*rank, 0.2});
        return x;
    };
    const auto planes = [](int rank)
    {
        SightPlanes p;
        for (int i = 0; rank == 2 && i <= 10; ++i) p.first.push_back(i/2);
        for (std::size_t i = 1; i < p.first.size(); ++i)
            if (p.first[i] > p.first[i - 1])
            {
                p.normal.insert(p.normal.end(), {0, 1, 0});
                p.depth.push_back(0.01);
            }
        return p;
    };
    std::vector<SampleResult> alone;
    const auto one = createSphScene(c, f, w);
    one->advance(1e9, 3);
    for (int rank = 0; rank < 3; ++rank) alone.push_back(one->sample(points(rank), planes(rank)));
    EXPECT_NE(alone[2].volumeFraction, one->sample(points(2)).volumeFraction);
    onRanks(3, [&](Transport& transport)
    {
        SphConfig own(c);
        own.ranks = &transport;
        const auto part = createSphScene(own, f, w);
        const auto whole = wholeSphScene(*part, transport);
        whole->advance(1e9, 3);
        const int rank = transport.rank();
        const SampleResult r = whole->sample(points(rank), planes(rank));
        if (r.volumeFraction != alone[rank].volumeFraction || r.pressure != alone[rank].pressure
            || r.velocity != alone[rank].velocity || r.centroid != alone[rank].centroid)
            throw std::logic_error("rank " + std::to_string(rank) + " has other values");
    });
}

//- Another speed of sound on the way
TEST_P(SphRanks, maxVelocityChanges)
{
    const SphConfig c = damBreak(0.05);
    const Course run = [](SphScene& s, Outcome& o)
    {
        include(o, s.advance(1e9, 40));
        s.setMaxVelocity(3.5, 35);
        include(o, s.advance(1e9, 40));
        s.saveState();
    };
    EXPECT_NE(alone(c, water(c), walls(c), run).energy.stiffening, 0);
    compare(c, water(c), walls(c), run, {3}, false);
}

//- The particle that made a guard fire is told by all
TEST_P(SphRanks, guards)
{
    SphConfig c = damBreak(0.05);
    for (const bool number : {false, true})
    {
        FluidInput f = water(c);
        f.velocity[3*7] = number ? 1e25 : 30;
        const Outcome one = alone(c, f, walls(c), stepsOf(10));
        EXPECT_EQ(one.report.stop, number ? StopReason::notANumber : StopReason::speed);
        for (const int ranks : {2, 3})
        {
            std::mutex mutex;
            onRanks(ranks, [&](Transport& transport)
            {
                SphConfig own(c);
                own.ranks = &transport;
                const auto part = createSphScene(own, f, walls(c));
                const SphReport r = part->advance(1e9, 10);
                std::lock_guard<std::mutex> lock(mutex);
                EXPECT_EQ(r.stop, one.report.stop);
                EXPECT_EQ(r.stopId, one.report.stopId);
                EXPECT_EQ(r.stopPosition, one.report.stopPosition);
                EXPECT_EQ(r.stopValue, one.report.stopValue);
                EXPECT_EQ(r.steps, one.report.steps);
            });
        }
    }
}

//- Who is interrupted stops all, after one step
TEST_P(SphRanks, interruption)
{
    const SphConfig c = damBreak(0.05);
    onRanks(3, [&](Transport& transport)
    {
        SphConfig own(c);
        own.ranks = &transport;
        const auto part = createSphScene(own, water(c), walls(c));
        if (transport.rank() == 1) part->interrupt();
        const std::int64_t steps = part->advance(1e9, 20).steps,
                           more = part->advance(1e9, 20).steps;
        if (steps != 1 || more != 20)
            throw std::logic_error(
                "took " + std::to_string(steps) + " and " + std::to_string(more) + " steps");
    });
}

//- One rank is none
TEST_P(SphRanks, oneRank)
{
    const SphConfig c = damBreak(0.05);
    const Outcome one = alone(c, water(c), walls(c), stepsOf(20)),
                  same = onSeveral(1, c, water(c), walls(c), stepsOf(20));
    expectSame(one, same);
    EXPECT_EQ(same.report.rank.owned, 0u);
}

//- What several ranks cannot have is refused by all
TEST_P(SphRanks, refusals)
{
    const auto expectRefused = [&](const SphConfig& c, const std::string& why)
    {
        onRanks(2, [&](Transport& transport)
        {
            SphConfig own(c);
            own.ranks = &transport;
            try { createSphScene(own, water(c), walls(c)); }
            catch (const std::invalid_argument& e)
            {
                if (std::string(e.what()).find(why) == std::string::npos)
                    throw std::logic_error(e.what());
                return;
            }
            throw std::logic_error("accepted, but: " + why);
        });
    };
    SphConfig c = damBreak(0.05);
    c.imbalance = 0;
    expectRefused(c, "imbalance");
}

} // namespace

RIPRAP_ALL_SETUPS(SphRanks);

} // namespace riprap
