// SPDX-License-Identifier: GPL-3.0-or-later
/*  The dictionaries of an SPH case: defaults, speeds, densities, messages. */

#include "coupling/couplings.hpp"
#include "coupling/fluidForces.hpp"
#include "modelFamily.hpp"
#include "particleCase.hpp"
#include "solvers/sph/sphModels.hpp"
#include "sphDictionaries.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    struct SphCase : ParticleCase
    {
        explicit SphCase(int D = 3, const char* g = "(0 0 -10)")
        :
            ParticleCase(boxOf(D), "deltaT 1e-4;", g)
        {}

        static BoxMesh boxOf(int D)
        {
            BoxMesh box;
            box.divide(0, 0, 2, 2);
            if (D == 2) box.sides(1, "empty");
            return box;
        }

        sphSettings settings(const std::string& text)
        {
            writeDict("constant/sphProperties", text);
            return readSphSettings(mesh());
        }

        std::string said(const std::string& text)
        {
            return messageOf([&]() { settings(text); });
        }
    };
}

TEST(SphSettings, defaults)
{
    SphCase c;
    const riprap::SphConfig otherwise;
    const sphSettings s(c.settings(""));
    EXPECT_EQ(s.config.kernel, otherwise.kernel);
    EXPECT_EQ(s.config.smoothingRatio, otherwise.smoothingRatio);
    EXPECT_EQ(s.config.density, 1000);
    EXPECT_NEAR(s.config.viscosity, 1e-3, 1e-18);
    EXPECT_EQ(s.config.fixedTimeStep, 1e-4);
    EXPECT_EQ(s.config.acousticCourant, 0.5);
    EXPECT_EQ(c.settings("timeIntegration leapfrog;").config.acousticCourant, 0.2);
    EXPECT_TRUE(s.autoMaxVelocity);
    EXPECT_EQ(s.soundSpeedRatio, 10);
    EXPECT_TRUE(s.walls.everyWallPatch);
    EXPECT_EQ(s.walls.layers, 0);
    EXPECT_FALSE(s.couples);
    EXPECT_TRUE(s.unused.empty());
    // what shifting takes for the surface
    EXPECT_EQ(s.config.shiftingSurfaceThreshold, 2.75);
    EXPECT_EQ(SphCase(2).settings("").config.shiftingSurfaceThreshold, 1.5);
}

TEST(SphSettings, whatIsRefused)
{
    SphCase c;
    EXPECT_EQ(c.said("kernel wendlandC3;"),
        "Entry kernel has the unknown word wendlandC3; valid are (wendlandC2 cubicSpline); did you "
        "mean wendlandC2?");
    EXPECT_TRUE(holds(c.said("smoothingLength { ratio 5; }"), "Entry ratio is 5: it must be "));
    EXPECT_EQ(c.said("gamma 0;"), "Entry gamma is 0: it must be positive");
    EXPECT_EQ(c.said("walls { layers 2.5; }"),
        "Entry layers is 2.5: it must be auto or a whole number from 1 to 20");
    EXPECT_EQ(c.said("shiftingCoeffs { surfaceThreshold 3; }"),
        "Entry surfaceThreshold is 3: it must be less than 3 in 3D");
    EXPECT_TRUE(holds(c.said("guards { speedRato 3; }"), "did you mean speedRatio?"));
    EXPECT_TRUE(holds(c.said("soundSpedRatio 3;"), "did you mean soundSpeedRatio?"));
    EXPECT_TRUE(holds(c.said("acousticCourant 3;"), "Entry acousticCourant is 3"));
    c.writeDict("constant/fluidProperties", "rho 1000; nu 1e-6; mu 1;");
    EXPECT_EQ(c.said(""), "One of the entries mu [Pa s] and nu [m2/s] must be there, not both");
    c.writeDict("constant/fluidProperties", "rho 1000;");
    EXPECT_EQ(c.said(""), "One of the entries mu [Pa s] and nu [m2/s] must be there");
}

