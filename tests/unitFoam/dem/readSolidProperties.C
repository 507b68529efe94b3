// SPDX-License-Identifier: GPL-3.0-or-later
/*  constant/solidProperties: what is valid, defaults, and messages. */

#include "dem/bond/bondRadius.hpp"
#include "dem/motion/integrators.hpp"
#include "modelFamily.hpp"
#include "readSolidProperties.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string rock("materials { rock { rho 2600; E 1e7; nu 0.2; } } ");

    demSettings read(const std::string& text)
    {
        demSettings s;
        s.config.gravity = {{0, 0, -10}};
        readSolidProperties(entries(text), s);
        return s;
    }

    std::string said(const std::string& text) { return messageOf([&]() { read(text); }); }
}

TEST(ReadSolidProperties, defaults)
{
    const riprap::DemConfig otherwise;
    const demSettings s(read(rock));
    EXPECT_EQ(s.config.normal, otherwise.normal);
    EXPECT_EQ(s.config.integrator, otherwise.integrator);
    EXPECT_EQ(s.config.sleepAfter, 0);
    EXPECT_EQ(s.materialNames(), wordList({"rock"}));
    EXPECT_EQ(s.materials[0].density, 2600);
    EXPECT_EQ(s.groupNames(), wordList({"free"}));
    EXPECT_TRUE(s.pairs.empty());
    EXPECT_TRUE(s.walls.everyWallPatch);
    EXPECT_TRUE(s.unused.empty());
    EXPECT_EQ(s.guards.allowed(), 0.01);
}

TEST(ReadSolidProperties, materialsAndPairs)
{
    const std::string two("materials { a { rho 1; E 2e6; nu 0.3; } b { rho 2; E 3e6; nu 0.1; } } ");
    const std::string law("contact { normal linear; tangential none; } ");
    const demSettings s(read(two + law
        + "pairs { a-b { stiffness 5; restitution 0.5; friction 0.7; } "
          "default { stiffness 9; restitution 0.9; } }"));
    ASSERT_EQ(s.pairs.size(), 3);
    EXPECT_EQ(s.pairs[0].a, 0);
    EXPECT_EQ(s.pairs[0].b, 1);
    EXPECT_EQ(s.pairs[0].properties.normalStiffness, 5);
    EXPECT_EQ(s.pairs[1].properties.normalStiffness, 9);
    EXPECT_EQ(s.unused, wordList({"friction"}));
    EXPECT_EQ(s.material("b", s.dict), 1);
    EXPECT_EQ(messageOf([&]() { s.material("aa", dictionary()); }),
        "Unknown material aa; constant/solidProperties has (a b)");
    EXPECT_EQ(said(two + law + "pairs { a-b { stiffness 5; restitution 1; } "
                               "b-a { stiffness 5; restitution 1; } }"),
        "Entry b-a: this pair is there twice");
    EXPECT_EQ(said(two + law + "pairs { a { } }"),
        "Entry a names no pair: <material>-<material>, or default; materials are (a b)");
    EXPECT_EQ(said(two + law + "pairs { a-b { stiffness modulus; } }"),
        "Entry stiffness has the unknown word modulus; valid are (<number> moduli planeStrain); "
        "did you mean moduli?");
    EXPECT_EQ(said("contact { normal hertz; }"),
        "Entry materials is missing or empty: materials { <name> { rho ..; E ..; nu ..; } }");
    EXPECT_TRUE(holds(said("materials { a-b { rho 1; } }"), "Material a-b cannot be named so"));
    EXPECT_EQ(said("materials { a 1; }"), "Entry a is no dictionary: a { ... }");
}

//- Eqs. 42, 43 of moduli; section 6.3.3 of plane strain
TEST(ReadSolidProperties, calibrations)
{
    const dictionary dict(entries("E 10; G 4; nu 0.25;"));
    checkedDictionary checked(dict);
    const auto column = readCalibration(checked, riprap::calibrationOf("moduli"));
    EXPECT_EQ(column.normal, 10);
    EXPECT_EQ(column.shear, 4);
    const auto plate = readCalibration(checked, riprap::calibrationOf("planeStrain"));
    EXPECT_NEAR(plate.normal, 10*0.75/(1.25*0.5), 1e-14);
    EXPECT_NEAR(plate.shear, 0.5*plate.normal, 1e-14);
    const demSettings s(read(rock + "contact { normal linear; tangential none; } pairs { "
        "rock-rock { stiffness moduli; E 10; G 4; radiusFactor 2; restitution 1; } }"));
    EXPECT_EQ(s.pairs[0].properties.normalStiffness, 20);
    EXPECT_EQ(s.pairs[0].properties.stiffnessRatio, 0.4);
}

