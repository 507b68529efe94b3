/*  The law of Johnson, Kendall & Roberts against its closed forms: pull-off force 3/2 pi w R*,
    forces at first touch and at separation, the energy that touching and parting takes (7.09 (w^5
    R*^4/E*^2)^(1/3), Johnson & Pollock 1994; Thornton & Ning 1998), Hertz where w is small; and
    scenes in which bodies are pulled beyond their surfaces and held, or torn off.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/contact/normal/hertz.hpp"
#include "dem/contact/normal/jkr.hpp"
#include "dem/contact/rolling/noRolling.hpp"
#include "dem/contact/tangential/frictionless.hpp"
#include "demTest.hpp"
#include "impact.hpp"

namespace riprap
{
namespace
{

using Adhesive = Contact<Jkr, Frictionless, NoRolling>;

PairProperties sticky(double w, double largest)
{
    PairProperties p;
    p.youngA = p.youngB = 1e7;
    p.largestRadius = largest;
    Jkr::workOfAdhesion.set(p, w);
    return p;
}

//- Slowly together and apart; rho = R*/R_largest from like ones down to a grain among boulders
TEST(Jkr, PullOffForce)
{
    const double w = 0.5, largest = 0.02;
    for (const double rho : {1.0, 0.3, 0.01})
    {
        const double R = rho*largest, unit = pi*w*R;
        const PairProperties p = sticky(w, largest);
        const auto q = Jkr::make(p);
        const double all = Jkr::reach(p, largest), own = Jkr::reach(p, R);
        ContactGeometry<3, double> g{};
        g.reducedMass = 0.01;
        g.reducedRadius = R;
        g.dt = 1;
        double h[1] = {0}, lowest = 0, last = 0;
        const auto force = [&](double overlap)
        {
            g.overlap = overlap + all;
            return Jkr::force<3, double>(q, g, h);
        };
        // not yet: nothing reaches over a gap that was never closed
        EXPECT_EQ(force(-0.5*own).force, 0);
        EXPECT_FALSE(Jkr::acts(h));
        EXPECT_NEAR(force(1e-9*own).force, -4.0/3*unit, 1e-6*unit);
        EXPECT_TRUE(Jkr::acts(h));
        const int steps = 100000;
        for (int k = steps; k > -steps; --k)
        {
            const auto f = force(own*k/steps);
            last = f.force;
            lowest = std::min(lowest, f.force);
            ASSERT_NEAR(f.load, f.force + 3*unit, 1e-9*unit);
        }
        EXPECT_NEAR(lowest, -1.5*unit, 1e-8*unit);
        // the square root with which the force falls there: at 1e-5 of the reach, 0.6 % before its
        // end
        EXPECT_NEAR(last, -5.0/6*unit, 0.01*unit);
        EXPECT_EQ(force(-1.001*own).force, 0);
        EXPECT_FALSE(Jkr::acts(h));
        EXPECT_EQ(force(-0.5*own).force, 0);
    }
}

//- Elastic bodies lose the energy of a touch, the same at all speeds, and stick below the speed
//  that has no more
TEST(Jkr, TouchingTakesEnergy)
{
    Body<3> a, b;
    a.radius = 0.01;
    b.radius = 0.015;
    a.mass = 0.011;
    b.mass = 0.031;
    const double R = a.radius*b.radius/(a.radius + b.radius), m = a.mass*b.mass/(a.mass + b.mass);
    const PairProperties p = sticky(0.5, b.radius);
    // -U at first touch and U at separation, a_0 = 4^(2/3) a_s: (0.225*4/3 4^(10/3) + 2.4*4/3) E*
    // a_s^5/R*^2
    const double constant = 4.0/3*(0.225*std::pow(4, 10.0/3) + 2.4)*std::pow(pi/8, 5.0/3);
    EXPECT_NEAR(constant, 7.09, 0.005);
    const double lost = constant
        *std::cbrt(std::pow(0.5, 5)*std::pow(R, 4)/std::pow(p.effectiveYoung(), 2)),
                 least = std::sqrt(2*lost/m);
    for (const double factor : {1.02, 1.5, 5.0})
    {
        const double speed = factor*least, k = Jkr::stiffness(p, Impact{a.mass, a.radius, speed});
        approach(a, b, speed, 0);
        const double before = a.kinetic() + b.kinetic();
        collide<Adhesive>(a, b, p, 1e-4*std::sqrt(m/k));
        EXPECT_NEAR(before - a.kinetic() - b.kinetic(), lost, 2e-3*lost) << factor;
    }
    approach(a, b, 0.98*least, 0);
    const double k = Jkr::stiffness(p, Impact{a.mass, a.radius, least}), root = std::sqrt(m/k);
    const ImpactResult r = collide<Adhesive>(a, b, p, 1e-3*root, 100*root);
    EXPECT_GT(r.duration, 99*root);
    EXPECT_LT(b.x.c[0] - a.x.c[0], a.radius + b.radius + Jkr::reach(p, R));
}

