// SPDX-License-Identifier: GPL-3.0-or-later
/*  Solids from a list: columns in any order, what has no column, the shape that an entry gives to a
    rigid body of a list; what is refused. */

#include "solidRegionCase.hpp"

using namespace Foam;

namespace
{
    const std::string list("source csv; file \"a.csv\"; ");

    struct ListCase : SolidRegionCase
    {
        explicit ListCase(const BoxMesh& box = BoxMesh())
        :
            SolidRegionCase(box, std::string(rockAndWood) + "groups { held { fixed all; } }")
        {}

        solidRegion of(const std::string& table, const std::string& text)
        {
            write("a.csv", table);
            return one(list + text);
        }

        std::string saidOf(const std::string& table, const std::string& text)
        {
            write("a.csv", table);
            return said(list + text);
        }
    };

    //- Balls of radius 0.05 in rows 0.1 apart in a block (0.2 0.2 0.2) to (0.5 0.4 0.4), or those
    //  at its bottom alone
    std::string blockOfBalls(int layers = 2)
    {
        std::string text("x,y,z\n");
        for (int k = 0; k < layers; ++k)
            for (int j = 0; j < 2; ++j)
                for (int i = 0; i < 3; ++i)
                {
                    const int at[3] = {i, j, k};
                    for (int d = 0; d < 3; ++d)
                        text += std::to_string(0.25 + 0.1*at[d]) + (d < 2 ? ',' : '\n');
                }
        return text;
    }

    const std::string rigid("rigid yes; radius 0.05; ");
    const std::string hull("surface { source box; box (0.2 0.2 0.2) (0.5 0.4 0.4); } ");
}

TEST(SolidList, columnsInAnyOrder)
{
    ListCase c;
    const auto r = c.of("mass,z,wx,wy,wz,group,x,radius,w,v,u,material,y\n"
                        "7,0.3,1,2,3,held,0.1,0.05,6,5,4,wood,0.2\n"
                        "8,0.6,0,0,0,free,0.4,0.04,9,8,7,rock,0.5\n", "material rock;");
    ASSERT_EQ(r.size(), 2);
    EXPECT_EQ(r.position, pointField({{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}}));
    EXPECT_EQ(r.velocity, vectorField({{4, 5, 6}, {7, 8, 9}}));
    EXPECT_EQ(r.spin, vectorField({{1, 2, 3}, {0, 0, 0}}));
    EXPECT_EQ(r.radius, scalarList({0.05, 0.04}));
    EXPECT_EQ(r.mass, scalarList({7, 8}));
    EXPECT_EQ(r.material, labelList({1, 0}));
    EXPECT_EQ(r.group, labelList({1, 0}));
}

TEST(SolidList, withoutColumnsTheRegionsOwn)
{
    ListCase c;
    auto r = c.of("x,y,z\n0.1,0.2,0.3\n", "radius 0.02; material wood; group held; velocity (1 2 "
                                          "3); spin (4 5 6);");
    EXPECT_EQ(r.velocity[0], vector(1, 2, 3));
    EXPECT_EQ(r.spin[0], vector(4, 5, 6));
    EXPECT_EQ(r.material[0], 1);
    EXPECT_EQ(r.group[0], 1);
    EXPECT_NEAR(r.mass[0], 500*ballOf(0.02), 1e-15);
    // each by its own material
    r = c.of("x,y,z,material\n0.1,0.2,0.3,wood\n0.5,0.2,0.3,rock\n", "radius 0.02; material rock;");
    EXPECT_NEAR(r.mass[0], 500*ballOf(0.02), 1e-15);
    EXPECT_NEAR(r.mass[1], 2000*ballOf(0.02), 1e-15);
    ListCase flat(SolidRegionCase::flat());
    r = flat.of("x,y,z\n0.1,0.2,0.3\n", "radius 0.02; material rock;");
    EXPECT_EQ(r.position[0], point(0.1, 0.5, 0.3));
}

