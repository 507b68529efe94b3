// SPDX-License-Identifier: GPL-3.0-or-later
/*  brokenBonds and springForces: bonds that are pulled until they break, bodies on springs. */

#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    //- Bonds of two spheres of radius 0.05 each, of 1e7 Pa/m and 2e7 Pa/m in tension and shear: the
    //  sphere at x = 0.5 is held, the other moves at this velocity [mm/s]. Strengths as they are
    //  reached after 0.2 s at 1 mm/s along, 0.1 s at 1 mm/s across
    struct PulledPair : RunningSolids
    {
        static constexpr double kn = 1e7, ks = 2e7, speed = 1e-3;
        const double area = std::acos(-1.0)*0.05*0.05;

        explicit PulledPair(const std::string& velocity, const std::string& more = "")
        :
            RunningSolids(rock("bonds { glue { normalStiffness 1e7; shearStiffness 2e7; "
                               "tensileStrength 2000; shearStrength 2000; } } "
                               "groups { held { fixed all; } drawn { motion { "
                               "solidBodyMotionFunction linearMotion; velocity "
                    + velocity + "; } } } " + more,
                "patches ();"),
                BoxMesh(), "(0 0 0)")
        {
            add(point(0.5, 0.5, 0.5), 0.05, Zero, Zero, "held");
            add(point(0.6, 0.5, 0.5), 0.05, Zero, Zero, "drawn");
            bond(0, 1);
        }

        //- Rows at these times
        FunctionTable rows(const std::vector<double>& times)
        {
            start();
            auto f = function("type brokenBonds;");
            for (const double t : times)
            {
                run(t);
                sample(f());
            }
            return table("brokenBonds");
        }
    };

    //- Counts of a row
    std::vector<int> counts(const FunctionTable& table, int row)
    {
        std::vector<int> all;
        for (const char* column : {"whole", "broken", "inTension", "inShear", "lost"})
            all.push_back(int(table.at(row, column)));
        return all;
    }

    using Counts = std::vector<int>;
}

TEST(BrokenBonds, pulledApart)
{
    PulledPair c("(1e-3 0 0)");
    const FunctionTable table(c.rows({0.1, 0.19, 0.21}));
    EXPECT_NEAR(table.at(0, "maxTension"), 0, 1e-9);
    for (const int row : {1, 2})
    {
        EXPECT_EQ(counts(table, row), (Counts{1, 0, 0, 0, 0}));
        EXPECT_NEAR(table.at(row, "maxTension"), c.kn*c.area*c.speed*table.at(row, "Time"), 0.02);
        EXPECT_NEAR(table.at(row, "maxShear"), 0, 1e-6);
    }
    EXPECT_EQ(counts(table, 3), (Counts{0, 1, 1, 0, 0}));
    EXPECT_EQ(table.at(3, "maxTension"), 0);
}

//- Across its line; the strength in shear is reached first
TEST(BrokenBonds, sheared)
{
    PulledPair c("(0 6e-4 8e-4)");
    const FunctionTable table(c.rows({0.05, 0.09, 0.11}));
    for (const int row : {1, 2})
    {
        EXPECT_EQ(counts(table, row), (Counts{1, 0, 0, 0, 0}));
        EXPECT_NEAR(table.at(row, "maxShear"), c.ks*c.area*c.speed*table.at(row, "Time"), 0.02);
    }
    EXPECT_EQ(counts(table, 3), (Counts{0, 1, 0, 1, 0}));
}

//- Pressed bonds have no tension; one whose particle leaves is lost
TEST(BrokenBonds, pressedAndLost)
{
    PulledPair c("(-1e-3 0 0)");
    c.add(point(0.9, 0.5, 0.5), 0.02, vector(1, 0, 0));
    c.add(point(0.86, 0.5, 0.5), 0.02, vector(1, 0, 0));
    c.bond(2, 3);
    const FunctionTable table(c.rows({0.05, 0.11, 0.2}));
    EXPECT_EQ(counts(table, 1), (Counts{2, 0, 0, 0, 0}));
    EXPECT_EQ(table.at(1, "maxTension"), 0);
    EXPECT_EQ(counts(table, 2), (Counts{1, 1, 0, 0, 1}));
    EXPECT_EQ(counts(table, 3), (Counts{1, 1, 0, 0, 1}));
}

