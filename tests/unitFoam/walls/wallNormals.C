// SPDX-License-Identifier: GPL-3.0-or-later
/*  What comes with wall points: normals into the fluid, sources, faces, names; what is refused. */

#include "laidWalls.hpp"
#include "scratchCase.hpp"
#include "StringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    BoxMesh tank()
    {
        BoxMesh box;
        box.divide(0, 0, 1, 5);
        box.divide(2, 0, 0.5, 5);
        box.sides(1, "empty");
        box.type[5] = "patch";
        return box;
    }
}

TEST(WallNormals, towardsTheNearestPlaceOfTheWall)
{
    const auto mesh = tank().make(testTime());
    const wallPoints w(laid(mesh(), wallControls(0.1, 3)));
    ASSERT_EQ(w.names.size(), 3);
    for (label i = 0; i < w.size(); ++i)
    {
        const point& p = w.position[i];
        const point foot(min(max(p.x(), 0.0), 1.0), p.y(), max(p.z(), 0.0));
        EXPECT_LT(mag(w.normal[i] - normalised(foot - p)), 1e-9);
        // beside a wall its own, in a corner one of both
        const word& name = w.names[w.source[i]];
        if (p.z() > 0) { EXPECT_EQ(name, p.x() < 0 ? "xMin" : "xMax"); }
        else if (p.x() > 0 && p.x() < 1) { EXPECT_EQ(name, "zMin"); }
        else { EXPECT_NE(name, p.x() < 0 ? "xMax" : "xMin"); }
    }
}

TEST(WallNormals, facesAreThePatches)
{
    const auto mesh = tank().make(testTime());
    const wallPoints w(laid(mesh(), wallControls(0.1, 3)));
    ASSERT_EQ(w.faces.size(), 15);
    const vector normals[] = {vector(1, 0, 0), vector(-1, 0, 0), vector(0, 0, 1)};
    for (label f = 0; f < w.faces.size(); ++f)
    {
        EXPECT_LT(mag(w.faces.normal[f] - normals[w.faces.source[f]]), 1e-12);
        EXPECT_EQ(w.faces.part[f], 0);
        EXPECT_EQ(w.faces.halfThickness[f], 0);
    }
}

TEST(WallNormals, patchesByName)
{
    const auto mesh = tank().make(testTime());
    EXPECT_EQ(wallPatches(mesh()), labelList({0, 1, 4}));
    const dictionary none;
    EXPECT_EQ(wallPatches(mesh(), wordRes({wordRe("x.*", wordRe::REGEX), wordRe("zMax")}), none),
        labelList({0, 1, 5}));
    EXPECT_EQ(messageOf([&]() { wallPatches(mesh(), wordRes({wordRe("yMin")}), none); }),
        "Entry patches: no patch yMin that can be a wall; valid ones are (xMin xMax zMin zMax)");
    EXPECT_EQ(messageOf([&]() { wallPatches(mesh(), wordRes({wordRe("xMaxx")}), none); }),
        "Entry patches: no patch xMaxx that can be a wall; valid ones are (xMin xMax zMin zMax); "
        "did you mean xMax?");
}

TEST(WallNormals, layersForASupport)
{
    EXPECT_EQ(wallPointsControls::layersFor(0.26, 0.1), 3);
    EXPECT_EQ(wallPointsControls::layersFor(3*0.1, 0.1), 3);
    EXPECT_EQ(wallPointsControls::layersFor(0.01, 0.1), 1);
}

TEST(WallNormals, report)
{
    const auto mesh = tank().make(testTime());
    OStringStream os;
    reportWallPoints(laid(mesh(), wallControls(0.1, 3)), os);
    EXPECT_EQ(std::string(os.str()),
        "Walls: 78 points, spacing 0.1 m, 3 layers\n"
        "    xMin: 24 points, nearest two 1 spacings apart\n"
        "    xMax: 24 points, nearest two 1 spacings apart\n"
        "    zMin: 30 points, nearest two 1 spacings apart\n");
}

TEST(WallNormals, spacingAndLayersAreNeeded)
{
    const auto mesh = tank().make(testTime());
    EXPECT_EQ(messageOf([&]() { laid(mesh(), wallControls(0, 3)); }),
        "walls need a spacing and layers above zero, not 0 and 3");
    EXPECT_EQ(messageOf([&]() { laid(mesh(), wallControls(0.1, 0)); }),
        "walls need a spacing and layers above zero, not 0.1 and 0");
    EXPECT_TRUE(holds(messageOf([&]() { laid(mesh(), wallControls(1e-9, 3)); }),
        "Walls (patches) would have at 1e-09 m"));
}

TEST(WallNormals, oneDirectionIsNotEnough)
{
    BoxMesh box(tank());
    box.sides(0, "empty");
    const auto mesh = box.make(testTime());
    EXPECT_EQ(messageOf([&]() { laid(mesh(), wallControls(0.1, 3)); }),
        "the mesh has 1 dimensions that are not empty: walls need 2 or 3");
}

//- Two faces of the mesh a hundredth of a spacing apart have no room for points
TEST(WallNormals, bafflesAreRefused)
{
    for (const double gap : {0.0005, 0.01})
    {
        BoxMesh box(tank());
        box.nodes[0] = {0, 0.5, 0.5 + gap, 1};
        box.there = [](int i, int, int) { return i != 1; };
        const auto mesh = box.make(testTime());
        const std::string said = messageOf([&]() { laid(mesh(), wallControls(0.1, 3)); });
        if (gap < 0.001)
        {
            EXPECT_TRUE(holds(said, "Patch inner is a baffle: a face of patch inner is right "
                                    "behind it, at (0.5 0.5 0.05)"))
                << said;
        }
        else { EXPECT_EQ(said, ""); }
    }
}
