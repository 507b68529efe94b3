// SPDX-License-Identifier: GPL-3.0-or-later
/*  Energies of fluid in tables: at rest, in free fall, with walls that work, over a restart. */

#include "runningFluid.hpp"

using namespace Foam;

namespace
{
    //- [J/kg] of a particle at this pressure, by Tait's equation: the integral of p/rho^2
    double elasticEnergy(const riprap::SphConfig& config, double p)
    {
        const double c2 = config.soundSpeed*config.soundSpeed, g = config.gamma;
        const double r = std::pow(p*g/(1000*c2) + 1, 1/g);
        return c2/g*((std::pow(r, g - 1) - 1)/(g - 1) + 1/r - 1);
    }

    const Water still{point(0, 0, 0), point(0.6, 0.5, 0.4), Zero, 0.4};
    const Water falling{point(0.2, 0.1, 0.5), point(0.6, 0.3, 0.8), vector(0.5, 0, 0.2)};

    //- A piston at the side of water at rest
    struct PistonRun : RunningSph
    {
        PistonRun()
        :
            RunningSph(tank(2, 1, 1, 20),
                "maxVelocity 2; walls { motion { piston { patches (xMin); solidBodyMotionFunction "
                "linearMotion; linearMotionCoeffs { velocity (0.01 0 0); } } } }",
                "deltaT 0.002;")
        {
            fill();
        }

        void fill() { start(0.05, {{point(0, 0, 0), point(1, 1, 0.5), Zero, 0.5}}); }
    };

    //- Of a block that falls freely since t = 0
    void fallsFreely(const WrittenTable& t, double mass, int row, double tolerance)
    {
        const double time = t.at("Time", row), w = 0.2 - 10*time;
        EXPECT_NEAR(t.at("kinetic", row)/mass, 0.5*(0.25 + w*w), tolerance);
        EXPECT_NEAR(t.at("potential", row)/mass, 10*(0.65 + 0.2*time - 5*time*time), tolerance);
        EXPECT_NEAR(t.at("elastic", row)/mass, 0, tolerance);
        EXPECT_NEAR(t.at("total", row)/mass, 6.5 + 0.5*0.29, tolerance);
        EXPECT_NEAR(t.at("dissipated", row)/mass, 0, tolerance);
        EXPECT_NEAR(t.at("maxSpeed", row), std::sqrt(0.25 + w*w), 50*tolerance);
        EXPECT_EQ(t.at("wallWork", row), 0);
    }
}

TEST(EnergyBalance, sphAtRest)
{
    for (const int D : {2, 3})
    {
        RunningSph run(tank(D, 1, 1, 10, 0.5));
        run.start(0.1, {still});
        run.make("energyBalance");
        const WrittenTable t(run.table("energyBalance"));
        const double mass = D == 2 ? 240 : 120;
        double elastic = 0;
        for (const double z : {0.05, 0.15, 0.25, 0.35})
            elastic += 0.25*mass*elasticEnergy(run.settings.config, 1e4*(0.4 - z));
        EXPECT_EQ(t["Time"], 0);
        EXPECT_EQ(t["kinetic"], 0);
        EXPECT_NEAR(t["potential"], mass*10*0.2, 1e-4);
        EXPECT_NEAR(t["elastic"], elastic, 1e-5*elastic);
        EXPECT_NEAR(t["total"], t["potential"] + t["elastic"], 1e-6);
        EXPECT_NEAR(t["maxDensityDeviation"],
            densityOfPressure(run.settings.config, 3500)/1000 - 1, 1e-7);
        for (const char* none : {"maxSpeed", "dissipated", "drift", "stiffening", "faceWork"})
            EXPECT_EQ(t[none], 0) << none;
    }
}

TEST(EnergyBalance, picAtRest)
{
    for (const int D : {2, 3})
    {
        RunningPic run(tank(D, 1, 1, 10, 0.5));
        run.start(0.1, {still});
        run.make("energyBalance");
        const WrittenTable t(run.table("energyBalance"));
        EXPECT_NEAR(t["potential"], (D == 2 ? 240 : 120)*10*0.2, 1e-4);
        EXPECT_EQ(t["total"], t["potential"]);
        EXPECT_EQ(t["elastic"], 0);
        EXPECT_EQ(t["kinetic"], 0);
    }
}

TEST(EnergyBalance, freeFall)
{
    for (const int D : {2, 3})
    {
        RunningSph sph(tank(D, 1, 1, 10, 0.5), "maxVelocity 3;", "deltaT 0.01;");
        sph.start(0.1, {falling});
        RunningPic pic(tank(D, 1, 1, 10, 0.5), "", "deltaT 0.01;");
        pic.start(0.1, {falling});
        const auto a = sph.make("energyBalance"), b = pic.make("energyBalance");
        for (int k = 0; k < 3; ++k)
        {
            sph.step();
            pic.step();
            FluidCase::sample(*a);
            FluidCase::sample(*b);
        }
        const double mass = D == 2 ? 120 : 24;
        for (int row = 0; row < 4; ++row)
        {
            fallsFreely(sph.table("energyBalance"), mass, row, 2e-4);
            fallsFreely(pic.table("energyBalance"), mass, row, 1e-6);
        }
    }
}

TEST(EnergyBalance, workOfAWall)
{
    PistonRun run;
    const auto f = run.make("energyBalance"), forces = run.make("wallForce", "", "forces");
    double work = 0, kinetic = 0;
    for (int k = 0; k < 5; ++k)
    {
        const double before = run.table("wallForce", "forces")["pistonFx"];
        run.step();
        FluidCase::sample(*f);
        FluidCase::sample(*forces);
        work -= 0.5*(before + run.table("wallForce", "forces")["pistonFx"])*0.01*0.002;
        kinetic = std::max(kinetic, run.table("energyBalance")["kinetic"]);
    }
    const WrittenTable t(run.table("energyBalance"));
    // the mean pressure, over the way
    EXPECT_NEAR(t["wallWork"], 0.01*0.01*1e4*0.125, 0.1*0.125);
    EXPECT_NEAR(t["wallWork"], work, 0.02*work);
    // what is given and not there is dissipated
    EXPECT_NEAR(t["dissipated"], t.at("total", 0) + t["wallWork"] - t["total"], 1e-6);
    EXPECT_NEAR(t["drift"]*kinetic, -t["dissipated"], 1e-6);
}

//- A scene that has forgotten what walls did goes on with what a written time kept
TEST(EnergyBalance, goesOnOverARestart)
{
    PistonRun run;
    auto f = run.make("energyBalance");
    for (int k = 0; k < 2; ++k)
    {
        run.step();
        FluidCase::sample(*f);
    }
    const WrittenTable before(run.table("energyBalance"));
    EXPECT_GT(before["wallWork"], 0.02);
    run.fill();
    f = run.make("energyBalance");
    f->write();
    const WrittenTable after(run.table("energyBalance_0"));
    EXPECT_EQ(after.rows.size(), 1u);
    EXPECT_EQ(after["wallWork"], before["wallWork"]);
    EXPECT_EQ(after["wallPressureWork"], before["wallPressureWork"]);
    EXPECT_EQ(after["total"], before.at("total", 0));
    EXPECT_NEAR(after["dissipated"], before["wallWork"], 1e-6);
    EXPECT_NEAR(after["drift"]*before.at("kinetic", 1), -before["wallWork"], 1e-5);
}
