// SPDX-License-Identifier: GPL-3.0-or-later
/*  Entries of constant/solidProperties that a scene does not need. */

#include "runningSolids.hpp"
#include "solidNeeds.H"
#include "StringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const std::string linear("device cpu; contact { normal linear; tangential none; } ");

    //- A sphere of each of these materials and groups
    struct NeedyCase : RunningSolids
    {
        std::vector<riprap::DemConfig> tried;
        bool same = true;

        explicit NeedyCase(const std::string& properties, const std::vector<int>& materials = {0},
            const char* gravity = "(0 0 -10)", const std::vector<const char*>& groups = {})
        :
            RunningSolids(properties, BoxMesh(), gravity)
        {
            for (std::size_t i = 0; i < materials.size(); ++i)
            {
                add(point(0.2 + 0.2*double(i), 0.5, 0.5), 0.05, Zero, Zero,
                    i < groups.size() ? groups[i] : "free");
                solids.particles.material[i] = materials[i];
            }
        }

        //- What the log has of them, without the heading of entries
        std::string log()
        {
            makeInput();
            sceneNeeds needs;
            const auto pairs = input.pairs.size();
            solidNeeds(needs, settings, input, typeOfBondType, [this](const riprap::DemConfig& c)
            {
                tried.push_back(c);
                modelCost cost;
                cost.same = same;
                return cost;
            });
            EXPECT_EQ(input.pairs.size(), pairs);
            OStringStream os;
            needs.log(os);
            return os.str();
        }
    };

    const std::string none("Entries and models without effect on this scene: none found\n\n"),
        idle("No effect on this scene\n"), on("On, and without effect on this scene\n"),
        costly("On, with an effect below what this scene resolves\n"),
        file("    constant/solidProperties, entry ");

    std::string log(const std::string& properties, const std::vector<int>& materials = {0},
        const char* gravity = "(0 0 -10)", const std::vector<const char*>& groups = {})
    {
        return NeedyCase(properties, materials, gravity, groups).log();
    }
}

TEST(SolidNeeds, nothing)
{
    EXPECT_EQ(log(linear + "materials { a { rho 1; } } walls { material a; } pairs { a-a { "
                           "stiffness 1e4; restitution 1; } }"),
        none);
}

TEST(SolidNeeds, materialsAndPairs)
{
    const std::string three("materials { a { rho 1000; } b { rho 1000; } c { rho 1000; } } ");
    const auto pair = [](const std::string& name, const char* k)
    { return name + " { stiffness " + k + "; restitution 1; } "; };
    // nobody is of c; b is of walls alone
    EXPECT_EQ(log(linear + three + "walls { material b; } pairs { " + pair("a-a", "1e4")
            + pair("a-b", "1e4") + pair("b-b", "1e3") + pair("c-a", "1e4") + "}"),
        idle + file + "materials/c: no solid and no wall is of this material\n" + file
            + "pairs/b-b: no solid of one meets a solid or wall of the other\n" + file
            + "pairs/c-a: no solid of one meets a solid or wall of the other\n\n");
    // default is what all pairs have
    EXPECT_EQ(log(linear + three + "walls { material c; } pairs { " + pair("default", "1e4") + "}",
        {0, 1}), none);
    EXPECT_EQ(log(linear + "materials { a { rho 1000; } } walls { material a; } pairs { "
            + pair("a-a", "1e4") + pair("default", "1e4") + "}"),
        idle + file + "pairs/default: all pairs that can meet have entries of their own\n\n");
}

//- A pair that nobody needs and that sets the step: 0.2 sqrt(m/k), m = 0.10472 kg
TEST(SolidNeeds, stiffnessThatSetsTheStep)
{
    const std::string why(", but its stiffness sets the time step: 6.47e-05 s, and 0.000647 s "
                          "without it\n");
    EXPECT_EQ(log(linear
                + "materials { a { rho 200; } b { rho 1; } c { rho 1; } } walls { material b; } "
                  "pairs { default { stiffness 1e4; restitution 1; } c-a { stiffness 1e6; "
                  "restitution 1; } }"),
        costly + file + "materials/c: no solid and no wall is of this material" + why + file
            + "pairs/c-a: no solid of one meets a solid or wall of the other" + why + "\n");
}

//- A gap decides how far neighbours are sought: no claim
TEST(SolidNeeds, gapOfAPair)
{
    EXPECT_EQ(log(linear
                + "materials { a { rho 200; } b { rho 1; } } walls { material b; } pairs { a-b { "
                  "stiffness 1e4; restitution 1; } a-a { stiffness 1e4; restitution 1; } b-b { "
                  "stiffness 1e4; restitution 1; gap 0.01; } }"),
        none);
}

