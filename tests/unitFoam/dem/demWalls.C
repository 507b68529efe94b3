// SPDX-License-Identifier: GPL-3.0-or-later
/*  Walls that solids touch: which there are, of which materials, where they stand. */

#include "runningSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    std::string two(const std::string& walls)
    {
        return "device cpu; contact { normal linear; tangential none; } materials { rock { rho "
               "1000; } steel { rho 8000; } } pairs { default { stiffness 1e4; restitution 1; } } "
               "walls { "
            + walls + " }";
    }

    //- x and z are solved
    BoxMesh flat()
    {
        BoxMesh box;
        box.divide(0, 0, 1, 4);
        box.sides(1, "empty");
        return box;
    }

    struct Walls : RunningSolids
    {
        explicit Walls(const std::string& walls, const BoxMesh& box = BoxMesh(),
            const std::string& geometry = "")
        :
            RunningSolids(two(walls), box)
        {
            if (!geometry.empty()) writeDict("constant/geometry", geometry);
            add(point(0.5, 0.5, 0.5), 0.05);
            makeInput();
        }

        const riprap::DemWall& wall(const std::string& name) const
        {
            for (const riprap::DemWall& w : input.walls)
                if (w.name == name) return w;
            throw std::runtime_error("no wall " + name);
        }

        std::vector<std::string> names() const
        {
            std::vector<std::string> all;
            for (const riprap::DemWall& w : input.walls) all.push_back(w.name);
            return all;
        }
    };

    std::string said(const std::string& walls, const BoxMesh& box = BoxMesh())
    {
        return messageOf([&]() { Walls(walls, box); });
    }

    point vertex(const riprap::DemWall& w, int v)
    {
        const double* x = &w.vertices[3*v];
        return point(x[0], x[1], x[2]);
    }

    //- Of its triangles, as many vertices as it uses
    double area(const riprap::DemWall& w)
    {
        double sum = 0;
        for (std::size_t e = 0; e < w.elements.size(); e += 3)
        {
            const point a(vertex(w, w.elements[e])), b(vertex(w, w.elements[e + 1])),
                c(vertex(w, w.elements[e + 2]));
            sum += 0.5*mag((b - a) ^ (c - a));
        }
        return sum;
    }

    using Names = std::vector<std::string>;
}

TEST(DemWalls, patchesSurfacesPlanes)
{
    const Walls c("material rock; patches (\"x.*\" zMin); planes { slope { point (0 0 0.1); normal "
                  "(3 0 4); } }",
        BoxMesh(), "shelf { type plate; origin (0.2 0.1 0.5); span (0.3 0.4 0); }");
    EXPECT_EQ(c.names(), (Names{"xMin", "xMax", "zMin", "shelf", "slope"}));
    EXPECT_NEAR(area(c.wall("xMin")), 1, 1e-12);
    EXPECT_NEAR(area(c.wall("shelf")), 0.12, 1e-12);
    for (std::size_t v = 0; v < c.wall("xMax").vertices.size(); v += 3)
        EXPECT_EQ(c.wall("xMax").vertices[v], 1);
    const riprap::DemWall& slope = c.wall("slope");
    EXPECT_TRUE(slope.plane);
    EXPECT_EQ(slope.point, (riprap::Vector3{{0, 0, 0.1}}));
    EXPECT_NEAR(slope.normal[0], 0.6, 1e-15);
    EXPECT_NEAR(slope.normal[2], 0.8, 1e-15);
    EXPECT_FALSE(c.wall("zMin").plane);
}

//- A curved surface to 1 % of a particle's size: its area within that of the radius
TEST(DemWalls, curvedSurfaces)
{
    const Walls c("material rock; patches ();", BoxMesh(),
        "ball { type sphere; origin (0.5 0.5 0.5); radius 0.3; }");
    // chords of depth 0.001 at most
    EXPECT_LT(area(c.wall("ball")), 4*pi*0.09);
    EXPECT_GT(area(c.wall("ball")), 4*pi*0.09*(1 - 2*0.001/0.3));
}

