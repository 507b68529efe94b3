// SPDX-License-Identifier: GPL-3.0-or-later
/*  The dictionaries of a PIC case: defaults, zones and openings, messages. */

#include "modelFamily.hpp"
#include "particleCase.hpp"
#include "pic/openings/kinds.hpp"
#include "pic/terms/viscousSchemes.hpp"
#include "picDictionaries.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    struct PicCase : ParticleCase
    {
        explicit PicCase(int D = 3, const std::string& control = "deltaT 1e-3;")
        :
            ParticleCase(boxOf(D), control)
        {}

        static BoxMesh boxOf(int D)
        {
            BoxMesh box;
            box.divide(0, 0, 2, 4);
            box.divide(1, 0, 0.5, 1);
            box.divide(2, 0, 1, 2);
            if (D == 2) box.sides(1, "empty");
            box.type[0] = box.type[5] = "patch";
            return box;
        }

        picSettings settings(const std::string& text)
        {
            writeDict("constant/picProperties", text);
            return readPicSettings(mesh());
        }

        std::string said(const std::string& text)
        {
            return messageOf([&]() { settings(text); });
        }
    };
}

TEST(PicSettings, defaults)
{
    PicCase c;
    const riprap::PicConfig otherwise;
    const picSettings s(c.settings(""));
    EXPECT_EQ(s.config.transfer, otherwise.transfer);
    EXPECT_EQ(s.config.splineOrder, otherwise.splineOrder);
    EXPECT_EQ(s.config.advectionOrder, 3);
    EXPECT_EQ(s.config.reflection, 1);
    EXPECT_EQ(s.config.maxCourant, 0.5);
    EXPECT_EQ(s.config.fixedTimeStep, 1e-3);
    EXPECT_FALSE(s.config.adjustTimeStep);
    EXPECT_FALSE(s.config.noSlip);
    EXPECT_EQ(s.contactVelocity, 1);
    EXPECT_FALSE(s.weak);
    EXPECT_TRUE(s.config.openings.empty());
    const picSettings t(c.settings("advection RungeKutta2; reflection no; spline cubic; "
                                   "positionCorrection none; viscosity none; coupling weak; "
                                   "seeds { perDirection 3; jitter 0.5; } walls { slip noSlip; "
                                   "velocity { zMin (1 0 0); } }"));
    EXPECT_EQ(t.config.advectionOrder, 2);
    EXPECT_EQ(t.config.reflection, 0);
    EXPECT_EQ(t.config.splineOrder, 3);
    EXPECT_EQ(t.config.positionCorrection, 0);
    EXPECT_EQ(t.config.viscosity, 0);
    EXPECT_TRUE(t.weak);
    EXPECT_EQ(t.config.seedsPerDirection, 3);
    EXPECT_EQ(t.config.slide[2][0][0], 1);
}

TEST(PicSettings, whatIsRefused)
{
    PicCase c;
    EXPECT_EQ(c.said("spline cubc;"), "Entry spline has the unknown word cubc; valid are (linear "
                                      "quadratic cubic); did you mean cubic?");
    EXPECT_EQ(c.said("seeds { perDirection 1.5; }"),
        "Entry perDirection is 1.5: it must be a whole number; 0 takes the particles as they are");
    EXPECT_TRUE(holds(c.said("seeds { perDirection 9; }"), "Entry perDirection is 9"));
    EXPECT_TRUE(holds(c.said("contactVelocity 2;"), "Entry contactVelocity is 2"));
    EXPECT_TRUE(holds(c.said("reflexion no;"), "did you mean reflection?"));
    EXPECT_EQ(c.said("walls { velocity { zMin (1 0 0); } }"),
        "A wall that slides needs `slip noSlip;`");
}

TEST(PicSettings, multirate)
{
    PicCase c;
    EXPECT_EQ(c.settings("").config.slowInterval, 1);
    EXPECT_EQ(c.settings("multirate {}").config.slowInterval, 10);
    EXPECT_EQ(c.settings("multirate {}").config.slowCourant, 0.25);
    const picSettings s(c.settings("multirate { interval 4; maxCo 0.1; }"));
    EXPECT_EQ(s.config.slowInterval, 4);
    EXPECT_EQ(s.config.slowCourant, 0.1);
    EXPECT_TRUE(holds(c.said("multirate { interval 1; }"), "Entry interval is 1"));
    EXPECT_TRUE(holds(c.said("multirate { interval 2.5; }"), "Entry interval is 2.5"));
    EXPECT_TRUE(holds(c.said("multirate { maxCo 0.6; }"), "Entry maxCo is 0.6"));
    EXPECT_TRUE(holds(c.said("multirate { maxco 0.1; }"), "did you mean maxCo?"));
    EXPECT_TRUE(holds(c.said("multirate yes;"), "Entry multirate must be a dictionary"));
}

