/*  The length of a step, its limits, and how runs begin and end: targets, numbers of steps,
    interrupts.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <chrono>
#include <thread>
#include "tankScene.hpp"

namespace riprap
{
namespace
{

class TimeStep : public TankScene
{
protected:

    //- A blob at rest: every limit is known
    FluidInput blob(const SphConfig& c, double speed = 0) const
    {
        FluidInput f = lattice(
            c, {{0.4, 0.4, D() == 3 ? 0.4 : 0.0}}, {{0.6, 0.6, D() == 3 ? 0.6 : 0.0}});
        for (std::size_t i = 0; i < f.size(); ++i) f.velocity[3*i] = speed;
        return f;
    }

    //- Of the first step: estimated, and taken
    void expectStep(const char* limit, double dt, const SphConfig& c, double speed = 0)
    {
        SCOPED_TRACE(limit);
        const auto s = scene(c, blob(c, speed));
        std::string name;
        EXPECT_NEAR(s->estimateTimeStep(name), dt, 1e-6*dt);        // maxima are floats
        EXPECT_EQ(name, limit);
        const SphReport r = s->advance(1, 1);
        EXPECT_EQ(r.steps, 1);
        EXPECT_NEAR(r.lastTimeStep, dt, 1e-6*dt);
        EXPECT_EQ(r.limit, limit);
        EXPECT_EQ(r.minTimeStep, r.lastTimeStep);
        EXPECT_EQ(r.maxTimeStep, r.lastTimeStep);
        EXPECT_EQ(r.time, r.lastTimeStep);
    }
};

RIPRAP_ALL_SETUPS(TimeStep);

TEST_P(TimeStep, Limits)
{
    SphConfig c = config();
    const double h = 1.25*c.spacing, c0 = c.soundSpeed;
    expectStep("acoustic", 0.3*h/c0, c);
    expectStep("acoustic", 0.3*h/(c0 + 1.5), c, 1.5);
    c.acousticCourant = 0.1;
    expectStep("acoustic", 0.1*h/c0, c);

    c = config();
    c.gravity = {{0, 3e4, -4e4}};
    if (D() == 2) c.gravity = {{-4e4, 3e4, 1e9}};       // of no concern in the plane
    expectStep("force", 0.25*std::sqrt(h/5e4), c);

    c = config();
    c.viscosityModel = "laminar";
    c.viscosity = 2000;
    expectStep("viscous", 0.125*h*h/2, c);
    c.viscosityModel = "artificial";
    expectStep("acoustic", 0.3*h/c0, c);
    // nu = alpha c0 h/(2 (D + 2)), Monaghan 2005
    c.artificialAlpha = 40;
    expectStep("viscous", 0.125*h*h/(40*c0*h/(2*(D() + 2))), c);
    c.viscosityModel = "laminarAndArtificial";
    expectStep("viscous", 0.125*h*h/(2 + 40*c0*h/(2*(D() + 2))), c);

    c = config();
    c.maxTimeStep = 1e-5;
    expectStep("maximum", 1e-5, c);
    c.adjustTimeStep = false;
    c.fixedTimeStep = 2e-5;
    expectStep("fixed", 2e-5, c);
}

TEST_P(TimeStep, LimitsTakeTheSmallestSmoothingLength)
{
    SphConfig c = config();
    c.variableSmoothing = true;
    FluidInput f = blob(c);
    for (double& rho : f.density) rho = 1.1*c.density;
    const double h0 = 1.25*c.spacing;
    const auto step = [&](const char* limit, double dt)
    {
        std::string name;
        EXPECT_NEAR(scene(c, f)->estimateTimeStep(name), dt, 1e-6*dt);
        EXPECT_EQ(name, limit);
    };
    const double h = h0*std::pow(1.1, -1.0/D());        // h rho^(1/D) stays what it was
    step("acoustic", 0.3*h/(c.soundSpeed*std::pow(1.1, 3)));
    c.viscosityModel = "laminar";
    c.viscosity = 4000;
    step("viscous", 0.125*h*h/4);
    c.gravity = {{0, 3e4, -4e4}};
    if (D() == 2) c.gravity = {{-4e4, 3e4, 0}};
    c.viscosityModel = "none";
    c.eos = "linear";
    // the surface of compressed fluid is accelerated too: by less than 1 % of this
    c.forceCourant = 0.01;
    std::string name;
    const double dt = scene(c, f)->estimateTimeStep(name);
    EXPECT_EQ(name, "force");
    EXPECT_NEAR(dt, 0.01*std::sqrt(h/5e4), 0.03*dt);
    c.forceCourant = 0.25;
    c.gravity = {{0, 0, 0}};
    c.maxSmoothingGrowth = 1.01;                        // h is not smaller than that
    step("acoustic", 0.3*h0/1.01/c.soundSpeed);
    c.variableSmoothing = false;
    step("acoustic", 0.3*h0/c.soundSpeed);
}

TEST_P(TimeStep, GrowsByATenthAtMost)
{
    // a fast particle that shortens the step until it leaves: then the way is free for 1.45 times
    // as much
    SphConfig c = config();
    FluidInput f = blob(c);
    const double loner[3] = {0.97, 0.9, 0.1}, velocity[3] = {9, 0, 0};
    f.position.insert(f.position.end(), loner, loner + 3);
    if (D() == 2) f.position.back() = 0;
    f.velocity.insert(f.velocity.end(), velocity, velocity + 3);
    f.density.push_back(c.density);
    const auto s = scene(c, f);
    const double dt = 0.3*1.25*c.spacing;
    double last = dt/(c.soundSpeed + 9);
    int grew = 0;
    for (int k = 0; k < 20; ++k)
    {
        const SphReport r = s->advance(1, 1);
        EXPECT_LE(r.lastTimeStep, 1.1*last*(1 + 1e-6));
        grew += r.limit == "growth";
        last = r.lastTimeStep;
    }
    EXPECT_EQ(grew, 3) << "1.1 cubed, and 1.45/1.33";
    EXPECT_NEAR(last, dt/c.soundSpeed, 1e-6*last);
}

TEST_P(TimeStep, TargetsAreReachedExactly)
{
    for (const std::string integrator : {"leapfrog", "symplectic"})
        for (const bool adjust : {true, false})
        {
            SphConfig c = config();
            c.integrator = integrator;
            c.startTime = 0.1;
            c.adjustTimeStep = adjust;
            c.fixedTimeStep = 7e-4;
            const auto s = scene(c, blob(c, 0.3));
            EXPECT_EQ(s->time(), 0.1);
            std::int64_t total = 0;
            for (const double t :
                {0.1001, 0.101, 0.1 + 1.0/300, 0.103333333333333333, 0.11, 0.11 + 1e-12, 0.12})
            {
                const SphReport r = s->advance(t);
                EXPECT_EQ(r.time, t) << "the same number, not one near it";
                EXPECT_EQ(s->time(), t);
                total += r.steps;
                EXPECT_EQ(r.totalSteps, total);
                EXPECT_LE(r.minTimeStep, r.maxTimeStep);
            }
            // the fluid has come as far as the clock says
            const FluidState f = s->fluid();
            const FluidInput start = blob(c, 0.3);
            for (std::size_t i = 0; i < f.id.size(); ++i)
                ASSERT_NEAR(f.position[3*i], start.position[3*f.id[i]] + 0.3*0.02,
                    0.02*0.3*total*2*epsilon() + 1e-14);
            // nothing to do: no step, no change
            const SphReport none = s->advance(0.12), back = s->advance(0.05);
            EXPECT_EQ(none.steps + back.steps, 0);
            EXPECT_EQ(back.time, 0.12);
            EXPECT_EQ(none.minTimeStep, 0);
        }
}

TEST_P(TimeStep, FixedStepsAreCounted)
{
    SphConfig c = config();
    c.adjustTimeStep = false;
    c.fixedTimeStep = 5e-4;
    const auto s = scene(c, blob(c));
    SphReport r = s->advance(0.01);
    EXPECT_EQ(r.steps, 20) << "round-off must not add a twenty-first";
    EXPECT_EQ(r.limit, "fixed");
    r = s->advance(0.0112);
    EXPECT_EQ(r.steps, 3);
    EXPECT_EQ(r.limit, "target");
    EXPECT_NEAR(r.lastTimeStep, 2e-4, 1e-12);
    EXPECT_EQ(r.maxTimeStep, 5e-4);
}

TEST_P(TimeStep, NumberOfSteps)
{
    SphConfig c = config();
    const auto s = scene(c, blob(c, 0.1)), other = scene(c, blob(c, 0.1));
    double time = 0;
    for (const int n : {1, 7, 30, 2})
    {
        const SphReport r = s->advance(100, n);
        EXPECT_EQ(r.steps, n);
        EXPECT_GT(r.time, time);
        time = r.time;
    }
    EXPECT_EQ(other->advance(100, 40).time, time) << "forty steps, however they are asked for";
}

TEST_P(TimeStep, Interrupt)
{
    // by the motion of a wall, which is asked at the start of a call: at once, and the next call
    // goes on
    SphConfig c = tank();
    WallInput w = walls(c);
    makePiston(w);
    SphScene* running = nullptr;
    const auto s = scene(c, column(c), w,
        [&](int, double)
        {
            if (running) running->interrupt();
            return WallPose();
        });
    running = s.get();
    const SphReport stopped = s->advance(0.01);
    EXPECT_LT(stopped.time, 0.01);
    EXPECT_EQ(stopped.steps, 1)
        << "a call that returns without a step would look like one that cannot go on";
    EXPECT_EQ(stopped.stop, StopReason::none);
    running = nullptr;
    EXPECT_EQ(s->advance(0.01).time, 0.01);

    // between two calls: heeded by the next one, once
    s->interrupt();
    EXPECT_EQ(s->advance(0.01).steps, 0) << "nothing to do";
    EXPECT_EQ(s->advance(0.02).steps, 1);
    EXPECT_EQ(s->advance(0.02).time, 0.02);

    // by another thread, in the middle of a run that would take minutes
    const auto blobs = scene(config(), blob(config()));
    std::thread alarm([&]
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        blobs->interrupt();
    });
    const SphReport r = blobs->advance(1e9, 5000000);
    alarm.join();
    EXPECT_GT(r.steps, 0);
    EXPECT_LT(r.steps, 5000000);
    EXPECT_EQ(r.time, blobs->time());
}

} // namespace
} // namespace riprap
