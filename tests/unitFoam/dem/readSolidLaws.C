// SPDX-License-Identifier: GPL-3.0-or-later
/*  Contact laws of solidProperties and what each takes of its pairs; time integration; materials
    and planes of walls. */

#include "particleCase.hpp"
#include "readSolidProperties.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string rock("materials { rock { rho 2600; E 1e7; nu 0.2; } } ");

    demSettings read(const std::string& text, double gravity = -10)
    {
        demSettings s;
        s.config.gravity = {{0, 0, gravity}};
        readSolidProperties(entries(rock + text), s);
        return s;
    }

    riprap::PairProperties pair(const std::string& laws, const std::string& numbers)
    {
        const demSettings s(read("contact { " + laws + " } pairs { default { " + numbers + " } }"));
        return s.pairs[0].properties;
    }

    std::string said(const std::string& text, double gravity = -10)
    {
        return messageOf([&]() { read(text, gravity); });
    }
}

TEST(ReadSolidLaws, numbersOfEachLaw)
{
    auto p = pair("normal cellSpring; tangential none;", "theta 0.02; alpha 0.3; cellSize 5e-4; "
        "gap 1e-5; attraction yes;");
    EXPECT_EQ(p.theta, 0.02);
    EXPECT_EQ(p.alpha, 0.3);
    EXPECT_EQ(p.cellSize, 5e-4);
    EXPECT_EQ(p.gap, 1e-5);
    EXPECT_TRUE(p.attraction);
    EXPECT_EQ(p.gravity, 10);
    p = pair("normal jkr; tangential history; rolling spring;", "workOfAdhesion 0.05; restitution "
        "0.7; friction 0.4; stiffnessRatio 0.8; tangentialDamping no; rollingFriction 0.1; "
        "rollingDamping 0.2;");
    EXPECT_EQ(p.more.at("workOfAdhesion"), 0.05);
    EXPECT_EQ(p.restitution, 0.7);
    EXPECT_EQ(p.friction, 0.4);
    EXPECT_EQ(p.stiffnessRatio, 0.8);
    EXPECT_FALSE(p.tangentialDamping);
    EXPECT_EQ(p.rollingFriction, 0.1);
    EXPECT_EQ(p.rollingDamping, 0.2);
    // section 6.3.3: E (1 - nu)/((1 + nu)(1 - 2 nu)), and half of it along the surface
    p = pair("normal linear;", "stiffness planeStrain; E 10; nu 0.25; restitution 1; friction 0;");
    EXPECT_NEAR(p.normalStiffness, 12, 1e-13);
    EXPECT_NEAR(p.stiffnessRatio, 0.5, 1e-14);
}

TEST(ReadSolidLaws, numbersOfOtherLaws)
{
    const std::string pairs(
        "pairs { default { restitution 0.9; friction 0.3; stiffness 1e4; E 1; G 2; nu 0.1; "
        "radiusFactor 1; theta 0.01; workOfAdhesion 1; rollingFriction 0; } }");
    EXPECT_EQ(read(pairs).unused, wordList({"E", "G", "nu", "radiusFactor", "rollingFriction",
        "stiffness", "theta", "workOfAdhesion"}));
    EXPECT_EQ(read("contact { normal linear; tangential none; } " + pairs).unused,
        wordList({"E", "G", "friction", "nu", "radiusFactor", "rollingFriction", "theta",
            "workOfAdhesion"}));
    // neither E nor nu where the law has no use for them
    demSettings s;
    const std::string bare("materials { rock { rho 2600; } } ");
    readSolidProperties(entries(bare + "contact { normal linear; }"), s);
    EXPECT_EQ(s.materials[0].elastic.young, 0);
    demSettings hertz;
    EXPECT_TRUE(holds(messageOf([&]() { readSolidProperties(entries(bare), hertz); }),
        "Entry 'E' not found in dictionary"));
}

