// SPDX-License-Identifier: GPL-3.0-or-later
/*  Rigid regions: mass, centre, inertia and axes of their volume, of what the entries say, or of a
    list's particles; what is refused. */

#include "solidRegionCase.hpp"

using namespace Foam;

namespace
{
    const double pi = std::acos(-1.0);
    const std::string block("rigid yes; source box; box (0.2 0.3 0.4) (0.6 0.5 0.5); ");
    const double blockVolume = 0.4*0.2*0.1;

    tensor diagonal(double x, double y, double z) { return tensor(x, 0, 0, 0, y, 0, 0, 0, z); }

    //- Of sides a, b, c about the centre
    tensor ofBlock(double mass, double a, double b, double c)
    {
        return mass/12*diagonal(b*b + c*c, a*a + c*c, a*a + b*b);
    }

    void expectBody(const riprap::DemClump& b, double mass, double volume, const point& centre,
        const tensor& inertia)
    {
        EXPECT_NEAR(b.mass, mass, 1e-10*mass);
        EXPECT_NEAR(b.volume, volume, 1e-10*volume);
        EXPECT_LT(mag(centreOf(b) - centre), 1e-10);
        EXPECT_LT(mag(inertiaOf(b) - inertia), 1e-8*mag(inertia));
    }

    //- One body, of which all particles have a part of the mass
    const riprap::DemClump& bodyOf(const solidRegion& r)
    {
        EXPECT_EQ(r.clumps.size(), 1);
        EXPECT_NEAR(sum(r.mass), r.clumps[0].mass, 1e-12*r.clumps[0].mass);
        for (const label c : r.clump) EXPECT_EQ(c, 0);
        return r.clumps[0];
    }
}

TEST(RigidRegion, blockOfItsMaterial)
{
    const SolidRegionCase c(BoxMesh(), std::string(SolidRegionCase::rockAndWood)
        + "groups { buoy { gravity no; } }");
    const auto r = c.one(block + "spacing 0.05; material wood; group buoy; velocity (1 2 3); spin "
                                 "(4 5 6);");
    const auto& b = bodyOf(r);
    expectBody(b, 500*blockVolume, blockVolume, {0.4, 0.4, 0.45},
        ofBlock(500*blockVolume, 0.4, 0.2, 0.1));
    EXPECT_EQ(r.size(), 8*4*2);
    for (int d = 0; d < 3; ++d)
    {
        EXPECT_EQ(b.velocity[d], 1 + d);
        EXPECT_EQ(b.spin[d], 4 + d);
    }
    EXPECT_EQ(b.group, 1);
    EXPECT_EQ(r.group[0], 1);
    EXPECT_EQ(r.material[0], 1);
    // what the particles' cells hold is not the body's affair
    const auto coarse = c.one(block + "particleRadius 0.04; spacing 0.09; material rock;");
    EXPECT_EQ(coarse.size(), 4*2*1);
    expectBody(bodyOf(coarse), 2000*blockVolume, blockVolume, {0.4, 0.4, 0.45},
        ofBlock(2000*blockVolume, 0.4, 0.2, 0.1));
    EXPECT_NEAR(coarse.cells, 8*0.09*0.09*0.09, 1e-14);
    EXPECT_EQ(r.shape.get<word>("source"), "box");
    EXPECT_FALSE(r.shape.found("axes"));
}

TEST(RigidRegion, whatEntriesSay)
{
    const SolidRegionCase c;
    const std::string text(block + "spacing 0.05; ");
    const point middle(0.4, 0.4, 0.45);
    expectBody(bodyOf(c.one(text + "density 300;")), 300*blockVolume, blockVolume, middle,
        ofBlock(300*blockVolume, 0.4, 0.2, 0.1));
    expectBody(bodyOf(c.one(text + "mass 7;")), 7, blockVolume, middle,
        ofBlock(7, 0.4, 0.2, 0.1));
    // the word of other regions means the same
    expectBody(bodyOf(c.one(text + "mass cell; density 300;")), 300*blockVolume, blockVolume,
        middle, ofBlock(300*blockVolume, 0.4, 0.2, 0.1));
    // another centre leaves the inertia as it is
    auto r = c.one(text + "mass 7; centreOfMass (0.3 0.35 0.42);");
    expectBody(bodyOf(r), 7, blockVolume, {0.3, 0.35, 0.42}, ofBlock(7, 0.4, 0.2, 0.1));
    EXPECT_EQ(r.shape.get<point>("centreOfMass"), point(0.3, 0.35, 0.42));
    r = c.one(text + "mass 7; inertia (0.2 0.3 0.4);");
    expectBody(bodyOf(r), 7, blockVolume, middle, diagonal(0.2, 0.3, 0.4));
    // with products of inertia: principal axes turned by 30 degrees about z
    r = c.one(text + "inertia (0.25 0.0866025403784 0 0.35 0 0.5);");
    const auto& b = bodyOf(r);
    expectBody(b, 2000*blockVolume, blockVolume, middle,
        tensor(0.25, 0.0866025403784, 0, 0.0866025403784, 0.35, 0, 0, 0, 0.5));
    EXPECT_NEAR(std::min(b.inertia[0], b.inertia[1]), 0.2, 1e-10);
    EXPECT_NEAR(std::max(b.inertia[0], b.inertia[1]), 0.4, 1e-10);
    EXPECT_LT(mag(r.shape.get<tensor>("axes") - turnOf(b)), 1e-5);
}

