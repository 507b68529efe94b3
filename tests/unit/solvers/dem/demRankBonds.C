/*  Bonds on several ranks, threads here: the same bits as on one, whichever bonds are cut by
    borders, break there, or lose their particles.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "solvers/dem/rankedPieces.hpp"

namespace riprap
{
namespace
{

//- What is read back of a whole scene, particles in the order of ids
struct Seen
{
    DemState particles;
    DemBondState bonds;
    DemContacts contacts;
    DemReport report;
    double energy = 0;

    static Seen of(DemScene& scene, const DemReport& r);
    void expectSame(const Seen& other) const;
};

Seen Seen::of(DemScene& scene, const DemReport& r)
{
    Seen s;
    s.report = r;
    s.energy = scene.energy().bond;
    s.bonds = scene.bonds();
    s.contacts = scene.contacts();
    s.particles = particlesById(scene);
    return s;
}

void Seen::expectSame(const Seen& b) const
{
    const Seen& a = *this;
    EXPECT_EQ(a.report.stop, DemStop::none) << a.report.stopMessage;
    EXPECT_EQ(a.report.steps, b.report.steps);
    EXPECT_EQ(a.report.rebuilds, b.report.rebuilds);
    EXPECT_EQ(a.report.brokenBonds, b.report.brokenBonds);
    EXPECT_EQ(a.report.particles, b.report.particles);
    EXPECT_NEAR(a.energy, b.energy, 1e-12*a.energy);
    const DemState &p = a.particles, &q = b.particles;
    ASSERT_EQ(p.id, q.id);
    expectBits(p.position, q.position, 3, p.id, "position");
    expectBits(p.velocity, q.velocity, 3, p.id, "velocity");
    expectBits(p.spin, q.spin, 3, p.id, "spin");
    expectBits(p.force, q.force, 3, p.id, "force");
    expectBits(p.moment, q.moment, 3, p.id, "moment");
    expectBits(p.orientation, q.orientation, 4, p.id, "orientation");
    expectBits(p.contacts, q.contacts, 1, p.id, "contacts");
    expectBits(p.brokenBonds, q.brokenBonds, 1, p.id, "broken bonds");
    const DemBondState &c = a.bonds, &d = b.bonds;
    ASSERT_EQ(c.number, d.number);
    expectBits(c.a, d.a, 1, c.number, "bond's first end");
    expectBits(c.b, d.b, 1, c.number, "bond's second end");
    expectBits(c.type, d.type, 1, c.number, "bond's type");
    expectBits(c.broken, d.broken, 1, c.number, "bond's break");
    expectBits(c.force, d.force, 3, c.number, "bond's force");
    expectBits(c.moment, d.moment, 3, c.number, "bond's moment");
    expectBits(c.gap, d.gap, 1, c.number, "bond's gap");
    expectBits(c.restGap, d.restGap, 1, c.number, "bond's unstressed gap");
    EXPECT_EQ(a.contacts.a.size(), b.contacts.a.size());
}

using Pieces = PiecesOf<Seen>;

class DemRankBonds : public DemTest
{
protected:

    static constexpr double radius = 0.01, stiffness = 1e4;

    //- A bond as stiff as contacts of particles of this radius
    DemBondType cement(int D, double strength, double size = radius) const
    {
        const double r = 0.8*size, area = D == 2 ? 2*r : pi*r*r;
        DemBondType t;
        t.radiusFactor = 0.8;
        t.normalStiffness = stiffness/area;
        t.shearStiffness = 0.4*stiffness/area;
        t.tensileStrength = strength/area;
        t.shearStrength = 0.6*strength/area;
        return t;
    }

    DemConfig config(int D) const
    {
        DemConfig c = DemTest::config(D);
        c.gravity[D - 1] = -9.81;
        c.tangential = "history";
        c.rolling = "spring";
        c.stepFraction = 0.1;
        c.orientation = true;
        return c;
    }

    //- A block of bonded particles from `corner`, uneven in size, that flies. strength [N]
    void addBlock(DemInput& in, int D, Vector3 corner, int across, Vector3 v, double spacing) const
    {
        std::mt19937 engine(unsigned(7 + in.particles.size()));
        std::uniform_real_distribution<double> u(-1, 1);
        for (int k = 0; k < (D == 3 ? across : 1); ++k)
            for (int j = 0; j < across; ++j)
                for (int i = 0; i < across; ++i)
                {
                    Vector3 x = corner, w = v;
                    x[0] += i*spacing;
                    x[1] += j*spacing;
                    x[2] += k*spacing;
                    for (int d = 0; d < D; ++d) { x[d] += 2e-4*u(engine); w[d] += 0.02*u(engine); }
                    addParticle(in, x, w, radius*(1 + 0.02*u(engine)));
                }
    }

    //- Blocks that roll, strike each other and the floor
    DemInput blocks(int D, double strength, double spacing = 2.04*radius) const
    {
        DemInput in = oneMaterial(stiffness);
        in.pairs[0].properties.friction = 0.4;
        in.pairs[0].properties.rollingFriction = 0.1;
        in.pairs[0].properties.restitution = 0.6;
        const int across = D == 2 ? 9 : 5;
        Vector3 low{{-0.4, -0.08, -0.05}}, v{{1.5, 0, 0}}, back{{-1, 0, 0}};
        low[D - 1] = -0.47;
        v[D - 1] = back[D - 1] = -1.5;
        addBlock(in, D, low, across, v, spacing);
        low[0] = 0.1;
        low[D - 1] += 0.05;
        addBlock(in, D, low, across, back, spacing);
        in.bondTypes.push_back(cement(D, strength));
        DemConfig c = config(D);
        in.bonds = bondsWithin(c, in.particles, 0, 0.1*radius);
        addBox(in, D);
        return in;
    }

    void accelerate(DemInput& in, double factor) const
    { for (double& v : in.particles.velocity) v *= factor; }

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

    //- Breaks of each kind at the end
    int broken(int kind) const
    { return int(std::count(last_.bonds.broken.begin(), last_.bonds.broken.end(), kind)); }

    mutable Seen last_;
};

TEST_P(DemRankBonds, squaresBreakOnTheFloor)
{
    const Traffic t = compare(config(2), blocks(2, 12), 250, 4, {2, 8});
    EXPECT_GT(broken(0), 30);
    EXPECT_GT(broken(1), 5);
    EXPECT_GT(broken(2), 5);
    EXPECT_GT(t.arrivals, 20);
    EXPECT_GT(t.ghosts, 20u);
}

TEST_P(DemRankBonds, cubesBreakOnTheFloor)
{
    const Traffic t = compare(config(3), blocks(3, 12), 200, 4, {4});
    EXPECT_GT(broken(0), 30);
    EXPECT_GT(broken(1), 5);
    EXPECT_GT(broken(2), 5);
    EXPECT_GT(t.arrivals, 20);
}

//- Nothing breaks: bonds go on being cut by borders that move
TEST_P(DemRankBonds, wholeBlocksRoll)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity[0] = 9;
        c.integrator = "velocityVerlet";
        DemInput in = blocks(D, 1);
        in.bondTypes[0].tensileStrength = in.bondTypes[0].shearStrength = 1e300;
        in.bondTypes[0].dampingRatio = 0.05;
        const Traffic t = compare(c, in, D == 2 ? 1000 : 400, 3, {D == 2 ? 4 : 3});
        EXPECT_EQ(broken(0), int(in.bonds.size()));
        EXPECT_GT(t.divisions, 1);
        EXPECT_GT(t.arrivals, 50);
    }
}

//- A bar through all ranks, of bonds far longer than contacts reach, is pulled until it breaks:
//  where borders cut it, too
TEST_P(DemRankBonds, longBondsAreStretched)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity = Vector3{{0, 0, 0}};
        DemInput in = oneMaterial(stiffness);
        in.groups.resize(2);
        for (int d = 0; d < 3; ++d) in.groups[1].held[d] = true;
        in.groups[1].heldSpin = true;
        in.bondTypes.push_back(cement(D, 100));
        in.bondTypes.push_back(cement(D, 1e30));
        const int n = 17;
        for (int i = 0; i < n; ++i)
        {
            // both ends are pulled, the middle is held
            const int end = i == 0 ? -1 : i == n - 1;
            addParticle(in, Vector3{{-0.32 + 0.04*i, 0.01*(i % 2), 0}}, Vector3{{4.0*end, 0, 0}});
            in.particles.group.push_back(end != 0 || i == n/2);
            if (i == 0) continue;
            in.bonds.a.push_back(i % 3 ? i - 1 : i);
            in.bonds.b.push_back(i % 3 ? i : i - 1);
            in.bonds.type.push_back(i % 8 != 3);
        }
        // 0.2 m: most of the bar
        in.bonds.a.push_back(9);
        in.bonds.b.push_back(4);
        in.bonds.type.push_back(1);
        const Traffic t = compare(c, in, 70, 8, {D == 2 ? 8 : 3});
        EXPECT_GT(t.ghosts, 10u);
        EXPECT_EQ(broken(1), 2);
        EXPECT_EQ(last_.report.brokenBonds, 2u);
        EXPECT_GT(*std::max_element(last_.bonds.gap.begin(), last_.bonds.gap.end()), 0.15);
    }
}

//- Through periodic sides
TEST_P(DemRankBonds, blocksCrossPeriodicSides)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.gravity = Vector3{{0, 0, 0}};
        for (int d = 0; d < D; ++d) c.periodic[d] = true;
        DemInput in = blocks(D, 30);
        in.walls.clear();
        accelerate(in, 8);
        const Traffic t = compare(c, in, D == 2 ? 300 : 150, 5, {D == 2 ? 2 : 5});
        EXPECT_GT(t.arrivals, 50);
        EXPECT_GT(broken(0), 20);
        EXPECT_GT(last_.report.brokenBonds, 20u);
    }
}

//- Blocks fall out of the domain: bonds lose one end, then the other, here and on another rank
TEST_P(DemRankBonds, bondsLoseTheirParticles)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = blocks(D, 12);
        in.walls.clear();
        accelerate(in, 4);
        compare(c, in, 60, 12, {D == 2 ? 4 : 2});
        EXPECT_LT(last_.report.particles, in.particles.size() - 20);
        EXPECT_GT(last_.report.particles, 20u);
        EXPECT_GT(broken(3), 20);
    }
}

//- Overlaps that are at rest (Bonds) stay so where the bond has broken
TEST_P(DemRankBonds, overlapsAtRestBreak)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = blocks(D, 12, 1.9*radius);
        compare(c, in, 150, 4, {D == 2 ? 2 : 4});
        EXPECT_GT(broken(0), 30);
        EXPECT_GT(last_.report.brokenBonds, 5u);
        c.contactWithinBonds = true;
        compare(c, in, 150, 2, {3});
    }
}

//- Small ones on large ones, which are in cells of their own; some bonds are broken at once
TEST_P(DemRankBonds, manySizes)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = oneMaterial(stiffness);
        in.pairs[0].properties.friction = 0.3;
        c.gravity[0] = 20;
        const int n = 6;
        std::mt19937 engine(3);
        std::uniform_real_distribution<double> u(-1, 1);
        const auto bond = [&](int a, int b)
        {
            in.bonds.a.push_back(a);
            in.bonds.b.push_back(b);
            in.bonds.type.push_back(b % 3 != 0);
        };
        for (int i = 0; i < n; ++i)
        {
            const double x = -0.37 + 0.14*i, z = -0.35 + 0.02*(i % 2);
            const auto put = [&](double dx, double dz, double r)
            {
                Vector3 at{{x + dx, 0, 0}}, v{{4 + u(engine), 0, 0}};
                at[D - 1] = z + dz;
                v[D - 1] = -2 + 0.2*u(engine);
                addParticle(in, at, v, r, r > 0.02 ? 0.05 : 0.005);
            };
            const int first = int(in.particles.size());
            put(0, 0, 0.05);
            for (int k = 0; k < 12; ++k)
            {
                put(0.061*std::cos(pi*k/6), 0.061*std::sin(pi*k/6), 0.01);
                bond(first, first + 1 + k);
                if (k) bond(first + 1 + k, first + k);
            }
        }
        in.bondTypes.push_back(cement(D, 6));
        in.bondTypes.push_back(cement(D, 60));
        in.bonds.gap.assign(in.bonds.size(), 0.001);
        for (const std::size_t k : {3u, 70u}) in.bonds.gap[k] = -0.02;
        addBox(in, D);
        const Traffic t = compare(c, in, 300, 4, {5});
        EXPECT_TRUE(D == 3 || t.arrivals > 20);
        EXPECT_GT(t.ghosts, 50u);
        EXPECT_GT(broken(0), 10);
        EXPECT_GT(last_.report.brokenBonds, 10u);
    }
}

//- More ranks than there are bonds, and than particles
TEST_P(DemRankBonds, ranksWithoutBonds)
{
    DemConfig c = config(3);
    DemInput in = oneMaterial(stiffness);
    for (int i = 0; i < 5; ++i)
        addParticle(in, Vector3{{-0.2 + 0.1*i, 0, -0.4}}, Vector3{{1.0*i, 0.5, -2}});
    in.bondTypes.push_back(cement(3, 5));
    in.bonds = DemBonds{{1}, {3}, {}, {}};
    addBox(in, 3);
    compare(c, in, 300, 3, {7});
    EXPECT_EQ(last_.report.brokenBonds, 1u);
}

//- Words of a state are those of one process; 3, 1, 2 and 4 ranks go on with each other's
TEST_P(DemRankBonds, savedStates)
{
    for (const int D : {2, 3})
    {
        const DemConfig c = config(D);
        const DemInput in = blocks(D, 12);
        std::vector<std::int32_t> one, many;
        Seen a;
        for (const int ranks : {3, 1, 2, 4})
        {
            SCOPED_TRACE(ranks);
            a = goOn<Seen>(1, c, in, one, 150);
            a.expectSame(goOn<Seen>(ranks, c, in, many, 150));
            EXPECT_EQ(one, many) << ranks << " ranks";
        }
        EXPECT_GT(a.report.brokenBonds, 20u);
        EXPECT_LT(a.report.brokenBonds, in.bonds.size() - 20);
    }
}

//- Of a scene that bonded particles have left: its state is that of those that stayed, and those
//  that saved go on alike
TEST_P(DemRankBonds, savingWhereBondsAreLost)
{
    const DemConfig c = config(2);
    DemInput in = blocks(2, 12);
    in.walls.clear();
    accelerate(in, 4);
    const Seen seen = sameWithStates<Seen>(c, in, 120, 6).first;
    const auto& broken = seen.bonds.broken;
    EXPECT_GT(std::count(broken.begin(), broken.end(), 3), 20);
}

INSTANTIATE_TEST_SUITE_P(Dem, DemRankBonds,
    testing::Values(DemCase{DeviceKind::cpu, PrecisionKind::mixed},
        DemCase{DeviceKind::cpu, PrecisionKind::doubled}),
    demCaseName);

} // namespace
} // namespace riprap
