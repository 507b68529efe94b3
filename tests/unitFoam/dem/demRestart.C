// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a continued run of solids is given: its record, whether the cloud is that of the state, and
    starts that would throw bodies apart. */

#include "runningSolids.hpp"
#include "sceneState.H"
#include "touchingStart.H"

#include <gtest/gtest.h>
#include <limits>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    demRestart numbers()
    {
        demRestart run;
        run.time = 0.1 + 0.2;
        run.particles = 12;
        run.initialParticles = int64_t(5) << 35;
        run.device = "cpu";
        run.precision = "double";
        run.brokenBefore = int64_t(3) << 34;
        run.timeStep = 1e-4/3;
        run.stepFraction = 0.7/3;
        run.maxDeltaT = 1.0/7;
        return run;
    }

    //- Three spheres that move and turn
    struct Cloud : RunningSolids
    {
        Cloud() : RunningSolids(rock("groups { raft { } }", "patches ();"))
        {
            add(point(0.2, 0.3, 0.4), 0.05, vector(1, 2, 3), vector(4, 5, 6));
            add(point(0.6, 0.3, 0.4), 0.06, vector(0, -1, 0), Zero, "raft");
            add(point(0.6, 0.7, 0.8), 0.07, Zero, vector(0, 0, 1));
            start();
        }

        bool matches(label digits) const
        {
            return matchesCloud(
                solids.particles, *scene, settings.config, std::sqrt(3.0), digits);
        }

        //- With one number of the cloud off by this
        bool with(double& number, double change, label digits)
        {
            const double before = number;
            number += change;
            const bool same = matches(digits);
            number = before;
            return same;
        }
    };

    std::string warned(RunningSolids& c)
    {
        testing::internal::CaptureStdout();
        warnOfTouchingStart(*c.scene, c.settings.config, c.input);
        return testing::internal::GetCapturedStdout();
    }
}

//- To the bit, whatever the case's digits are
TEST(DemRestart, comesBackToTheBit)
{
    for (const char* format : {"writePrecision 4;", "writePrecision 9;", "writeFormat binary;"})
    {
        ScratchCase c(format);
        EXPECT_FALSE(hasDemRun(c.time(), false));
        const demRestart run(numbers());
        writeDemRun(c.time(), run);
        const demRestart back(readDemRun(c.time()));
        EXPECT_EQ(back.time, run.time);
        EXPECT_EQ(back.initialParticles, run.initialParticles);
        EXPECT_EQ(back.brokenBefore, run.brokenBefore);
        EXPECT_EQ(back.timeStep, run.timeStep);
        EXPECT_EQ(back.stepFraction, run.stepFraction);
        EXPECT_EQ(back.maxDeltaT, run.maxDeltaT);
        // of the fields beside it
        EXPECT_EQ(back.digits, *format == 'w' && format[5] == 'F' ? 17 : format[15] - '0');
        EXPECT_TRUE(hasDemRun(c.time(), false));
    }
}

TEST(DemRestart, filesThatAreMissingOrDamaged)
{
    ScratchCase c;
    writeDemRun(c.time(), numbers());
    const std::string folder(c.path()/"0/uniform/riprap"), good(c.read("0/uniform/riprap/demRun"));
    const std::string alone(messageOf([&]() { hasDemRun(c.time()); }));
    EXPECT_EQ(alone,
        "The exact state of the particles is damaged (one of its two files is missing or empty): "
        "remove the folder \"" + folder + "\" to continue from the fields of the cloud");
    writeStateWords(c.time(), demRestart::stateFile, riprap::knownWords({1, 2, 3}));
    EXPECT_TRUE(hasDemRun(c.time()));

    const auto without = [&](const std::string& entry)
    {
        std::string text(good);
        text.replace(text.find(entry), entry.size(), "other");
        c.write("0/uniform/riprap/demRun", text);
        return messageOf([&]() { readDemRun(c.time()); });
    };
    for (const char* entry : {"brokenBefore", "timeStep", "stepFraction", "steps"})
    {
        const std::string message(without(entry));
        EXPECT_TRUE(holds(message, entry)) << message;
        EXPECT_TRUE(holds(message, folder)) << message;
    }
    // of earlier versions
    EXPECT_EQ(without("maxDeltaT"), "");
    EXPECT_EQ(readDemRun(c.time()).maxDeltaT, 0);
    EXPECT_EQ(without("digits"), "");
    EXPECT_EQ(readDemRun(c.time()).digits, 6);
}

