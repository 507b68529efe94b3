// SPDX-License-Identifier: GPL-3.0-or-later
/*  Forces on walls and groups of solids: of contacts that are known, over time, and the parts that
    entries name. */

#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    vector vectorOf(const FunctionTable& table, const std::string& name, int row = -1)
    {
        if (row < 0) row = int(table.rows.size()) - 1;
        return vector(table.at(row, name + "_x"), table.at(row, name + "_y"),
            table.at(row, name + "_z"));
    }

    //- Every vector of a row
    void expectRow(const FunctionTable& table, int row, const vector& normal,
        const vector& tangential, double close)
    {
        EXPECT_LT(mag(vectorOf(table, "normal", row) - normal), close) << row;
        EXPECT_LT(mag(vectorOf(table, "tangential", row) - tangential), close) << row;
        EXPECT_LT(mag(vectorOf(table, "total", row) - normal - tangential), close) << row;
    }

    //- A sphere between two floors of walls that move and rest, a body, and one that is pressed
    //  against another of its group
    struct Parts : RunningSolids
    {
        Parts()
        :
            RunningSolids(rock("groups { pair { } }",
                "planes { slope { point (1 1 0.02); normal (0 0 1); } } motion { lid { patches "
                "(zMax); solidBodyMotionFunction linearMotion; velocity (0 0 -1e-3); } }"))
        {
            writeDict("constant/geometry",
                "shelf { type plate; origin (0.6 0.1 0.5); span (0.3 0.3 0); }");
            // overlaps of 1, 2, 3, 4 mm with slope, shelf, zMax, each other
            add(point(0.2, 0.2, 0.069), 0.05, Zero, Zero, "pair");
            add(point(0.75, 0.25, 0.548), 0.05);
            add(point(0.2, 0.8, 0.953), 0.05);
            add(point(0.296, 0.2, 0.069), 0.05);
            start();
        }

        //- At the start
        FunctionTable force(const std::string& text, const char* name = "force")
        {
            const word folder("f" + std::to_string(++made_));
            function("type particleForces; " + text, folder.c_str());
            return table(name, "0", folder.c_str());
        }

    private:

        int made_ = 0;
    };
}

TEST(ParticleForces, partsOfWallsAndSolids)
{
    Parts c;
    const auto total = [&](const std::string& text) { return vectorOf(c.force(text), "total"); };
    const vector x(1, 0, 0), z(0, 0, 1);
    // 1e5 N/m; the fourth sphere lies on the slope as well, by 1 mm
    EXPECT_LT(mag(total("planes (slope);") + 200*z), 1e-6);
    EXPECT_LT(mag(total("surfaces (shelf);") + 200*z), 1e-6);
    EXPECT_LT(mag(total("patches (zMax);") - 300*z), 1e-6);
    EXPECT_LT(mag(total("bodies (lid);") - 300*z), 1e-6);
    EXPECT_LT(mag(total("patches (\"x.*\" zMin);")), 1e-6);
    // a wall that is named twice counts once
    EXPECT_LT(mag(total("patches (\".*\"); bodies (lid); surfaces (shelf);") - 100*z), 1e-6);
    // on the group: by the plane, and by the sphere that is none of it
    EXPECT_LT(mag(total("groups (pair);") - 100*z + 400*x), 1e-6);
    EXPECT_LT(mag(total("groups (free);") - 100*z - 200*z + 300*z - 400*x), 1e-6);
    // between two groups that are both named nothing acts
    EXPECT_LT(mag(total("groups (\".*\");") - 200*z - 200*z + 300*z), 1e-6);
}

TEST(ParticleForces, momentsAboutAPoint)
{
    Parts c;
    const FunctionTable moment(c.force("surfaces (shelf); CofR (0.5 0.5 0.5);", "moment"));
    EXPECT_EQ(moment.comments,
        (std::vector<std::string>{"Moment", "CofR            : (0.5 0.5 0.5)", ""}));
    EXPECT_EQ(moment.columns,
        (std::vector<std::string>{"Time", "total_x", "total_y", "total_z", "normal_x", "normal_y",
            "normal_z", "tangential_x", "tangential_y", "tangential_z"}));
    const vector f(0, 0, -200);
    expectRow(moment, 0, vector(0.25, -0.25, 0) ^ f, Zero, 1e-6);
    // on spheres: at the contact point, here below and beside the first
    const FunctionTable group(c.force("groups (pair);", "moment"));
    expectRow(group, 0,
        (point(0.2, 0.2, 0.02) ^ vector(0, 0, 100))
            + (point(0.248, 0.2, 0.069) ^ vector(-400, 0, 0)),
        Zero, 1e-6);
}

//- A sphere that slips over the floor with friction: half the load, against it, on either
TEST(ParticleForces, normalAndTangential)
{
    RunningSolids c(rock("groups { sled { motion { solidBodyMotionFunction linearMotion; velocity "
                         "(0.03 0.04 0); } } }",
        "", "stiffness 1e5; restitution 1; friction 0.5; tangentialDamping no;",
        "normal linear; tangential history;"));
    c.add(point(0.3, 0.3, 0.049), 0.05, Zero, Zero, "sled");
    c.start();
    auto floor = c.function("type particleForces; patches (zMin);", "floor");
    auto sled = c.function("type particleForces; groups (sled);", "sled");
    c.run(0.5);
    c.sample(floor());
    c.sample(sled());
    const vector load(0, 0, -100), drag(0.5*100*vector(0.6, 0.8, 0)), at(0.315, 0.32, 0);
    expectRow(c.table("force", "0", "floor"), 1, load, drag, 1e-6);
    expectRow(c.table("force", "0", "sled"), 1, -load, -drag, 1e-6);
    expectRow(c.table("moment", "0", "floor"), 1, at ^ load, at ^ drag, 1e-6);
    expectRow(c.table("moment", "0", "sled"), 1, -at ^ load, -at ^ drag, 1e-6);
}

