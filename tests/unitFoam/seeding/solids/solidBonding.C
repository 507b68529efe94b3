// SPDX-License-Identifier: GPL-3.0-or-later
/*  Bonds between particles of groups: their number, ends, types and gaps; what is refused. */

#include "solidRegionCase.hpp"

#include <algorithm>
#include <set>

using namespace Foam;

namespace
{
    struct BondCase : SolidRegionCase
    {
        BondCase()
        :
            SolidRegionCase(BoxMesh(), std::string(rock) + "groups { left { } right { } } bonds { "
                "glue { normalStiffness 2; shearStiffness 1; } steel { normalStiffness 20; "
                "shearStiffness 10; } }")
        {}

        //- Lattices of 3 x 4 x 2 and of 2 x 4 x 2 with spacing 0.1, side by side, `gap` apart
        List<solidRegion> blocks(double gap = 0) const
        {
            return regions("a { set solids; source box; box (0 0 0) (0.3 0.4 0.2); spacing 0.1; "
                           "group left; } b { set solids; source box; box ("
                + std::to_string(0.3 + gap) + " 0 0) (" + std::to_string(0.5 + gap)
                + " 0.4 0.2); spacing 0.1; group right; }");
        }

        riprap::DemBondState bonds(const std::string& list, double gap = 0) const
        {
            return bondSolids(entries("bonds (" + list + ");"), joined(blocks(gap)), *settings);
        }

        std::string bondsSaid(const std::string& list) const
        {
            return messageOf([&]() { bonds(list); });
        }
    };

    const std::string within("n { type glue; groups (left); gapTolerance 1e-6; } ");
    // neighbours along each axis
    const int ofLeft = 2*4*2 + 3*3*2 + 3*4*1, ofRight = 1*4*2 + 2*3*2 + 2*4*1, across = 4*2;
}

TEST(SolidBonding, neighboursOfALattice)
{
    const BondCase c;
    const auto b = c.bonds(within);
    ASSERT_EQ(b.a.size(), std::size_t(ofLeft));
    const solidSet all(joined(c.blocks()));
    std::set<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < b.a.size(); ++i)
    {
        EXPECT_LT(b.a[i], b.b[i]);
        EXPECT_LT(b.b[i], 24);
        EXPECT_TRUE(pairs.insert({b.a[i], b.b[i]}).second);
        double apart = 0;
        for (int d = 0; d < 3; ++d)
            apart += std::pow(all.particles.position[3*b.a[i] + d]
                    - all.particles.position[3*b.b[i] + d], 2);
        EXPECT_NEAR(std::sqrt(apart), 0.1, 1e-12);
        EXPECT_NEAR(b.restGap[i], 0, 1e-12);
        EXPECT_EQ(b.type[i], 0);
        EXPECT_EQ(b.broken[i], 0);
    }
    EXPECT_TRUE(bondSolids(dictionary(), all, *c.settings).a.empty());
}

TEST(SolidBonding, diagonalsWithinTheTolerance)
{
    const BondCase c;
    // 0.1 sqrt(2) - 0.1 in the planes, 0.1 sqrt(3) - 0.1 in space
    const int flat = 2*(2*3*2 + 2*4*1 + 3*3*1), space = 4*2*3*1;
    const auto text = [](double tolerance)
    {
        return "n { type glue; groups (left); gapTolerance " + std::to_string(tolerance) + "; }";
    };
    EXPECT_EQ(c.bonds(text(0.041)).a.size(), std::size_t(ofLeft));
    const auto b = c.bonds(text(0.042));
    EXPECT_EQ(b.a.size(), std::size_t(ofLeft + flat));
    double sum = 0;
    for (const double gap : b.restGap) sum += gap;
    EXPECT_NEAR(sum, flat*0.1*(std::sqrt(2.0) - 1), 1e-12);
    EXPECT_EQ(c.bonds(text(0.074)).a.size(), std::size_t(ofLeft + flat + space));
}