TEST(SolidList, whatIsRefused)
{
    ListCase c;
    const std::string rest("radius 0.02; material rock;");
    const auto line = [&](int n)
    { return "Entry file: line " + std::to_string(n) + " of \"" + c.path() + "/a.csv\": "; };
    EXPECT_EQ(c.saidOf("x,y\n1,2\n", rest),
        line(1) + "the columns (x y z) must be there, all of them");
    EXPECT_EQ(c.saidOf("x,y,z,u,w\n1,2,3,4,5\n", rest),
        line(1) + "the columns (u v w) must be there, all of them");
    EXPECT_EQ(c.saidOf("x,y,z,wx\n1,2,3,4\n", rest),
        line(1) + "the columns (wx wy wz) must be there, all of them");
    EXPECT_EQ(c.saidOf("x,y,z,radios\n1,2,3,4\n", rest), line(1) + "unknown column 'radios'; valid "
        "are (x y z u v w wx wy wz radius mass material group); did you mean radius?");
    EXPECT_EQ(c.saidOf("x,y,z,radius\n0.1,0.1,0.1,0.1\n\n0.5,0.5,0.5,0\n", "material rock;"),
        line(4) + "radius is 0: it must be positive");
    EXPECT_EQ(c.saidOf("x,y,z,mass\n0.1,0.1,0.1,-2\n", rest),
        line(2) + "mass is -2: it must be positive");
    EXPECT_EQ(c.saidOf("x,y,z,material\n0.1,0.1,0.1,rok\n", rest),
        "Unknown material rok; constant/solidProperties has (rock wood); did you mean rock?");
    EXPECT_EQ(c.saidOf("x,y,z,group\n0.1,0.1,0.1,hold\n", rest),
        "Unknown group hold; constant/solidProperties has (free held); did you mean held?");
    EXPECT_TRUE(holds(c.saidOf("x,y,z,radius\n0.1,0.1,0.1,0.1\n", rest), "Unknown entry radius"));
    EXPECT_TRUE(holds(c.saidOf("x,y,z\n0.1,0.1,0.1\n", "material rock;"),
        "Entry 'radius' not found in dictionary"));
    EXPECT_TRUE(holds(c.said("source box; box (0 0 0) (1 1 1); spacing 0.1;"),
        "Entry 'material' not found in dictionary"));
    EXPECT_EQ(c.said("source bix; material rock;"), "Entry source has the unknown word bix; valid "
        "are (box csv cylinder sphere surface clumpsFromSurface clumpsFromOutline); did you mean "
        "box?");
}

//- The body has mass, volume and inertia of the shape, whatever its particles hold
TEST(SolidList, aShapeForARigidBody)
{
    ListCase c;
    c.write("constant/triSurface/hull.off",
        boxSurface(boundBox(point(0.2, 0.2, 0.2), point(0.5, 0.4, 0.4))));
    const std::string wood(rigid + "material wood; ");
    for (const std::string& shape : {hull, std::string("surface { source surface; file "
                                                       "\"hull.off\"; } ")})
    {
        const auto r = c.of(blockOfBalls(), wood + shape);
        ASSERT_EQ(r.clumps.size(), 1);
        const double mass = 500*0.3*0.2*0.2;
        EXPECT_NEAR(r.clumps[0].mass, mass, 1e-9) << shape;
        EXPECT_NEAR(r.clumps[0].volume, 0.012, 1e-12);
        EXPECT_NEAR(r.clumps[0].position[0], 0.35, 1e-9);
        const auto& I = r.clumps[0].inertia;
        EXPECT_NEAR(I[0] + I[1] + I[2], mass/6*(0.09 + 0.04 + 0.04), 1e-9);
        EXPECT_NEAR(I[0]*I[1]*I[2], std::pow(mass/12, 3)*0.08*0.13*0.13, 1e-9);
        EXPECT_NEAR(sum(r.mass), mass, 1e-9);
        EXPECT_TRUE(r.surface.found("source"));
        EXPECT_TRUE(r.exact != nullptr);
    }
    // materials of two densities, and one mass for all
    const auto r = c.of("x,y,z,material\n0.25,0.25,0.25,rock\n0.35,0.25,0.25,wood\n",
        rigid + "material rock; mass 3; " + hull);
    EXPECT_NEAR(r.clumps[0].mass, 3, 1e-12);
}

