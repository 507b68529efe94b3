// SPDX-License-Identifier: GPL-3.0-or-later
/*  Named particles: where they are and were, what moves them, those that have left. */

#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    //- Its sides do not hold anybody
    std::string open(const std::string& more = "")
    {
        return rock(more, "patches ();");
    }

    //- Sphere 0 falls, 1 flies out through x = 1 soon, 2 is in a group that does not feel gravity
    struct Three : RunningSolids
    {
        Three() : RunningSolids(open("groups { light { gravity no; } }"))
        {
            add(point(0.5, 0.5, 0.8), 0.05, vector(0.1, 0.2, 0), vector(1, 2, 3));
            add(point(0.95, 0.5, 0.5), 0.02, vector(2, 0, 0));
            add(point(0.2, 0.3, 0.4), 0.05, vector(0, 0.5, 0), Zero, "light");
            start();
        }
    };

    vector vectorOf(const FunctionTable& table, const std::string& name, int row, bool small = true)
    {
        return small ? vector(
                   table.at(row, name + 'x'), table.at(row, name + 'y'), table.at(row, name + 'z'))
                     : vector(table.at(row, name + 'X'), table.at(row, name + 'Y'),
                         table.at(row, name + 'Z'));
    }
}

TEST(ParticleDisplacement, ofThrownSpheres)
{
    Three c;
    auto f = c.function("type particleDisplacement; origIds (2 0);");
    c.run(0.2);
    c.sample(f());
    const FunctionTable table(c.table("particleDisplacement"));
    const std::vector<std::string> first(table.columns.begin(), table.columns.begin() + 17);
    EXPECT_EQ(first,
        (std::vector<std::string>{"Time", "2X", "2Y", "2Z", "2Dx", "2Dy", "2Dz", "2Ux", "2Uy",
            "2Uz", "2Wx", "2Wy", "2Wz", "2Fx", "2Fy", "2Fz", "0X"}));
    EXPECT_EQ(table.columns.size(), 31u);
    const double weight = 10*1000*4*pi/3*0.05*0.05*0.05;
    for (const int row : {0, 1})
    {
        const double t = 0.2*row;
        const vector way(0.1*t, 0.2*t, -5*t*t);
        EXPECT_LT(mag(vectorOf(table, "0", row, false) - point(0.5, 0.5, 0.8) - way), 1e-8);
        EXPECT_LT(mag(vectorOf(table, "0D", row) - way), 1e-8);
        EXPECT_LT(mag(vectorOf(table, "0U", row) - vector(0.1, 0.2, -10*t)), 1e-8);
        EXPECT_LT(mag(vectorOf(table, "0W", row) - vector(1, 2, 3)), 1e-8);
        EXPECT_LT(mag(vectorOf(table, "2D", row) - vector(0, 0.5*t, 0)), 1e-8);
        EXPECT_LT(mag(vectorOf(table, "2F", row)), 1e-8);
    }
    EXPECT_LT(mag(vectorOf(table, "0F", 1) - vector(0, 0, -weight)), 1e-8);
}

TEST(ParticleDisplacement, ofAllAlsoOfThoseThatHaveLeft)
{
    Three c;
    auto f = c.function("type particleDisplacement; origIds all;");
    c.run(0.1);
    c.sample(f());
    ASSERT_EQ(c.report.escapedId, std::vector<std::int32_t>{1});
    const FunctionTable table(c.table("particleDisplacement"));
    ASSERT_EQ(table.columns.size(), 46u);
    for (std::size_t k = 1; k < table.columns.size(); ++k)
    {
        EXPECT_FALSE(std::isnan(table.rows[0][k])) << table.columns[k];
        EXPECT_EQ(std::isnan(table.rows[1][k]), table.columns[k][0] == '1') << table.columns[k];
    }
    EXPECT_NEAR(table.at(0, "1X"), 0.95, 1e-8);
}

//- Those that were next to the points at the start of the run, wherever they are when it goes on
TEST(ParticleDisplacement, nearestToPointsOfTheStart)
{
    Three c;
    const std::string text("type particleDisplacement; points ((0.2 0.3 0.45) (0.6 0.6 0.9));");
    auto before = c.function(text);
    c.run(0.1);
    c.sample(before());
    EXPECT_NEAR(c.table("particleDisplacement").last("2Dy"), 0.05, 1e-8);
    EXPECT_NEAR(c.table("particleDisplacement").last("0Dx"), 0.01, 1e-8);
    // a run that goes on from here: its scene starts where particles are now
    before.clear();
    for (const int id : {0, 2})
    {
        const vector x(c.now(&riprap::DemState::position, id));
        const vector u(c.now(&riprap::DemState::velocity, id));
        for (int d = 0; d < 3; ++d)
        {
            c.solids.particles.position[3*id + d] = x[d];
            c.solids.particles.velocity[3*id + d] = u[d];
        }
    }
    c.settings.config.startTime = 0.1;
    c.start();
    auto after = c.function(text);
    c.run(0.3);
    c.sample(after());
    const FunctionTable table(c.table("particleDisplacement_0"));
    EXPECT_NEAR(table.last("2Dy"), 0.15, 1e-8);
    EXPECT_LT(mag(vectorOf(table, "0D", 0) - vector(0.03, 0.06, -0.45)), 1e-8);
}

TEST(ParticleDisplacement, wrongEntries)
{
    Three c;
    const auto said = [&](const std::string& text)
    { return c.refused("type particleDisplacement; " + text); };
    const std::string one("Function object f needs one of the entries origIds and points");
    EXPECT_EQ(said(""), one);
    EXPECT_EQ(said("origIds (1); points ((0 0 0));"), one);
    EXPECT_EQ(said("origIds ();"), "Entry origIds of function object f is empty");
    EXPECT_EQ(said("origIds (0 7);"),
        "Entry origIds of function object f: there is no particle 7; there are 3");
    EXPECT_TRUE(holds(said("origIds all 3;"), "excess tokens"));
    EXPECT_TRUE(holds(said("origId (0);"), "Unknown entry origId; valid are"));
    EXPECT_EQ(said("points ();"), "Entry points of function object f is empty");
}