//- Zones that absorb nothing, or lie beyond the mesh, are not kept
TEST(PicSettings, absorbingZones)
{
    PicCase c(2);
    const auto zones = [&](const std::string& text)
    { return c.settings("absorb { " + text + " }").config.absorbers; };
    const auto kept = zones(
        "a { from (1.5 0 0); to (2 0 0); rate 3; } b { from (1 0 0); to (2 0 0); "
        "rate 0; } c { from (2.5 0 0); to (3 0 0); rate 1; } "
        "d { from (0.5 0 0); to (0 9 0); rate 1; }");
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].name, "a");
    EXPECT_EQ(kept[0].rate, 3);
    EXPECT_EQ(kept[0].from[0], 1.5);
    EXPECT_EQ(kept[1].name, "d");
    EXPECT_EQ(c.said("absorb { a { to (1 0 0); } }"),
        "Zone a needs from, a point: where it begins");
    EXPECT_EQ(c.said("absorb { a { from (1 0 0); to (1 3 0); rate 1; } }"),
        "Zone a begins and ends at the same place: from and to must differ along a solved "
        "direction");
    EXPECT_EQ(c.said("absorb { a 1; }"),
        "Entry a must be a dictionary with from, to and rate: a zone that absorbs waves");
}

TEST(PicSettings, openings)
{
    PicCase c(2);
    const picSettings s(
        c.settings("openings { xMin { type flowRate; flowRate table ((0 0) (2 0.5)); "
                   "level 0.4; } zMax { type velocity; velocity (0 0 -1); } }"));
    ASSERT_EQ(s.config.openings.size(), 2u);
    const auto& river = s.config.openings[0];
    EXPECT_EQ(river.name, "xMin");
    // through 0.5 m of depth: per metre
    EXPECT_NEAR(river.flowRate(1), 0.25/0.5, 1e-14);
    EXPECT_NEAR(river.flowRate(2), 0.5/0.5, 1e-14);
    EXPECT_EQ(river.level(1), 0.4);
    EXPECT_EQ(s.config.openings[1].velocity(0), (riprap::Vector3{{0, 0, -1}}));

    const auto of = [&](const std::string& text) { return c.said("openings { " + text + " }"); };
    EXPECT_EQ(of("zMin { type level; level 1; }"),
        "There is no patch zMin of type patch; the mesh has (xMin zMax); did you mean xMin?");
    EXPECT_EQ(of("xMin { level 1; }"),
        "Opening xMin needs a type, one of (velocity flowRate level)");
    EXPECT_EQ(of("xMin { type velocity; }"), "Opening xMin needs velocity, a vector [m/s]");
    EXPECT_EQ(of("xMin { type velocity; velocity (2000 0 0); }"),
        "Opening xMin: entry velocity means a speed of 2000 m/s, above that of sound in water");
    EXPECT_EQ(of("xMin { type flowRate; flowRate 1000; }"),
        "Opening xMin: entry flowRate means a speed of 2000 m/s, above that of sound in water");
    EXPECT_TRUE(holds(of("xMin { type level; level 1e5; }"),
        "Opening xMin: entry level reaches 100000 m, more than 100 times the size of the mesh"));
    EXPECT_EQ(of("xMin 1;"),
        "Entry xMin must be a dictionary: a patch through which water comes and goes");
}

//- Of every family of models that a word chooses, besides the transfers
TEST(PicSettings, families)
{
    using namespace riprap;
    PicCase c;
    ModelFamily{"viscosity", wordsOf<ViscousSchemes>(), [](const std::string& s) { return s; },
        [&](const std::string& s) { return c.settings(s).config.viscousScheme; }}.expectWords();
    for (const ViscousScheme& scheme : cardsOf<ViscousScheme, ViscousSchemes>())
    {
        const auto s = c.settings(std::string("viscosity ") + scheme.word + ";");
        EXPECT_EQ(s.config.viscosity > 0, scheme.acts) << scheme.word;
    }

    ModelFamily{"type", wordsOf<OpeningKinds>(),
        [](const std::string& s) { return "openings { xMin { " + s + " } }"; },
        [&](const std::string& s)
        { return c.settings(s).config.openings.at(0).kind; }}.expectWords(
        [](const std::string& word)
        { return word + (word == "velocity" ? " (1 0 0);" : " 0.1;"); });
}