TEST(SolidList, shapesThatAreRefused)
{
    ListCase c;
    const std::string rock(rigid + "material rock; ");
    EXPECT_EQ(c.saidOf(blockOfBalls(), rock + "surface { source csv; file \"a.csv\"; }"),
        "Entry source has the unknown word csv; valid are (box cylinder sphere surface)");
    EXPECT_TRUE(holds(c.saidOf(blockOfBalls(), rock + "surface { source sphere; centre (0 0 0); "
        "radius 1; colour red; }"), "Unknown entry colour; valid are (source radius centre)"));
    EXPECT_EQ(c.saidOf("x,y,z,mass\n0.25,0.25,0.25,1\n", rock + hull), "Region a has the mass of "
        "its entry surface, and its list has a column mass: leave it out, or say the body's mass "
        "or density");
    EXPECT_EQ(c.saidOf("x,y,z,material\n0.25,0.25,0.25,rock\n0.35,0.25,0.25,wood\n", rock + hull),
        "Region a has the mass of its entry surface, and its list has materials of different "
        "density: say the body's mass or density");
    EXPECT_EQ(c.saidOf(blockOfBalls(), rock + "surface { source box; box (0.2 0.2 0.2) (0.4 0.4 "
        "0.4); }"), "Entry surface does not hold the particles of region a: the centres of 4 of 12 "
        "are outside of it, that at (0.45 0.25 0.25) by 0.05 m");
    EXPECT_EQ(c.said("source box; box (0 0 0) (1 1 1); spacing 0.1; material rock; " + hull).substr(
        0, 21), "Unknown entry surface");
}

//- Faces are sought within a particle's radius and the water's spacing
TEST(SolidList, particlesMustFollowTheShape)
{
    ListCase c;
    riprap::SphConfig config;
    config.dimensions = 3;
    config.spacing = 0.06;
    const auto said = [&](const solidRegion& r)
    { return messageOf([&]() { requireCovered(r, c.time(), config); }); };
    const std::string text(rigid + "material rock; " + hull);
    EXPECT_EQ(said(c.of(blockOfBalls(), text)), "");
    // corners are 0.05 sqrt(3) from a centre
    config.spacing = 0.036;
    EXPECT_TRUE(holds(said(c.of(blockOfBalls(), text)),
        "Region a: no particle of the list is within 0.086 m of its entry surface at "));
    config.spacing = 0.037;
    EXPECT_EQ(said(c.of(blockOfBalls(), text)), "");
    // nothing in its upper half
    config.spacing = 0.06;
    const std::string bare(said(c.of(blockOfBalls(1), text)));
    EXPECT_TRUE(holds(bare, ", where water would get in: faces are sought within a particle's "
        "radius and the water's spacing. Let particles follow the surface")) << bare;
    // others have no list
    EXPECT_EQ(said(c.one(rigid + "material rock; source box; box (0 0 0) (1 1 1);")), "");
    // 2D: the sides of a rectangle
    ListCase flat(SolidRegionCase::flat());
    config.dimensions = 2;
    config.axes[1] = 2;
    config.axes[2] = 1;
    EXPECT_EQ(said(flat.of("x,y,z\n0.25,0.5,0.25\n0.25,0.5,0.35\n0.35,0.5,0.25\n0.35,0.5,0.35\n"
        "0.45,0.5,0.25\n0.45,0.5,0.35\n", text)), "");
    EXPECT_TRUE(holds(said(flat.of("x,y,z\n0.25,0.5,0.25\n0.25,0.5,0.35\n0.35,0.5,0.25\n", text)),
        "Region a: no particle of the list is within 0.11 m of its entry surface at "));
}

//- Two materials, and a column that says which: no entry is needed
TEST(SolidList, materialOfTheColumn)
{
    const SolidRegionCase c(BoxMesh(), SolidRegionCase::rockAndWood);
    c.write("a.csv", "x,y,z,material\n0.2,0.5,0.5,wood\n0.5,0.5,0.5,rock\n");
    const auto r = c.one("source csv; file \"a.csv\"; radius 0.1;");
    ASSERT_EQ(r.size(), 2);
    EXPECT_EQ(r.material[0], 1);
    EXPECT_EQ(r.material[1], 0);
    EXPECT_NEAR(r.mass[0], 500*ballOf(0.1), 1e-9);
    c.write("a.csv", "x,y,z\n0.2,0.5,0.5\n");
    EXPECT_TRUE(holds(c.said("source csv; file \"a.csv\"; radius 0.1;"), "'material' not found"));
}