TEST(ParticleForces, momentsIn2D)
{
    BoxMesh flat;
    flat.sides(1, "empty");
    RammedFloor c("", flat);
    c.start();
    auto f = c.function("type particleForces; patches (zMin); CofR (0.5 0.7 0.2);");
    c.run(0.1);
    c.sample(f());
    const double force = 0.1*c.rate;
    EXPECT_LT(mag(vectorOf(c.table("force"), "total") - vector(0, 0, -force)), 1e-4*force);
    // about the empty direction alone
    EXPECT_LT(mag(vectorOf(c.table("moment"), "total") - vector(0, 0.3*force - 0.5*force, 0)),
        1e-4*force);
}

//- Of a force that grows with the time: the mean is that of the middle, the impulse its integral
TEST(ParticleForces, overTime)
{
    RammedFloor c;
    c.start();
    const std::string text("type particleForces; patches (zMin); average 0.1; impulse yes;");
    auto f = c.function(text);
    for (int i = 1; i <= 20; ++i)
    {
        c.run(0.01*i);
        f->execute();
        if (i % 10 == 0) f->write();
    }
    f.clear();
    // a run that goes on from what was kept
    auto after = c.function(text);
    for (int i = 21; i <= 24; ++i)
    {
        c.run(0.01*i);
        c.sample(after());
    }
    for (const char* part : {"", "_0"})
    {
        const FunctionTable mean(c.table(std::string("forceMean") + part)),
            moment(c.table(std::string("momentMean") + part)),
            impulse(c.table(std::string("impulse") + part));
        EXPECT_EQ(impulse.comments[0], "Impulse");
        EXPECT_EQ(mean.rows.size(), *part ? 4u : 3u);
        for (int row = 0; row < int(mean.rows.size()); ++row)
        {
            const double t = mean.at(row, "Time");
            const vector f(0, 0, -c.rate*std::max(t - 0.05, 0.0));
            expectRow(mean, row, f, Zero, 1e-4*c.rate);
            expectRow(moment, row, vector(0.3, 0.6, 0) ^ f, Zero, 1e-4*c.rate);
            expectRow(impulse, row, vector(0, 0, -0.5*c.rate*t*t), Zero, 1e-4*c.rate);
        }
    }
}

//- The log has what the tables have
TEST(ParticleForces, log)
{
    Parts c;
    testing::internal::CaptureStdout();
    c.function("type particleForces; log yes; patches (zMin);");
    const std::string said(testing::internal::GetCapturedStdout());
    EXPECT_TRUE(holds(said,
        "particleForces f write:\n    Sum of force\n        normal : (0 0 0)\n        tangential : "
        "(0 0 0)\n        total : (0 0 0)\n    Sum of moment\n"))
        << said;
}

TEST(ParticleForces, wrongParts)
{
    Parts c;
    const auto said = [&](const std::string& text)
    { return c.refused("type particleForces; " + text); };
    const std::string patches("(xMin xMax yMin yMax zMin zMax)");
    EXPECT_EQ(said(""),
        "Function object f does not say of which parts the force is wanted: one or more of the "
        "entries (patches surfaces planes bodies groups) are needed. Valid are patches "
            + patches + ", surfaces (shelf), planes (slope), bodies (lid), groups (free pair)");
    EXPECT_EQ(said("patches ();"),
        "Entry patches of function object f is empty; valid are " + patches);
    EXPECT_EQ(said("surfaces (zMin);"),
        "Entry surfaces of function object f: zMin selects none; valid are (shelf)");
    EXPECT_EQ(said("planes (slop);"),
        "Entry planes of function object f: slop selects none; valid are (slope); did you mean "
        "slope?");
    EXPECT_EQ(said("groups (free pairs);"),
        "Entry groups of function object f: pairs selects none; valid are (free pair); did you "
        "mean pair?");
    EXPECT_EQ(said("patches (zMin); average -0.1;"),
        "Entry average of function object f is -0.1: it must not be negative");
    EXPECT_TRUE(holds(said("patch (zMin);"), "Unknown entry patch; valid are"));
}

TEST(ParticleForces, needsAScene)
{
    RunningSolids c(rock());
    EXPECT_EQ(c.refused("type particleForces; patches (zMin);"),
        "Function object f needs a running particle scene, and there is none on mesh region0.\n"
        "    riprapFoam has one, as has its option -postProcess; other solvers and the utility "
        "postProcess have none.");
    EXPECT_EQ(c.refused("type solidEnergies;"),
        "Function object f of type solidEnergies needs a running scene of solids, and there is no "
        "demScene on mesh region0.\n    riprapFoam with solver dem has one, solver sphDem where "
        "the "
        "case has solids, as has its option -postProcess; other solvers and the utility "
        "postProcess "
        "have none.");
}
