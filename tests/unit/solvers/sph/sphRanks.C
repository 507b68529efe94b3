/*  SPH scenes on several ranks, threads here: the same bits as on one, whatever crosses borders.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <functional>
#include <set>
#include "tankScene.hpp"
#include "core/threadRanks.hpp"
#include "api/wholeSphScene.hpp"
#include "api/sphDemScene.hpp"

namespace riprap
{
namespace
{

//- What a run ends with, of all ranks together
struct Outcome
{
    FluidState fluid;               // by id
    WallState walls;
    SphReport report;
    SphEnergy energy;
    FluidExtremes extremes;
    FluidEnd end;
    FaceContacts faces;
    std::vector<Vector3> wallForces;
    std::vector<FluidForce> places;
    SampleResult sample;
    NeighbourCounts neighbours;
    std::array<std::size_t, SphScene::speedClasses> faster;
    std::string limit;
    double step = 0;
    std::vector<Vector3> escaped;
    std::vector<std::int32_t> escapedId, wild;
    std::int64_t steps = 0, rebuilds = 0, arrivals = 0, divisions = 0, ghosts = 0;
    double mostOwned = 0;
};

FluidState sorted(const FluidState& s)
{
    std::vector<std::size_t> order(s.id.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
        [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
    FluidState r;
    for (const std::size_t i : order)
    {
        r.id.push_back(s.id[i]);
        r.position.insert(r.position.end(), &s.position[3*i], &s.position[3*i] + 3);
        r.velocity.insert(r.velocity.end(), &s.velocity[3*i], &s.velocity[3*i] + 3);
        r.density.push_back(s.density[i]);
        r.pressure.push_back(s.pressure[i]);
        r.smoothingLength.push_back(s.smoothingLength[i]);
    }
    return r;
}

void include(Outcome& o, const SphReport& r)
{
    o.report = r;
    o.steps += r.steps;
    o.rebuilds += r.rebuilds;
    o.escaped.insert(o.escaped.end(), r.escaped.begin(), r.escaped.end());
    o.escapedId.insert(o.escapedId.end(), r.escapedId.begin(), r.escapedId.end());
    for (const WildParticle& w : r.wild) o.wild.push_back(w.id);
}

//- All that is read back of a scene; reading moves nothing
void readBack(Outcome& o, SphScene& s)
{
    std::vector<double> points;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 6; ++j)
            for (const double z : {0.0, 0.3})
                points.insert(points.end(), {-0.05 + 0.1*i, 0.02 + 0.1*j, z});
    o.fluid = sorted(s.fluid());
    o.energy = s.energy();
    o.extremes = s.extremes();
    o.end = s.farEnd(Vector3{{0.8, 0.6, 0}}, 0.1);
    o.faces = s.faceContacts();
    o.step = s.estimateTimeStep(o.limit);
    o.sample = s.sample(points);
    o.walls = s.walls();
    o.neighbours = s.countNeighbours();
    o.faster = s.fasterThan({{0, 0.01, 0.1, 0.3, 0.5, 1, 2, 4}});
    o.wallForces = s.wallForces();
    o.places = s.forcesOnWalls();
}

using Course = std::function<void(SphScene&, Outcome&)>;

Course stepsOf(std::int64_t n)
{
    return [n](SphScene& s, Outcome& o) { include(o, s.advance(1e9, n)); };
}

class SphRanks : public TankScene
{
protected:

    //- As the tutorial damBreak has it
    SphConfig damBreak(double spacing) const
    {
        SphConfig c = tank();
        c.spacing = c.wallSpacing = spacing;
        const double thick = layers*spacing;
        c.domainMin = {{-thick, -thick, -thick}};
        c.domainMax = {{1 + thick, 1, 0.5 + thick}};
        c.integrator = IntegratorKind::symplectic;
        c.variableSmoothing = true;
        c.maxSmoothingGrowth = 1.1;
        c.viscosity = 0.001;
        c.viscosityModel = "laminarAndArtificial";
        c.antiClump = 0.01;
        c.xsph = 0.05;
        c.diffusion = "fourtakas";
        c.acousticCourant = 0.4;
        c.forceCourant = 0.33;
        return c;
    }
    SphConfig damBreak() const { return damBreak(D() == 2 ? 0.02 : 0.05); }

    FluidInput water(const SphConfig& c) const
    {
        FluidInput f = column(c);
        disturb(c, f, 0.05, 0.2, 0.001);
        // so that some soon cross borders
        for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] += 1.5;
        return f;
    }

    static Outcome alone(
        const SphConfig& c, const FluidInput& f, const WallInput& w, const Course& run)
    {
        Outcome o;
        const auto scene = createSphScene(c, f, w);
        run(*scene, o);
        readBack(o, *scene);
        return o;
    }

    static Outcome onSeveral(
        int ranks, const SphConfig& c, const FluidInput& f, const WallInput& w, const Course& run)
    {
        Outcome first;
        std::mutex mutex;
        std::int64_t arrivals = 0, ghosts = 0;
        double mostOwned = 0;
        onRanks(ranks, [&](Transport& transport)
        {
            SphConfig own(c);
            own.ranks = &transport;
            const auto part = createSphScene(own, f, w);
            const auto whole = wholeSphScene(*part, transport);
            Outcome o;
            run(*whole, o);
            readBack(o, *whole);
            std::lock_guard<std::mutex> lock(mutex);
            arrivals += o.report.rank.arrivals;
            ghosts += std::int64_t(o.report.rank.ghosts);
            mostOwned = std::max(mostOwned, double(o.report.rank.owned));
            if (transport.rank() == 0) first = o;
        });
        first.arrivals = arrivals;
        first.ghosts = ghosts;
        first.mostOwned = mostOwned;
        first.divisions = first.report.rank.divisions;
        return first;
    }

    static void expectNear(double a, double b, double scale, const char* what)
    {
        EXPECT_NEAR(a, b, 1e-12*scale) << what;
    }

    static std::set<Vector3> points(const std::vector<double>& x)
    {
        std::set<Vector3> all;
        for (std::size_t i = 0; i < x.size(); i += 3)
            all.insert(Vector3{{x[i], x[i + 1], x[i + 2]}});
        return all;
    }

    //- Bits of what moves, and of what is a sum about one place; other sums are added up by rank
    void expectSame(const Outcome& a, const Outcome& b) const
    {
        EXPECT_EQ(a.fluid.id, b.fluid.id);
        EXPECT_EQ(a.fluid.position, b.fluid.position);
        EXPECT_EQ(a.fluid.velocity, b.fluid.velocity);
        EXPECT_EQ(a.fluid.density, b.fluid.density);
        EXPECT_EQ(a.fluid.pressure, b.fluid.pressure);
        EXPECT_EQ(a.fluid.smoothingLength, b.fluid.smoothingLength);
        EXPECT_EQ(a.steps, b.steps);
        EXPECT_EQ(a.rebuilds, b.rebuilds);
        EXPECT_EQ(a.report.time, b.report.time);
        EXPECT_EQ(a.report.lastTimeStep, b.report.lastTimeStep);
        EXPECT_EQ(a.report.limit, b.report.limit);
        EXPECT_EQ(a.report.maxSpeed, b.report.maxSpeed);
        EXPECT_EQ(a.report.maxDensityDeviation, b.report.maxDensityDeviation);
        EXPECT_EQ(a.report.fluid, b.report.fluid);
        EXPECT_FALSE(a.report.skinExceeded);
        EXPECT_FALSE(b.report.skinExceeded);
        EXPECT_EQ(std::set<Vector3>(a.escaped.begin(), a.escaped.end()),
            std::set<Vector3>(b.escaped.begin(), b.escaped.end()));
        EXPECT_EQ(std::set<int>(a.escapedId.begin(), a.escapedId.end()),
            std::set<int>(b.escapedId.begin(), b.escapedId.end()));
        EXPECT_EQ(std::set<int>(a.wild.begin(), a.wild.end()),
            std::set<int>(b.wild.begin(), b.wild.end()));
        EXPECT_EQ(a.walls.position, b.walls.position);
        EXPECT_EQ(a.walls.pressure, b.walls.pressure);
        EXPECT_EQ(a.sample.volumeFraction, b.sample.volumeFraction);
        EXPECT_EQ(a.sample.pressure, b.sample.pressure);
        EXPECT_EQ(a.sample.velocity, b.sample.velocity);
        EXPECT_EQ(a.sample.centroid, b.sample.centroid);
        EXPECT_EQ(a.extremes.speed, b.extremes.speed);
        EXPECT_EQ(a.extremes.densityDeviation, b.extremes.densityDeviation);
        EXPECT_EQ(a.end.particles, b.end.particles);
        EXPECT_EQ(points(a.end.position), points(b.end.position));
        EXPECT_EQ(a.step, b.step);
        EXPECT_EQ(a.limit, b.limit);
        EXPECT_EQ(a.faster, b.faster);
        EXPECT_EQ(a.neighbours.particles, b.neighbours.particles);
        EXPECT_EQ(a.neighbours.fluid, b.neighbours.fluid);
        EXPECT_EQ(a.neighbours.walls, b.neighbours.walls);
        EXPECT_EQ(a.neighbours.aboutWalls, b.neighbours.aboutWalls);
        EXPECT_EQ(a.faces.count, b.faces.count);
        expectSameSums(a, b);
    }

    void expectSameSums(const Outcome& a, const Outcome& b) const
    {
        const double all = a.energy.kinetic + std::abs(a.energy.potential) + a.energy.elastic;
        expectNear(a.energy.kinetic, b.energy.kinetic, all, "kinetic");
        expectNear(a.energy.potential, b.energy.potential, all, "potential");
        expectNear(a.energy.elastic, b.energy.elastic, all, "elastic");
        expectNear(a.energy.faceWork, b.energy.faceWork, all, "work of faces");
        expectNear(a.energy.stiffening, b.energy.stiffening, all, "stiffening");
        double force = 1e-6;
        for (const FluidForce& f : a.places)
            for (int d = 0; d < 3; ++d) force += std::abs(f.pressure[d]) + std::abs(f.viscous[d]);
        ASSERT_EQ(a.wallForces.size(), b.wallForces.size());
        for (std::size_t k = 0; k < a.wallForces.size(); ++k)
            for (int d = 0; d < 3; ++d)
                expectNear(a.wallForces[k][d], b.wallForces[k][d], force, "force on walls");
        std::map<Vector3, Vector3> places;
        for (const FluidForce& f : a.places) places[f.place] = f.pressure;
        EXPECT_EQ(a.places.size(), b.places.size());
        for (const FluidForce& f : b.places) EXPECT_EQ(places[f.place], f.pressure);
        for (int d = 0; d < 3; ++d)
            expectNear(a.faces.impulse[d], b.faces.impulse[d], 1, "impulse of faces");
    }

    void compare(const SphConfig& c, const FluidInput& f, const WallInput& w, const Course& run,
        const std::vector<int>& ranks, bool moves = true) const
    {
        const Outcome one = alone(c, f, w, run);
        for (const int n : ranks)
        {
            SCOPED_TRACE(std::to_string(n) + " ranks");
            const Outcome o = onSeveral(n, c, f, w, run);
            expectSame(one, o);
            EXPECT_TRUE(!moves || (o.ghosts > 0 && o.arrivals > 0));
            if (testing::Test::HasFailure()) return;
        }
    }
};

TEST_P(SphRanks, damBreak)
{
    const SphConfig c = damBreak();
    compare(c, water(c), walls(c), stepsOf(D() == 2 ? 150 : 50), {2, 3, 4});
}

TEST_P(SphRanks, leapfrogAndStationaryWalls)
{
    SphConfig c = damBreak();
    c.integrator = IntegratorKind::leapfrog;
    c.wallModel = WallKind::stationary;
    c.variableSmoothing = false;
    c.viscosityModel = "artificial";
    c.shifting = ShiftingKind::fickian;
    compare(c, water(c), walls(c), stepsOf(D() == 2 ? 80 : 25), {3}, D() == 2);
}

TEST_P(SphRanks, leapfrogAndExtrapolatedWalls)
{
    SphConfig c = damBreak();
    c.integrator = IntegratorKind::leapfrog;
    c.xsph = 0;
    compare(c, water(c), walls(c), stepsOf(D() == 2 ? 80 : 25), {3}, D() == 2);
}

//- Fast fluid without walls crosses borders and periodic sides all the time, also at corners
TEST_P(SphRanks, periodicBox)
{
    SphConfig c = config();
    c.integrator = IntegratorKind::symplectic;
    c.variableSmoothing = true;
    c.xsph = 0.2;
    c.diffusion = "molteni";
    c.viscosityModel = "artificial";
    c.spacing = D() == 2 ? 0.05 : 1.0/12;
    c.maxDensityDeviation = 10;
    for (int d = 0; d < D(); ++d) c.periodic[d] = true;
    FluidInput f = lattice(c, {{0, 0, 0}}, {{1, 1, D() == 3 ? 1.0 : 0.0}});
    disturb(c, f, 0.1, 2, 0.01, 3);
    compare(c, f, WallInput(), stepsOf(D() == 2 ? 60 : 15), {2, 8});
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
    compare(c, f, walls(c), stepsOf(30), {3}, false);
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
    const WallInput w = walls(c);
    std::vector<std::int32_t> one, many;
    std::mutex mutex;
    const auto goOn = [&mutex](std::vector<std::int32_t>& state)
    {
        const auto from = std::make_shared<std::vector<std::int32_t>>(state);
        return Course([from, &state, &mutex](SphScene& s, Outcome& o)
        {
            if (!from->empty()) s.loadState(*from);
            include(o, s.advance(1e9, 30));
            const std::vector<std::int32_t> words = s.saveState();
            std::lock_guard<std::mutex> lock(mutex);
            if (!words.empty()) state = words;
        });
    };
    for (const int ranks : {4, 1, 3})
    {
        SCOPED_TRACE(std::to_string(ranks) + " ranks");
        const Outcome a = alone(c, f, w, goOn(one));
        const Outcome b = ranks == 1 ? alone(c, f, w, goOn(many))
                                     : onSeveral(ranks, c, f, w, goOn(many));
        expectSame(a, b);
        EXPECT_EQ(one, many);
    }
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
    const auto expectRefused = [&](const SphConfig& c, const WallInput& w, const WallMotion& motion,
                                   const std::string& why)
    {
        onRanks(2, [&](Transport& transport)
        {
            SphConfig own(c);
            own.ranks = &transport;
            try { createSphScene(own, water(c), w, motion); }
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
    WallInput w = walls(c);
    c.imbalance = 0;
    expectRefused(c, w, WallMotion(), "imbalance");
    c = damBreak(0.05);
    c.device = DeviceKind::gpu;
    expectRefused(c, w, WallMotion(), "CPUs alone");
    c.device = DeviceKind::cpu;
    makePiston(w);
    expectRefused(c, w, pistonMotion(), "walls that move");
}

} // namespace

INSTANTIATE_TEST_SUITE_P(, SphRanks, testing::ValuesIn(std::vector<Setup>
{
    {DeviceKind::cpu, 2, PrecisionKind::mixed}, {DeviceKind::cpu, 2, PrecisionKind::doubled},
    {DeviceKind::cpu, 3, PrecisionKind::mixed}, {DeviceKind::cpu, 3, PrecisionKind::doubled}
}), setupName);

} // namespace riprap
