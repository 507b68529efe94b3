/*  Another maxVelocity and speed of sound between two steps: pressures stay, energy is accounted
    for, steps follow, restarts are exact. And who is faster than some speeds.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "tankScene.hpp"

namespace riprap
{
namespace
{

class Stiffness : public TankScene
{
protected:

    //- A tank under way, with particles in tension too
    SphConfig moving(FluidInput& f) const
    {
        SphConfig c = tank();
        f = column(c);
        disturb(c, f, 0.05, 0.3, 0.02);
        return c;
    }

    static double total(const SphEnergy& e) { return e.kinetic + e.potential + e.elastic; }
    double single() const { return mixed() ? 2e-6 : 1e-13; }
};

RIPRAP_ALL_SETUPS(Stiffness);

TEST_P(Stiffness, PressureIsKept)
{
    for (const std::string eos : {"Tait", "linear"})
        for (const double ratio : {1.25, 3.0, 0.8})
        {
            FluidInput f;
            SphConfig c = moving(f);
            c.eos = eos;
            const auto s = scene(c, f, walls(c));
            s->advance(0.02);
            const FluidState a = s->fluid();
            const double c1 = ratio*c.soundSpeed, scale = largest(a.pressure);
            s->setMaxVelocity(ratio*c.maxVelocity, c1);
            const FluidState b = s->fluid();
            EXPECT_EQ(a.id, b.id);
            EXPECT_EQ(a.position, b.position);
            EXPECT_EQ(a.velocity, b.velocity);
            double lowest = 0;
            for (std::size_t i = 0; i < a.id.size(); ++i)
            {
                lowest = std::min(lowest, a.pressure[i]);
                ASSERT_NEAR(b.pressure[i], a.pressure[i], single()*scale);
                const double p = a.pressure[i], B = c1*c1*c.density;
                const double expected = eos == "linear"
                    ? p/B
                    : std::pow(1 + 7*p/B, 1.0/7) - 1;
                ASSERT_NEAR(b.density[i]/c.density - 1, expected, single()*scale/B);
            }
            EXPECT_LT(lowest, -0.01*scale) << "some are in tension";
        }
}

//- The jump of the elastic energy is what is accounted for; nearly -sum V p^2/2 (1/(rho c^2) -
//  1/(rho c'^2))
TEST_P(Stiffness, EnergyIsAccountedFor)
{
    FluidInput f;
    const SphConfig c = moving(f);
    const auto s = scene(c, f, walls(c));
    s->advance(0.02);
    const SphEnergy before = s->energy();
    EXPECT_EQ(before.stiffening, 0);
    const FluidState a = s->fluid();
    const double stiff = c.density*c.soundSpeed*c.soundSpeed, volume = std::pow(c.spacing, D());
    double expected = 0;
    for (const double p : a.pressure) expected -= 0.5*volume*p*p/stiff*(1 - 1.0/4);
    s->setMaxVelocity(2*c.maxVelocity, 2*c.soundSpeed);
    const SphEnergy after = s->energy();
    EXPECT_EQ(after.kinetic, before.kinetic);
    EXPECT_EQ(after.potential, before.potential);
    EXPECT_NEAR(after.elastic - before.elastic, after.stiffening, 1e-12*total(before));
    EXPECT_LT(after.stiffening, 0);
    // deviations of some per cent
    EXPECT_NEAR(after.stiffening, expected, 0.15*std::abs(expected));
    // and the sum of two raises
    s->advance(0.03);
    const SphEnergy third = s->energy();
    EXPECT_EQ(third.stiffening, after.stiffening);
    s->setMaxVelocity(3*c.maxVelocity, 3*c.soundSpeed);
    const SphEnergy last = s->energy();
    EXPECT_NEAR(
        last.elastic - third.elastic, last.stiffening - third.stiffening, 1e-12*total(before));
}

//- Energy in all, with what was accounted for, only falls through a raise
TEST_P(Stiffness, NothingIsGained)
{
    SphConfig c = tank();
    c.diffusion = "fourtakas";
    c.integrator = "symplectic";
    const auto s = scene(c, column(c), walls(c));
    double least = 1e300;
    for (int k = 1; k <= 20; ++k)
    {
        s->advance(0.01*k);
        if (k == 8) s->setMaxVelocity(2*c.maxVelocity, 2*c.soundSpeed);
        const SphEnergy e = s->energy();
        const double now = total(e) - e.stiffening;
        EXPECT_LT(now, least + 1e-3*e.kinetic) << "at " << s->time();
        least = std::min(least, now);
    }
}

TEST_P(Stiffness, StepsAndGuardsFollow)
{
    SphConfig c = config();         // vmax 2, c0 20 m/s
    FluidInput f = lattice(
        c, {{0.4, 0.4, D() == 3 ? 0.4 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.6 : 0.0}});
    for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] = 9;
    const auto s = scene(c, f);
    std::string limit;
    const double h = 1.25*c.spacing;
    EXPECT_NEAR(s->estimateTimeStep(limit), 0.3*h/29, 1e-6*h/29);
    s->setMaxVelocity(4, 40);
    EXPECT_NEAR(s->estimateTimeStep(limit), 0.3*h/49, 1e-6*h/49);
    const SphReport r = s->advance(1, 1);
    EXPECT_EQ(r.stop, StopReason::none);
    EXPECT_NEAR(r.lastTimeStep, 0.3*h/49, 1e-6*h/49);
    // the guard of speed, five times maxVelocity
    s->setMaxVelocity(1.5, 40);
    EXPECT_EQ(s->advance(1, 1).stop, StopReason::speed);
    EXPECT_THROW(s->setMaxVelocity(0, 40), std::invalid_argument);
    EXPECT_THROW(s->setMaxVelocity(1, -1), std::invalid_argument);
}

//- As a scene that had the new speed of sound from the start and was given these pressures
TEST_P(Stiffness, GoesOnAsOneThatBeganSo)
{
    FluidInput f;
    SphConfig c = moving(f);
    const auto s = scene(c, f, walls(c));
    s->setMaxVelocity(2*c.maxVelocity, 2*c.soundSpeed);
    const FluidState now = s->fluid();
    c.maxVelocity *= 2;
    c.soundSpeed *= 2;
    f.id = now.id;
    f.position = now.position;
    f.velocity = now.velocity;
    f.density = now.density;
    const auto other = scene(c, f, walls(c));
    // first forces were those of before, which were of the same pressures: artificial viscosity
    // alone differs
    s->advance(0.02);
    other->advance(0.02);
    const FluidState a = s->fluid(), b = other->fluid();
    const auto ia = byId(a), ib = byId(b);
    for (std::size_t k = 0; k < ia.size(); ++k)
        for (int d = 0; d < D(); ++d)
            ASSERT_NEAR(a.position[3*ia[k] + d], b.position[3*ib[k] + d], 0.05*c.spacing);
}

TEST_P(Stiffness, RestartIsExact)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
    {
        FluidInput f;
        SphConfig c = moving(f);
        c.integrator = integrator;
        c.diffusion = "fourtakas";
        const WallInput w = walls(c);
        const auto first = scene(c, f, w);
        first->advance(0.02);
        first->setMaxVelocity(2*c.maxVelocity, 2*c.soundSpeed);
        for (const double saveAt : {0.02, 0.03})        // at the raise, and after some steps
        {
            if (saveAt > 0.02) first->advance(saveAt);
            const std::vector<std::int32_t> saved = first->saveState();
            SphConfig raised = c;
            raised.maxVelocity *= 2;
            raised.soundSpeed *= 2;
            const auto second = scene(raised, f, w);
            second->loadState(saved);
            EXPECT_EQ(second->energy().stiffening, first->energy().stiffening);
            const auto reference = scene(c, f, w);
            reference->advance(0.02);
            reference->setMaxVelocity(2*c.maxVelocity, 2*c.soundSpeed);
            if (saveAt > 0.02) reference->advance(saveAt);
            EXPECT_EQ(reference->saveState(), saved);
            reference->advance(0.05);
            second->advance(0.05);
            expectSameBits(reference->fluid(), second->fluid());
            EXPECT_EQ(reference->saveState(), second->saveState());
        }
    }
}

TEST_P(Stiffness, FasterThan)
{
    SphConfig c = config();
    FluidInput f = lattice(
        c, {{0.4, 0.4, D() == 3 ? 0.4 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.6 : 0.0}});
    for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i + i % D()] = 0.01*double(i);
    const auto counts = scene(c, f)->fasterThan({0, 0.005, 0.015, 0.055, 0.1, 0.105, 0.5, 10});
    const auto n = f.size();
    const auto expected = [&](std::size_t first) { return n > first ? n - first : 0; };
    EXPECT_EQ(counts[0], n - 1);
    EXPECT_EQ(counts[1], n - 1);
    EXPECT_EQ(counts[2], n - 2);
    EXPECT_EQ(counts[3], expected(6));
    EXPECT_EQ(counts[5], expected(11));
    EXPECT_EQ(counts[7], 0u);
}

} // namespace
} // namespace riprap
