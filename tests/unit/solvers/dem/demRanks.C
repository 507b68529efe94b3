/*  DEM scenes on several ranks, threads here: the same bits as on one, whatever crosses borders.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <atomic>
#include <map>
#include "dem/demTest.hpp"
#include "core/threadRanks.hpp"
#include "api/wholeDemScene.hpp"

namespace riprap
{
namespace
{

//- All that is read back of a particle
using Row = std::array<double, 19>;
using Rows = std::map<std::int32_t, Row>;

Rows rowsOf(const DemState& s)
{
    Rows rows;
    for (std::size_t i = 0; i < s.id.size(); ++i)
    {
        Row r{};
        int k = 0;
        for (const auto* v : {&s.position, &s.velocity, &s.spin, &s.force, &s.moment})
            for (int d = 0; d < 3; ++d) r[k++] = (*v)[3*i + d];
        r[k++] = s.radius[i];
        r[k++] = s.mass[i];
        r[k++] = s.material[i];
        r[k++] = s.contacts[i];
        EXPECT_TRUE(rows.emplace(s.id[i], r).second) << "particle " << s.id[i] << " twice";
    }
    return rows;
}

//- What a run ends with, of all ranks together
struct Outcome
{
    Rows rows;
    DemReport report;
    DemEnergy energy;
    std::vector<DemWallForce> walls;
    double deepest = 0;
    std::map<std::pair<int, int>, Vector3> contacts;
    std::map<int, Vector3> escaped;
    std::size_t passed = 0;
    std::int64_t arrivals = 0, divisions = 0;
    std::size_t ghosts = 0, leastOwned = 1u << 30, mostOwned = 0;
};

void include(Outcome& o, DemScene& scene, const DemReport& r, std::size_t owned)
{
    for (const auto& row : rowsOf(scene.particles()))
        EXPECT_TRUE(o.rows.insert(row).second) << "particle " << row.first << " on two ranks";
    const DemEnergy e = scene.energy();
    o.energy.translation += e.translation;
    o.energy.rotation += e.rotation;
    o.energy.potential += e.potential;
    o.energy.contact += e.contact;
    const auto walls = scene.wallForces();
    o.walls.resize(walls.size());
    for (std::size_t w = 0; w < walls.size(); ++w)
        for (int d = 0; d < 3; ++d)
        {
            o.walls[w].force[d] += walls[w].force[d];
            o.walls[w].moment[d] += walls[w].moment[d];
        }
    o.deepest = std::max(o.deepest, scene.deepestOverlap());
    const DemContacts c = scene.contacts();
    for (std::size_t k = 0; k < c.a.size(); ++k)
        EXPECT_TRUE(o.contacts
                        .emplace(std::make_pair(c.a[k], c.b[k]),
                            Vector3{{c.force[3*k], c.force[3*k + 1], c.force[3*k + 2]}})
                        .second);
    for (std::size_t k = 0; k < r.escapedId.size(); ++k)
        EXPECT_TRUE(o.escaped.emplace(r.escapedId[k], r.escaped[k]).second);
    o.passed += r.passedWalls;
    o.report = r;
    o.arrivals += r.rank.arrivals;
    o.divisions = r.rank.divisions;
    o.ghosts += r.rank.ghosts;
    o.leastOwned = std::min(o.leastOwned, owned);
    o.mostOwned = std::max(o.mostOwned, owned);
}

Outcome runAlone(const DemConfig& c, const DemInput& in, std::int64_t steps)
{
    Outcome o;
    auto scene = createDemScene(c, in);
    const DemReport r = scene->advance(1e9, steps);
    include(o, *scene, r, r.particles);
    return o;
}

Outcome runOnRanks(int ranks, DemConfig c, const DemInput& in, std::int64_t steps)
{
    Outcome o;
    std::mutex mutex;
    onRanks(ranks, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto scene = createDemScene(own, in);
        const DemReport r = scene->advance(1e9, steps);
        std::lock_guard<std::mutex> lock(mutex);
        include(o, *scene, r, r.rank.owned);
    });
    return o;
}

void expectNear(double a, double b, double scale, const char* what)
{
    EXPECT_NEAR(a, b, 1e-12*scale) << what;
}

void expectSame(const Outcome& a, const Outcome& b, int ranks)
{
    EXPECT_EQ(a.report.stop, DemStop::none) << a.report.stopMessage;
    ASSERT_EQ(a.rows.size(), b.rows.size()) << ranks << " ranks";
    std::size_t different = 0;
    for (const auto& row : a.rows)
    {
        const auto other = b.rows.find(row.first);
        ASSERT_NE(other, b.rows.end()) << "particle " << row.first;
        if (std::memcmp(row.second.data(), other->second.data(), sizeof(Row)) == 0) continue;
        ++different;
        for (int k = 0; k < 19 && different == 1; ++k)
        {
            EXPECT_EQ(row.second[k], other->second[k])
                << "number " << k << " of particle " << row.first << " on " << ranks << " ranks";
        }
    }
    EXPECT_EQ(different, 0u) << "particles of other bits on " << ranks << " ranks, of "
                            << a.rows.size();
    EXPECT_EQ(a.report.steps, b.report.steps);
    EXPECT_EQ(a.report.rebuilds, b.report.rebuilds);
    EXPECT_EQ(a.report.time, b.report.time);
    EXPECT_EQ(a.report.maxSpeed, b.report.maxSpeed);
    EXPECT_EQ(a.report.particles, b.report.particles);
    EXPECT_EQ(a.contacts, b.contacts);
    EXPECT_EQ(a.escaped, b.escaped);
    EXPECT_EQ(a.passed, b.passed);
    EXPECT_EQ(a.deepest, b.deepest);
    const double all = std::abs(a.energy.translation) + std::abs(a.energy.potential)
        + a.energy.contact;
    expectNear(a.energy.translation, b.energy.translation, all, "translation");
    expectNear(a.energy.rotation, b.energy.rotation, all, "rotation");
    expectNear(a.energy.potential, b.energy.potential, all, "potential");
    expectNear(a.energy.contact, b.energy.contact, all, "contact");
    double force = 1e-6;
    for (const DemWallForce& w : a.walls) for (const double f : w.force) force += std::abs(f);
    for (std::size_t w = 0; w < a.walls.size(); ++w)
        for (int d = 0; d < 3; ++d)
        {
            expectNear(a.walls[w].force[d], b.walls[w].force[d], force, "force on a wall");
            expectNear(a.walls[w].moment[d], b.walls[w].moment[d], force, "moment on a wall");
        }
}

class DemRanks : public DemTest
{
protected:

    //- A column of spheres of different size, about to fall apart
    DemInput column(int dimensions, int n, double small, double large, unsigned seed) const
    {
        DemInput in = oneMaterial();
        in.pairs[0].properties.friction = 0.4;
        in.pairs[0].properties.rollingFriction = 0.1;
        in.pairs[0].properties.restitution = 0.6;
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> u(0, 1);
        const double spacing = 2.02*large;
        const int across = dimensions == 2 ? 12 : 7,
                  layer = dimensions == 2 ? across : across*across;
        for (int i = 0; i < n; ++i)
        {
            const double r = small + (large - small)*u(engine);
            Vector3 x{{0, 0, 0}};
            const int q = i % layer, column = q/across, height = i/layer;
            x[0] = -0.4 + spacing*(q % across) + 0.1*large*u(engine);
            if (dimensions == 3) x[1] = -0.2 + spacing*column + 0.1*large*u(engine);
            x[dimensions - 1] = -0.44 + spacing*height + 0.1*large*u(engine);
            addParticle(in, x, Vector3{{u(engine) - 0.5, dimensions == 3 ? u(engine) - 0.5 : 0, 0}},
                r, 1e4*r*r*r);
        }
        addBox(in, dimensions);
        return in;
    }

    DemConfig falling(int dimensions) const
    {
        DemConfig c = config(dimensions);
        c.gravity[dimensions - 1] = -9.81;
        c.tangential = "history";
        c.rolling = "spring";
        c.stepFraction = 0.1;
        return c;
    }

    void compare(const DemConfig& c, const DemInput& in, std::int64_t steps,
        const std::vector<int>& ranks, bool moves = true) const
    {
        const Outcome one = runAlone(c, in, steps);
        for (const int n : ranks)
        {
            const Outcome o = runOnRanks(n, c, in, steps);
            expectSame(one, o, n);
            EXPECT_TRUE(!moves || (o.ghosts > 0 && o.arrivals > 0));
        }
    }
};

TEST_P(DemRanks, columnCollapse)
{
    compare(falling(3), column(3, 700, 0.014, 0.02, 5), 900, {2, 4});
}

TEST_P(DemRanks, columnCollapseOfManySizes)
{
    compare(falling(3), column(3, 500, 0.005, 0.025, 9), 900, {3});
}

TEST_P(DemRanks, columnCollapseOfDisks)
{
    compare(falling(2), column(2, 300, 0.008, 0.016, 5), 1500, {2, 5});
}

TEST_P(DemRanks, hertzAndVerlet)
{
    DemConfig c = falling(3);
    c.normal = "hertz";
    c.rolling = "none";
    c.integrator = "velocityVerlet";
    c.orientation = true;
    compare(c, column(3, 400, 0.014, 0.02, 3), 900, {2, 3});
}

//- Fast particles in a box without sides: they cross borders and periodic sides all the time, also
//  at corners
class DemRanksOfGas : public DemRanks
{
protected:
    void run(int D) const
    {
        DemConfig c = config(D);
        c.stepFraction = 0.1;
        c.tangential = "history";
        for (int d = 0; d < D; ++d) c.periodic[d] = true;
        DemInput in = oneMaterial();
        in.pairs[0].properties.friction = 0.3;
        std::mt19937 engine(4);
        std::uniform_real_distribution<double> u(-1, 1);
        const int across = D == 2 ? 15 : 7, n = D == 2 ? 225 : 343;
        for (int i = 0; i < n; ++i)
        {
            Vector3 x{{0, 0, 0}};
            int k = i;
            for (int d = 0; d < D; ++d, k /= across)
                x[d] = -0.5 + (k % across + 0.5 + 0.1*u(engine))/across;
            addParticle(in, x, Vector3{{u(engine), u(engine), D == 3 ? u(engine) : 0}},
                D == 2 ? 0.02 : 0.04, 0.01);
        }
        compare(c, in, 1200, {2, 8});
    }
};

TEST_P(DemRanksOfGas, inAPeriodicBox) { run(3); }

TEST_P(DemRanksOfGas, inAPeriodicSquare) { run(2); }

//- A tray of triangles that shakes: walls remember touches by their normals, and go with particles
//  from rank to rank
TEST_P(DemRanks, shakenSurfaces)
{
    DemConfig c = falling(3);
    DemInput in = column(3, 400, 0.016, 0.02, 8);
    in.walls.clear();
    DemWall tray;
    tray.name = "tray";
    tray.motion = 0;
    tray.vertices = {-0.45, -0.45, -0.46, 0.45, -0.45, -0.46, 0.45, 0.45, -0.46, -0.45, 0.45, -0.46,
        -0.49, -0.49, 0.4, 0.49, -0.49, 0.4, 0.49, 0.49, 0.4, -0.49, 0.49, 0.4};
    tray.elements = {
        0, 1, 2, 0, 2, 3, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    in.walls.push_back(tray);
    in.wallMotion = [](int, double t)
    {
        WallPose p;
        p.translation[0] = 0.01*std::sin(40*t);
        p.translation[1] = 0.004*std::sin(55*t);
        return p;
    };
    compare(c, in, 900, {3, 4});
}

//- Nothing at the bottom: all leave, some ranks become empty
TEST_P(DemRanks, particlesLeaveTheDomain)
{
    DemConfig c = falling(3);
    DemInput in = column(3, 300, 0.014, 0.02, 2);
    in.walls.clear();
    const Outcome one = runAlone(c, in, 1000);
    EXPECT_GT(one.escaped.size(), 50u);
    EXPECT_GT(one.rows.size(), 10u);
    for (const int ranks : {2, 4}) expectSame(one, runOnRanks(ranks, c, in, 1000), ranks);
}

//- Forces of more than one block are put together as one process has it
TEST_P(DemRanks, manyBlocks)
{
    DemConfig c = falling(3);
    DemInput in = oneMaterial();
    in.pairs[0].properties.friction = 0.4;
    std::mt19937 engine(6);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int i = 0; i < 13000; ++i)
    {
        const int across = 24;
        const int k[3] = {i % across, i/across % across, i/across/across};
        const double r = 0.0175;
        addParticle(in,
            Vector3{{-0.44 + 2*r*k[0] + 1e-3*u(engine), -0.44 + 2*r*k[1] + 1e-3*u(engine),
                -0.44 + 1.98*r*k[2] + 1e-3*u(engine)}},
            Vector3{{u(engine), u(engine), u(engine)}}, r, 0.02);
    }
    addBox(in, 3);
    compare(c, in, 150, {2, 3});
}

//- Ranks that have nothing, at first or always
TEST_P(DemRanks, moreRanksThanParticles)
{
    DemConfig c = falling(3);
    compare(c, column(3, 5, 0.014, 0.02, 2), 1500, {3, 9}, false);
    DemInput two = oneMaterial();
    addParticle(two, Vector3{{0, 0, -0.4}}, Vector3{{0.3, 0, 0}});
    addParticle(two, Vector3{{0.3, 0, -0.4}}, Vector3{{-0.3, 0, 0}});
    addBox(two, 3);
    const Outcome one = runAlone(c, two, 2000);
    for (const int ranks : {2, 3}) expectSame(one, runOnRanks(ranks, c, two, 2000), ranks);
}

//- A pile that collapses to one side: bricks follow it
TEST_P(DemRanks, bricksFollowTheLoad)
{
    DemConfig c = falling(3);
    c.gravity = Vector3{{9.81, 0, -3}};
    const DemInput in = column(3, 700, 0.014, 0.02, 5);
    const Outcome one = runAlone(c, in, 2500), four = runOnRanks(4, c, in, 2500);
    expectSame(one, four, 4);
    EXPECT_GT(four.divisions, 2);
    EXPECT_LT(double(four.mostOwned), 1.35*700/4);
}

//- A run that goes on in pieces is the same run
TEST_P(DemRanks, advancesInPieces)
{
    const DemConfig c = falling(3);
    const DemInput in = column(3, 300, 0.014, 0.02, 5);
    const auto run = [&](DemScene& scene)
    {
        DemReport r;
        for (int k = 1; k <= 5; ++k) r = scene.advance(0.013*k, 0);
        return r;
    };
    Outcome one, three;
    auto alone = createDemScene(c, in);
    const DemReport r = run(*alone);
    include(one, *alone, r, r.particles);
    std::mutex mutex;
    onRanks(3, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto scene = createDemScene(own, in);
        const DemReport here = run(*scene);
        std::lock_guard<std::mutex> lock(mutex);
        include(three, *scene, here, here.rank.owned);
    });
    expectSame(one, three, 3);
}

//- So many ranks go on from a state (empty: from the beginning) for some steps, and save theirs; 1:
//  one process, without ranks
Outcome goOn(int ranks, const DemConfig& c, const DemInput& in, std::vector<std::int32_t>& state,
    std::int64_t steps)
{
    Outcome o;
    std::mutex mutex;
    const std::vector<std::int32_t> from(state);
    const auto run = [&](const DemConfig& own, bool first)
    {
        auto scene = createDemScene(own, in);
        // others are told by the first
        if (!from.empty()) scene->loadState(first ? from : std::vector<std::int32_t>());
        const DemReport r = scene->advance(1e9, steps);
        const std::vector<std::int32_t> words = scene->saveState();
        std::lock_guard<std::mutex> lock(mutex);
        EXPECT_EQ(words.empty(), !first);
        if (first) state = words;
        include(o, *scene, r, own.ranks ? r.rank.owned : r.particles);
    };
    if (ranks == 1)
    {
        run(c, true);
        return o;
    }
    onRanks(ranks, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        run(own, transport.rank() == 0);
    });
    return o;
}

//- Words of a state are those of one process; 4, 1 and 3 ranks go on with each other's, and end
//  with the bits of one that did not change
TEST_P(DemRanks, savedStates)
{
    for (const int dimensions : {2, 3})
    {
        DemConfig c = falling(dimensions);
        c.orientation = dimensions == 3;
        const DemInput in = dimensions == 2 ? column(2, 200, 0.008, 0.016, 5)
                                            : column(3, 400, 0.014, 0.02, 5);
        std::vector<std::int32_t> one, many;
        Outcome a, b;
        for (const int ranks : {4, 1, 3})
        {
            a = goOn(1, c, in, one, 600);
            b = goOn(ranks, c, in, many, 600);
            expectSame(a, b, ranks);
            EXPECT_EQ(one, many) << ranks << " ranks";
        }
        EXPECT_GT(a.contacts.size(), 20u);
    }
}

//- Those that save go on alike
TEST_P(DemRanks, savingChangesNothing)
{
    DemConfig c = falling(3);
    const DemInput in = column(3, 300, 0.014, 0.02, 5);
    const auto run = [&](DemScene& scene)
    {
        for (int k = 0; k < 4; ++k) { scene.advance(1e9, 250); scene.saveState(); }
        return scene.advance(1e9, 250);
    };
    Outcome one, three;
    auto alone = createDemScene(c, in);
    const DemReport r = run(*alone);
    include(one, *alone, r, r.particles);
    std::mutex mutex;
    onRanks(3, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto scene = createDemScene(own, in);
        const DemReport here = run(*scene);
        std::lock_guard<std::mutex> lock(mutex);
        include(three, *scene, here, here.rank.owned);
    });
    expectSame(one, three, 3);
}

//- A state of other particles, or a damaged one, is refused by all ranks alike
TEST_P(DemRanks, wrongStatesAreRefused)
{
    const DemConfig c = falling(3);
    std::vector<std::int32_t> state, damaged;
    goOn(1, c, column(3, 100, 0.014, 0.02, 5), state, 10);
    damaged = state;
    ++damaged[damaged.size()/2];
    for (const auto& words : {state, damaged})
    {
        std::atomic<int> refused{0};
        onRanks(3, [&](Transport& transport)
        {
            DemConfig own(c);
            own.ranks = &transport;
            auto scene = createDemScene(own, column(3, 101, 0.014, 0.02, 5));
            try { scene->loadState(words); }
            catch (const std::invalid_argument&) { ++refused; }
        });
        EXPECT_EQ(refused, 3);
    }
}

//- Seen as one: particles, contacts and sums are there on each rank, those who left as well
TEST_P(DemRanks, aWholeScene)
{
    DemConfig c = falling(3);
    DemInput in = column(3, 200, 0.014, 0.02, 2);
    in.walls.clear();
    const Outcome one = runAlone(c, in, 1000);
    std::mutex mutex;
    onRanks(3, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto part = createDemScene(own, in);
        auto scene = wholeDemScene(*part, transport);
        const DemReport r = scene->advance(1e9, 1000);
        Outcome whole;
        const DemState s = scene->particles();
        EXPECT_TRUE(std::is_sorted(s.id.begin(), s.id.end()));
        whole.rows = rowsOf(s);
        whole.energy = scene->energy();
        whole.walls = scene->wallForces();
        whole.deepest = scene->deepestOverlap();
        const DemContacts contacts = scene->contacts();
        for (std::size_t k = 0; k < contacts.a.size(); ++k)
        {
            const Vector3 f{
                {contacts.force[3*k], contacts.force[3*k + 1], contacts.force[3*k + 2]}};
            EXPECT_TRUE(
                whole.contacts.emplace(std::make_pair(contacts.a[k], contacts.b[k]), f).second);
        }
        for (std::size_t k = 0; k < r.escapedId.size(); ++k)
            whole.escaped.emplace(r.escapedId[k], r.escaped[k]);
        whole.passed = r.passedWalls;
        whole.report = r;
        std::lock_guard<std::mutex> lock(mutex);
        expectSame(one, whole, 3);
    });
    EXPECT_GT(one.escaped.size(), 0u);
}

//- Step by step: walls, energies and overlaps right after rebuilds as well, when particles have
//  just arrived
TEST_P(DemRanks, whatIsReadBackAfterEachStep)
{
    constexpr int steps = 1200;
    DemConfig c = falling(3);
    c.gravity = Vector3{{6, 3, -9}};        // particles slide along the floor from rank to rank
    const DemInput in = column(3, 150, 0.014, 0.02, 5);
    struct Read { double energy = 0, deepest = 0, wall[6][3] = {}; };
    std::vector<Read> one(steps), three(steps);
    const auto read = [](DemScene& scene, Read& r)
    {
        scene.advance(1e9, 1);
        const double energy = scene.energy().contact, deepest = scene.deepestOverlap();
        const auto walls = scene.wallForces();
        static std::mutex mutex;
        std::lock_guard<std::mutex> lock(mutex);
        r.energy += energy;
        r.deepest = std::max(r.deepest, deepest);
        for (int w = 0; w < 6; ++w) for (int d = 0; d < 3; ++d) r.wall[w][d] += walls[w].force[d];
    };
    auto alone = createDemScene(c, in);
    for (Read& r : one) read(*alone, r);
    onRanks(3, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto scene = createDemScene(own, in);
        for (Read& r : three) read(*scene, r);
    });
    double energy = 0, force = 0;
    for (const Read& r : one)
    {
        energy = std::max(energy, r.energy);
        force = std::max(force, std::abs(r.wall[4][2]));
    }
    EXPECT_GT(force, 0);
    for (int k = 0; k < steps; ++k)
    {
        ASSERT_NEAR(one[k].energy, three[k].energy, 1e-12*energy) << "step " << k;
        ASSERT_EQ(one[k].deepest, three[k].deepest) << "step " << k;
        for (int w = 0; w < 6; ++w)
            for (int d = 0; d < 3; ++d)
                ASSERT_NEAR(one[k].wall[w][d], three[k].wall[w][d], 1e-12*force)
                    << "step " << k << ", wall " << w;
    }
}

//- One particle is too fast: all ranks stop at the same step and name it
TEST_P(DemRanks, guardsStopAllRanks)
{
    DemConfig c = falling(3);
    c.gravity = Vector3{{0, 0, 0}};
    DemInput in = column(3, 200, 0.014, 0.02, 5);
    in.particles.velocity[3*77] = 4000;
    const DemReport one = createDemScene(c, in)->advance(1e9, 50);
    ASSERT_EQ(one.stop, DemStop::tooFast);
    std::mutex mutex;
    int ranks = 0;
    onRanks(4, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        const DemReport r = createDemScene(own, in)->advance(1e9, 50);
        std::lock_guard<std::mutex> lock(mutex);
        ++ranks;
        EXPECT_EQ(r.stop, one.stop);
        EXPECT_EQ(r.stopId, 77);
        EXPECT_EQ(r.stopMessage, one.stopMessage);
        EXPECT_EQ(r.stopPosition, one.stopPosition);
        EXPECT_EQ(r.steps, one.steps);
    });
    EXPECT_EQ(ranks, 4);
}

//- An interrupt of one rank stops all after the same step
TEST_P(DemRanks, interruptsStopAllRanks)
{
    const DemConfig c = falling(3);
    const DemInput in = column(3, 200, 0.014, 0.02, 5);
    std::mutex mutex;
    std::vector<std::int64_t> steps;
    onRanks(3, [&](Transport& transport)
    {
        DemConfig own(c);
        own.ranks = &transport;
        auto scene = createDemScene(own, in);
        std::thread other;
        if (transport.rank() == 1)
            other = std::thread(
                [&]
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(300));
                    scene->interrupt();
                });
        const DemReport r = scene->advance(1e9, 100000000);
        if (other.joinable()) other.join();
        std::lock_guard<std::mutex> lock(mutex);
        steps.push_back(r.totalSteps);
    });
    EXPECT_GT(steps[0], 0);
    EXPECT_LT(steps[0], 100000000);
    for (const std::int64_t s : steps) EXPECT_EQ(s, steps[0]);
}

//- One rank is no division at all
TEST_P(DemRanks, oneRankIsAsNone)
{
    const DemConfig c = falling(3);
    const DemInput in = column(3, 200, 0.014, 0.02, 5);
    const Outcome one = runAlone(c, in, 300), same = runOnRanks(1, c, in, 300);
    EXPECT_EQ(same.ghosts, 0u);
    EXPECT_EQ(same.report.rank.bytesInSteps, 0);
    EXPECT_EQ(one.rows, same.rows);
}

TEST_P(DemRanks, refusesWhatIsNotThereYet)
{
    const auto why = [&](auto change)
    {
        std::string text;
        std::mutex mutex;
        try
        {
            onRanks(2, [&](Transport& transport)
            {
                DemConfig c = falling(3);
                c.ranks = &transport;
                DemInput in = column(3, 20, 0.014, 0.02, 5);
                change(c, in);
                auto scene = createDemScene(c, in);
            });
        }
        catch (const std::invalid_argument& e) { text = e.what(); }
        return text;
    };
    EXPECT_EQ(why([](DemConfig&, DemInput&) {}), "");
    EXPECT_NE(why([](DemConfig& c, DemInput&) { c.device = DeviceKind::gpu; }).find("CPU"),
        std::string::npos);
    EXPECT_NE(
        why([](DemConfig& c, DemInput&) { c.sleepSpeed = 1e-3; }).find("sleep"), std::string::npos);
    const auto later = [&](auto use)
    {
        std::string text;
        try
        {
            onRanks(2, [&](Transport& transport)
            {
                DemConfig c = falling(3);
                c.ranks = &transport;
                auto scene = createDemScene(c, column(3, 20, 0.014, 0.02, 5));
                use(*scene);
            });
        }
        catch (const std::invalid_argument& e) { text = e.what(); }
        return text;
    };
    EXPECT_NE(
        later([](DemScene& s) { s.setExternalForces({}, {}); }).find("outside"), std::string::npos);
}

const auto onCpus = testing::Values(DemCase{DeviceKind::cpu, PrecisionKind::mixed},
    DemCase{DeviceKind::cpu, PrecisionKind::doubled});
INSTANTIATE_TEST_SUITE_P(Dem, DemRanks, onCpus, demCaseName);
INSTANTIATE_TEST_SUITE_P(Dem, DemRanksOfGas, onCpus, demCaseName);

} // namespace
} // namespace riprap