TEST(DemWalls, segmentsIn2D)
{
    const Walls c(
        "material rock; planes { slope { point (0 0 0.1); normal (0.3 7 0.4); } }", flat());
    EXPECT_EQ(c.names(), (Names{"xMin", "xMax", "zMin", "zMax", "slope"}));
    const riprap::DemWall& floor = c.wall("zMin");
    ASSERT_EQ(floor.elements.size() % 2, 0u);
    double length = 0;
    for (std::size_t e = 0; e < floor.elements.size(); e += 2)
        length += mag(vertex(floor, floor.elements[e]) - vertex(floor, floor.elements[e + 1]));
    EXPECT_NEAR(length, 1, 1e-12);
    // in the plane of the case
    EXPECT_NEAR(c.wall("slope").normal[0], 0.6, 1e-12);
    EXPECT_EQ(c.wall("slope").normal[1], 0);
    EXPECT_EQ(said("material rock; planes { slope { point (0 0 0); normal (0 2 0); } }", flat()),
        "Entry normal of plane slope is (0 2 0): it needs a length in the plane of this 2D case");
    EXPECT_EQ(said("material rock; planes { slope { point (0 0 0); normal (0 0 0); } }"),
        "Entry normal of plane slope is (0 0 0): it needs a length");
    EXPECT_TRUE(holds(said("material rock; planes { slope { point (0 0 0); normal (0 0 1); radius "
                           "1; } }"),
        "Unknown entry radius; valid are (point normal)"));
}

//- A literal name before patterns, patterns before the one for all
TEST(DemWalls, materials)
{
    const Walls c("material rock; materials { \"z.*\" steel; zMax rock; xMin steel; }");
    for (const riprap::DemWall& w : c.input.walls)
        EXPECT_EQ(w.material, w.name == "zMin" || w.name == "xMin") << w.name;
    EXPECT_EQ(said("materials { \"[xy].*\" steel; zMin rock; }"),
        "Entry walls: wall zMax has no material: walls { material <name>; } for all, or materials "
        "{ "
        "zMax <name>; }; valid are (rock steel)");
    EXPECT_EQ(said("material rock; materials { floor steel; }"),
        "Entry materials: floor selects no wall; valid are (xMin xMax yMin yMax zMin zMax)");
    // a pattern that only names what others name literally
    EXPECT_EQ(said("material rock; materials { zMax steel; \"zMa.*\" rock; }"),
        "Entry materials: \"zMa.*\" selects no wall; valid are (xMin xMax yMin yMax zMin zMax)");
}

TEST(DemWalls, bodiesThatMove)
{
    const Walls c("material rock; motion { a { patches (xMin); solidBodyMotionFunction "
                  "linearMotion; velocity (0.1 0 0); } b { patches (\"z.*\"); "
                  "solidBodyMotionFunction linearMotion; velocity (0 0 0.1); } }");
    for (const riprap::DemWall& w : c.input.walls)
        EXPECT_EQ(w.motion, w.name == "xMin" ? 0 : w.name[0] == 'z' ? 1 : -1) << w.name;
    ASSERT_TRUE(bool(c.input.wallMotion));
    EXPECT_NEAR(c.input.wallMotion(1, 2).translation[2], 0.2, 1e-12);
    EXPECT_FALSE(bool(c.input.groupMotion));
}

//- An end of the box holds if all its faces are walls at rest
TEST(DemWalls, endsThatHold)
{
    BoxMesh box;
    box.divide(0, 0, 1, 2);
    box.divide(2, 0, 1, 2);
    box.type[1] = "patch";
    // a step in the lower corner: its faces are of patch inner, and not at the end
    box.there = [](int i, int, int k) { return i > 0 || k > 0; };
    const Walls c("material rock; patches (xMin xMax \"y.*\" zMin inner);", box);
    const bool walled[3][2] = {{true, true}, {true, true}, {true, false}};
    for (int d = 0; d < 3; ++d)
        for (int side = 0; side < 2; ++side)
            EXPECT_EQ(c.settings.config.walled[d][side], walled[d][side]) << d << side;
}