//- The domain grows by the walls' thickness: layers of their spacing
TEST(SphSettings, spacingAndLayers)
{
    for (const int D : {2, 3})
    {
        SphCase c(D);
        sphSettings s(c.settings("walls { spacing 0.04; }"));
        setSpacing(s, 0.1);
        EXPECT_EQ(s.config.spacing, 0.1);
        EXPECT_EQ(s.config.wallSpacing, 0.04);
        // 2 h0 = 2.5 dp
        EXPECT_EQ(wallLayers(s), 7);
        EXPECT_NEAR(wallThickness(s), 0.28, 1e-14);
        EXPECT_NEAR(s.config.domainMin[0], -0.28, 1e-14);
        EXPECT_NEAR(s.config.domainMax[2], 1.28, 1e-14);
        EXPECT_NEAR(s.config.domainMax[1], D == 2 ? 1 : 1.28, 1e-14);
        EXPECT_NEAR(s.config.escapeInset, 0.18, 1e-14);
    }
    SphCase c;
    EXPECT_EQ(wallLayers(c.settings("walls { layers 2; }")), 2);
}

//- Torricelli, and what moves, as energies
TEST(SphSettings, maxVelocity)
{
    SphCase c;
    sphSettings s(c.settings(""));
    setSpacing(s, 0.1);
    const pointField x({{0.5, 0.5, 0.05}, {0.5, 0.5, 0.95}});
    vectorField U(2, Zero);
    setMaxVelocity(s, c.mesh(), x, U, {});
    EXPECT_NEAR(s.config.maxVelocity, std::sqrt(2*10*1.0), 1e-12);
    EXPECT_NEAR(s.config.soundSpeed, 10*s.config.maxVelocity, 1e-12);
    U[1] = vector(3, 0, 0);
    setMaxVelocity(s, c.mesh(), x, U, {});
    EXPECT_NEAR(s.config.maxVelocity, std::sqrt(20 + 9.0), 1e-12);
    otherSpeeds others;
    others.walls = 2;
    setMaxVelocity(s, c.mesh(), x, U, others);
    EXPECT_NEAR(s.config.maxVelocity, std::sqrt(20 + 9 + 4.0), 1e-12);
    others.solids = 100;
    setMaxVelocity(s, c.mesh(), x, U, others);
    EXPECT_NEAR(s.config.maxVelocity, std::sqrt(1e4 + 4), 1e-10);
    // water that starts above the bed falls to it
    setMaxVelocity(s, c.mesh(), pointField(1, point(0.5, 0.5, 0.75)), vectorField(1, Zero), {});
    EXPECT_NEAR(s.config.maxVelocity, std::sqrt(2*10*0.8), 1e-12);

    SphCase still(3, "(0 0 0)");
    sphSettings t(still.settings(""));
    setSpacing(t, 0.1);
    EXPECT_TRUE(
        holds(messageOf([&]() { setMaxVelocity(t, still.mesh(), x, vectorField(2, Zero), {}); }),
            "Entry maxVelocity is auto, but there is neither gravity nor an initial velocity"));
    sphSettings given(still.settings("maxVelocity 3; soundSpeedRatio 20;"));
    setMaxVelocity(given, still.mesh(), x, vectorField(2, Zero), {});
    EXPECT_EQ(given.config.soundSpeed, 60);
}

TEST(SphSettings, speedsThatAreNoSphs)
{
    SphCase c;
    sphSettings s(c.settings("maxVelocity 0.3;"));
    setSpacing(s, 0.1);
    EXPECT_EQ(
        messageOf([&]() { requireSpeeds(s, c.time(), vectorField(1, vector(2.9, 0, 0))); }), "");
    EXPECT_EQ(messageOf([&]() { requireSpeeds(s, c.time(), vectorField(1, vector(4, 0, 0))); }),
        "Entries maxVelocity, 0.3 m/s, and soundSpeedRatio give the fluid a speed of sound of 3 "
        "m/s, "
        "and it starts with 4 m/s");
    s.config.viscosity = 1e15;
    EXPECT_TRUE(holds(messageOf([&]() { requireSpeeds(s, c.time(), vectorField(1, Zero)); }),
        "The viscosity, mu or nu, is 1e+12 m2/s"));
}

