/*  Rigid bodies of several particles on several ranks, threads here: the same bits as on one,
    however many ranks have a part of them, also where they leave or ranks are empty.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <map>
#include "solvers/dem/rankedPieces.hpp"

namespace riprap
{
namespace
{

//- What is read back of a whole scene, particles in the order of ids
struct Seen
{
    DemState particles;
    DemClumpState bodies;
    std::vector<DemSpringState> springs;
    std::map<std::pair<int, int>, std::array<double, 4>> contacts;     // force, overlap
    DemReport report;
    DemEnergy energy;
    double deepest = 0;

    static Seen of(DemScene& scene, const DemReport& r);
    void expectSame(const Seen& other) const;
};

Seen Seen::of(DemScene& scene, const DemReport& r)
{
    Seen s;
    s.report = r;
    s.energy = scene.energy();
    s.bodies = scene.clumps();
    s.springs = scene.springs();
    s.deepest = scene.deepestOverlap();
    const DemContacts c = scene.contacts();
    for (std::size_t k = 0; k < c.a.size(); ++k)
        s.contacts[{c.a[k], c.b[k]}] = {
            c.force[3*k], c.force[3*k + 1], c.force[3*k + 2], c.overlap[k]};
    s.particles = particlesById(scene);
    return s;
}

void expectEnergies(const DemEnergy& a, const DemEnergy& b)
{
    const double most = std::abs(a.translation) + std::abs(a.potential) + a.contact + a.spring;
    EXPECT_NEAR(a.translation, b.translation, 1e-12*most);
    EXPECT_NEAR(a.rotation, b.rotation, 1e-12*most);
    EXPECT_NEAR(a.potential, b.potential, 1e-12*most);
    EXPECT_NEAR(a.contact, b.contact, 1e-12*most);
    EXPECT_NEAR(a.spring, b.spring, 1e-12*most);
}

void Seen::expectSame(const Seen& b) const
{
    const Seen& a = *this;
    EXPECT_EQ(a.report.stop, DemStop::none) << a.report.stopMessage;
    EXPECT_EQ(a.report.steps, b.report.steps);
    EXPECT_EQ(a.report.rebuilds, b.report.rebuilds);
    EXPECT_EQ(a.report.particles, b.report.particles);
    EXPECT_EQ(a.report.maxSpeed, b.report.maxSpeed);
    const DemState &p = a.particles, &q = b.particles;
    ASSERT_EQ(p.id, q.id);
    EXPECT_EQ(p.clump, q.clump);
    EXPECT_EQ(p.group, q.group);
    expectBits(p.position, q.position, 3, p.id, "position");
    expectBits(p.velocity, q.velocity, 3, p.id, "velocity");
    expectBits(p.spin, q.spin, 3, p.id, "spin");
    expectBits(p.force, q.force, 3, p.id, "force");
    expectBits(p.moment, q.moment, 3, p.id, "moment");
    expectBits(p.orientation, q.orientation, 4, p.id, "orientation");
    expectBits(p.contacts, q.contacts, 1, p.id, "contacts");
    const DemClumpState &c = a.bodies, &d = b.bodies;
    std::vector<std::size_t> numbers(c.left.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t(0));
    expectBits(c.left, d.left, 1, numbers, "body that has left");
    expectBits(c.position, d.position, 3, numbers, "body's position");
    expectBits(c.velocity, d.velocity, 3, numbers, "body's velocity");
    expectBits(c.spin, d.spin, 3, numbers, "body's spin");
    expectBits(c.orientation, d.orientation, 4, numbers, "body's orientation");
    expectBits(c.force, d.force, 3, numbers, "body's force");
    expectBits(c.moment, d.moment, 3, numbers, "body's moment");
    ASSERT_EQ(a.springs.size(), b.springs.size());
    for (std::size_t k = 0; k < a.springs.size(); ++k)
    {
        EXPECT_EQ(a.springs[k].name, b.springs[k].name);
        EXPECT_EQ(a.springs[k].left, b.springs[k].left);
        EXPECT_EQ(a.springs[k].tension, b.springs[k].tension);
        EXPECT_EQ(a.springs[k].length, b.springs[k].length);
        EXPECT_EQ(a.springs[k].force, b.springs[k].force);
    }
    EXPECT_EQ(a.contacts, b.contacts);
    EXPECT_EQ(a.deepest, b.deepest);
    expectEnergies(a.energy, b.energy);
}

using Pieces = PiecesOf<Seen>;

//- R(q) a
Vector3 turned(const std::array<double, 4>& q, const Vector3& a)
{
    const auto cross = [](const Vector3& u, const Vector3& v)
    {
        return Vector3{{u[1]*v[2] - u[2]*v[1], u[2]*v[0] - u[0]*v[2], u[0]*v[1] - u[1]*v[0]}};
    };
    const Vector3 u{{q[1], q[2], q[3]}};
    Vector3 t = cross(u, a);
    for (double& x : t) x *= 2;
    const Vector3 s = cross(u, t);
    return Vector3{{a[0] + q[0]*t[0] + s[0], a[1] + q[0]*t[1] + s[1], a[2] + q[0]*t[2] + s[2]}};
}

//- Spheres of a body about its centre: four numbers each
using Shape = std::vector<std::array<double, 4>>;

class DemRankBodies : public DemTest
{
protected:

    static constexpr double radius = 0.012;

    //- So heavy that bodies lie on one another within a thousand steps
    DemConfig config(int D) const
    {
        DemConfig c = DemTest::config(D);
        c.gravity[D - 1] = -60;
        c.tangential = "history";
        c.rolling = "spring";
        c.stepFraction = 0.1;
        c.orientation = true;
        return c;
    }

    DemInput stones() const
    {
        DemInput in = oneMaterial(1e4);
        in.pairs[0].properties.friction = 0.4;
        in.pairs[0].properties.rollingFriction = 0.1;
        in.pairs[0].properties.restitution = 0.6;
        return in;
    }

    //- n in a row, along an axis
    static Shape bar(int n, double spacing, int axis = 0)
    {
        Shape s;
        for (int i = 0; i < n; ++i)
        {
            s.push_back({0, 0, 0, radius});
            s.back()[axis] = spacing*(i - 0.5*(n - 1));
        }
        return s;
    }

    //- Two to seven of different size
    Shape rock(int D, std::mt19937& engine) const
    {
        std::uniform_real_distribution<double> u(-1, 1);
        Shape s;
        const int n = 2 + int(engine() % 6);
        for (int i = 0; i < n; ++i)
        {
            const int row = i/3 - 1;
            s.push_back({0.9*radius*(i % 3 - 1) + 3e-3*u(engine), 0.9*radius*row + 3e-3*u(engine),
                D == 3 ? 6e-3*u(engine) : 0, radius*(0.9 + 0.2*u(engine))});
        }
        return s;
    }

    void addBody(DemInput& in, int D, const Shape& shape, Vector3 x, Vector3 v, unsigned seed,
        bool upright = false) const
    {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> u(-1, 1);
        DemClump body;
        body.position = x;
        body.velocity = v;
        double norm = 0;
        body.orientation = {
            {1 + u(engine), D == 3 ? u(engine) : 0, D == 3 ? u(engine) : 0, u(engine)}};
        if (upright) body.orientation = {{1, 0, 0, 0}};
        for (const double q : body.orientation) norm += q*q;
        for (double& q : body.orientation) q /= std::sqrt(norm);
        for (int d = 0; d < 3; ++d) if (D == 3 || d == 2) body.spin[d] = upright ? 0 : 8*u(engine);
        for (const auto& p : shape)
        {
            const double mass = 0.008*std::pow(p[3]/radius, D);
            body.mass += mass;
            for (int d = 0; d < 3; ++d)
                body.inertia[d] += mass
                    *(p[(d + 1) % 3]*p[(d + 1) % 3] + p[(d + 2) % 3]*p[(d + 2) % 3]
                        + 0.4*p[3]*p[3]);
            const Vector3 arm = turned(body.orientation, Vector3{{p[0], p[1], p[2]}});
            loose(in, Vector3{{x[0] + arm[0], x[1] + arm[1], x[2] + arm[2]}}, v, p[3], mass,
                int(in.clumps.size()));
        }
        in.clumps.push_back(body);
    }

    //- A particle; of a body
    static void loose(DemInput& in, Vector3 x, Vector3 v, double r = radius, double mass = 0.008,
        int body = -1)
    {
        addParticle(in, x, v, r, mass);
        in.particles.clump.push_back(body);
    }

    //- Rocks of all kinds and single particles among them, that fly against the walls. Members of a
    //  body do not stand side by side in the input
    DemInput rocks(int D, int across, double speed, unsigned seed = 3) const
    {
        DemInput in = stones();
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> u(-1, 1);
        const double spacing = 0.86/across;
        for (int k = 0; k < (D == 3 ? 3 : 1); ++k)
            for (int j = 0; j < (D == 3 ? across : across/2); ++j)
                for (int i = 0; i < across; ++i)
                {
                    Vector3 x{{-0.43 + spacing*(i + 0.5), -0.43 + spacing*(j + 0.5), 0}},
                        v{{speed*u(engine), speed*u(engine), D == 3 ? speed*u(engine) : 0}};
                    if (D == 3) x[2] = -0.39 + 0.1*k;
                    if (engine() % 5) addBody(in, D, rock(D, engine), x, v, unsigned(engine()));
                    else loose(in, x, v);
                }
        shuffle(in, engine);
        addBox(in, D);
        return in;
    }

    static void shuffle(DemInput& in, std::mt19937& engine)
    {
        std::vector<std::size_t> order(in.particles.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::shuffle(order.begin(), order.end(), engine);
        DemParticles& p = in.particles;
        for (auto* v : {&p.position, &p.velocity, &p.spin}) arrange(*v, 3, order);
        for (auto* v : {&p.radius, &p.mass}) arrange(*v, 1, order);
        for (auto* v : {&p.clump, &p.group}) arrange(*v, 1, order);
    }

    //- \return what the largest number of ranks did
    Traffic compare(const DemConfig& c, const DemInput& in, std::int64_t steps, int pieces,
        const std::vector<int>& ranks) const
    {
        const Pieces one = runAlone<Seen>(c, in, steps, pieces);
        Traffic t;
        for (const int n : ranks) t = compareOn(n, c, in, steps, one);
        last_ = one.back();
        return t;
    }

    int left() const
    { return int(std::count(last_.bodies.left.begin(), last_.bodies.left.end(), char(1))); }

    mutable Seen last_;
};

TEST_P(DemRankBodies, rocksInASquare)
{
    DemConfig c = config(2);
    c.gravity = Vector3{{15, -40, 0}};
    const Traffic t = compare(c, rocks(2, 12, 2), 400, 4, {9});
    EXPECT_GT(t.arrivals, 50);
    EXPECT_GT(t.ghosts, 50u);
    EXPECT_GT(last_.contacts.size(), 30u);
}

TEST_P(DemRankBodies, rocksInABox)
{
    DemConfig c = config(3);
    c.gravity = Vector3{{15, 5, -100}};
    const Traffic t = compare(c, rocks(3, 7, 2), 250, 4, {8});
    EXPECT_GT(t.arrivals, 50);
    EXPECT_GT(t.ghosts, 50u);
    EXPECT_GT(last_.contacts.size(), 30u);
}

TEST_P(DemRankBodies, hertzAndVerlet)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.normal = "hertz";
        c.rolling = "none";
        c.gravity[D - 1] = -400;
        c.integrator = "velocityVerlet";
        compare(c, rocks(D, D == 2 ? 12 : 6, 2), 300, 3, {D == 2 ? 5 : 3});
        EXPECT_GT(last_.contacts.size(), 10u);
    }
}

//- A bar through all ranks, struck by others and by balls; through it goes a hinge, or nothing
TEST_P(DemRankBodies, longBars)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        if (D == 2) c.integrator = "velocityVerlet";
        DemInput in = stones();
        addBody(in, D, bar(40, 0.02), Vector3{{0, D == 3 ? 0.01 : -0.4, D == 3 ? -0.4 : 0}},
            Vector3{{0, 0, 0}}, 1, true);
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> u(-1, 1);
        for (int i = 0; i < 12; ++i)
        {
            Vector3 x{{-0.37 + 0.06*i, 0.01, 0}}, v{{u(engine), 0.1*u(engine), 0}};
            x[D - 1] = -0.33 + 0.02*(i % 3);
            v[D - 1] = -2 + u(engine);
            if (i % 2) loose(in, x, v);
            else addBody(in, D, rock(D, engine), x, v, unsigned(i));
        }
        // one that stands upright, and falls over several ranks
        addBody(in, D, bar(26, 0.02, D - 1),
            Vector3{{D == 3 ? 0.3 : 0.38, D == 3 ? 0.2 : 0, 0}}, Vector3{{-0.7, 0, 0}}, 4,
            true);
        shuffle(in, engine);
        addBox(in, D);
        const Traffic t = compare(c, in, 250, 4, {D == 2 ? 8 : 3});
        EXPECT_GT(t.arrivals, 20);
        EXPECT_GT(last_.contacts.size(), 4u);
    }
}

//- Through periodic sides, also at corners
TEST_P(DemRankBodies, periodicSides)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity = Vector3{{0, 0, 0}};
        for (int d = 0; d < D; ++d) c.periodic[d] = true;
        DemInput in = rocks(D, D == 2 ? 12 : 6, 5);
        addBody(in, D, bar(20, 0.018), Vector3{{-0.3, 0.47, D == 3 ? 0.3 : 0}},
            Vector3{{-3, 2, D == 3 ? 1.0 : 0}}, 9, true);
        in.walls.clear();
        const Traffic t = compare(c, in, 300, 4, {2, 5});
        EXPECT_GT(t.arrivals, 100);
        EXPECT_GT(last_.contacts.size(), 0u);
    }
}

//- No walls: bodies leave as one, at whichever rank's border; in the end a few ranks have nothing
TEST_P(DemRankBodies, bodiesLeave)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = rocks(D, D == 2 ? 12 : 6, 6);
        addBody(in, D, bar(30, 0.02), Vector3{{0.02, 0.4, D == 3 ? 0.3 : 0}},
            Vector3{{1.5, 0.2, 0}}, 9, true);
        in.walls.clear();
        c.gravity = Vector3{{120, 0, 0}};
        const Traffic t = compare(c, in, 260, 6, {D == 2 ? 9 : 5});
        EXPECT_GT(left(), int(in.clumps.size())/2);
        EXPECT_GT(t.arrivals, 20);
        EXPECT_TRUE(last_.bodies.left.back());
    }
}

//- Nothing is left at all
TEST_P(DemRankBodies, allLeave)
{
    DemConfig c = config(2);
    DemInput in = rocks(2, 6, 6);
    in.walls.clear();
    c.gravity = Vector3{{400, 0, 0}};
    compare(c, in, 300, 5, {3});
    EXPECT_EQ(last_.report.particles, 0u);
    EXPECT_EQ(left(), int(in.clumps.size()));
}

//- Damped, held and constrained ones, on springs and lines
TEST_P(DemRankBodies, groups)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = rocks(D, D == 2 ? 12 : 6, 3);
        const int up = D - 1;
        in.groups.resize(6);
        for (int g = 0; g < 6; ++g) in.groups[g].name = "g" + std::to_string(g);
        in.groups[1].held[0] = true;
        in.groups[1].heldSpin = true;
        in.groups[1].localDamping = 0.2;
        in.groups[2].viscousDamping = 1;
        in.groups[2].viscousSpinDamping = 2;
        in.groups[2].force[up] = 0.05;
        in.groups[2].moment[2] = 1e-4;
        in.groups[3].constraint.hinge = true;
        in.groups[3].constraint.axis = Vector3{{0, D == 3 ? 1.0 : 0, D == 3 ? 0 : 1.0}};
        in.groups[3].constraint.point[up] = 0.1;
        in.groups[4].constraint.translation = TranslationKind::line;
        in.groups[4].constraint.rotation = RotationKind::axis;
        in.groups[4].constraint.direction = Vector3{{1, D == 2 ? 0.2 : 0, 0}};
        for (std::size_t k = 0; k < in.clumps.size(); ++k) in.clumps[k].group = int(k % 3);
        const auto more = [&](const Shape& shape, Vector3 x, int group)
        {
            addBody(in, D, shape, x, Vector3{{0.5, 0, 0}}, unsigned(group), true);
            in.clumps.back().group = group;
        };
        Vector3 x{{0.02, 0, 0}};
        x[up] = 0.1;
        more(bar(20, 0.018), x, 3);
        x[up] = 0.25;
        more(bar(12, 0.02), x, 4);
        x[up] = 0.35;
        more(bar(25, 0.02), x, 5);
        in.groups[5].springs.push_back(DemSpring{"spring", Vector3{{-0.3, x[1], x[2]}},
            Vector3{{-0.2, x[1], x[2]}}, 200, 0.5, 0.05, false});
        in.groups[5].springs.push_back(DemSpring{
            "line", Vector3{{0.3, x[1], x[2]}}, Vector3{{0.2, x[1], x[2]}}, 500, 0, 0.12, true});
        in.particles.group.clear();
        for (const std::int32_t body : in.particles.clump)
            in.particles.group.push_back(body < 0 ? 2 : in.clumps[body].group);
        const Traffic t = compare(c, in, 600, 3, {4});
        EXPECT_GT(t.arrivals, 20);
        ASSERT_EQ(last_.springs.size(), 2u);
        EXPECT_GT(last_.energy.spring, 0);
    }
}

//- Ranks have two particles of a body each, or none
TEST_P(DemRankBodies, moreRanksThanParticles)
{
    DemConfig c = config(3);
    DemInput in = stones();
    addBody(in, 3, bar(4, 0.05), Vector3{{0, 0, -0.3}}, Vector3{{1, 0.4, -1}}, 2);
    loose(in, Vector3{{0.1, 0.1, -0.2}}, Vector3{{0, 0, -1}});
    addBox(in, 3);
    const Traffic t = compare(c, in, 400, 3, {9});
    EXPECT_EQ(t.least, 0u);
}

//- All to one side: bricks follow
TEST_P(DemRankBodies, bricksFollowTheLoad)
{
    DemConfig c = config(3);
    c.gravity = Vector3{{50, 0, -10}};
    const Traffic t = compare(c, rocks(3, 7, 1), 500, 4, {4});
    EXPECT_GT(t.divisions, 2);
}

//- Beside bonds, some of which are between bodies
TEST_P(DemRankBodies, bondedBodies)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity[0] = 5;
        DemInput in = stones();
        const double r = 0.8*radius, area = D == 2 ? 2*r : pi*r*r;
        DemBondType cement;
        cement.radiusFactor = 0.8;
        cement.normalStiffness = 1e4/area;
        cement.shearStiffness = 4e3/area;
        cement.tensileStrength = 6/area;
        cement.shearStrength = 4/area;
        in.bondTypes.push_back(cement);
        std::mt19937 engine(8);
        for (int j = 0; j < 6; ++j)
            for (int i = 0; i < 6; ++i)
            {
                Vector3 x{{-0.35 + 0.0744*i, 0, 0}}, v{{1, 0, 0}};
                x[D - 1] = -0.42 + 0.0248*j;
                v[D - 1] = -2;
                addBody(in, D, bar(3, 0.0248), x, v, unsigned(i), true);
            }
        in.bonds = bondsWithin(c, in.particles, 0, 0.1*radius);
        addBox(in, D);
        const Traffic t = compare(c, in, 200, 4, {D == 2 ? 2 : 4});
        EXPECT_GT(last_.report.brokenBonds, 5u);
        EXPECT_GT(t.arrivals, 10);
    }
}

//- Step by step, also right after rebuilds, when members have just come
TEST_P(DemRankBodies, whatIsReadBackAfterEachStep)
{
    DemConfig c = config(2);
    c.gravity[0] = 6;
    compare(c, rocks(2, 10, 2), 1, 500, {3});
}

//- Triangles that shake
TEST_P(DemRankBodies, shakenSurfaces)
{
    DemConfig c = config(3);
    c.gravity[2] = -100;
    DemInput in = rocks(3, 6, 2);
    in.walls.clear();
    DemWall tray;
    tray.name = "tray";
    tray.motion = 0;
    tray.vertices = {-0.46, -0.46, -0.46, 0.46, -0.46, -0.46, 0.46, 0.46, -0.46, -0.46, 0.46, -0.46,
        -0.49, -0.49, 0.4, 0.49, -0.49, 0.4, 0.49, 0.49, 0.4, -0.49, 0.49, 0.4};
    tray.elements = {
        0, 1, 2, 0, 2, 3, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    in.walls.push_back(tray);
    in.wallMotion = [](int, double t)
    {
        WallPose p;
        p.translation[0] = 0.01*std::sin(40*t);
        return p;
    };
    compare(c, in, 300, 3, {4});
    EXPECT_GT(last_.contacts.size(), 20u);
}

//- Words of a state are those of one process; 4, 1, 3 and 2 ranks go on with each other's
TEST_P(DemRankBodies, savedStates)
{
    for (const int D : {2, 3})
    {
        const DemConfig c = config(D);
        DemInput in = rocks(D, D == 2 ? 12 : 6, 3);
        addBody(in, D, bar(30, 0.02), Vector3{{0.02, 0.4, D == 3 ? 0.3 : 0}},
            Vector3{{0.5, -1, D == 3 ? -1.0 : 0}}, 9, true);
        std::vector<std::int32_t> one, many;
        Seen a;
        for (const int ranks : {4, 1, 3, 2})
        {
            SCOPED_TRACE(ranks);
            a = goOn<Seen>(1, c, in, one, 260);
            a.expectSame(goOn<Seen>(ranks, c, in, many, 260));
            EXPECT_EQ(one, many) << ranks << " ranks";
        }
        EXPECT_GT(a.contacts.size(), 20u);
    }
}

//- Of a scene that bodies have left: the state is that of those that stayed, those that saved go on
//  alike, and a scene of those that stayed goes on with it
TEST_P(DemRankBodies, savingWhereBodiesHaveLeft)
{
    DemConfig c = config(2);
    c.gravity = Vector3{{60, 0, 0}};
    DemInput in = rocks(2, 12, 6);
    in.walls.clear();
    for (std::size_t i = 0; i < in.particles.size(); ++i) in.particles.id.push_back(int(i));
    const auto [seen, last] = sameWithStates<Seen>(c, in, 90, 6);
    last_ = seen;
    EXPECT_GT(left(), 5);
    EXPECT_LT(left(), int(in.clumps.size()) - 5);

    DemInput stayed = in;
    stayed.particles = DemParticles();
    for (const std::int32_t i : last_.particles.id)
    {
        loose(stayed, at(in.particles.position, i), at(in.particles.velocity, i),
            in.particles.radius[i], in.particles.mass[i], in.particles.clump[i]);
        stayed.particles.id.push_back(i);
    }
    std::vector<std::int32_t> one(last), many(last);
    const Seen a = goOn<Seen>(1, c, stayed, one, 60);
    a.expectSame(goOn<Seen>(4, c, stayed, many, 60));
    EXPECT_EQ(one, many);
    EXPECT_EQ(a.bodies.left.size(), in.clumps.size());
}

INSTANTIATE_TEST_SUITE_P(Dem, DemRankBodies,
    testing::Values(DemCase{DeviceKind::cpu, PrecisionKind::mixed},
        DemCase{DeviceKind::cpu, PrecisionKind::doubled}),
    demCaseName);

} // namespace
} // namespace riprap
