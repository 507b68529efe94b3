/*  Bonded particles: the cantilever's closed form (ERRATA), torsion, breakage at the given
    strength, contact afterwards, energy.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/bond/calibration.hpp"
#include "dem/bond/parallelBond.hpp"
#include "demTest.hpp"

namespace riprap
{
namespace
{

using DemBonded = DemTest;

constexpr double spacing = 0.02;

//- A row of n particles along x, touching; the first is held (group 1), the last is loaded (group
//  2)
DemInput row(int n, const DemBondType& type)
{
    DemInput in = oneMaterial();
    in.groups.resize(3);
    for (int d = 0; d < 3; ++d) in.groups[1].held[d] = true;
    in.groups[1].heldSpin = true;
    for (int i = 0; i < n; ++i)
    {
        addParticle(in, {{-0.2 + spacing*i, 0, 0}});
        in.particles.group.push_back(i == 0 ? 1 : (i == n - 1 ? 2 : 0));
        if (i) { in.bonds.a.push_back(i - 1); in.bonds.b.push_back(i); }
    }
    for (DemGroup& g : in.groups) g.localDamping = 0.7;
    in.bondTypes.push_back(type);
    return in;
}

DemBondType bondType(double young, double shear, double factor)
{
    DemBondType t;
    t.normalStiffness = young/spacing;
    t.shearStiffness = shear/spacing;
    t.radiusFactor = factor;
    return t;
}

//- Tip deflection of a row under an end load, for several lengths, stiffnesses and radii. Small:
//  second order effects 1e-6
TEST_P(DemBonded, CantileverClosedForm)
{
    if (mixed())
        GTEST_SKIP() << "quasi-static deflections to 1e-4 need double: increments fall under "
                        "single precision";
    struct Beam { int n; double young, shear, factor; };
    for (const int D : {2, 3})
        for (const Beam b :
            {Beam{5, 1e6, 4e5, 0.8}, Beam{8, 3e6, 1e6, 0.5}, Beam{4, 1e6, 1e5, 1.0}})
        {
            DemConfig c = config(D);
            c.stepFraction = 0.3;
            DemInput in = row(b.n, bondType(b.young, b.shear, b.factor));
            const BondParameters<double> q{0, 0, 0, 0, 0, b.factor, false, D == 3};
            const BondSection<double> s = bondSection(q, 0.01, 0.01);
            const BondStiffness k = bondStiffness(b.young, b.shear, 0.01, 0.01);
            double load = 1e-3;
            load *= 1e-6/cantileverDeflection(b.n, spacing, load, k, s.area, s.inertia);
            in.groups[2].force = Vector3{{0, load, 0}};
            const double expected = cantileverDeflection(b.n, spacing, load, k, s.area, s.inertia);
            auto scene = createDemScene(c, in);
            scene->advance(1e9, 60000);
            const DemState state = scene->particles();
            EXPECT_NEAR(state.position[3*find(state, b.n - 1) + 1], expected, 1e-4*expected)
                << D << "D, n = " << b.n;
        }
}

//- Twist of a row in 3D: M (n - 1)/(ks J)
TEST_P(DemBonded, Torsion)
{
    if (mixed()) GTEST_SKIP() << "as the cantilever";
    DemConfig c = config(3);
    c.stepFraction = 0.3;
    c.orientation = true;
    const int n = 5;
    DemInput in = row(n, bondType(1e6, 4e5, 0.8));
    const double J = 0.5*pi*std::pow(0.008, 4), moment = 1e-6;
    in.groups[2].moment = Vector3{{moment, 0, 0}};
    auto scene = createDemScene(c, in);
    scene->advance(1e9, 40000);
    const DemState s = scene->particles();
    const double* q = &s.orientation[4*find(s, n - 1)];
    EXPECT_NEAR(2*std::atan2(q[1], q[0]), moment*(n - 1)/(4e5/spacing*J),
        1e-4*moment*(n - 1)/(4e5/spacing*J));
}

//- Pulled at constant speed, a bond breaks when F_n/A reaches its strength: at a stretch of
//  sigma_c/kn, to one step's stretch
TEST_P(DemBonded, BreaksInTensionAtItsStrength)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemBondType t = bondType(1e6, 4e5, 0.8);
        t.tensileStrength = 1e4;
        DemInput in = row(2, t);
        in.groups[2] = in.groups[1];
        in.particles.velocity[3] = 0.01;
        auto scene = createDemScene(c, in);
        const double dt = scene->plan().timeStep, stretch = t.tensileStrength/t.normalStiffness,
                     speed = 0.01;
        const std::int64_t before = std::int64_t(stretch/(speed*dt)) - 1;
        // velocities of held particles are never kicked: x is exact
        DemReport r = scene->advance(1e9, mixed() ? before - 3 : before);
        EXPECT_EQ(r.brokenBonds, 0u) << D;
        r = scene->advance(1e9, mixed() ? 7 : 3);
        EXPECT_EQ(r.brokenBonds, 1u) << D;
        EXPECT_EQ(scene->bonds().broken[0], 1);
    }
}

TEST_P(DemBonded, BreaksInShear)
{
    DemConfig c = config(2);
    DemBondType t = bondType(1e6, 4e5, 0.8);
    t.shearStrength = 1e3;
    DemInput in = row(2, t);
    in.groups[2] = in.groups[1];
    in.particles.velocity[4] = 0.01;
    auto scene = createDemScene(c, in);
    const double dt = scene->plan().timeStep, slip = t.shearStrength/t.shearStiffness;
    const std::int64_t steps = std::int64_t(slip/(0.01*dt));
    EXPECT_EQ(scene->advance(1e9, steps - steps/50).brokenBonds, 0u);
    EXPECT_EQ(scene->advance(1e9, steps/25).brokenBonds, 1u);
    EXPECT_EQ(scene->bonds().broken[0], 2);
}

//- Particles that overlapped when they were bonded part without a bang when the bond breaks, and
//  touch at that overlap again
TEST_P(DemBonded, ContactAfterBreakage)
{
    DemConfig c = config(3);
    DemBondType t = bondType(1e6, 4e5, 0.8);
    t.tensileStrength = 100;
    DemInput in = row(2, t);
    in.groups.assign(3, DemGroup());
    in.particles.position[3] = -0.2 + 0.9*spacing;              // overlap of 2e-3
    in.particles.velocity[3] = 0.02;
    auto scene = createDemScene(c, in);
    const double before = scene->energy().translation;
    DemReport r = scene->advance(1e9, 2000);
    EXPECT_EQ(r.brokenBonds, 1u);
    EXPECT_LE(scene->energy().total(), before*(1 + 1e-3));
    EXPECT_EQ(scene->contacts().a.size(), 0u);
    EXPECT_EQ(scene->particles().brokenBonds[0], 1);
}

//- A block of bonded particles that shakes stands the largest step that is not refused, whatever
//  its bonds; dashpots halve that step
TEST_P(DemBonded, StandsTheLargestStep)
{
    for (const int D : {2, 3})
        for (const double shear : {0.1, 1.0, 3.0})
            for (const double factor : {0.5, 1.0})
            {
                SCOPED_TRACE(std::to_string(D) + "D, G/E " + std::to_string(shear) + ", radius "
                    + std::to_string(factor));
                DemConfig c = config(D);
                c.stepFraction = 1;
                DemInput in = oneMaterial(1);
                std::mt19937 engine(7);
                std::uniform_real_distribution<double> u(-1, 1);
                const int across = D == 3 ? 5 : 8;
                for (int k = 0; k < (D == 3 ? across : 1); ++k)
                    for (int j = 0; j < across; ++j)
                        for (int i = 0; i < across; ++i)
                            addParticle(in,
                                {{i*spacing - 0.1, j*spacing - 0.1,
                                    D == 3 ? k*spacing - 0.1 : 0}},
                                {{1e-3*u(engine), 1e-3*u(engine),
                                    D == 3 ? 1e-3*u(engine) : 0}});
                in.bondTypes.push_back(bondType(1e6, shear*1e6, factor));
                in.bonds = bondsWithin(c, in.particles, 0, 1e-4);
                const DemPlan plan = planDemScene(c, in);
                EXPECT_NEAR(plan.hardStop, plan.timeStep, 1e-9*plan.timeStep) << plan.cause;
                auto scene = createDemScene(c, in);
                scene->advance(1e9, 1);
                const double before = scene->energy().total();
                scene->advance(1e9, 4000);
                // at this step the fastest modes' energy is known to their order only
                EXPECT_LT(scene->energy().total(), 4*before);
                in.bondTypes[0].dampingRatio = 0.01;
                EXPECT_NEAR(planDemScene(c, in).hardStop, 0.5*plan.hardStop, 1e-9*plan.hardStop);
            }
}

//- A bonded triangle thrown and spun keeps momentum and energy
TEST_P(DemBonded, FreeBodyKeepsMomentumAndEnergy)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        DemInput in = oneMaterial();
        for (int k = 0; k < 3; ++k)
        {
            const double a = 2*pi*k/3, r = spacing/std::sqrt(3.0), spin = 5;
            addParticle(in, {{r*std::cos(a), r*std::sin(a), 0}},
                {{0.1 - spin*r*std::sin(a), spin*r*std::cos(a), 0}});
            in.particles.spin[3*k + 2] = spin;
        }
        in.bondTypes.push_back(bondType(1e5, 4e4, 0.8));
        in.bonds = bondsWithin(c, in.particles, 0, 1e-4);
        ASSERT_EQ(in.bonds.size(), 3u);
        auto scene = createDemScene(c, in);
        const double before = scene->energy().total();
        scene->advance(1e9, 5000);
        const DemState s = scene->particles();
        Vector3 p{{0, 0, 0}};
        for (int i = 0; i < 3; ++i) for (int d = 0; d < 3; ++d) p[d] += s.velocity[3*i + d]/3;
        EXPECT_NEAR(p[0], 0.1, mixed() ? 1e-6 : 1e-14);
        EXPECT_NEAR(p[1], 0, mixed() ? 1e-6 : 1e-14);
        EXPECT_NEAR(scene->energy().total(), before, 2e-4*before);
    }
}

RIPRAP_DEM_CASES(DemBonded);

} // namespace
} // namespace riprap
