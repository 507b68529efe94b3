/*  Steps of the fluid that follow one another on the device with those of its solids in them: to the bit what they are where the host looks on.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "couplingTest.hpp"

namespace riprap
{
namespace
{

class Turns : public CouplingTest
{
protected:

    struct Case { std::string name; SolidInput solids; FluidForceKind force; CouplingKind kind; };

    //- The host samples motions for each step: with one that no particle has it looks on
    static SolidInput watched(SolidInput s)
    {
        DemGroup moved;
        moved.name = "nobody";
        moved.motion = 0;
        if (s.input.groups.empty()) s.input.groups.emplace_back();
        s.input.groups.push_back(moved);
        s.input.groupMotion = [](int, double) { return RigidMotion(); };
        return s;
    }

    SphConfig water() const
    {
        SphConfig c = waterBox();
        c.integrator = IntegratorKind::symplectic;
        c.gravity = {{0, -1, 0}};
        return c;
    }

    double low() const { return 0.3; }
    double size(const SphConfig& c) const { return 0.6*c.spacing; }

    std::vector<Case> cases(const SphConfig& c) const
    {
        const SolidInput bonded = block(c, 4, size(c), {{low(), low(), D() == 3 ? low() : 0.0}});
        SolidInput fast(bonded), weak(bonded), heldByHalf(bonded), leapfrog(rigid(bonded));
        // loose and fast: lists are spent within a step of the fluid
        fast.input.bonds = DemBonds();
        fast.input.bondTypes.clear();
        fast.input.particles.velocity.assign(fast.input.particles.position.size(), 0.0);
        for (std::size_t i = 0; i < fast.input.particles.size(); ++i) fast.input.particles.velocity[3*i] = i % 2 ? 3 : -3;
        // bonds that break
        weak.input.bondTypes[0].tensileStrength = weak.input.bondTypes[0].shearStrength = 20;
        DemGroup held;
        held.held[0] = held.held[1] = held.held[2] = held.heldSpin = true;
        heldByHalf.input.groups = {DemGroup(), held};
        for (std::size_t i = 0; i < heldByHalf.input.particles.size(); ++i) heldByHalf.input.particles.group.push_back(int(i % 2));
        leapfrog.config.integrator = DemIntegratorKind::leapfrog;
        // the third dimension adds nothing to how steps follow one another
        if (D() == 3)
            return
            {
                {"bonds that break", weak, FluidForceKind::impulse, CouplingKind::extrapolated},
                {"rigid, blows", rigid(bonded), FluidForceKind::impulse, CouplingKind::stationary}
            };
        return
        {
            {"bonded", bonded, FluidForceKind::held, CouplingKind::extrapolated},
            {"bonded, blows", bonded, FluidForceKind::impulse, CouplingKind::pressureGradient},
            {"half of it held", heldByHalf, FluidForceKind::held, CouplingKind::pressureApproximation},
            {"bonds that break", weak, FluidForceKind::impulse, CouplingKind::extrapolated},
            {"fast", fast, FluidForceKind::held, CouplingKind::extrapolated},
            {"fast, blows", fast, FluidForceKind::impulse, CouplingKind::extrapolated},
            {"rigid", rigid(bonded), FluidForceKind::held, CouplingKind::extrapolated},
            {"rigid, blows", rigid(bonded), FluidForceKind::impulse, CouplingKind::stationary},
            {"rigid, leapfrog", leapfrog, FluidForceKind::held, CouplingKind::extrapolated}
        };
    }

    std::unique_ptr<SphScene> scene(const SphConfig& c, const Case& now, bool watch) const
    {
        SolidInput solids = watch ? watched(now.solids) : now.solids;
        solids.coupling.force = now.force;
        solids.coupling.kind = now.kind;
        return createSphDemScene(c, waterAround(c, {{low(), low(), low()}}, 4*size(c)), {}, solids);
    }

    static void expectSame(SphScene& a, SphScene& b)
    {
        expectSameBits(a.fluid(), b.fluid());
        const DemState p = a.solids()->particles(), q = b.solids()->particles();
        EXPECT_EQ(p.id, q.id);
        EXPECT_EQ(p.position, q.position);
        EXPECT_EQ(p.velocity, q.velocity);
        EXPECT_EQ(p.spin, q.spin);
        EXPECT_EQ(a.coupling().force, b.coupling().force);
        EXPECT_EQ(a.coupling().subcycles, b.coupling().subcycles);
        EXPECT_EQ(a.solids()->time(), b.solids()->time());
        EXPECT_EQ(a.solids()->bonds().broken, b.solids()->bonds().broken);
    }
};

RIPRAP_ALL_SETUPS(Turns);

TEST_P(Turns, HaveTheBitsOfAHostThatLooksOn)
{
    const SphConfig c = water();
    std::size_t broken = 0;
    for (const Case& now : cases(c))
    {
        SCOPED_TRACE(now.name);
        const auto a = scene(c, now, false), b = scene(c, now, true);
        for (const double t : {0.004, 0.005, 0.012})
        {
            const SphReport p = a->advance(t), q = b->advance(t);
            ASSERT_EQ(p.stop, StopReason::none) << a->solids()->lastReport().stopMessage;
            EXPECT_EQ(p.steps, q.steps);
            EXPECT_EQ(p.rebuilds, q.rebuilds);
            EXPECT_EQ(p.minTimeStep, q.minTimeStep);
            EXPECT_EQ(p.lastTimeStep, q.lastTimeStep);
            EXPECT_EQ(a->solids()->lastReport().steps, b->solids()->lastReport().steps);
            expectSame(*a, *b);
            if (HasFailure()) return;
        }
        broken += a->solids()->lastReport().brokenBonds;
        EXPECT_EQ(a->solids()->time(), a->time());
    }
    EXPECT_GT(broken, 0u) << "or nothing of bonds that break was seen";
}

//- Recorded launches and steps within one block, and one launch after the other as they are timed
TEST_P(Turns, HaveTheBitsOfSingleLaunches)
{
    const SphConfig c = water();
    for (const Case& now : cases(c))
    {
        SCOPED_TRACE(now.name);
        const auto a = scene(c, now, false), b = scene(c, now, false);
        b->timeKernels(true);
        b->solids()->timeKernels(true);
        for (const double t : {0.004, 0.008})
        {
            a->advance(t);
            b->advance(t);
            expectSame(*a, *b);
            if (HasFailure()) return;
        }
    }
}

TEST_P(Turns, ContinueToTheBit)
{
    const SphConfig c = water();
    for (const Case& now : cases(c))
    {
        if (now.name == "bonds that break") continue;       // a state is of the bonds there are
        SCOPED_TRACE(now.name);
        const auto a = scene(c, now, false), b = scene(c, now, false);
        a->advance(0.01);
        b->loadState(a->saveState());
        a->advance(0.02);
        b->advance(0.02);
        expectSame(*a, *b);
        EXPECT_EQ(a->saveState(), b->saveState());
        if (HasFailure()) return;
    }
}

//- A guard of the solids stops both where they are
TEST_P(Turns, GuardsOfSolidsStopTheFluid)
{
    const SphConfig c = water();
    const Vector3 corner{{low(), low(), D() == 3 ? low() : 0.0}};
    Case now{"", block(c, 4, size(c), corner), FluidForceKind::held, CouplingKind::extrapolated};
    // loose and as light as air, a step of theirs in one of the water: the first force carries them beyond their lists
    now.solids.input.bonds = DemBonds();
    now.solids.input.bondTypes.clear();
    for (double& m : now.solids.input.particles.mass) m *= 1e-4;
    now.solids.config.timeStep = 0.01;
    now.solids.config.allowLargeStep = true;
    const auto a = scene(c, now, false), b = scene(c, now, true);
    const SphReport p = a->advance(0.02, 50), q = b->advance(0.02, 50);
    EXPECT_EQ(p.stop, q.stop);
    EXPECT_EQ(p.steps, q.steps);
    EXPECT_EQ(p.time, q.time);
    EXPECT_EQ(p.stop, StopReason::solids);
    EXPECT_EQ(a->solids()->lastReport().stopMessage, b->solids()->lastReport().stopMessage);
}

} // namespace
} // namespace riprap