TEST(SpringForces, springAndSlackLine)
{
    RunningSolids c(rock("groups { buoy { springs { coil { anchor (0.5 0.5 0.9); point (0.5 0.5 "
                         "0.6); stiffness 40; restLength 0.2; } push { anchor (0.5 0.5 0.2); point "
                         "(0.5 0.5 0.5); stiffness 10; restLength 0.5; } } moorings { slack { "
                         "anchor (0.1 0.5 0.5); point (0.4 0.5 0.5); stiffness 1e3; length 0.4; } "
                         "taut { anchor (0.9 0.8 0.5); point (0.5 0.5 0.5); stiffness 1e3; length "
                         "0.4; } } } }",
                        "patches ();"),
        BoxMesh(), "(0 0 0)");
    c.add(point(0.5, 0.5, 0.5), 0.1);
    c.body(0, point(0.5, 0.5, 0.5), 2, vector(0.1, 0.1, 0.1), "buoy");
    c.start();
    c.function("type springForces;");
    const FunctionTable table(c.table("springForces"));
    const auto row = [&](const std::string& name)
    {
        std::vector<double> all;
        for (const char* what : {"Length", "Tension", "Fx", "Fy", "Fz"})
            all.push_back(table.last("buoy." + name + what));
        return all;
    };
    const auto expect = [&](const std::string& name, const std::vector<double>& numbers)
    {
        const auto is = row(name);
        for (std::size_t i = 0; i < is.size(); ++i) EXPECT_NEAR(is[i], numbers[i], 1e-7) << name;
    };
    ASSERT_EQ(table.columns.size(), 21u);
    expect("coil", {0.3, 4, 0, 0, 4});
    expect("push", {0.3, -2, 0, 0, 2});
    expect("slack", {0.3, 0, 0, 0, 0});
    // 0.5 long, by (0.8 0.6 0)
    expect("taut", {0.5, 100, 80, 60, 0});
}

//- About the point where the weight hangs, 0.1 below the unstretched end; its speed by the damping
TEST(SpringForces, ofABodyThatSwings)
{
    RunningSolids c(rock("groups { buoy { constrain { line (0 0 1); orientation fixed; } springs { "
                         "coil { anchor (0.5 0.5 0.9); point (0.5 0.5 0.5); stiffness 200; damping "
                         "4; restLength 0.4; } } } }",
        "patches ();"));
    c.add(point(0.5, 0.5, 0.5), 0.1);
    c.body(0, point(0.5, 0.5, 0.5), 2, vector(0.1, 0.1, 0.1), "buoy");
    c.start();
    auto f = c.function("type springForces;");
    // m x'' + c x' + k x = m g from rest
    const double decay = 1, omega = std::sqrt(100 - decay*decay);
    for (int i = 1; i <= 4; ++i)
    {
        c.run(0.1*i);
        c.sample(f());
        const double t = 0.1*i, e = std::exp(-decay*t),
                     x = 0.1*(1 - e*(std::cos(omega*t) + decay/omega*std::sin(omega*t))),
                     v = 0.1*e*(omega + decay*decay/omega)*std::sin(omega*t);
        const FunctionTable table(c.table("springForces"));
        EXPECT_NEAR(table.last("buoy.coilLength"), 0.4 + x, 2e-4) << t;
        EXPECT_NEAR(table.last("buoy.coilTension"), 200*x + 4*v, 0.06) << t;
        EXPECT_NEAR(table.last("buoy.coilFz"), 200*x + 4*v, 0.06) << t;
    }
}

TEST(SpringForces, needsSome)
{
    RunningSolids c(rock());
    c.add(point(0.5, 0.5, 0.5), 0.1);
    c.start();
    EXPECT_EQ(c.refused("type springForces;"),
        "Function object f of type springForces: no group of constant/solidProperties has springs "
        "or moorings");
}