//- Positions to the domain, velocities to the fastest; with digits every field
TEST(MatchesCloud, numbersThatAreOff)
{
    Cloud c;
    riprap::DemParticles& p = c.solids.particles;
    EXPECT_TRUE(c.matches(0));
    EXPECT_TRUE(c.matches(6));
    EXPECT_TRUE(c.matches(17));
    // a part of 1e-5 of the size, sqrt(3)
    EXPECT_TRUE(c.with(p.position[4], 1.7e-5, 0));
    EXPECT_FALSE(c.with(p.position[4], 1.8e-5, 0));
    EXPECT_FALSE(c.with(p.position[4], -1.8e-5, 0));
    EXPECT_TRUE(c.with(p.position[4], 1.7e-5, 6));
    EXPECT_FALSE(c.with(p.position[4], 1.8e-5, 6));
    EXPECT_FALSE(c.with(p.position[4], 1e-8, 17));
    // 1e-4 of the fastest, sqrt(14)
    EXPECT_TRUE(c.with(p.velocity[8], 3.7e-4, 0));
    EXPECT_FALSE(c.with(p.velocity[8], 3.8e-4, 0));
    EXPECT_FALSE(c.with(p.velocity[8], 3.7e-4, 6));     // it was at rest
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(c.with(p.position[0], nan, 0));
    EXPECT_FALSE(c.with(p.velocity[0], nan, 0));
    // others with digits alone
    for (const label digits : {0, 6})
    {
        EXPECT_EQ(c.with(p.spin[0], 1e-4, digits), !digits);
        EXPECT_EQ(c.with(p.radius[1], 1e-6, digits), !digits);
        EXPECT_EQ(c.with(p.mass[2], 1e-4, digits), !digits);
    }
    EXPECT_TRUE(c.with(p.spin[0], 3e-5, 6));
    EXPECT_FALSE(c.with(p.spin[0], 3e-5, 7));
}

TEST(MatchesCloud, particlesOfOthers)
{
    Cloud c;
    riprap::DemParticles& p = c.solids.particles;
    p.group[1] = 0;
    EXPECT_TRUE(c.matches(0));
    EXPECT_FALSE(c.matches(6));
    p.group[1] = 1;
    p.id[2] = 7;
    EXPECT_FALSE(c.matches(0));
    p.id[2] = 2;
    EXPECT_TRUE(c.matches(6));
    c.add(point(0.1, 0.1, 0.1), 0.01);
    EXPECT_FALSE(c.matches(0));
}

//- Energy of the contacts over the weight of what touches: a twentieth of the smallest diameter
TEST(TouchingStart, thrownUp)
{
    // 0.5 k delta^2/(2 m g) against 0.005
    const double m = 1000*4*pi/3*1.25e-4, limit = std::sqrt(0.005*2*m*10/(0.5*1e5));
    for (const double part : {0.98, 1.02})
    {
        RunningSolids c(rock("", "patches ();"));
        c.add(point(0.3, 0.5, 0.5), 0.05);
        c.add(point(0.4 - part*limit, 0.5, 0.5), 0.05);
        c.add(point(0.8, 0.5, 0.5), 0.01);
        c.start();
        const std::string said(warned(c));
        if (part < 1) EXPECT_EQ(said, "");
        else
        {
            EXPECT_TRUE(holds(said, "Warning: solids touch at the start. The contacts of 2 bodies "
                                    "hold 0.054"))
                << said;
            EXPECT_TRUE(holds(said, " J, enough to throw them 0.0052")) << said;
            EXPECT_TRUE(holds(said, " m up. The deepest is 0.0010")) << said;
            EXPECT_TRUE(holds(said,
                " m, gap included, of particle 0 at (0.3 0.5 0.5) with particle "
                "1. Place them farther apart, or give a smaller gap or stiffness "
                "in constant/solidProperties\n"))
                << said;
        }
    }
}

//- A rigid body on a wall counts once, with its own mass
TEST(TouchingStart, bodyAtAWall)
{
    for (const double mass : {5.0, 0.5})
    {
        RunningSolids c(rock());
        c.add(point(0.4, 0.5, 0.048), 0.05);
        c.add(point(0.6, 0.5, 0.047), 0.05);
        c.body(0, point(0.5, 0.5, 0.05), mass, vector(1, 1, 1));
        c.start();
        const std::string said(warned(c));
        // 0.5 k (0.002^2 + 0.003^2) = 0.65 J lifts 0.5 kg by 0.13 m, 5 kg by 0.013
        EXPECT_TRUE(holds(said, mass > 1
                ? "The contacts of 1 body hold 0.65 J, enough to throw them 0.013 m up."
                : "The contacts of 1 body hold 0.65 J, enough to throw them 0.13 m up."))
            << said;
        EXPECT_TRUE(holds(said, "The deepest is 0.003 m, gap included, of particle 1 at (0.6 0.5 "
                                "0.047) with a wall. "))
            << said;
    }
}

TEST(TouchingStart, withoutGravity)
{
    RunningSolids c(rock("", "patches ();"), BoxMesh(), "(0 0 0)");
    c.add(point(0.3, 0.5, 0.5), 0.05);
    c.add(point(0.39, 0.5, 0.5), 0.05);
    c.start();
    EXPECT_EQ(warned(c), "");
}
