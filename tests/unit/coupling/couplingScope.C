/*  Fluid and solids: what is far apart or not there costs nothing, and what is refused.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <algorithm>
#include <set>
#include "couplingTest.hpp"

namespace riprap
{
namespace
{

class CouplingScope : public CouplingTest {};

RIPRAP_ALL_SETUPS(CouplingScope);

//- The same particles, to what another order of sums leaves: on the GPU a scene with solids seeks
//  neighbours at other steps
void expectClose(const FluidState& a, const FluidState& b, const SphConfig& c)
{
    const double tolerance = c.precision == PrecisionKind::mixed ? 1e-6 : 1e-12;
    const std::vector<std::size_t> ia = byId(a), ib = byId(b);
    ASSERT_EQ(ia.size(), ib.size());
    for (std::size_t k = 0; k < ia.size(); ++k)
    {
        EXPECT_EQ(a.id[ia[k]], b.id[ib[k]]);
        EXPECT_NEAR(a.density[ia[k]], b.density[ib[k]], tolerance*c.density);
        for (int d = 0; d < 3; ++d)
        {
            EXPECT_NEAR(a.position[3*ia[k] + d], b.position[3*ib[k] + d], tolerance*c.spacing);
            EXPECT_NEAR(a.velocity[3*ia[k] + d], b.velocity[3*ib[k] + d], tolerance*c.soundSpeed);
        }
    }
}

//- Solids far from any fluid: they fall as if alone, the fluid does what it does alone, and no pass
//  between the two is launched
TEST_P(CouplingScope, FarApartNothingPasses)
{
    SphConfig c = config();
    c.wallSpacing = c.spacing;
    c.domainMax[0] = 2;
    c.gravity = {{0, -1, 0}};
    SolidInput solids = block(c, 3, 0.6*c.spacing, {{1.5, 0.5, D() == 3 ? 0.3 : 0.0}});
    FluidInput f = lattice(
        c, {{0.2, 0.5, D() == 3 ? 0.2 : 0.0}}, {{0.6, 0.8, D() == 3 ? 0.4 : 0.0}});
    disturb(c, f, 0.1, 0.2, 0.01);
    const auto both = createSphDemScene(c, f, {}, solids);
    const auto alone = createSphScene(c, f, {});
    both->advance(0.05);
    alone->advance(0.05);
    if (GetParam().device == DeviceKind::cpu) expectSameBits(both->fluid(), alone->fluid());
    else expectClose(both->fluid(), alone->fluid(), c);
    for (const double force : both->coupling().force) EXPECT_EQ(force, 0);
    const std::set<std::string> coupling {"solidMomentumPass", "solidDensityPass", "solidForce",
        "solidPressure", "listFluidSolid", "listSolidFluid"};
    for (const KernelInfo& k : both->kernels())
        EXPECT_EQ(coupling.count(k.name), 0u) << k.name << " was launched";
    const DemState q = both->solids()->particles();
    for (std::size_t i = 0; i < q.id.size(); ++i) EXPECT_NEAR(q.velocity[3*i + 1], -0.05, 1e-5);
}

//- They meet: what falls into the water is seen when it gets there
TEST_P(CouplingScope, SolidsThatComeNearMeetTheFluid)
{
    SphConfig c = config();
    c.wallSpacing = c.spacing;
    c.domainMax[1] = 2;
    SolidInput solids = block(c, 2, c.spacing, {{0.4, 1.0, D() == 3 ? 0.3 : 0.0}});
    solids.input.particles.velocity.assign(solids.input.particles.position.size(), 0.0);
    for (std::size_t i = 0; i < solids.input.particles.size(); ++i)
        solids.input.particles.velocity[3*i + 1] = -5;
    FluidInput f = lattice(
        c, {{0.2, 0.2, D() == 3 ? 0.2 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.4 : 0.0}});
    const auto s = createSphDemScene(c, f, {}, solids);
    const auto largest = [&]
    {
        double most = 0;
        for (const double v : s->coupling().force) most = std::max(most, std::abs(v));
        return most;
    };
    s->advance(0.01);
    EXPECT_EQ(largest(), 0);
    s->advance(0.09);
    EXPECT_GT(largest(), 0);
}

//- A particle has left: a scene of those that stayed goes on from the state, to the bit
TEST_P(CouplingScope, WhatStayedContinuesToTheBit)
{
    for (const std::string force : {"impulse", "interpolated"})
    {
        SphConfig c = config();
        c.wallSpacing = c.spacing;
        c.domainMax[1] = 2;
        SolidInput solids = block(c, 2, c.spacing, {{0.4, 0.66, D() == 3 ? 0.3 : 0.0}});
        DemInput& in = solids.input;
        in.bonds = DemBonds();
        in.bondTypes.clear();
        DemParticles& p = in.particles;
        p.velocity.assign(p.position.size(), 0.0);
        for (std::size_t i = 0; i < p.size(); ++i)
        {
            p.velocity[3*i + 1] = -2;
            p.id.push_back(7 + int(i));
        }
        p.position[3*1 + 1] = 1.95;                     // not the last one: keys after it move up
        p.velocity[3*1 + 1] = 2;
        solids.coupling.force = force;
        FluidInput f = lattice(
            c, {{0.2, 0.2, D() == 3 ? 0.2 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.4 : 0.0}});
        const auto first = createSphDemScene(c, f, {}, solids);
        first->advance(0.05);
        const DemState there = first->solids()->motion();
        ASSERT_EQ(there.id.size(), p.size() - 1);
        EXPECT_EQ(std::count(there.id.begin(), there.id.end(), 8), 0);
        double largest = 0;
        for (const double v : first->coupling().force) largest = std::max(largest, std::abs(v));
        EXPECT_GT(largest, 0) << "they should have met the water";

        SolidInput stayed = solids;
        DemParticles& q = stayed.input.particles;
        q = DemParticles();
        stayed.volume.clear();
        for (std::size_t i = 0; i < p.size(); ++i)
        {
            if (p.id[i] == 8) continue;
            const std::size_t at = std::find(there.id.begin(), there.id.end(), p.id[i])
                - there.id.begin();
            for (int d = 0; d < 3; ++d)
            {
                q.position.push_back(there.position[3*at + d]);
                q.velocity.push_back(there.velocity[3*at + d]);
            }
            q.radius.push_back(p.radius[i]);
            q.mass.push_back(p.mass[i]);
            q.id.push_back(p.id[i]);
            stayed.volume.push_back(solids.volume[i]);
        }
        const auto saved = first->saveState();
        const auto second = createSphDemScene(c, f, {}, stayed);
        second->loadState(saved);
        first->advance(0.08);
        second->advance(0.08);
        EXPECT_EQ(first->saveState(), second->saveState());

        // of others than the state is of
        stayed.input.particles.id.back() = 99;
        EXPECT_THROW(createSphDemScene(c, f, {}, stayed)->loadState(saved), std::invalid_argument);
    }
}

//- Soft solids, whose contacts ask for a step a step of the fluid, and fast ones: as many steps as
//  their way takes. Alone or in a rigid body
TEST_P(CouplingScope, StepsFollowTheSpeedOfSolids)
{
    for (const bool body : {false, true})
    {
        SphConfig c = config();
        c.wallSpacing = c.spacing;
        c.domainMax[0] = 2;
        SolidInput solids = block(c, 2, 0.02, {{1.2, 0.5, D() == 3 ? 0.3 : 0.0}});
        DemInput& in = solids.input;
        in.bonds = DemBonds();
        in.bondTypes.clear();
        in.pairs[0].properties.normalStiffness = 1;
        if (body) solids = rigid(solids);
        // 4.7 mm a step of the fluid; half the skin is 1.5 mm and less
        const double speed = 5;
        in.particles.velocity.assign(in.particles.position.size(), 0.0);
        for (std::size_t i = 0; i < in.particles.size(); ++i) in.particles.velocity[3*i] = speed;
        for (DemClump& k : solids.input.clumps) k.velocity[0] = speed;
        FluidInput f = lattice(
            c, {{0.2, 0.2, D() == 3 ? 0.2 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.4 : 0.0}});
        const auto s = createSphDemScene(c, f, {}, solids);
        const double step = s->solids()->plan().timeStep, x = s->solids()->particles().position[0];
        const SphReport r = s->advance(0.02);
        ASSERT_EQ(r.stop, StopReason::none) << s->solids()->lastReport().stopMessage;
        ASSERT_GT(step, r.maxTimeStep) << "contacts alone want one step";
        const double skin = (GetParam().device == DeviceKind::gpu ? 0.1 : 0.15)*0.02;
        EXPECT_GE(s->coupling().subcycles, r.lastTimeStep*speed/(0.5*skin));
        EXPECT_LE(s->coupling().subcycles, 1.25*1.2*r.lastTimeStep*speed/(0.5*skin) + 1);
        const DemState q = s->solids()->particles();
        EXPECT_NEAR(q.position[0] - x, 0.02*speed, 1e-6);
    }
}

//- Two rigid bodies in water run into each other, touch and part; what both and the water have of
//  momentum stays
TEST_P(CouplingScope, BodiesCollideInWater)
{
    SphConfig c = waterBox();
    c.integrator = "symplectic";
    const double size = 0.6*c.spacing, side = 3*size, apart = 0.5*size, z = D() == 3 ? 0.3 : 0.0;
    SolidInput both = rigid(block(c, 3, size, {{0.3, 0.4, z}}));
    const SolidInput right = rigid(block(c, 3, size, {{0.3 + side + apart, 0.4, z}}));
    DemParticles& p = both.input.particles;
    const auto append = [](auto& to, const auto& from)
    { to.insert(to.end(), from.begin(), from.end()); };
    append(p.position, right.input.particles.position);
    append(p.radius, right.input.particles.radius);
    append(p.mass, right.input.particles.mass);
    append(both.volume, right.volume);
    p.clump.resize(p.radius.size(), 1);
    both.input.clumps.push_back(right.input.clumps[0]);
    both.input.clumps[0].velocity[0] = 1;
    both.input.clumps[1].velocity[0] = -1;
    both.input.pairs[0].properties.normalStiffness = 1e6;
    both.coupling.kind = "extrapolated";
    both.coupling.force = "impulse";
    const auto s = createSphDemScene(
        c, waterAround(c, {{0.3, 0.4, 0.3}}, 2*side + apart), {}, both);
    const Momentum before = momentum(*s, c);
    bool touched = false, parted = false;
    for (int k = 0; k < 40; ++k)
    {
        ASSERT_EQ(s->advance(1, 2).stop, StopReason::none);
        const bool touch = s->solids()->contacts().a.size() > 0;
        const DemClumpState body = s->solids()->clumps();
        touched = touched || touch;
        parted = parted || (touched && !touch && body.velocity[3] > body.velocity[0]);
        EXPECT_GT(body.position[3] - body.position[0], 0.95*side)
            << "they must not go into each other";
    }
    EXPECT_TRUE(touched);
    EXPECT_TRUE(parted);
    const Momentum after = momentum(*s, c);
    for (int d = 0; d < D(); ++d)
        EXPECT_NEAR(after.sum[d], before.sum[d], 160*epsilon()*after.size) << "axis " << d;
}

//- What the solids do not use is not computed: without bonds no kernel of bonds, without clumps
//  none of clumps; without solids no kernel of theirs
TEST_P(CouplingScope, CostsOnlyWhatIsThere)
{
    const SphConfig c = waterBox();
    const double size = 0.6*c.spacing;
    const SolidInput bonded = block(c, 3, size, {{0.3, 0.3, D() == 3 ? 0.3 : 0.0}});
    SolidInput loose(bonded);
    loose.input.bonds = DemBonds();
    loose.input.bondTypes.clear();
    const FluidInput water = waterAround(c, {{0.3, 0.3, 0.3}}, 3*size);
    const auto launched = [&](const std::vector<KernelInfo>& kernels, const std::string& part)
    {
        std::int64_t n = 0;
        for (const KernelInfo& k : kernels)
        {
            std::string name = k.name;
            std::transform(name.begin(), name.end(), name.begin(),
                [](unsigned char x) { return char(std::tolower(x)); });
            if (name.find(part) != std::string::npos) n += k.launches;
        }
        return n;
    };
    const auto of = [&](const SolidInput& in)
    {
        auto s = createSphDemScene(c, water, {}, in);
        s->advance(1, 5);
        return s->solids()->kernels();
    };
    EXPECT_GT(launched(of(bonded), "bond"), 0);
    EXPECT_EQ(launched(of(bonded), "clump"), 0);
    EXPECT_EQ(launched(of(loose), "bond"), 0);
    EXPECT_EQ(launched(of(loose), "clump"), 0);
    EXPECT_GT(launched(of(rigid(bonded)), "clump"), 0);
    EXPECT_EQ(launched(of(rigid(bonded)), "bond"), 0);
    const auto alone = createSphScene(c, water, {});
    alone->advance(1, 5);
    EXPECT_EQ(launched(alone->kernels(), "solid"), 0);
    EXPECT_EQ(alone->solids(), nullptr);
}

TEST_P(CouplingScope, RefusesWhatDoesNotFit)
{
    const SphConfig c = waterBox();
    SolidInput solids = block(c, 2, 0.03, {{0.3, 0.3, 0.3}});
    const FluidInput water = waterAround(c, {{0.3, 0.3, 0.3}}, 0.06);
    solids.volume.pop_back();
    EXPECT_THROW(createSphDemScene(c, water, {}, solids), std::invalid_argument);
    solids.volume.push_back(0);
    EXPECT_THROW(createSphDemScene(c, water, {}, solids), std::invalid_argument);
    solids.volume.back() = 1e-3;
    solids.coupling.xsph = true;
    EXPECT_THROW(createSphDemScene(c, water, {}, solids), std::invalid_argument);
}

//- Overlap at the start is found, touching is none
TEST_P(CouplingScope, FindsSolidsInFluid)
{
    SphConfig c = config();
    FluidInput f = lattice(c, {{0, 0, D() == 3 ? 0.2 : 0.0}}, {{0.5, 0.5, D() == 3 ? 0.4 : 0.0}});
    DemParticles p;
    p.radius = {0.02};
    p.position = {0.52, 0.3, f.position[2]};
    EXPECT_EQ(solidsInFluid(c, f, p, 1e-3).count, 0u);
    p.position[0] = 0.47;
    EXPECT_GT(solidsInFluid(c, f, p, 1e-3).count, 0u);
}

} // namespace
} // namespace riprap