TEST(SolidNeeds, numbersOfOtherLaws)
{
    EXPECT_EQ(
        log(linear
            + "materials { a { rho 1; E 1e6; } } walls { material a; } pairs { a-a { stiffness "
              "1e4; restitution 1; friction 0.3; G 4; } }"),
        idle + file
            + "materials/a/E: contacts of normal law linear take their stiffness from pairs\n"
            + file + "pairs/a-a/G: the stiffness is no calibration\n" + file
            + "pairs/a-a/friction: it is of a law that is not chosen\n\n");
    // of a stiffness that is calibrated they are its own
    EXPECT_EQ(log(linear
                + "materials { a { rho 1; } } walls { material a; } pairs { a-a { stiffness "
                  "moduli; E 1e4; G 1e4; restitution 1; } }"),
        none);
}

TEST(SolidNeeds, groupsAndGuards)
{
    const std::string text(
        "groups { base { fixed all; viscousDamping 1; gravity no; } light { "
        "gravity no; fixed (x y z); viscousSpinDamping 1; } none { gravity no; } "
        "lid { motion { solidBodyMotionFunction linearMotion; velocity (0 0 1); } "
        "} } guards { escape stop; maxEscaped 0.5; } contact { normal linear; "
        "tangential none; withinBonds yes; } device cpu; materials { rock { rho "
        "1000; } } pairs { default { stiffness 1e5; restitution 1; } } walls { "
        "material rock; } bonds { glue { normalStiffness 1; shearStiffness 1; } "
        "}");
    const std::string always(file + "groups/none: no solid is in this group\n" + file
        + "guards/maxEscaped: guards/escape is stop\n");
    EXPECT_EQ(log(text, {0, 0}, "(0 0 -10)", {"base", "light"}),
        idle + file + "bonds/glue: there are no such bonds\n" + file
            + "contact/withinBonds: there are no bonds\n" + file
            + "groups/base/viscousDamping: its solids are fixed\n" + always + "\n");
    EXPECT_EQ(log(text, {0, 0}, "(0 0 0)", {"base", "light"}),
        idle + file + "bonds/glue: there are no such bonds\n" + file
            + "contact/withinBonds: there are no bonds\n" + file
            + "groups/base/gravity: constant/g is zero\n" + file
            + "groups/base/viscousDamping: its solids are fixed\n" + file
            + "groups/light/gravity: constant/g is zero\n" + always + "\n");
}

TEST(SolidNeeds, bondsOfTwoKinds)
{
    NeedyCase c(
        rock("bonds { glue { normalStiffness 1e7; shearStiffness 1e7; } rubber { calibration "
             "moduli; E 1e6; G 1e6; } }"),
        {0, 0, 0});
    c.bond(0, 1);
    c.bond(1, 2);
    c.solids.bonds.type = {1, 1};
    const std::string text(c.log());
    EXPECT_TRUE(holds(text, file + "bonds/glue: there are no such bonds\n")) << text;
    EXPECT_FALSE(holds(text, "rubber")) << text;
}

//- Friction and rolling that are 0 in all pairs that can meet
TEST(SolidNeeds, lawsThatDoNothing)
{
    const auto properties = [](const char* friction, const char* rolling)
    {
        return rock("", "",
            std::string("stiffness 1e5; restitution 1; friction ") + friction + "; rollingFriction "
                + rolling + ";",
            "normal linear; tangential history; rolling constantTorque;");
    };
    const std::string materials(idle + file
        + "materials/rock/E: contacts of normal law linear take their stiffness from pairs\n");
    NeedyCase both(properties("0", "0"));
    EXPECT_EQ(both.log(),
        materials + on + file
            + "contact/rolling: rollingFriction is 0 in all pairs that can meet; `rolling none` "
              "does "
              "the same\n"
            + file
            + "contact/tangential: friction is 0 in all pairs that can meet, and rolling does "
              "nothing; `tangential none` does the same\n\n");
    ASSERT_EQ(both.tried.size(), 2u);
    EXPECT_EQ(both.tried[0].rolling, "none");
    EXPECT_EQ(both.tried[0].tangential, "history");
    EXPECT_EQ(both.tried[1].tangential, "none");
    // one that comes out otherwise makes no claim
    NeedyCase others(properties("0", "0"));
    others.same = false;
    EXPECT_EQ(others.log(), materials + "\n");
    NeedyCase slides(properties("0.1", "0"));
    EXPECT_TRUE(holds(slides.log(), "`rolling none`"));
    EXPECT_EQ(slides.tried.size(), 1u);
    // bodies that slide may still be kept from rolling
    NeedyCase rolls(properties("0", "0.1"));
    EXPECT_EQ(rolls.log(), materials + "\n");
    EXPECT_TRUE(rolls.tried.empty());
}