TEST(RigidRegion, roundBodiesAreFilledToTheirSurface)
{
    const SolidRegionCase c;
    auto r = c.one("rigid yes; source sphere; centre (0.5 0.4 0.5); radius 0.3; spacing 0.1;");
    expectBody(bodyOf(r), 2000*ballOf(0.3), ballOf(0.3), {0.5, 0.4, 0.5},
        0.4*2000*ballOf(0.3)*0.09*tensor::I);
    EXPECT_EQ(r.size(), std::lround(ballOf(0.3)/1e-3));
    for (const point& x : r.position) EXPECT_LE(mag(x - point(0.5, 0.4, 0.5)), 0.25 + 1e-9);
    EXPECT_EQ(r.radius[0], 0.05);

    // askew
    const point p1(0.3, 0.4, 0.3), p2(0.7, 0.6, 0.7);
    const double R = 0.1, L = mag(p2 - p1), V = pi*R*R*L, across = V*(3*R*R + L*L)/12;
    const vector n((p2 - p1)/L);
    r = c.one("rigid yes; source cylinder; p1 (0.3 0.4 0.3); p2 (0.7 0.6 0.7); radius 0.1; spacing "
              "0.05;");
    expectBody(bodyOf(r), 2000*V, V, {0.5, 0.5, 0.5},
        2000*(across*tensor::I + (V*R*R/2 - across)*n*n));
    EXPECT_EQ(r.size(), std::lround(V/(0.05*0.05*0.05)));
    EXPECT_EQ(r.shape.get<word>("source"), "cylinder");
}

TEST(RigidRegion, sectionsIn2D)
{
    const SolidRegionCase c(SolidRegionCase::flat());
    const auto expectFlat = [&](const std::string& text, double area, double perMass,
                                const point& centre)
    {
        const auto r = c.one("rigid yes; spacing 0.05; " + text);
        const auto& b = bodyOf(r);
        EXPECT_NEAR(b.mass, 2000*area, 1e-9) << text;
        EXPECT_NEAR(b.volume, area, 1e-12) << text;
        EXPECT_NEAR(b.inertia[2], 2000*area*perMass, 1e-9) << text;
        EXPECT_LT(mag(centreOf(b) - centre), 1e-12) << text;
        EXPECT_EQ(turnOf(b), tensor::I);
    };
    expectFlat(
        "source box; box (0.2 0 0.4) (0.6 1 0.5);", 0.04, (0.16 + 0.01)/12, {0.4, 0.5, 0.45});
    expectFlat("source cylinder; p1 (0.5 0 0.5); p2 (0.5 1 0.5); radius 0.3;", pi*0.09, 0.045,
        {0.5, 0.5, 0.5});
    // its axis in the plane: a rectangle, narrower off the axis
    expectFlat("source cylinder; p1 (0.2 0.5 0.5); p2 (0.8 0.5 0.5); radius 0.1;", 0.12,
        (0.36 + 0.04)/12, {0.5, 0.5, 0.5});
    expectFlat("source cylinder; p1 (0.2 0.58 0.5); p2 (0.8 0.58 0.5); radius 0.1;", 0.6*0.12,
        (0.36 + 0.0144)/12, {0.5, 0.5, 0.5});
    // a circle of radius 0.4 of a ball of 0.5
    expectFlat("source sphere; centre (0.5 0.2 0.5); radius 0.5;", pi*0.16, 0.08, {0.5, 0.5, 0.5});
    const auto r = c.one(
        "rigid yes; spacing 0.05; source box; box (0.2 0 0.4) (0.6 1 0.5); mass 3; inertia 0.7; "
        "centreOfMass (0.3 0.9 0.45);");
    const auto& b = bodyOf(r);
    EXPECT_EQ(b.mass, 3);
    EXPECT_EQ(b.inertia[2], 0.7);
    // the mid-plane's, whatever was given
    EXPECT_EQ(centreOf(b), point(0.3, 0.5, 0.45));
    EXPECT_EQ(r.shape.get<pointField>("outline").size(), 4);
    EXPECT_EQ(
        c.said("rigid yes; spacing 0.05; source cylinder; p1 (0.2 0.5 0.5); p2 (0.8 0.6 0.5); "
               "radius 0.1;"),
        "Entries p1 and p2: in this 2D case a cylinder must lie along the empty direction or "
        "across it");
}