TEST(SolidBonding, ofSeveralGroups)
{
    const BondCase c;
    const std::string both("n { type steel; groups (left right); gapTolerance 1e-6; } ");
    EXPECT_EQ(c.bonds(both).a.size(), std::size_t(ofLeft + ofRight + across));
    // those that have a bond keep it
    const auto b = c.bonds(within + "m { type steel; groups (right left); gapTolerance 1e-6; }");
    ASSERT_EQ(b.type.size(), std::size_t(ofLeft + ofRight + across));
    for (std::size_t i = 0; i < b.type.size(); ++i) EXPECT_EQ(b.type[i], int(i) < ofLeft ? 0 : 1);
    // apart they are two bodies, unless the tolerance reaches across
    EXPECT_EQ(c.bonds(both, 0.01).a.size(), std::size_t(ofLeft + ofRight));
    const auto far = c.bonds("n { type glue; groups (left right); gapTolerance 0.0101; }", 0.01);
    EXPECT_EQ(far.a.size(), std::size_t(ofLeft + ofRight + across));
    EXPECT_NEAR(*std::max_element(far.restGap.begin(), far.restGap.end()), 0.01, 1e-12);
}

TEST(SolidBonding, whatIsRefused)
{
    const BondCase c;
    EXPECT_EQ(c.bondsSaid("n { type glue; groups (free); gapTolerance 1e-6; }"), "Entry bonds: n "
        "bonds nothing: no two particles of these groups are nearer than gapTolerance 1e-06 m");
    EXPECT_EQ(c.bondsSaid("n { type glu; groups (left); gapTolerance 1e-6; }"),
        "Unknown bond type glu; constant/solidProperties has (glue steel); did you mean glue?");
    EXPECT_EQ(c.bondsSaid("n { type glue; groups (lift); gapTolerance 1e-6; }"), "Unknown group "
        "lift; constant/solidProperties has (free left right); did you mean left?");
    EXPECT_EQ(c.bondsSaid("n { type glue; groups (left); gapTolerance -1; }"),
        "Entry gapTolerance is -1: it must be zero or positive");
    EXPECT_TRUE(holds(c.bondsSaid("n { type glue; groups (left); }"),
        "Entry 'gapTolerance' not found in dictionary"));
    EXPECT_EQ(c.bondsSaid("n { type glue; groups (left); gapTolerance 0; tolerance 0; }").substr(
        0, 23), "Unknown entry tolerance");
    EXPECT_EQ(c.bondsSaid(within + within), "Entry bonds: two are named n");
    EXPECT_EQ(c.bondsSaid("n 3;"), "Entry bonds: n is no dictionary");
}

//- A row of ten that ends where it begins
TEST(SolidBonding, ringThroughAPeriodicEnd)
{
    BoxMesh ring;
    ring.sides(0, "cyclic");
    const SolidRegionCase c(ring, std::string(SolidRegionCase::rock)
        + "walls { patches (); } bonds { glue { normalStiffness 2; shearStiffness 1; } }");
    const auto row = c.regions("a { set solids; source box; box (0 0.4 0.4) (1 0.5 0.5); spacing "
                               "0.1; }");
    ASSERT_EQ(row[0].size(), 10);
    const auto b = bondSolids(
        entries("bonds (n { type glue; groups (free); gapTolerance 1e-6; });"), joined(row),
        *c.settings);
    ASSERT_EQ(b.a.size(), 10u);
    for (const double gap : b.restGap) EXPECT_NEAR(gap, 0, 1e-12);
}

TEST(SolidBonding, whatIsBondedAlready)
{
    const BondCase c;
    const std::string again("again { type steel; groups (left); gapTolerance 1e-6; }");
    EXPECT_TRUE(holds(c.bondsSaid(within + again),
        "Entry bonds: again bonds nothing: all pairs of these groups that are nearer than "
        "gapTolerance 1e-06 m are bonded already, by an entry before it"));
}

//- The particles of a rigid body need no bonds among themselves
TEST(SolidBonding, notWithinARigidBody)
{
    const BondCase c;
    const auto r = c.regions("a { set solids; rigid yes; source box; box (0 0 0) (0.3 0.1 0.1); "
                             "spacing 0.1; group left; } b { set solids; source box; box (0.3 0 0) "
                             "(0.4 0.1 0.1); spacing 0.1; group left; }");
    const auto b = bondSolids(entries("bonds (" + within + ");"), joined(r), *c.settings);
    ASSERT_EQ(b.a.size(), 1u);
    EXPECT_EQ(b.a[0], 2);
    EXPECT_EQ(b.b[0], 3);
}
