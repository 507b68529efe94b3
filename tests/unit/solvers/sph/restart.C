/*  Saved states: a scene that is given one continues bit for bit, and refuses what is damaged or of
    another scene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <future>
#include "tankScene.hpp"

namespace riprap
{
namespace
{

class Restart : public TankScene
{
protected:

    //- Run, save, run on; and the same from the saved state in a new scene
    void continueFrom(const SphConfig& c, bool piston)
    {
        WallInput w = walls(c);
        if (piston) makePiston(w);
        const WallMotion motion = piston ? pistonMotion() : WallMotion();
        const FluidInput f = column(c);
        const auto first = scene(c, f, w, motion);
        first->advance(0.05);
        first->advance(0.06);
        const std::vector<std::int32_t> saved = first->saveState();

        SphConfig later = c;
        later.startTime = 0.06;
        // with the case's start time, and with that of the restart
        for (const SphConfig& start : {c, later})
        {
            const auto second = scene(start, f, w, motion);
            second->loadState(saved);
            EXPECT_EQ(second->time(), 0.06);
            expectSameWalls(*first, *second);
            // first, saved at the same time, runs on in `reference`
            const auto reference = scene(c, f, w, motion);
            reference->advance(0.05);
            reference->advance(0.06);
            EXPECT_EQ(reference->saveState(), saved);
            const auto words = reference->savedState(true);
            const Later<FluidState> fluid = reference->fluidLater();
            auto wordsThen = std::async(std::launch::async, words.take);
            auto fluidThen = std::async(std::launch::async, fluid.take);
            const FluidState fluidNow = reference->fluid();
            for (const double t : {0.07, 0.1})
            {
                const SphReport a = reference->advance(t), b = second->advance(t);
                EXPECT_EQ(a.totalSteps, b.totalSteps);
                EXPECT_EQ(a.lastTimeStep, b.lastTimeStep);
                expectSameBits(reference->fluid(), second->fluid());
                expectSameWalls(*reference, *second);
            }
            // what is taken while the scene moves on is what it was
            EXPECT_EQ(words.size, saved.size());
            EXPECT_EQ(wordsThen.get(), saved);
            EXPECT_EQ(fluid.size, fluidNow.id.size());
            expectSameBits(fluidThen.get(), fluidNow);
            EXPECT_EQ(reference->energy().wallWork, second->energy().wallWork);
            EXPECT_EQ(reference->energy().wallPressureWork, second->energy().wallPressureWork);
            EXPECT_EQ(reference->saveState(), second->saveState());
        }
    }

    void expectSameWalls(SphScene& a, SphScene& b) const
    {
        // sorts both: sums in the same order
        EXPECT_EQ(a.wallForces(), b.wallForces());
        const WallState first = a.walls(), second = b.walls();
        EXPECT_EQ(first.position, second.position);
        EXPECT_EQ(first.velocity, second.velocity);
        EXPECT_EQ(first.pressure, second.pressure);
    }

    void expectRefused(SphScene& s, const std::vector<std::int32_t>& words, const std::string& why)
    {
        try
        {
            s.loadState(words);
            ADD_FAILURE() << "accepted, but: " << why;
        }
        catch (const std::invalid_argument& e)
        {
            EXPECT_NE(std::string(e.what()).find(why), std::string::npos) << e.what();
        }
    }

    //- The words with the checksum that fits them (FNV-1a, as in checkpointWords.hpp)
    static std::vector<std::int32_t> signedWords(std::vector<std::int32_t> words)
    {
        std::uint32_t h = 2166136261u;
        for (std::size_t i = 0; i + 1 < words.size(); ++i)
            h = (h ^ std::uint32_t(words[i]))*16777619u;
        words.back() = std::int32_t(h);
        return words;
    }
};

RIPRAP_ALL_SETUPS(Restart);

TEST_P(Restart, Leapfrog) { continueFrom(tank(), false); }

TEST_P(Restart, Symplectic)
{
    SphConfig c = tank();
    c.integrator = "symplectic";
    continueFrom(c, false);
}

TEST_P(Restart, StationaryWalls)
{
    SphConfig c = tank();
    c.wallModel = "stationary";
    continueFrom(c, false);
    continueFrom(c, true);
}

TEST_P(Restart, MovingWalls) { continueFrom(tank(), true); }

TEST_P(Restart, MovingWallsSymplectic)
{
    SphConfig c = tank();
    c.integrator = "symplectic";
    continueFrom(c, true);
}

TEST_P(Restart, VariableSmoothingAndDrifts)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
    {
        SphConfig c = tank();
        c.integrator = integrator;
        c.variableSmoothing = true;
        c.xsph = 0.5;
        c.antiClump = 0.01;
        c.shifting = "fickian";
        c.diffusion = "molteni";
        continueFrom(c, false);
    }
}

TEST_P(Restart, RefusesWhatDoesNotFit)
{
    const SphConfig c = tank();
    const FluidInput f = column(c);
    const WallInput w = walls(c);
    const auto s = scene(c, f, w);
    s->advance(0.01);
    const auto saved = s->saveState();
    s->loadState(saved);                    // which sorts
    const FluidState before = s->fluid();

    for (const std::size_t at :
        {std::size_t(5), std::size_t(20), saved.size()/2, saved.size() - 2, saved.size() - 1})
    {
        auto damaged = saved;
        damaged[at] ^= 1 << 7;
        expectRefused(*s, damaged, "checksum");
    }
    auto words = saved;
    words[0] = 7;
    expectRefused(*s, words, "not a riprap state");
    expectRefused(*s, {}, "too short");
    expectRefused(*s, std::vector<std::int32_t>(saved.begin(), saved.begin() + 20), "too short");
    words = saved;
    words[1] += 1;
    expectRefused(*s, signedWords(words), "version");
    words = saved;
    words.insert(words.end() - 1, 0);
    expectRefused(*s, signedWords(words), "wrong length");
    words = saved;
    words[5] = -1;
    expectRefused(*s, signedWords(words), "particles");

    SphConfig other = c;
    other.precision = mixed() ? PrecisionKind::doubled : PrecisionKind::mixed;
    expectRefused(*s, scene(other, f, w)->saveState(), "precision");
    other = c;
    other.xsph = 0.5;
    expectRefused(*s, scene(other, f, w)->saveState(), "fields");
    expectRefused(*scene(other, f, w), saved, "fields");
    other = c;
    other.dimensions = 5 - D();
    FluidInput one;
    one.position = {0.1, 0.1, 0.1};
    one.velocity = {0, 0, 0};
    one.density = {1000};
    expectRefused(*scene(other, one), saved, "dimensions");
    expectRefused(*scene(c, one, w), saved, "particles");
    WallInput moving = w;
    makePiston(moving);
    expectRefused(*scene(c, f, moving, pistonMotion()), saved, "moving walls");

    expectSameBits(s->fluid(), before);
    s->loadState(saved);
    expectSameBits(s->fluid(), before);
}

} // namespace
} // namespace riprap
