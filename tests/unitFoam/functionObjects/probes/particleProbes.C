// SPDX-License-Identifier: GPL-3.0-or-later
/*  Probes in water at rest and in fall: points, sensors, means, bodies that they ride on. */

#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    const double dp = 0.05;

    const Water pool{point(0, 0, 0), point(1, 0.5, 0.5), vector(0.2, 0, 0.1), 0.5};

    struct Pool : RunningSph
    {
        explicit Pool(int D = 2, const std::string& more = "")
        :
            RunningSph(tank(D, 1, 1, 10, 0.5), "maxVelocity 3; " + more)
        {
            start(dp, {pool});
        }

        WrittenTable probe(const std::string& entries, const std::string& field = "p",
            const std::string& name = "f")
        {
            make("particleProbes", entries, name);
            return table(field, name);
        }
    };
}

TEST(ParticleProbes, waterAtRest)
{
    for (const int D : {2, 3})
    {
        Pool run(D);
        const auto f = run.make("particleProbes", "fields (p U rho volumeFraction); probeLocations "
            "((0.5 0.25 0.25) (0.5 0.25 0) (1 0.25 0.3) (0.5 0.25 0.8) (0 0.25 0));");
        const WrittenTable p(run.table("p")), rho(run.table("rho")), U(run.table("U")),
            fraction(run.table("volumeFraction"));
        const double pressure[] = {2500, 5000, 2000, 0, 5000};
        for (int i = 0; i < 5; ++i)
        {
            const std::string n(std::to_string(i));
            const bool inside = i == 0, dry = i == 3;
            EXPECT_NEAR(p["p" + n], pressure[i], inside || dry ? 0.5 : 50) << i;
            EXPECT_NEAR(rho["rho" + n],
                dry ? 0 : densityOfPressure(run.settings.config, p["p" + n]), 1e-4) << i;
            EXPECT_NEAR(fraction["f" + n], dry ? 0 : 1, 0.05) << i;
            EXPECT_NEAR(U["Ux" + n], dry ? 0 : 0.2, 1e-6) << i;
            EXPECT_NEAR(U["Uy" + n], 0, 1e-6) << i;
            EXPECT_NEAR(U["Uz" + n], dry ? 0 : 0.1, 1e-6) << i;
        }
        EXPECT_EQ(p.comments[2], "Probe 2 (1 0.25 0.3)");
    }
}

TEST(ParticleProbes, onAGrid)
{
    for (const int D : {2, 3})
    {
        RunningPic run(tank(D, 1, 1, 10, 0.5), "", "deltaT 0.001; adjustTimeStep no;");
        run.start(dp, {{point(0, 0, 0), point(1, 0.5, 0.5)}});
        const auto f = run.make("particleProbes", "fields (p rho U volumeFraction); probeLocations "
            "((0.5 0.25 0.25) (0.5 0.25 0) (1 0.25 0.3) (0.5 0.25 0.8));");
        run.step();
        FluidCase::sample(*f);
        const WrittenTable p(run.table("p")), rho(run.table("rho"));
        EXPECT_NEAR(p["p0"], 2500, 0.01);
        EXPECT_NEAR(p["p1"], 5000, 0.01);
        EXPECT_NEAR(p["p2"], 2000, 0.01);
        EXPECT_EQ(p["p3"], 0);
        EXPECT_EQ(rho["rho0"], 1000);
        EXPECT_EQ(rho["rho3"], 0);
        EXPECT_NEAR(run.table("volumeFraction")["f0"], 1, 1e-6);
        EXPECT_NEAR(run.table("U")["Uz0"], 0, 1e-6);
    }
}

//- What a mean over the half of the kernel before a wall is at, and at the surface
TEST(ParticleProbes, corrections)
{
    Pool run;
    const std::string floor("probeLocations ((0.5 0.5 0)); ");
    const double p = run.probe(floor + "wallCorrection off;")["p0"];
    // the centroid is about 0.4 h away
    EXPECT_NEAR(5000 - p, 1e4*0.4*1.25*dp, 0.2*250);
    EXPECT_NEAR(run.probe(floor + "wallCorrection off;", "p", "g")["p0"], p, 1e-6);
    EXPECT_NEAR(run.probe(floor + "surfaceCorrection on;", "p", "h")["p0"], 5000, 1);
    // half of the support is in the wall
    EXPECT_NEAR(run.probe(floor + "fields (volumeFraction); wallCorrection off;",
        "volumeFraction", "i")["f0"], 0.5, 0.02);
    const std::string surface("probeLocations ((0.5 0.5 0.5)); ");
    EXPECT_GT(run.probe(surface, "p", "j")["p0"], 150);
    EXPECT_NEAR(run.probe(surface + "surfaceCorrection on;", "p", "k")["p0"], 0, 1);
    EXPECT_EQ(run.probe(surface + "minVolumeFraction 0.6;", "p", "l")["p0"], 0);
}