//- There and back; Tait's and the linear equation of state by their formulas
TEST(SphSettings, densityOfPressure)
{
    riprap::SphConfig config;
    config.soundSpeed = 20;
    for (const scalar p : {-100.0, 0.0, 3e4})
    {
        config.eos = "Tait";
        const double B = 1000*400/7.0;
        EXPECT_NEAR(densityOfPressure(config, p), 1000*std::pow(p/B + 1, 1/7.0), 1e-9);
        EXPECT_NEAR(pressureOfDensity(config, densityOfPressure(config, p), 20), p, 1e-6);
        config.eos = "linear";
        EXPECT_NEAR(densityOfPressure(config, p), 1000 + p/400, 1e-9);
        EXPECT_NEAR(pressureOfDensity(config, densityOfPressure(config, p), 20), p, 1e-6);
    }
}

//- Of every family of models that a word chooses
TEST(SphSettings, families)
{
    using namespace riprap;
    SphCase c;
    const auto same = [](const std::string& s) { return s; };
    const auto within = [](const std::string& dict)
    { return [dict](const std::string& s) { return dict + " { " + s + " }"; }; };
    const auto of = [&](auto word)
    { return [&c, word](const std::string& text) { return word(c.settings(text)); }; };

    ModelFamily{"kernel", kernelWords(), same,
        of([](const sphSettings& s) { return s.config.kernel; })}.expectWords();
    ModelFamily{"timeIntegration", wordsOf(integrators()), same,
        of([](const sphSettings& s) { return s.config.integrator; })}.expectWords();
    ModelFamily{"shifting", wordsOf(shiftings()), same,
        of([](const sphSettings& s) { return s.config.shifting; })}.expectWords();
    ModelFamily{"model", wordsOf(wallModels()), within("walls"),
        of([](const sphSettings& s) { return s.config.wallModel; })}.expectWords();
    ModelFamily{"coupling", wordsOf<Couplings>(), same,
        of([](const sphSettings& s) { return s.coupling.kind; })}.expectWords();
    ModelFamily{"fluidForce", wordsOf<FluidForces>(), within("couplingCoeffs"),
        of([](const sphSettings& s) { return s.coupling.force; })}.expectWords();
    const ModelFamily equations{"equationOfState", wordsOf(equationsOfState()), same,
        of([](const sphSettings& s) { return s.config.eos; })};
    equations.expectWords();
    for (const EquationModel& e : equationsOfState()) equations.expectEntries(e.word, e.entries);
}

//- The default of an integrator's Courant number is that of its card, and above its highest it is
//  refused
TEST(SphSettings, courantOfIntegrators)
{
    SphCase c;
    for (const riprap::IntegratorModel& i : riprap::integrators())
    {
        const std::string word = std::string("timeIntegration ") + i.word + "; ";
        EXPECT_EQ(c.settings(word).config.acousticCourant, i.acousticCourant);
        EXPECT_TRUE(holds(c.said(word + "acousticCourant 5;"), "Entry acousticCourant is 5"));
    }
}

//- Where the equation of state is cut off: a little above it there is a density for each pressure
TEST(SphSettings, lowestPressure)
{
    riprap::SphConfig config;
    for (const riprap::EquationModel& e : riprap::equationsOfState())
    {
        config.eos = e.word;
        const scalar lowest = lowestPressure(config);
        EXPECT_LT(lowest, 0) << e.word;
        EXPECT_EQ(densityOfPressure(config, 2*lowest), densityOfPressure(config, lowest));
    }
    config.eos = "linear";
    EXPECT_NEAR(lowestPressure(config), -0.5*1000*sqr(config.soundSpeed), 1e-9);
    config.eos = "Tait";
    EXPECT_NEAR(lowestPressure(config), -0.99/7*1000*sqr(config.soundSpeed), 1e-9);
}
