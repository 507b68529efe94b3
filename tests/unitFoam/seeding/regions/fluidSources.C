// SPDX-License-Identifier: GPL-3.0-or-later
/*  Sources of fluid: volumes in 2D and askew, closed surfaces and their sections, lists with
    velocities and pressures; bodies of constant/geometry; what is refused. */

#include "closedSurface.H"
#include "fluidRegionCase.hpp"

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);

    //- A tetrahedron with right angles at (low low low), and edges from there to high
    std::string corner(double low, double high)
    {
        const std::string a(std::to_string(low) + ' '), b(std::to_string(high) + ' ');
        return "OFF\n4 4 0\n" + a + a + a + '\n' + b + a + a + '\n' + a + b + a + '\n' + a + a + b
            + "\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    }

    clumpShape shapeOf(const FluidRegionCase& c, const std::string& file)
    {
        const dictionary dict(entries("file \"" + file + "\";"));
        checkedDictionary checked(dict);
        const particlePacking frame(
            c.mesh(), particlePacking::kind::square, 0.1, vector(0, 0, -10));
        return closedShape(std::shared_ptr<const triSurface>(
            readClosedSurface(checked, c.mesh().time()).ptr()), frame);
    }
}

TEST(FluidSources, closedSurfaces)
{
    FluidRegionCase c;
    c.write("constant/triSurface/box.off", boxSurface(boundBox(point(1, 2, 3), point(6, 6, 5))));
    auto r = c.water("source surface; file \"box.off\"; scale 0.1;");
    EXPECT_EQ(r.size(), 10*8*4);
    EXPECT_LT(mag(boundBox(r.position, false).min() - point(0.125, 0.225, 0.325)), 1e-9);
    c.write("constant/triSurface/corner.off", corner(0, 0.8));
    r = c.water("source surface; file \"corner.off\";");
    int n = 0;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j)
            for (int k = 0; k < 16; ++k) n += i + j + k + 1.5 < 16;
    EXPECT_EQ(r.size(), n);
    EXPECT_TRUE(holds(c.waterSaid("source surface; file \"none.off\";"), "there is no "));
    // a body of it, by its exact volume
    c.write("constant/triSurface/half.off", corner(0.2, 0.6));
    const auto body = c.one("rigid yes; source surface; file \"half.off\"; spacing "
                            "0.05;").clumps[0];
    EXPECT_NEAR(body.mass, 2000*0.064/6, 1e-6);
    for (const double x : body.position) EXPECT_NEAR(x, 0.3, 1e-6);
    // m a^2 3/40 about axes through the centre parallel to edges, products m a^2/80
    const double unit = body.mass*0.16/80;
    EXPECT_NEAR(body.inertia[0] + body.inertia[1] + body.inertia[2], 18*unit, 1e-6);
    EXPECT_NEAR(body.inertia[0]*body.inertia[1]*body.inertia[2], 8*5*5*unit*unit*unit, 1e-6*unit);
}

TEST(FluidSources, shapeOfASurface)
{
    FluidRegionCase c;
    c.write("constant/triSurface/corner.off", corner(0, 1));
    const clumpShape s(shapeOf(c, "corner.off"));
    EXPECT_NEAR(s.volume, 1.0/6, 1e-12);
    EXPECT_LT(mag(s.middle - 0.25*vector::one), 1e-9);
    const tensor J(inertiaOf(s));
    EXPECT_NEAR(J.xx(), 3.0/40/6, 1e-9);
    EXPECT_NEAR(J.xy(), 1.0/80/6, 1e-9);
    const scalarField d
    (
        s.distance(pointField({{0.1, 0.3, 0.3}, {0.5, 0.5, 0.5}, {-1, 0.2, 0.2}, {-3, -4, 0}}))
    );
    const double expected[] = {-0.1, 0.5/std::sqrt(3.0), 1, 5};
    forAll(d, i) EXPECT_NEAR(d[i], expected[i], 1e-9) << i;
}

//- By y = 0.5 a right triangle with sides of 0.41 along x and z
TEST(FluidSources, sectionOfASurface)
{
    FluidRegionCase c(SolidRegionCase::flat());
    c.write("constant/triSurface/corner.off", corner(0.2, 0.91));
    const clumpShape s(shapeOf(c, "corner.off"));
    const double side2 = 0.41*0.41, third = 0.41/3;
    EXPECT_NEAR(s.volume, side2/2, 1e-14);
    const point middle(0.2 + third, 0.5, 0.2 + third);
    EXPECT_LT(mag(s.middle - middle), 1e-14);
    EXPECT_NEAR(s.moments[2], side2*side2/18, 1e-14);
    const scalarField d
    (
        s.distance(pointField({{0.25, 9, 0.3}, {0.5, 0, 0.51}, {-0.1, 1, -0.2}}))
    );
    const double expected[] = {-0.05, 0.1*std::sqrt(2.0), 0.5};
    forAll(d, i) EXPECT_NEAR(d[i], expected[i], 1e-14) << i;
    // points at the height of the plane are above it
    c.write("constant/triSurface/up.off", boxSurface(boundBox(point(0, 0.5, 0), point(1, 1, 1))));
    c.write("constant/triSurface/down.off", boxSurface(boundBox(point(0, 0, 0), point(1, 0.5, 1))));
    EXPECT_NEAR(shapeOf(c, "up.off").volume, 0, 1e-14);
    EXPECT_NEAR(shapeOf(c, "down.off").volume, 1, 1e-14);

    const auto r = c.one("rigid yes; source surface; file \"corner.off\"; spacing 0.05;");
    ASSERT_EQ(r.clumps.size(), 1);
    EXPECT_NEAR(r.clumps[0].mass, 1000*side2, 1e-9);
    EXPECT_NEAR(r.clumps[0].inertia[2], 2000*side2*side2/18, 1e-9);
    EXPECT_NEAR(r.clumps[0].position[2], middle.z(), 1e-12);
    EXPECT_EQ(r.size(), std::lround(side2/2/0.0025));
    EXPECT_TRUE(r.shape.empty());
    const auto w = c.water("source surface; file \"corner.off\";");
    int n = 0;
    for (int i = 0; i < 8; ++i) for (int j = 0; j < 8; ++j) n += i + j + 1 < 8.2;
    EXPECT_EQ(w.size(), n);
}

