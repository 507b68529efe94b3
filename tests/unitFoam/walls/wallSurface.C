// SPDX-License-Identifier: GPL-3.0-or-later
/*  The surface of walls: what its edges are, how far it is. */

#include "laidWalls.hpp"
#include "testTime.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    using kind = wallSurface::edgeKind;

    struct Laid
    {
        autoPtr<polyMesh> mesh;
        wallSpace space;
        wallSurface wall;

        explicit Laid(const BoxMesh& box)
        :
            mesh(box.make(testTime())),
            space(mesh(), wallControls(0.1, 2)),
            wall(space, patchElements(space, wallPatches(mesh())), 2)
        {}

        //- Length of the edges of this kind
        double length(kind k) const
        {
            const List<kind> kinds(wall.edgeKinds(space.cosFeature));
            double sum = 0;
            forAll(kinds, e)
            {
                if (kinds[e] == k)
                    sum += wall.surface.edges()[e].mag(wall.surface.localPoints());
            }
            return sum;
        }
    };

    BoxMesh cube()
    {
        BoxMesh box;
        for (int d = 0; d < 3; ++d) box.divide(d, 0, 1, 4);
        return box;
    }
}

TEST(WallSurface, edgesOfABox)
{
    const Laid closed(cube());
    EXPECT_NEAR(closed.length(kind::convex), 12, 1e-12);
    EXPECT_EQ(closed.length(kind::concave), 0);
    EXPECT_EQ(closed.length(kind::open), 0);

    BoxMesh tank(cube());
    tank.type[5] = "patch";
    const Laid open(tank);
    EXPECT_NEAR(open.length(kind::convex), 8, 1e-12);
    EXPECT_NEAR(open.length(kind::open), 4, 1e-12);
}

TEST(WallSurface, edgesOfAStepAndOfABlockInTheFluid)
{
    // The step's own edge sticks out into the fluid; its foot does not
    BoxMesh step(cube());
    step.there = [](int i, int, int k) { return i > 1 || k > 1; };
    const Laid laid(step);
    EXPECT_NEAR(laid.length(kind::concave), 1, 1e-12);
    // of an L of sides 1, 1/2, 1/2, 1/2, 1/2 and 1, twice, and five edges between
    EXPECT_NEAR(laid.length(kind::convex), 2*4 + 5, 1e-12);

    BoxMesh block(cube());
    block.there = [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; };
    EXPECT_NEAR(Laid(block).length(kind::concave), 12*0.25, 1e-12);
}

//- A turn by less than the feature angle is a curve
TEST(WallSurface, featureAngle)
{
    for (const double degrees : {24.0, 26.0})
    {
        BoxMesh roof(cube());
        const double rise = std::tan(degrees*std::acos(-1.0)/180);
        roof.map = [=](const point& p)
        {
            return point(p.x(), p.y(), p.z() + std::max(p.x() - 0.5, 0.0)*rise);
        };
        roof.type = {{"patch", "patch", "patch", "patch", "wall", "patch", "wall"}};
        EXPECT_NEAR(Laid(roof).length(kind::convex), degrees > 25, 1e-12) << degrees;
    }
}

TEST(WallSurface, distances)
{
    const Laid closed(cube());
    const scalarField d
    (
        closed.wall.distance(pointField({{0.5, 0.5, 0.4}, {0.1, 0.3, 0.2}, {2, 0.5, 0.5},
            {-0.3, -0.4, 0.5}, {2, 3, 3}}))
    );
    const double expected[] = {0.4, 0.1, 1, 0.5, 3};
    forAll(d, i) EXPECT_NEAR(d[i], expected[i], 1e-12) << i;

    // 2D: strips along the empty axis, one spacing wide
    BoxMesh flat(cube());
    flat.divide(1, 3, 4, 1);
    flat.sides(1, "empty");
    const Laid plane(flat);
    ASSERT_EQ(plane.wall.segments.size(), 16);
    EXPECT_NEAR(plane.wall.distance(pointField(1, point(-0.3, 3.5, -0.4)))[0], 0.5, 1e-12);
    EXPECT_NEAR(sum(mag(plane.wall.surface.faceAreas())), 4*0.1, 1e-12);
    // both triangles of each strip look into the fluid
    forAll(plane.wall.surface, f)
    {
        const vector in(vector(0.5, 3.5, 0.5) - plane.wall.surface.faceCentres()[f]);
        EXPECT_GT(in & plane.wall.surface.faceNormals()[f], 0.4) << f;
    }
}