//- A dumb-bell: each ball's own inertia, and Steiner's part
TEST(RigidRegion, particlesOfAList)
{
    for (const bool planar : {false, true})
    {
        const SolidRegionCase c(planar ? SolidRegionCase::flat() : BoxMesh());
        c.write("a.csv", "x,y,z,radius\n0.2,0.5,0.5,0.1\n0.8,0.5,0.5,0.05\n");
        const auto r = c.one("rigid yes; source csv; file \"a.csv\";");
        const auto& b = bodyOf(r);
        const double v1 = planar ? pi*0.01 : ballOf(0.1), v2 = planar ? pi*0.0025 : ballOf(0.05),
                     m1 = 2000*v1, m2 = 2000*v2, own = (planar ? 0.5 : 0.4)*(m1*0.01 + m2*0.0025),
                     arm = m1*m2/(m1 + m2)*0.36, x = 0.2 + 0.6*m2/(m1 + m2);
        if (planar)
        {
            EXPECT_NEAR(b.inertia[2], own + arm, 1e-10);
            EXPECT_NEAR(b.position[0], x, 1e-12);
            EXPECT_NEAR(b.mass, m1 + m2, 1e-10);
        }
        else
            expectBody(b, m1 + m2, v1 + v2, {x, 0.5, 0.5}, diagonal(own, own + arm, own + arm));
        EXPECT_NEAR(r.mass[0], m1, 1e-10);
        EXPECT_TRUE(r.shape.empty());
        EXPECT_NEAR(c.one("rigid yes; source csv; file \"a.csv\"; density 1000;").mass[1], m2/2,
            1e-10);
    }
}

TEST(RigidRegion, centreOutsideIsWarnedOf)
{
    const SolidRegionCase c;
    const auto warning = [&](const std::string& centre)
    {
        testing::internal::CaptureStdout();
        c.one(block + "spacing 0.05; centreOfMass " + centre + ';');
        return testing::internal::GetCapturedStdout();
    };
    EXPECT_FALSE(holds(warning("(0.21 0.49 0.45)"), "Warning"));
    const std::string text(warning("(0.1 0 0.02)"));
    EXPECT_TRUE(holds(text, "Entry centreOfMass (0.1 0 0.02) of region a is outside of its "
        "particles, which are within (0.2 0.3 0.4) and (0.6 0.5 0.5) m. Coordinates are those of "
        "the mesh")) << text;
}

TEST(RigidRegion, whatIsRefused)
{
    const SolidRegionCase c;
    const std::string text(block + "spacing 0.05; ");
    EXPECT_EQ(c.said(text + "mass 2; density 3;"),
        "Entries mass and density are both there: one of them says what the body weighs");
    EXPECT_EQ(c.said(text + "mass particle;"), "Entry mass is particle, but the body is rigid: it "
        "has the mass of its region. Leave the entry out, or give a number [kg] or a density "
        "[kg/m3]");
    EXPECT_EQ(c.said(text + "mass -1;"), "Entry mass is -1: it must be positive");
    EXPECT_EQ(c.said(text + "density 0;"), "Entry density is 0: it must be positive");
    EXPECT_EQ(c.said(text + "inertia (1 2);"),
        "Entry inertia has 2 values; valid are (Ixx Iyy Izz) and (Ixx Ixy Ixz Iyy Iyz Izz)");
    EXPECT_EQ(c.said(text + "inertia (1 2 3.5);"), "Entry inertia: its principal moments are (1 2 "
        "3.5); those of a body are positive, and none is larger than the other two together");
    EXPECT_EQ(c.said(text + "inertia (1 1 0);"), "Entry inertia: its principal moments are (1 1 "
        "0); those of a body are positive, and none is larger than the other two together");
    EXPECT_EQ(c.said(text + "inertia (1 1 2);"), "");
    EXPECT_EQ(c.said("rigid yes; source clumpsFromSurface; file \"a.stl\";"), "Entry rigid is yes, "
        "but the bodies of source clumpsFromSurface are rigid ones already: leave it out");
    EXPECT_EQ(c.said("source box; box (0 0 0) (1 1 1); spacing 0.1; density 3;"), "Unknown entry "
        "density; valid are (set clip material group velocity spin rigid source box packing mass "
        "particleRadius radius spacing)");
    const auto list = [&](const std::string& columns, const std::string& values)
    {
        c.write("a.csv", "x,y,z" + columns + "\n0.2,0.5,0.5" + values + '\n');
        return c.said("rigid yes; source csv; file \"a.csv\"; radius 0.1;");
    };
    const std::string begin("Region a is one rigid body, and its list has the columns ");
    const std::string end(" for each particle: leave them out; the entries velocity, spin and "
        "group of the region are the body's");
    EXPECT_EQ(list(",u,v,w", ",1,2,3"), begin + "u, v, w" + end);
    EXPECT_EQ(list(",wx,wy,wz", ",1,2,3"), begin + "wx, wy, wz" + end);
    EXPECT_EQ(list(",group", ",free"), begin + "group" + end);
    EXPECT_EQ(list("", ""), "");
}

//- v + omega x r
TEST(RigidRegion, particlesOfATurningBody)
{
    const SolidRegionCase c;
    const vector velocity(1, 2, 3), spin(4, 5, 6);
    const auto r = c.one(block + "spacing 0.05; velocity (1 2 3); spin (4 5 6);");
    const point centre(0.4, 0.4, 0.45);
    forAll(r.position, i)
        EXPECT_LT(mag(r.velocity[i] - velocity - (spin ^ (r.position[i] - centre))), 1e-12);
}