TEST(FluidSources, volumesInTheMidPlane)
{
    FluidRegionCase c(SolidRegionCase::flat());
    const auto area = [&](const std::string& text) { return c.water(text).size()*0.0025; };
    EXPECT_NEAR(
        area("source cylinder; p1 (0.5 0 0.5); p2 (0.5 1 0.5); radius 0.4;"), pi*0.16, 0.02);
    EXPECT_NEAR(area("source cylinder; p1 (0.1 0.5 0.5); p2 (0.9 0.5 0.5); radius 0.2;"), 0.32,
        1e-9);
    // of a ball of radius 0.5 a circle of 0.4
    EXPECT_NEAR(area("source sphere; centre (0.5 0.2 0.5); radius 0.5;"), pi*0.16, 0.02);
    EXPECT_EQ(c.waterSaid("source box; box (0 0.6 0) (1 1 1);"), "Region w holds no particle. The "
        "mesh is (0 0 0) to (1 1 1), and its mid-plane must be in the region");
    // hexagonal: as many in the same area
    EXPECT_NEAR(
        c.water("source box; box (0 0 0) (1 1 1);", "spacing 0.05; packing hexagonal;").size(), 400,
        20);
    EXPECT_EQ(c.waterSaid("source cylinder; p1 (0.5 0 0.5); p2 (0.5 0 0.5); radius 1;"),
        "Entries p1 and p2 are the same point (0.5 0 0.5): the cylinder has no length");
}

TEST(FluidSources, listsWithVelocityAndPressure)
{
    FluidRegionCase c;
    const std::string list("source csv; file \"a.csv\"; ");
    c.write("a.csv", "x,y,z,u,v,w,p\n0.1,0.2,0.3,1,2,3,77\n0.5,0.6,0.7,4,5,6,-8\n"
                     "1.5,0.6,0.7,7,8,9,5\n");
    EXPECT_EQ(c.waterSaid(list),
        "Region w: 1 of 3 particles are outside the mesh, the first at (1.5 0.6 0.7); `clip yes;` "
        "drops such particles");
    auto r = c.water(list + "clip yes;");
    ASSERT_EQ(r.size(), 2);
    EXPECT_EQ(r.clipped, 1);
    EXPECT_EQ(r.pressure, scalarList({77, -8}));
    EXPECT_EQ(r.velocity[1], vector(4, 5, 6));
    // the region's own word comes first
    r = c.water(list + "clip yes; pressure zero;");
    EXPECT_EQ(r.pressure, scalarList({0, 0}));
    r = c.water(list + "clip yes; pressure hydrostatic; freeSurface 0.5;");
    EXPECT_NEAR(r.pressure[0], 2000, 1e-9);
    EXPECT_EQ(r.pressure[1], 0);
    c.write("a.csv", "x,y,z,u,v,w\n0.1,0.2,0.3,1,2,3\n");
    EXPECT_EQ(c.water(list + "velocity (9 9 9);").velocity[0], vector(1, 2, 3));
    for (const char* head : {"x,y,w", "x,y", "u,v,w,x,y,z", "x,y,z,u", "x,y,z,u,v,w,rho"})
    {
        c.write("a.csv", std::string(head) + '\n');
        EXPECT_EQ(c.waterSaid(list),
            "Entry file: line 1 of \"" + c.path()
                + "/a.csv\": the header is '"
                + head + "', not x,y,z or x,y,z,u,v,w or x,y,z,u,v,w,p");
    }
}

TEST(FluidSources, inBodiesOfGeometry)
{
    FluidRegionCase c;
    c.bodies = std::make_unique<const geometryWalls>(c.time(),
        entries("rock { type box; min (0.2 0.2 0.2); max (0.5 0.6 0.4); }"));
    const std::string box("source box; box (0 0 0) (1 1 1); ");
    EXPECT_EQ(c.waterSaid(box), "Region w: 192 of 8000 particles are in the solid rock of "
        "constant/geometry, the first at (0.225 0.225 0.225); `clip yes;` drops such particles");
    const auto r = c.water(box + "clip yes;");
    EXPECT_EQ(r.size(), 20*20*20 - 6*8*4);
    EXPECT_EQ(r.clipped, 6*8*4);
}

TEST(FluidSources, besideSolids)
{
    FluidRegionCase c;
    const std::string water("w { set fluid; source box; box (0 0 0) (0.1 0.1 0.1); } ");
    const std::string both(water + "s { set solids; } ");
    EXPECT_EQ(c.waters(both, "spacing 0.05; overlapTolerance 1; bonds ();").size(), 1);
    EXPECT_TRUE(holds(messageOf([&]() { c.waters(water, "spacing 0.05; packng square;"); }),
        "Unknown entry packng; valid are (spacing packing regions), "));
    EXPECT_EQ(messageOf([&]() { c.waters(water + "s { set solid; }", "spacing 0.05;"); }), "Entry "
        "set has the unknown word solid; valid are (fluid solids); did you mean solids?");
}