TEST(Jkr, WithoutAdhesionItIsHertz)
{
    const PairProperties p = sticky(1e-9, 0.005);
    const auto q = Jkr::make(p);
    const auto hertz = Hertz::make(p);
    ContactGeometry<3, double> g{};
    g.reducedMass = 0.01;
    g.reducedRadius = 0.005;
    g.dt = 1e-6;
    for (const double overlap : {1e-5, 1e-4, 1e-3})
    {
        double h[1] = {0};
        g.overlap = overlap;
        const double expected = Hertz::force<3, double>(hertz, g, h).force;
        g.overlap = overlap + q.reach;
        EXPECT_NEAR((Jkr::force<3, double>(q, g, h).force), expected, 1e-3*expected);
        EXPECT_NEAR((Jkr::energy<3, double>(q, g, h)), 0.4*expected*overlap, 1e-3*expected*overlap);
    }
}

class JkrScenes : public DemTest
{
protected:
    static constexpr double w = 0.5;

    DemConfig adhesive() const
    {
        DemConfig c = config(3);
        c.normal = "jkr";
        return c;
    }

    //- Group 0 is held; bodies of group 1 are pulled along z, against a drag
    static DemInput pulled(double force)
    {
        DemInput in = oneMaterial(0);
        Jkr::workOfAdhesion.set(in.pairs[0].properties, w);
        in.groups.resize(2);
        in.groups[0].name = "held";
        for (bool& h : in.groups[0].held) h = true;
        in.groups[0].heldSpin = true;
        in.groups[1].name = "pulled";
        in.groups[1].force = Vector3{{0, 0, force}};
        in.groups[1].viscousDamping = 500;
        return in;
    }
};

//- Below the pull-off force bodies hang on beyond their surfaces, above it they are torn off. A
//  third one flies about, so that neighbours are searched anew meanwhile; a fourth hangs where it
//  has never touched
TEST_P(JkrScenes, BodiesHangOn)
{
    const double R = 0.005, most = 1.5*pi*w*R, start = 0.0199975;
    for (const double share : {0.95, 1.05})
    {
        DemInput in = pulled(share*most);
        addParticle(in, {{0, 0, 0}});
        addParticle(in, {{0, 0, start}});
        addParticle(in, {{0.2, 0.2, -0.4}}, {{0.3, -0.4, 1}});
        const PairProperties& q = in.pairs[0].properties;
        PairProperties p = q;
        p.youngA = p.youngB = in.materials[0].young;
        const double reach = Jkr::reach(p, R);
        addParticle(in, {{0, 0.02 + 0.9*reach, 0}});
        in.groups.resize(3);
        in.groups[2].name = "free";
        in.particles.group = {0, 1, 2, 2};
        auto scene = createDemScene(adhesive(), in);
        scene->advance(0.25);
        EXPECT_GT(scene->lastReport().rebuilds, 1);
        const DemState s = scene->particles();
        const double apart = at(s.position, find(s, 1))[2] - 0.02;
        const bool holds = share < 1;
        EXPECT_EQ(s.contacts[find(s, 1)], holds ? 1 : 0) << share;
        EXPECT_EQ(s.contacts[find(s, 3)], 0);
        EXPECT_NEAR(at(s.position, find(s, 3))[1], 0.02 + 0.9*reach, 1e-7*reach + 2e-9);
        const DemContacts c = scene->contacts();
        if (holds)
        {
            EXPECT_GT(apart, 0);
            EXPECT_LT(apart, reach);
            ASSERT_EQ(c.overlap.size(), 1u);
            EXPECT_NEAR(c.overlap[0], -apart, 5e-9);
            EXPECT_NEAR(std::abs(c.force[2]), share*most, 0.01*most);
            EXPECT_LT(scene->deepestOverlap(), 1e-6);
        }
        else
        {
            EXPECT_GT(apart, 2*reach);
            EXPECT_EQ(c.overlap.size(), 0u);
        }
    }
}

//- On a plane R* is the body's own radius
TEST_P(JkrScenes, BodiesHangOnAPlane)
{
    const double R = 0.01, most = 1.5*pi*w*R;
    for (const double share : {0.95, 1.05})
    {
        DemInput in = pulled(share*most);
        addParticle(in, {{0, 0, -0.5 + R - 2.5e-6}});
        in.particles.group = {1};
        in.walls.push_back(planeWall({{0, 0, -0.5}}, {{0, 0, 1}}));
        auto scene = createDemScene(adhesive(), in);
        scene->advance(0.25);
        const DemState s = scene->particles();
        const double apart = at(s.position, 0)[2] + 0.5 - R;
        EXPECT_GT(apart, 0);
        const DemContacts c = scene->contacts();
        EXPECT_EQ(c.overlap.size(), share < 1 ? 1u : 0u);
        EXPECT_EQ(s.contacts[0], share < 1 ? 1 : 0);
        if (share < 1) EXPECT_NEAR(c.overlap[0], -apart, 5e-9);
        else EXPECT_GT(apart, 2e-5);
    }
}

TEST_P(JkrScenes, NeedsAWorkOfAdhesion)
{
    DemInput in = pulled(0);
    addParticle(in, {{0, 0, 0}});
    in.particles.group = {0};
    in.pairs[0].properties.more.clear();
    try { createDemScene(adhesive(), in); FAIL(); }
    catch (const std::invalid_argument& e)
    {
        EXPECT_NE(
            std::string(e.what()).find("the work of adhesion must be positive"), std::string::npos)
            << e.what();
    }
}

RIPRAP_DEM_CASES(JkrScenes);

} // namespace
} // namespace riprap