//- Over their face, where it is dry with 0
TEST(ParticleProbes, roundSensors)
{
    for (const int D : {2, 3})
    {
        Pool run(D);
        const std::string radius(" sensorRadius 0.06; fields (p U); ");
        const auto f = run.make("particleProbes",
            "probeLocations ((1 0.25 0.25) (1 0.25 0.55) (1 0.25 0.8)); " + radius);
        const WrittenTable p(run.table("p")), U(run.table("U"));
        EXPECT_NEAR(p["p0"], 2500, 30);
        // a disc of which 0.01 is under water: less than half a spacing's head
        EXPECT_GE(p["p1"], 0);
        EXPECT_LT(p["p1"], 0.5*1e4*dp);
        EXPECT_NEAR(U["Uz1"], 0.1, 1e-5);
        EXPECT_EQ(p["p2"], 0);
        // in the open its face must be told
        const std::string inside("probeLocations ((0.5 0.25 0.25)); " + radius);
        EXPECT_NEAR(run.probe(inside + "sensorNormal (0 0 2);", "p", "g")["p0"], 2500, 300);
        EXPECT_EQ(run.said("particleProbes", inside),
            "Entry sensorNormal of function object f is missing: probe 0 at (0.5 0.25 0.25) has a "
            "sensorRadius and is on no wall");
    }
}

TEST(ParticleProbes, whatIsRefused)
{
    Pool run;
    EXPECT_EQ(run.said("particleProbes", "probeLocations ((0.5 0.5 0.5) (0.5 0 1.2));"),
        "Entry probeLocations of function object f: probe 1 at (0.5 0 1.2) is outside of the mesh, "
        "which spans (0 0 0) to (1 0.5 1)");
    EXPECT_EQ(run.said("particleProbes", "probeLocations ((0.5 0.5 0.5)); sensorNormal (0 1 0);"),
        "Entry sensorNormal of function object f: (0 1 0) is across the plane of the 2D mesh");
    EXPECT_EQ(run.said("particleProbes", "probeLocations ((0.5 0.5 0.5)); fields (q);"),
        "Entry fields of function object f: unknown field q; valid are (p U rho volumeFraction)");
    EXPECT_EQ(run.said("particleProbes", "probeLocations ((0.5 0.5 0.5)); average -1;"),
        "Entry average of function object f is -1: it must not be negative");
    EXPECT_EQ(run.said("particleProbes", "probeLocations ((0.5 0.5 0.5)); body gate;"),
        "Entry body of function object f: gate is no group of walls that moves and none of "
        "solids; valid are, of walls, (), of solids, ()");
    RunningPic pic(tank(2, 1, 1, 10));
    pic.start(dp, {pool});
    EXPECT_EQ(pic.said("particleProbes", "probeLocations ((0.5 0.5 0.5)); sensorNormal (0 0 1);"),
        "Entry sensorNormal of function object f needs a sensorRadius where water is on a grid");
}

//- The velocity of what falls, over the time before: half of it late; over restarts as well
TEST(ParticleProbes, meansOverTime)
{
    RunningSph run(tank(2, 1, 1, 10), "maxVelocity 3;", "deltaT 0.002;");
    run.start(dp, {{point(0.2, 0, 0.5), point(0.8, 1, 0.9)}});
    const std::string entries("probeLocations ((0.5 0.5 0.7)); fields (U); average 0.02;");
    auto f = run.make("particleProbes", entries);
    for (int k = 0; k < 15; ++k)
    {
        run.step();
        FluidCase::sample(*f);
    }
    const WrittenTable U(run.table("U")), mean(run.table("UMean"));
    ASSERT_EQ(mean.rows.size(), 16u);
    for (int row = 0; row < 16; ++row)
    {
        const double t = U.at("Time", row);
        EXPECT_NEAR(U.at("Uz0", row), -10*t, 2e-3) << row;
        EXPECT_NEAR(mean.at("Uz0", row), -10*(t - 0.5*std::min(t, 0.02)), 1e-3) << row;
    }
    // the written time kept what a continued run needs
    f = run.make("particleProbes", entries);
    run.step();
    FluidCase::sample(*f);
    EXPECT_NEAR(run.table("UMean_0")["Uz0"], -10*(0.032 - 0.01), 1e-3);
}

//- In the reference pose, read where the group is now
TEST(ParticleProbes, rideOnABody)
{
    const std::string entries(
        "probeLocations ((0 0.5 0.1) (0.3 0.5 0.2)); body lift; fields (p); ");
    RunningSph run(tank(2, 1, 1, 10),
        "maxVelocity 3; walls { motion { lift { patches (xMin); solidBodyMotionFunction "
        "linearMotion; linearMotionCoeffs { velocity (0 0 0.1); } } } }");
    run.time().setTime(1, 1);
    run.start(dp, {pool});
    const auto f = run.make("particleProbes", entries);
    f->write();
    const WrittenTable p(run.table("p", "f"));
    EXPECT_NEAR(p["p0"], 1e4*0.3, 50);
    EXPECT_NEAR(p["p1"], 1e4*0.2, 1);
    EXPECT_EQ(p.comments[1], "Probe 1 (0.3 0.5 0.2) on lift");
    EXPECT_EQ(run.said("particleProbes", "probeLocations ((0.5 0.5 0.98)); body lift;"),
        "Entry probeLocations of function object f: probe 0 at (0.5 0.5 1.08) is outside of the "
        "mesh, which spans (0 0 0) to (1 1 1)");
}