TEST(ReadSolidLaws, lawsThatAreRefused)
{
    EXPECT_EQ(
        said("contact { normal cellSpring; } pairs { default { cellSize 1; friction 0; } }", 0),
        "Normal law cellSpring takes its stiffness from gravity, and constant/g is zero");
    EXPECT_EQ(said("contact { tangential none; rolling spring; }"),
        "Entry rolling is spring: rolling friction needs friction: with tangential none bodies "
        "slide, and nothing makes them roll; valid are rolling (none), or tangential (history "
        "oneStep)");
    EXPECT_EQ(said("contact { rolling sprin; }"), "Entry rolling has the unknown word sprin; valid "
        "are (none constantTorque spring); did you mean spring?");
    EXPECT_EQ(said("pairs { default { restitution 0; friction 0.1; } }"),
        "Entry restitution is 0: it must be positive");
    EXPECT_TRUE(holds(said("pairs { default { restitution 1.5; friction 0.1; } }"),
        "Entry restitution is 1.5: it must be "));
    EXPECT_TRUE(holds(said("pairs { default { restitution 1; friction 0.1; frction 3; } }"),
        "Unknown entry frction; valid are "));
    EXPECT_EQ(said("contact { withinBonds maybe; }"),
        "Entry withinBonds has the unknown word maybe; valid are (yes no)");
    EXPECT_EQ(said("materials 3;"), "Entry materials must be a dictionary: materials { ... }");
}

TEST(ReadSolidLaws, timeIntegration)
{
    const auto c = read(
        "timeIntegration velocityVerlet; stepFraction 0.1; allowLargeStep yes; skin 0.3; "
        "orientation yes; sleep { speed 1e-3; after 0.5; } contact { withinBonds yes; } guards { "
        "escape stop; maxEscaped 0.2; }")
                       .config;
    EXPECT_EQ(c.integrator, "velocityVerlet");
    EXPECT_EQ(c.stepFraction, 0.1);
    EXPECT_TRUE(c.allowLargeStep && c.orientation && c.contactWithinBonds);
    EXPECT_EQ(c.skin, 0.3);
    EXPECT_EQ(c.sleepSpeed, 1e-3);
    EXPECT_EQ(c.sleepAfter, 0.5);
    EXPECT_LT(read("skin auto;").config.skin, 0);
    EXPECT_EQ(said("skin 0;"), "Entry skin is 0: it must be positive");
    EXPECT_EQ(said("timeIntegration leapfog;"),
        "Entry timeIntegration has the unknown word leapfog; valid are (leapfrog velocityVerlet); "
        "did you mean leapfrog?");
}

TEST(ReadSolidLaws, walls)
{
    const auto w = read(
        "walls { materials { floor rock; \"side.*\" rock; } planes { slope { point (1 2 3); normal "
        "(0 0 1); } } }")
                       .walls;
    ASSERT_EQ(w.materials.size(), 2);
    EXPECT_FALSE(w.materials[0].first().isPattern());
    EXPECT_TRUE(w.materials[1].first().match("sideLeft"));
    EXPECT_TRUE(w.material.empty());
    ASSERT_EQ(w.planes.size(), 1);
    EXPECT_EQ(w.planes[0].first(), "slope");
    EXPECT_EQ(w.planes[0].second().get<vector>("point"), vector(1, 2, 3));
    for (const char* value : {"rock rock", "{ rho 1; }"})
    {
        const std::string entry(std::string("floor ") + value + (*value == '{' ? "" : ";"));
        EXPECT_EQ(said("walls { materials { " + entry + " } }"),
            "Entry floor must be one word, the name of a material");
    }
    EXPECT_EQ(said("walls { materials { floor rok; } }"),
        "Unknown material rok; constant/solidProperties has (rock); did you mean rock?");
    EXPECT_EQ(said("walls { planes { slope 3; } }"), "Entry slope is no dictionary: slope { ... }");
    EXPECT_EQ(said("walls { patchs (); }"), "Unknown entry patchs; valid are (patches material "
        "materials planes motion); did you mean patches?");
}

TEST(ReadSolidLaws, stepOfControlDict)
{
    const auto config = [](const std::string& control)
    {
        ParticleCase c(BoxMesh(), control);
        c.writeDict("constant/solidProperties", rock);
        return readDemSettings(c.mesh()).config;
    };
    auto c = config("deltaT 0.25; adjustTimeStep no;");
    EXPECT_EQ(c.timeStep, 0.25);
    EXPECT_EQ(c.maxTimeStep, 0);
    EXPECT_EQ(c.gravity, (riprap::Vector3{{0, 0, -10}}));
    EXPECT_EQ(c.dimensions, 3);
    c = config("deltaT 0.25; adjustTimeStep yes;");
    EXPECT_EQ(c.timeStep, 0);
    EXPECT_EQ(c.maxTimeStep, 0);
    c = config("deltaT 0.25; adjustTimeStep yes; maxDeltaT 0.1;");
    EXPECT_EQ(c.timeStep, 0);
    EXPECT_EQ(c.maxTimeStep, 0.1);
}
