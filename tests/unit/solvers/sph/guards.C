/*  What stops a run, and what leaves the domain: with the particle, where and how much; nothing is
    lost silently.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <set>
#include "sceneTest.hpp"

namespace riprap
{
namespace
{

class Guards : public SceneTest
{
protected:

    //- A blob in the middle of an open box; ids that are not indices
    FluidInput blob(const SphConfig& c) const
    {
        FluidInput f = lattice(
            c, {{0.4, 0.4, D() == 3 ? 0.4 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.6 : 0.0}});
        for (std::size_t i = 0; i < f.size(); ++i) f.id.push_back(1000 - 3*int(i));
        return f;
    }

    //- One particle alone, beyond reach of the blob: index, as appended
    std::size_t addLoner(FluidInput& f, const Vector3& x, const Vector3& v, std::int32_t id) const
    {
        f.position.insert(f.position.end(), x.begin(), x.end());
        if (D() == 2) f.position.back() = 0;
        f.velocity.insert(f.velocity.end(), v.begin(), v.end());
        f.density.push_back(1000);
        f.id.push_back(id);
        return f.size() - 1;
    }
};

RIPRAP_ALL_SETUPS(Guards);

TEST_P(Guards, DensityStopsWithTheParticle)
{
    SphConfig c = config();
    FluidInput f = blob(c);
    const std::size_t i = addLoner(f, {{0.1, 0.9, 0.2}}, {{0, 0, 0}}, 77);
    for (const double deviation : {0.25, -0.25})
    {
        f.density[i] = c.density*(1 + deviation);
        const auto s = scene(c, f);
        const SphReport r = s->advance(0.1);
        EXPECT_EQ(r.stop, StopReason::density);
        EXPECT_EQ(r.stopId, 77);
        EXPECT_NEAR(r.stopValue, 0.25, 1e-6);
        EXPECT_NEAR(r.stopPosition[0], 0.1, 1e-7);
        EXPECT_NEAR(r.stopPosition[1], 0.9, 1e-7);
        EXPECT_EQ(r.steps, 0) << "before the step, not after";
        EXPECT_EQ(s->advance(0.1).stop, StopReason::density) << "it stays stopped";
    }
    f.density[i] = c.density*1.19;
    EXPECT_EQ(scene(c, f)->advance(1e-5).stop, StopReason::none);
}

TEST_P(Guards, SpeedStopsWithTheParticle)
{
    SphConfig c = config();     // vmax 2 m/s, limit five times that
    FluidInput f = blob(c);
    const std::size_t i = addLoner(f, {{0.1, 0.9, 0.2}}, {{0, 0, 0}}, 77);
    for (const double speed : {10.2, 100.0})
    {
        f.velocity[3*i + 1] = -speed;
        const SphReport r = scene(c, f)->advance(1e-4);
        EXPECT_EQ(r.stop, StopReason::speed) << speed << " m/s";
        EXPECT_EQ(r.stopId, 77);
        EXPECT_NEAR(r.stopValue, speed, 1e-5*speed);
        EXPECT_NEAR(r.stopPosition[0], 0.1, 1e-6);
    }
    f.velocity[3*i + 1] = -9.8;
    const SphReport r = scene(c, f)->advance(1e-5);
    EXPECT_EQ(r.stop, StopReason::none);
    EXPECT_NEAR(r.maxSpeed, 9.8, 1e-4);
}

TEST_P(Guards, MaximaAreThoseOfTheParticles)
{
    // compressed, so that the speed of sound is not c0
    SphConfig c = config();
    FluidInput f = blob(c);
    const std::size_t i = addLoner(f, {{0.1, 0.9, 0.2}}, {{0.3, 0.4, 0}}, 77);
    f.density[i] = 1.1*c.density;
    const SphReport r = scene(c, f)->advance(1e-6);
    EXPECT_NEAR(r.maxSpeed, 0.5, 1e-5);
    EXPECT_NEAR(r.maxDensityDeviation, 0.1, 1e-5);
}

TEST_P(Guards, NotANumberStops)
{
    // none may come in (see checks.C), but a speed whose square is beyond the precision is as bad
    SphConfig c = config();
    FluidInput f = blob(c);
    const std::size_t i = addLoner(f, {{0.1, 0.9, 0.2}}, {{0, 0, 0}}, 77);
    f.velocity[3*i] = mixed() ? 1e25 : 1e200;
    const SphReport r = scene(c, f)->advance(0.1);
    EXPECT_EQ(r.stop, StopReason::notANumber);
    EXPECT_EQ(r.stopId, 77);
    EXPECT_EQ(r.steps, 0);
    EXPECT_NEAR(r.stopPosition[0], 0.1, 1e-6);
}

TEST_P(Guards, NotANumberIsOfTheParticleThatBegan)
{
    // beyond the support of the blob, but next to it in memory: a pack of neighbours reads it in
    // lanes that are not in use, where zero times infinity is no number
    SphConfig c = config();
    for (const double x : {0.2, 0.75, 0.8})
    {
        FluidInput f = blob(c);
        const std::size_t i = addLoner(f, {{x, 0.475, 0.475}}, {{0, 0, 0}}, 77);
        f.velocity[3*i] = mixed() ? 3e38 : 1.7e308;
        const SphReport r = scene(c, f)->advance(0.1);
        EXPECT_EQ(r.stop, StopReason::notANumber);
        EXPECT_EQ(r.stopId, 77);
        EXPECT_NEAR(r.stopPosition[0], x, 1e-6);
    }
}

TEST_P(Guards, EscapedAreReportedOnce)
{
    SphConfig c = config();
    c.maxVelocity = 10;
    c.soundSpeed = 100;
    FluidInput f = blob(c);
    const std::size_t n = f.size();
    // they leave at 0.02, 0.04 and 0.06 s on three sides
    addLoner(f, {{0.9, 0.5, 0.5}}, {{5, 0, 0}}, 77);
    addLoner(f, {{0.5, 0.2, 0.5}}, {{0, -5, 0}}, 88);
    addLoner(f, {{0.3, 0.9, 0.5}}, {{-5, 0, 0}}, 99);
    const auto s = scene(c, f);
    std::multiset<int> gone;
    std::size_t inside = f.size();
    for (int k = 1; k <= 10; ++k)
    {
        const SphReport r = s->advance(0.01*k);
        ASSERT_EQ(r.escaped.size(), r.escapedId.size());
        for (std::size_t e = 0; e < r.escaped.size(); ++e)
        {
            gone.insert(r.escapedId[e]);
            const Vector3& x = r.escaped[e];
            double beyond = 0;
            for (int d = 0; d < D(); ++d) beyond = std::max({beyond, x[d] - 1, -x[d]});
            EXPECT_GT(beyond, 0) << "outside";
            EXPECT_LT(beyond, 0.01) << "and just so: a step carries it 2 mm";
        }
        inside -= r.escaped.size();
        EXPECT_EQ(r.fluid, inside);
        const FluidState state = s->fluid();
        EXPECT_EQ(state.id.size(), inside);
        EXPECT_EQ(state.position.size(), 3*inside);
        EXPECT_EQ(state.density.size(), inside);
        if (k == 3)
        {
            // the last of them is saved and escapes in the restarted run too
            const auto restarted = scene(c, f);
            restarted->loadState(s->saveState());
            std::vector<std::int32_t> later = restarted->advance(0.1).escapedId;
            std::sort(later.begin(), later.end());
            EXPECT_EQ(later, (std::vector<std::int32_t>{88, 99}));
        }
    }
    EXPECT_EQ(gone, (std::multiset<int>{77, 88, 99}));
    EXPECT_EQ(inside, n);
}

TEST_P(Guards, MissedPairsAreSaid)
{
    // a fixed step that is far too long: from rest past the skin, where a step's travel was
    // foreseen as none
    SphConfig c = config();
    c.adjustTimeStep = false;
    c.fixedTimeStep = 0.01;
    c.maxSpeedRatio = 100;
    const FluidInput f = blob(c);
    for (const double g : {1.0, 1000.0})        // 0.05 and 50 mm; half the skin is 6 to 22 mm
    {
        c.gravity = {{0, -g, 0}};
        const auto s = scene(c, f);
        EXPECT_EQ(s->advance(1, 1).skinExceeded, g > 1);
    }
}

TEST_P(Guards, AllMayEscape)
{
    SphConfig c = config();
    c.maxVelocity = 10;
    c.soundSpeed = 100;
    FluidInput f = blob(c);
    for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] = 8;
    const auto s = scene(c, f);
    std::set<int> gone;
    for (int k = 1; k <= 5; ++k)
        for (const int id : s->advance(0.02*k).escapedId) EXPECT_TRUE(gone.insert(id).second);
    EXPECT_EQ(gone.size(), f.size());
    EXPECT_EQ(s->time(), 0.1) << "an empty scene goes on";
    EXPECT_TRUE(s->fluid().id.empty());
    EXPECT_EQ(s->energy().kinetic, 0);
    EXPECT_EQ(s->sample({0.5, 0.5, 0.5}).volumeFraction[0], 0);
    EXPECT_EQ(s->neighboursPerParticle(), 0);
    const auto saved = s->saveState();
    const auto restarted = scene(c, f);
    restarted->loadState(saved);
    EXPECT_TRUE(restarted->fluid().id.empty());
    EXPECT_EQ(restarted->advance(0.2).time, 0.2);
}

TEST_P(Guards, EscapeInset)
{
    // the edge of the domain is behind the walls; fluid is out where the inset says
    SphConfig c = config();
    c.escapeInset = 0.2;
    FluidInput f = blob(c);
    addLoner(f, {{0.75, 0.5, 0.5}}, {{2, 0, 0}}, 77);
    const auto s = scene(c, f);
    EXPECT_TRUE(s->advance(0.02).escaped.empty());      // at 0.79
    // at 0.80001, by the last step of the call: in its report, not in that of the next
    EXPECT_EQ(s->advance(0.025005).escaped.size(), 1u);
    EXPECT_TRUE(s->advance(0.03).escaped.empty());
}

} // namespace
} // namespace riprap
