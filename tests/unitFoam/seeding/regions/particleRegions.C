// SPDX-License-Identifier: GPL-3.0-or-later
/*  Regions of fluid: places, pressures, velocities; what is refused. */

#include "boxMesh.hpp"
#include "particleRegions.H"
#include "scratchCase.hpp"
#include "wallPoints.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- A mesh of 2 x 1 x 1 with gravity along -z
    struct Tank
    {
        ScratchCase c;
        autoPtr<polyMesh> mesh;
        wallPoints walls;

        explicit Tank(bool withWalls = false)
        {
            BoxMesh box;
            box.divide(0, 0, 2, 4);
            box.type[5] = "patch";
            mesh = box.make(c.time());
            if (!withWalls) return;
            wallPointsControls controls;
            controls.spacing = 0.05;
            controls.layers = 1;
            walls = generateWallPoints(mesh(), wallPatches(mesh()), nullptr, controls);
        }

        List<particleRegion> regions(const std::string& list, double spacing = 0.1)
        {
            const dictionary dict
            (
                entries("spacing " + std::to_string(spacing) + "; regions (" + list + ");")
            );
            const vector g(0, 0, -10);
            const regionSpace space{mesh(), nullptr, walls, g, 1000, {}};
            return readRegions(dict, readPacking(dict, mesh(), g), space);
        }

        std::string said(const std::string& list)
        {
            return messageOf([&]() { regions(list); });
        }
    };

    const std::string block("set fluid; source box; box (0 0 0) (0.5 1 0.4);");
}

TEST(ParticleRegions, hydrostaticAndOtherPressures)
{
    Tank tank;
    const auto r = tank.regions("a { " + block + " } b { set fluid; source box; box (1 0 0) (1.5 1 "
        "0.2); pressure hydrostatic; freeSurface 0.5; velocity (1 2 3); } c { set fluid; source "
        "box; box (0.6 0 0) (0.7 1 0.2); pressure 77; } d { set fluid; source box; "
        "box (0.8 0 0) (0.9 1 0.2); pressure zero; }");
    ASSERT_EQ(r.size(), 4);
    EXPECT_EQ(r[0].name, "a");
    ASSERT_EQ(r[0].size(), 5*10*4);
    forAll(r[0].position, i)
    {
        EXPECT_NEAR(r[0].pressure[i], 1e4*(0.4 - r[0].position[i].z()), 1e-8);
        EXPECT_EQ(r[0].velocity[i], vector(0, 0, 0));
    }
    ASSERT_EQ(r[1].size(), 5*10*2);
    forAll(r[1].position, i)
    {
        EXPECT_NEAR(r[1].pressure[i], 1e4*(0.5 - r[1].position[i].z()), 1e-8);
        EXPECT_EQ(r[1].velocity[i], vector(1, 2, 3));
    }
    for (const scalar p : r[2].pressure) EXPECT_EQ(p, 77);
    for (const scalar p : r[3].pressure) EXPECT_EQ(p, 0);
}

TEST(ParticleRegions, sourcesHoldTheirVolume)
{
    Tank tank;
    const double pi = std::acos(-1.0);
    struct { const char* text; double volume; } sources[] = {
        {"source cylinder; p1 (1 0.2 0.5); p2 (1 0.9 0.5); radius 0.4;", pi*0.16*0.7},
        {"source sphere; centre (1 0.5 0.5); radius 0.45;", 4*pi/3*0.45*0.45*0.45},
        {"source box; box (1 1 1) (0.5 0.2 0.1);", 0.5*0.8*0.9}};
    for (const auto& s : sources)
    {
        const auto r = tank.regions(std::string("a { set fluid; ") + s.text + " }", 0.05);
        EXPECT_NEAR(r[0].size()*0.05*0.05*0.05/s.volume, 1, 0.05) << s.text;
    }
}

TEST(ParticleRegions, listsOfPoints)
{
    Tank tank;
    tank.c.write("a.csv", "x,y,z\n0.1,0.2,0.3\n0.5,0.6,0.7\n");
    auto r = tank.regions("a { set fluid; source csv; file \"a.csv\"; velocity (4 0 0); }");
    ASSERT_EQ(r[0].size(), 2);
    EXPECT_EQ(r[0].position[1], point(0.5, 0.6, 0.7));
    EXPECT_EQ(r[0].velocity[1], vector(4, 0, 0));
    EXPECT_NEAR(r[0].pressure[0], 1e4*(0.7 + 0.05 - 0.3), 1e-8);
    // two in one place, of one list
    tank.c.write("a.csv", "x,y,z\n0.1,0.2,0.3\n0.1,0.2,0.34\n");
    EXPECT_TRUE(holds(tank.said("a { set fluid; source csv; file \"a.csv\"; }"),
        "Regions a and a overlap at (0.1 0.2 0.34)"));
}

TEST(ParticleRegions, overlap)
{
    Tank tank;
    EXPECT_EQ(tank.said("a { " + block + " } b { set fluid; source box; "
                        "box (0.5 0 0) (1 1 0.4); }"), "");
    EXPECT_TRUE(holds(tank.said("a { " + block + " } b { set fluid; source box; "
                                "box (0.43 0 0) (1 1 0.4); }"),
        "Regions a and b overlap at (0.48 0.05 0.05): particles there are nearer than half a "
        "spacing"));
}

TEST(ParticleRegions, placesWhereNoneMayBe)
{
    Tank tank(true);
    EXPECT_TRUE(holds(tank.said("a { set fluid; source box; box (0 0 0) (1 1 1.2); }"),
        "Region a: 200 of 1200 particles are outside the mesh, the first at "));
    const auto r = tank.regions("a { set fluid; source box; box (0 0 0) (1 1 1.2); clip yes; }");
    EXPECT_EQ(r[0].size(), 1000);
    EXPECT_TRUE(holds(
        tank.said("a { set fluid; source box; box (-0.04 0.025 0.025) (1 0.9 0.2); }"),
        "particles are too near to wall xMin (or others), the first at (0.01 0.075 0.075); `clip "
        "yes;` drops such particles"));
    EXPECT_TRUE(holds(tank.said("a { set fluid; source box; box (5 0 0) (6 1 1); clip yes; }"),
        "Region a holds no particle after clipping. The mesh is (0 0 0) to (2 1 1)"));
}

TEST(ParticleRegions, whatIsRefused)
{
    Tank tank;
    EXPECT_EQ(tank.said(""), "Entry regions is empty");
    EXPECT_EQ(tank.said("a { " + block + " } a { " + block + " }"),
        "Entry regions: two are named a");
    EXPECT_EQ(tank.said("a { set fluids; source box; box (0 0 0) (1 1 1); }"),
        "Entry set has the unknown word fluids; valid are (fluid solids); did you mean fluid?");
    EXPECT_EQ(tank.said("a { set fluid; source box; box (0 0 0) (1 0 1); }"),
        "Entry box has no volume: its corners are (0 0 0) and (1 0 1)");
    EXPECT_TRUE(holds(tank.said("a { " + block + " pressure hydrostatik; }"),
        "Entry pressure has the unknown word hydrostatik; valid are (hydrostatic zero <number>)"));
    EXPECT_EQ(tank.said("a { " + block + " pressure 3; freeSurface 1; }"),
        "Entry freeSurface is used by pressure hydrostatic alone");
    EXPECT_TRUE(holds(tank.said("a { " + block + " colour 3; }"), "Unknown entry colour"));
    EXPECT_TRUE(holds(tank.said("a { set fluid; source sphere; centre (0 0 0); radius 1e6; }"),
        "Region a would hold about "));
}