TEST(ReadSolidProperties, groups)
{
    const demSettings s(read(rock + "groups { base { fixed all; } slider { fixed (y spin); gravity "
        "no; force (1 2 3); sharedForce (0 0 9); localDamping 0.7; } paddle { motion { "
        "solidBodyMotionFunction linearMotion; velocity (1 0 0); } } }"));
    EXPECT_EQ(s.groupNames(), wordList({"free", "base", "slider", "paddle"}));
    const riprap::DemGroup &base = s.groups[1].group, &slider = s.groups[2].group;
    for (int d = 0; d < 3; ++d)
    {
        EXPECT_TRUE(base.held[d]);
        EXPECT_EQ(slider.held[d], d == 1);
        EXPECT_EQ(slider.force[d], d + 1);
    }
    EXPECT_TRUE(base.heldSpin && slider.heldSpin);
    EXPECT_FALSE(slider.gravity);
    EXPECT_EQ(slider.localDamping, 0.7);
    EXPECT_EQ(s.groups[2].sharedForce, vector(0, 0, 9));
    EXPECT_TRUE(s.groups[3].moves);
    ASSERT_EQ(s.groupMotion.size(), 1);
    EXPECT_EQ(s.groupMotion[0].name, "paddle");
    const auto of = [](const std::string& g) { return said(rock + "groups { a { " + g + " } }"); };
    EXPECT_EQ(of("fixed some;"),
        "Entry fixed has the unknown word some; valid are (all none (x y z "
        "spin))");
    EXPECT_TRUE(holds(of("fixed (x w);"), "Entry fixed has the unknown word w; valid are (x y z "
                                          "spin)"));
    EXPECT_EQ(of("localDamping 1;"), "Entry localDamping is 1: it must be less than 1");
    EXPECT_EQ(of("fixed all; motion { solidBodyMotionFunction linearMotion; velocity (1 0 0); }"),
        "Group a has both entries fixed and motion");
}

TEST(ReadSolidProperties, bondsAndWalls)
{
    const demSettings s(read(rock
        + "bonds { glue { normalStiffness 2; shearStiffness 1; "
          "tensileStrength none; shearStrength 5; } rubber { calibration planeStrain; E 10; nu 0; "
          "} } "
          "walls { patches (\"w.*\"); material rock; materials { floor rock; } }"));
    EXPECT_EQ(s.bondNames(), wordList({"glue", "rubber"}));
    const riprap::DemBondType none;
    EXPECT_EQ(s.bondTypes[0].type.tensileStrength, none.tensileStrength);
    EXPECT_EQ(s.bondTypes[0].type.shearStrength, 5);
    EXPECT_NEAR(s.bondTypes[1].type.normalStiffness, 10, 1e-14);
    EXPECT_FALSE(s.walls.everyWallPatch);
    EXPECT_TRUE(s.walls.patches.match("west"));
    EXPECT_EQ(s.walls.materials[0].second(), "rock");
    EXPECT_EQ(said(rock + "walls { material rok; }"),
        "Unknown material rok; constant/solidProperties has (rock); did you mean rock?");
    EXPECT_EQ(
        said(rock + "bonds { a { normalStiffness 1; shearStiffness 1; tensileStrength nome; } }"),
        "Entry tensileStrength has the unknown word nome; valid are (none <number>); did you mean "
        "none?");
}

TEST(ReadSolidProperties, whatIsRefused)
{
    EXPECT_TRUE(holds(said(rock + "contact { normal herz; }"), "did you mean hertz?"));
    EXPECT_EQ(said(rock + "sleep { after 2; }"),
        "Entry after is the time after which solids sleep that are slower than speed, which is "
        "missing or 0; valid is a positive speed");
    EXPECT_TRUE(holds(said(rock + "stepFracton 0.1;"), "Unknown entry stepFracton; valid are"));
    EXPECT_TRUE(holds(said(rock + "stepFracton 0.1;"), "did you mean stepFraction?"));
    EXPECT_EQ(said(rock + "stepFraction 0;"), "Entry stepFraction is 0: it must be positive");
    EXPECT_TRUE(holds(said(rock + "guards { escap stop; }"), "did you mean escape?"));
}

//- Of every family of models that a word chooses, besides the contact laws
TEST(ReadSolidProperties, families)
{
    using namespace riprap;
    const auto whole = [](const std::string& s) { return rock + s; };
    ModelFamily{"timeIntegration", wordsOf<DemIntegrators>(), whole,
        [](const std::string& s) { return read(s).config.integrator; }}.expectWords();

    const auto bond = [](const std::string& more)
    {
        return [more](const std::string& s)
        { return rock + "bonds { glue { " + more + s + " } }"; };
    };
    ModelFamily{"radius", wordsOf<BondRadii>(), bond("normalStiffness 1; shearStiffness 1; "),
        [](const std::string& s) { return read(s).bondTypes[0].type.radiusKind; }}.expectWords();

    const ModelFamily family{"calibration", wordsOf(calibrations()), bond(""),
        [](const std::string& s) { return read(s).bondTypes[0].calibration; }};
    family.expectWords([](const std::string& word)
    {
        std::string s;
        for (const CalibrationEntry& e : calibrationOf(word).entries)
            s += std::string(e.name) + " " + std::to_string(e.typical) + "; ";
        return s;
    });
    for (const CalibrationCard& c : calibrations()) family.expectEntries(c.word, c.entries);
}
