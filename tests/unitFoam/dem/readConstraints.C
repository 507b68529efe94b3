// SPDX-License-Identifier: GPL-3.0-or-later
/*  Constraints, springs and moorings of a group: what each entry means in 3D and 2D, which exclude
    each other. */

#include "readSolidProperties.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    using riprap::RotationKind;
    using riprap::TranslationKind;
    using riprap::Vector3;

    //- The group a of a case in space, or in the plane of x and z
    riprap::DemGroup read(const std::string& text, bool planar = false)
    {
        demSettings s;
        if (planar)
        {
            s.config.dimensions = 2;
            s.config.axes[1] = 2;
            s.config.axes[2] = 1;
        }
        readSolidProperties(entries("materials { rock { rho 2600; E 1e7; nu 0.2; } } groups { a { "
                                + text + " } }"), s);
        return s.groups[1].group;
    }

    riprap::DemConstraint constraint(const std::string& text, bool planar = false)
    {
        return read("constrain { " + text + " }", planar).constraint;
    }

    std::string said(const std::string& text, bool planar = false)
    {
        return messageOf([&]() { read(text, planar); });
    }

    std::string constrainSaid(const std::string& text, bool planar = false)
    {
        return said("constrain { " + text + " }", planar);
    }
}

TEST(ReadConstraints, translationAndRotation)
{
    EXPECT_FALSE(read("").constraint.any());
    auto c = constraint("line (0 0 2); orientation fixed;");
    EXPECT_EQ(c.translation, TranslationKind::line);
    EXPECT_EQ(c.direction, (Vector3{{0, 0, 2}}));
    EXPECT_EQ(c.rotation, RotationKind::none);
    EXPECT_FALSE(c.hinge);
    c = constraint("plane (0 3 0);");
    EXPECT_EQ(c.translation, TranslationKind::plane);
    EXPECT_EQ(c.direction, (Vector3{{0, 3, 0}}));
    EXPECT_EQ(c.rotation, RotationKind::free);
    c = constraint("axis (1 1 0); position fixed;");
    EXPECT_EQ(c.translation, TranslationKind::none);
    EXPECT_EQ(c.rotation, RotationKind::axis);
    EXPECT_EQ(c.axis, (Vector3{{1, 1, 0}}));
    // words that leave it free
    c = constraint("orientation free; position free; line (1 0 0);");
    EXPECT_EQ(c.translation, TranslationKind::line);
    EXPECT_EQ(c.rotation, RotationKind::free);
}

TEST(ReadConstraints, hinges)
{
    auto c = constraint("hinge { point (0 0 0.1); axis (0 2 0); }");
    EXPECT_TRUE(c.hinge && c.any());
    EXPECT_EQ(c.point, (Vector3{{0, 0, 0.1}}));
    EXPECT_EQ(c.axis, (Vector3{{0, 2, 0}}));
    EXPECT_EQ(c.translation, TranslationKind::free);
    // in 2D about the empty direction, whether it is said or not
    for (const char* axis : {"", "axis (0 1 0); ", "axis (0 -4 0); "})
    {
        c = constraint(std::string("hinge { point (1 2 3); ") + axis + "}", true);
        EXPECT_TRUE(c.hinge);
        EXPECT_EQ(c.axis, (Vector3{{0, 1, 0}}));
    }
    EXPECT_EQ(constraint("axis (0 5 0);", true).axis, (Vector3{{0, 1, 0}}));
}

TEST(ReadConstraints, springsAndMoorings)
{
    const auto g = read(
        "springs { coil { anchor (0 0 1); point (0 0 0.2); stiffness 100; damping 2; restLength "
        "0.6; } bare { anchor (1 2 3); point (4 5 6); stiffness 7; } } moorings { west { anchor "
        "(-2 0 -1); point (-0.1 0 0); stiffness 5e3; length 2.2; } }");
    ASSERT_EQ(g.springs.size(), std::size_t(3));
    const auto expectSpring = [&](int i, const char* name, const Vector3& anchor,
                                  const Vector3& point, const std::array<double, 3>& numbers,
                                  bool slack)
    {
        const riprap::DemSpring& s = g.springs[i];
        EXPECT_EQ(s.name, name);
        EXPECT_EQ(s.anchor, anchor);
        EXPECT_EQ(s.point, point);
        EXPECT_EQ(s.stiffness, numbers[0]);
        EXPECT_EQ(s.damping, numbers[1]);
        EXPECT_EQ(s.length, numbers[2]);
        EXPECT_EQ(s.slack, slack);
    };
    expectSpring(0, "coil", {{0, 0, 1}}, {{0, 0, 0.2}}, {100, 2, 0.6}, false);
    expectSpring(1, "bare", {{1, 2, 3}}, {{4, 5, 6}}, {7, 0, 0}, false);
    expectSpring(2, "west", {{-2, 0, -1}}, {{-0.1, 0, 0}}, {5e3, 0, 2.2}, true);
}

