/*  What a DEM scene says of itself before it runs: the step's limits; helpers for bonds; forces
    from outside.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "dem/bond/calibration.hpp"
#include "dem/demTest.hpp"
#include "dem/passes/packingLimit.hpp"

namespace riprap
{
namespace
{

using DemPlanned = DemTest;

//- The lightest particle on the stiffest spring; the hard stop is half of it
TEST(DemPlan, LimitsOfSprings)
{
    DemConfig c;
    c.normal = "linear";
    DemInput in = oneMaterial(4e4);
    addParticle(in, {{0.5, 0.5, 0.5}}, {{0, 0, 0}}, 0.01, 0.04);
    addParticle(in, {{0.2, 0.5, 0.5}}, {{0, 0, 0}}, 0.01, 0.01);
    DemPlan p = planDemScene(c, in);
    const double limit = std::sqrt(0.01/4e4);
    EXPECT_NEAR(p.timeStep, 0.2*limit, 1e-12);
    EXPECT_NEAR(p.hardStop, 0.5*limit, 1e-12);
    EXPECT_NE(p.cause.find("stone-stone"), std::string::npos);

    // a step that is too long is refused with the limit that it broke and its figure, and no other
    DemConfig tooLong = c;
    tooLong.timeStep = 0.6*limit;
    try
    {
        createDemScene(tooLong, in);
        ADD_FAILURE() << "a step of 0.6 sqrt(m/k) is accepted";
    }
    catch (const std::invalid_argument& e)
    {
        double step = 0, hard = 0, share = 0;
        EXPECT_EQ(std::sscanf(e.what(),
                      "the time step of %lf s is above %lf s, %lf sqrt(m/k) of contact stone-stone",
                      &step, &hard, &share),
            3)
            << e.what();
        EXPECT_NEAR(step, 0.6*limit, 1e-5*limit);
        EXPECT_NEAR(hard, 0.5*limit, 1e-5*limit);
        EXPECT_NEAR(share, 0.5, 1e-9);
    }

    // paper 2: k = m g/(theta dx), Eq. 18 with gamma = 150 as a fraction
    c.normal = "cellSpring";
    PairProperties& q = in.pairs[0].properties;
    q.theta = 0.01;
    q.cellSize = 5e-4;
    q.gravity = 9.81;
    q.gap = 1e-3;
    c.stepFraction = 2*pi/150;
    p = planDemScene(c, in);
    EXPECT_NEAR(p.timeStep, 2*pi/150*std::sqrt(0.01*5e-4/9.81), 1e-12);
    EXPECT_TRUE(p.warnings.empty());
    // solids that can fall by 1 m at g go through the gap of 2 dx at 1.40 m/s
    c.gravity = Vector3{{0, 0, -9.81}};
    p = planDemScene(c, in);
    ASSERT_EQ(p.warnings.size(), 1u);
    EXPECT_NE(p.warnings[0].find("1.401 m/s"), std::string::npos) << p.warnings[0];
}

//- What a close packing stands: its normal modes (fcc: w^2 = 8 and 40 kappa, hexagonal: 6 and 24
//  kappa of k/m), and steps that follow
TEST(DemPlan, PackedParticles)
{
    PackedContact packed;
    EXPECT_NEAR(packingLimit(packed), 2/std::sqrt(8.0), 1e-9);
    packed.kappa = 0.8;
    EXPECT_NEAR(packingLimit(packed), 2/std::sqrt(32.0), 1e-9);
    packed.dimensions = 2;
    packed.inertia = 0.5;
    EXPECT_NEAR(packingLimit(packed), 2/std::sqrt(24*0.8), 1e-9);
    packed.kappa = 0;
    EXPECT_NEAR(packingLimit(packed), 2/std::sqrt(6.0), 1e-9);

    DemConfig c;
    c.normal = "linear";
    c.tangential = "history";
    DemInput in = oneMaterial(4e4);
    PairProperties& q = in.pairs[0].properties;
    q.friction = 0.5;
    q.stiffnessRatio = 1;
    const double unit = std::sqrt(0.01/4e4);
    for (int k = 0; k < 13; ++k)
    {
        // few of them cannot surround one
        if (k > 0) { EXPECT_NEAR(planDemScene(c, in).hardStop, 0.5*unit, 1e-12); }
        addParticle(in, {{0.05 + 0.05*k, 0.5, 0.5}}, {{0, 0, 0}}, 0.01, 0.01);
    }
    DemPlan p = planDemScene(c, in);
    EXPECT_NEAR(p.hardStop, 2/std::sqrt(40.0)*unit, 1e-9*unit);
    EXPECT_NEAR(p.timeStep, 0.2*unit, 1e-12);
    EXPECT_TRUE(p.warnings.empty());
    // dashpots: the automatic step gives way, a given one is warned of
    q.restitution = 0.5;
    p = planDemScene(c, in);
    EXPECT_LT(p.timeStep, 0.13*unit);
    EXPECT_NE(p.cause.find("close packing"), std::string::npos);
    EXPECT_TRUE(p.warnings.empty());
    const double stands = p.timeStep;
    c.timeStep = 1.1*stands;
    p = planDemScene(c, in);
    ASSERT_EQ(p.warnings.size(), 1u);
    EXPECT_NE(p.warnings[0].find("dashpots"), std::string::npos) << p.warnings[0];
    c.timeStep = 0;
    c.maxTimeStep = 0.5*stands;
    p = planDemScene(c, in);
    EXPECT_NEAR(p.timeStep, 0.5*stands, 1e-15);
    EXPECT_EQ(p.cause, "maxDeltaT");
}

//- Rayleigh's time of a sphere: pi R sqrt(rho/G)/(0.1631 nu + 0.8766)
TEST(DemPlan, RayleighTime)
{
    DemConfig c;
    c.normal = "hertz";
    DemInput in = oneMaterial();
    addParticle(in, {{0.5, 0.5, 0.5}}, {{0, 0, 0}}, 0.005, 2500*4.0/3*pi*std::pow(0.005, 3));
    const DemPlan p = planDemScene(c, in);
    const double expected = pi*0.005*std::sqrt(2500/(1e7/2.5))/(0.1631*0.25 + 0.8766);
    bool found = false;
    for (const StepLimit& l : p.limits)
        if (l.name == "Rayleigh stone") { found = true; EXPECT_NEAR(l.critical, expected, 1e-12); }
    EXPECT_TRUE(found);
    EXPECT_NEAR(expected, 4.28e-4, 1e-6);   // 2e-5 s are 4.7 % of it (benchmarks)
}

//- Calibration: Eqs. 42, 43 and section 6.3.3; Table 2's beam deflects by 0.0829505 in
TEST(DemPlan, Calibration)
{
    const BondStiffness bond = bondStiffness(10000, 3759.4, 10, 10);
    EXPECT_NEAR(bond.normal, 500, 1e-9);
    EXPECT_NEAR(bond.shear, 187.97, 1e-9);
    const BondStiffness contact = contactStiffness(10000, 3759.4, 8, 10, 10);
    EXPECT_NEAR(contact.normal, 8000, 1e-9);
    const BondStiffness plate = plateBondStiffness(10e6, 0.4, 0.5, 0.5);
    EXPECT_NEAR(plate.normal, 10e6*0.6/(1.4*0.2), 1e-3);
    EXPECT_NEAR(plate.shear, 0.5*plate.normal, 1e-9);
    EXPECT_NEAR(cantileverDeflection(11, 20, 1, {500, 188}, pi*64, pi*4096/4), 0.0829505, 5e-8);
}

//- Bonds are made within the tolerance and the group alone
TEST(DemPlan, BondsWithin)
{
    DemConfig c;
    DemInput in = oneMaterial();
    for (const double x : {0.1, 0.1201, 0.1405, 0.17}) addParticle(in, {{x, 0.5, 0.5}});
    in.particles.id = {5, 6, 7, 8};
    in.particles.group = {0, 0, 0, 0};
    const DemBonds b = bondsWithin(c, in.particles, 0, 2e-4);
    ASSERT_EQ(b.size(), 1u);
    EXPECT_EQ(b.a[0], 5);
    EXPECT_EQ(b.b[0], 6);
    EXPECT_EQ(bondsWithin(c, in.particles, 0, 1e-3).size(), 2u);
    in.particles.group[1] = 1;
    EXPECT_THROW(bondsWithin(c, in.particles, 0, 1e-3), std::invalid_argument);
}

//- Forces and moments from outside act by id until given anew
TEST_P(DemPlanned, ExternalForces)
{
    for (const int D : {2, 3})
    {
        DemConfig c = config(D);
        c.timeStep = 1e-4;
        DemInput in = oneMaterial();
        addParticle(in, {{-0.2, 0, 0}});
        addParticle(in, {{0.2, 0, 0}});
        in.particles.id = {3, 1};
        auto scene = createDemScene(c, in);
        std::vector<double> force(12, 0.0), moment(12, 0.0);
        force[3*3 + 1] = 0.02;
        moment[3*1 + 2] = 1e-6;
        scene->setExternalForces(force, moment);
        scene->advance(0.1);
        scene->setExternalForces({}, {});
        scene->advance(0.2);
        const DemState s = scene->particles();
        const double inertia = (D == 2 ? 0.5 : 0.4)*0.01*1e-4;
        // leapfrog: the kick at 0.1 s is the mean of the step before and the one after, which is
        // free
        EXPECT_NEAR(s.velocity[3*find(s, 3) + 1], 2*0.1, 2*1.01e-4);
        EXPECT_NEAR(s.velocity[3*find(s, 1) + 1], 0, 1e-12);
        EXPECT_NEAR(s.spin[3*find(s, 1) + 2], 1e-6/inertia*0.1, 1e-6/inertia*1.01e-4);
    }
}

//- Solved in the plane of axes 0 and 2: spins turn about axis 1, the other way round
TEST_P(DemPlanned, AxesOfThePlane)
{
    DemConfig c = config(2);
    c.axes[1] = 2;
    c.axes[2] = 1;
    c.tangential = "history";
    c.gravity = Vector3{{0, 0, -9.81}};
    DemInput in = oneMaterial();
    in.pairs[0].properties.friction = 0.5;
    in.pairs[0].properties.restitution = 0.3;
    in.walls.push_back(planeWall({{0, 0, -0.2}}, {{0, 0, 1}}));
    addParticle(in, {{-0.3, 0.07, -0.19 - 0.01*9.81/1e4}}, {{0.5, 0, 0}});
    auto scene = createDemScene(c, in);
    scene->advance(0.2);
    const DemState s = scene->particles();
    EXPECT_NEAR(s.velocity[0], 2.0/3*0.5, 1e-3);
    // rolls towards +x over a floor below: about +y
    EXPECT_NEAR(s.spin[1], s.velocity[0]/0.01, 0.05);
    EXPECT_DOUBLE_EQ(s.position[1], 0.07);
}

RIPRAP_DEM_CASES(DemPlanned);

} // namespace
} // namespace riprap