TEST(ReadConstraints, whatExcludesEachOther)
{
    const auto both = [](const std::string& a, const std::string& b)
    {
        return "Entries " + a + " and " + b + " of constrain exclude each other";
    };
    EXPECT_EQ(constrainSaid("line (0 0 1); plane (0 1 0);"), both("line", "plane"));
    EXPECT_EQ(constrainSaid("axis (0 0 1); orientation fixed;"), both("axis", "orientation"));
    EXPECT_EQ(constrainSaid("position fixed; line (0 0 1);"), both("position", "line"));
    EXPECT_EQ(constrainSaid("position fixed; plane (0 0 1);"), both("position", "plane"));
    const std::string hinge("hinge { point (0 0 0); axis (0 1 0); } ");
    EXPECT_EQ(constrainSaid(hinge + "position fixed;"), both("position", "hinge"));
    EXPECT_EQ(constrainSaid(hinge + "line (0 0 1);"), both("hinge", "line"));
    EXPECT_EQ(constrainSaid(hinge + "plane (0 0 1);"), both("hinge", "plane"));
    EXPECT_EQ(constrainSaid(hinge + "axis (0 0 1);"), both("hinge", "axis"));
    EXPECT_EQ(constrainSaid(hinge + "orientation fixed;"), both("hinge", "orientation"));
    EXPECT_EQ(said("fixed all; constrain { line (0 0 1); }"),
        "Group a has both entries constrain and fixed");
    EXPECT_EQ(said("constrain { line (0 0 1); } motion { solidBodyMotionFunction linearMotion; "
                   "velocity (1 0 0); }"), "Group a has both entries constrain and motion");
}

TEST(ReadConstraints, whatIsRefused)
{
    EXPECT_EQ(constrainSaid(""), "Entry constrain constrains nothing; valid are (line plane "
                                 "position axis orientation hinge)");
    EXPECT_EQ(constrainSaid("orientation free; position free;"), constrainSaid(""));
    EXPECT_EQ(constrainSaid("line (0 0 0);"), "Entry line is (0 0 0): it needs a length");
    EXPECT_EQ(constrainSaid("axis (0 0 0);"), "Entry axis is (0 0 0): it needs a length");
    EXPECT_EQ(constrainSaid("plane (0 1 0);", true),
        "Entry plane is (0 1 0): it needs a length in the plane of this 2D case");
    EXPECT_EQ(constrainSaid("axis (0 1 1);", true), "Entry axis is (0 1 1): bodies of this 2D case "
        "turn about its empty direction, valid is (0 1 0)");
    EXPECT_EQ(constrainSaid("axis (1 1 0);", true), "Entry axis is (1 1 0): bodies of this 2D case "
        "turn about its empty direction, valid is (0 1 0)");
    EXPECT_EQ(constrainSaid("hinge { point (0 0 0); axis (0 0 0); }", true),
        "Entry axis is (0 0 0): bodies of this 2D case turn about its empty direction, valid is (0 "
        "1 0)");
    EXPECT_EQ(constrainSaid("orientation held;"),
        "Entry orientation has the unknown word held; valid are (fixed free)");
    EXPECT_EQ(constrainSaid("lines (0 0 1);"), "Unknown entry lines; valid are (hinge line plane "
        "axis orientation position); did you mean line?");
    EXPECT_TRUE(holds(constrainSaid("hinge { point (0 0 0); axis (0 0 1); angle 3; }"),
        "Unknown entry angle; valid are (point axis)"));
    EXPECT_TRUE(
        holds(constrainSaid("hinge { point (0 0 0); }"), "Entry 'axis' not found in dictionary"));
    EXPECT_EQ(said("constrain 3;"), "Entry constrain must be a dictionary: constrain { ... }");
    const auto spring = [](const std::string& more)
    { return said("springs { s { anchor (0 0 1); point (0 0 0); " + more + " } }"); };
    EXPECT_EQ(spring("stiffness 0;"), "Entry stiffness is 0: it must be positive");
    EXPECT_EQ(
        spring("stiffness 1; damping -1;"), "Entry damping is -1: it must be zero or positive");
    EXPECT_TRUE(holds(spring("stiffness 1; length 2;"), "Unknown entry length; valid are (anchor "
        "point stiffness damping restLength)"));
    EXPECT_EQ(said("springs { s 3; }"), "Entry s is no dictionary: s { ... }");
    EXPECT_EQ(said("moorings { m { anchor (0 0 1); point (0 0 0); stiffness 1; length 0; } }"),
        "Entry length is 0: it must be positive");
}
