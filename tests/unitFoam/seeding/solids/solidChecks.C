// SPDX-License-Identifier: GPL-3.0-or-later
/*  Where solids may be: in the mesh, off walls, planes and bodies of constant/geometry, and clear
    of each other; what clipping leaves, and how regions are joined. */

#include "solidRegionCase.hpp"

using namespace Foam;

namespace
{
    const std::string list("source csv; file \"a.csv\"; radius 0.1; ");

    struct ChecksCase : SolidRegionCase
    {
        explicit ChecksCase(const std::string& more = "", const BoxMesh& box = BoxMesh())
        :
            SolidRegionCase(box, rock + more)
        {}

        //- Balls of radius 0.1 at x, in the middle of y and z
        void balls(const std::vector<double>& x, const char* file = "a.csv") const
        {
            std::string text("x,y,z\n");
            for (const double at : x) text += std::to_string(at) + ",0.5,0.5\n";
            write(file, text);
        }

        //- What is said of balls there, without clipping and with it: left over
        void expectClipped(const std::vector<double>& x, const std::string& message,
            const std::vector<double>& left, const std::string& others = "") const
        {
            balls(x);
            EXPECT_EQ(said(list, others), message + "; `clip yes;` drops such particles");
            const auto r = one(list + "clip yes;", others);
            ASSERT_EQ(r.size(), label(left.size())) << message;
            EXPECT_EQ(r.clipped, label(x.size() - left.size()));
            forAll(r.position, i) EXPECT_NEAR(r.position[i].x(), left[i], 1e-9) << message;
        }

        std::string overlap(const List<solidRegion>& r, double tolerance,
            const riprap::DemBondState& bonds = riprap::DemBondState()) const
        {
            const riprap::DemConfig& config = settings->config;
            return messageOf([&]() { checkSolidOverlap(r, joined(r), bonds, config, tolerance); });
        }
    };

    std::string twoLists() { return "a { set solids; " + list + "} b { set solids; source csv; "
        "file \"b.csv\"; radius 0.05; } "; }
}

TEST(SolidChecks, outsideTheMesh)
{
    const ChecksCase c;
    c.expectClipped({-0.2, 0.3, 0.7, 1.2}, "Region a: 2 of 4 particles are outside the mesh, the "
        "first at (-0.2 0.5 0.5)", {0.3, 0.7});
    c.balls({1.5});
    EXPECT_EQ(c.said(list + "clip yes;"), "Region a holds no particle after clipping: bodies must "
        "lie wholly in it. The mesh is (0 0 0) to (1 1 1)");
}

TEST(SolidChecks, inWalls)
{
    const ChecksCase c;
    const std::string first(" particles are in the mesh's walls by more than overlapTolerance, the "
        "first at ");
    // a thousandth of a radius deep
    c.expectClipped({0.0999, 0.5, 0.9001}, "Region a: 2 of 3" + first + "(0.0999 0.5 0.5)", {0.5});
    c.balls({0.0999, 0.5, 0.9001});
    EXPECT_EQ(c.said(list, "overlapTolerance 2e-3;"), "");
    c.balls({0.1, 0.5, 0.9});
    EXPECT_EQ(c.said(list), "");
    EXPECT_NEAR(c.one(list).wallGap, 0, 1e-12);
    c.balls({0.35, 0.6});
    EXPECT_NEAR(c.one(list).wallGap, 0.25, 1e-12);
    // walls of the solids alone
    const ChecksCase some("walls { patches (xMax); }");
    some.expectClipped({0.05, 0.5, 0.95}, "Region a: 1 of 3" + first + "(0.95 0.5 0.5)",
        {0.05, 0.5});
    const ChecksCase none("walls { patches (); }");
    none.balls({0.05, 0.95});
    EXPECT_EQ(none.said(list), "");
    EXPECT_EQ(none.one(list).wallGap, GREAT);
}

TEST(SolidChecks, behindPlanes)
{
    const ChecksCase c(
        "walls { patches (); planes { slope { point (0.5 0 0); normal (3 0 0); } } }");
    c.expectClipped({0.2, 0.55, 0.6, 0.95}, "Region a: 2 of 4 particles are behind the plane slope "
        "or in it, the first at (0.2 0.5 0.5)", {0.6, 0.95});
    c.balls({0.65, 0.9});
    EXPECT_NEAR(c.one(list).wallGap, 0.05, 1e-12);
}

TEST(SolidChecks, bodiesOfGeometry)
{
    ChecksCase c;
    c.bodies = std::make_unique<const geometryWalls>(c.time(),
        entries("rock { type sphere; origin (0.5 0.5 0.5); radius 0.2; }"));
    c.expectClipped({0.15, 0.45, 0.85}, "Region a: 1 of 3 particles are in the solid rock of "
        "constant/geometry, the first at (0.45 0.5 0.5)", {0.15, 0.85});
    c.expectClipped({0.15, 0.79, 0.85},
        "Region a: 1 of 3 particles are in the surface rock by more than overlapTolerance, the "
        "first at (0.79 0.5 0.5)",
        {0.15, 0.85});
    c.balls({0.15});
    EXPECT_NEAR(c.one(list).wallGap, 0.05, 1e-6);
}

TEST(SolidChecks, overlapsNameBothRegions)
{
    const ChecksCase c;
    c.balls({0.2, 0.4});
    c.balls({0.54}, "b.csv");
    auto r = c.regions(twoLists());
    EXPECT_EQ(c.overlap(r, 1e-4),
        "Particles overlap at the start: one of region a at (0.4 0.5 0.5) and one of region b at "
        "(0.54 0.5 0.5), by 0.01 m; overlapTolerance allows 0.0001 of the smaller radius");
    // of the smaller radius
    EXPECT_EQ(c.overlap(r, 0.21), "");
    EXPECT_NE(c.overlap(r, 0.19), "");
    riprap::DemBondState bonds;
    bonds.a = {2};
    bonds.b = {1};
    EXPECT_EQ(c.overlap(r, 1e-4, bonds), "");
    bonds.b = {0};
    EXPECT_NE(c.overlap(r, 1e-4, bonds), "");
    c.balls({0.55}, "b.csv");
    EXPECT_EQ(c.overlap(c.regions(twoLists()), 1e-4), "");
    // of one region, and of one body
    c.balls({0.3, 0.45});
    EXPECT_TRUE(holds(c.overlap(c.regions("a { set solids; " + list + " }"), 1e-4),
        "one of region a at (0.3 0.5 0.5) and one of region a at (0.45 0.5 0.5), by 0.05 m"));
    EXPECT_EQ(c.overlap(c.regions("a { set solids; rigid yes; " + list + " }"), 1e-4), "");
}

//- A clump goes with the first of its spheres
TEST(SolidChecks, clumpsStayWhole)
{
    const ChecksCase c;
    c.write("constant/triSurface/box.off", boxSurface(boundBox(point(0, 0, 0), 0.2*vector::one)));
    const std::string text(
        "source clumpsFromSurface; file \"box.off\"; spheres 7; resolution 12; centres ((0.2 0.5 "
        "0.5) (0.95 0.5 0.5) (0.5 0.5 0.5) (0.5 1.2 0.5) (0.8 0.5 0.5)); ");
    EXPECT_TRUE(holds(c.said(text), "particles are outside the mesh, the first at "));
    const auto r = c.one(text + "clip yes;");
    ASSERT_EQ(r.clumps.size(), 3);
    const double left[] = {0.2, 0.5, 0.8};
    EXPECT_EQ(r.size(), 21);
    EXPECT_EQ(r.clipped, 14);
    forAll(r.position, i)
    {
        const riprap::DemClump& own = r.clumps[r.clump[i]];
        EXPECT_EQ(r.clump[i], i/7);
        EXPECT_EQ(own.position[0], left[i/7]);
        EXPECT_LT(std::abs(r.position[i].x() - own.position[0]), 0.1);
    }
}

TEST(SolidChecks, regionsAreJoined)
{
    const ChecksCase c("groups { one { } two { } } ");
    c.write("constant/triSurface/box.off", boxSurface(boundBox(point(0, 0, 0), 0.2*vector::one)));
    c.balls({0.3, 0.5});
    const auto r = c.regions(
        "water { set fluid; } balls { set solids; velocity (1 2 3); spin (4 5 6); " + list
        + "} brick { set solids; source clumpsFromSurface; file \"box.off\"; spheres 1; resolution "
          "12; centres ((0.2 0.2 0.2) (0.8 0.2 0.2)); group one; } crate { set solids; rigid yes; "
          "source box; box (0.4 0 0.7) (0.6 0.1 0.8); spacing 0.1; group two; } ");
    ASSERT_EQ(r.size(), 3);
    const solidSet all(joined(r));
    const riprap::DemParticles& p = all.particles;
    ASSERT_EQ(p.size(), std::size_t(6));
    EXPECT_EQ(p.id, (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(p.clump, (std::vector<std::int32_t>{-1, -1, 0, 1, 2, 2}));
    EXPECT_EQ(p.group, (std::vector<std::int32_t>{0, 0, 1, 1, 2, 2}));
    EXPECT_NEAR(p.position[3*4], 0.45, 1e-12);
    for (int d = 0; d < 3; ++d)
    {
        EXPECT_EQ(p.velocity[3*1 + d], 1 + d);
        EXPECT_EQ(p.spin[3*1 + d], 4 + d);
    }
    ASSERT_EQ(all.clumps.size(), std::size_t(3));
    EXPECT_EQ(all.clumps[1].shape, 0);
    EXPECT_EQ(all.clumps[2].shape, 1);
    EXPECT_EQ(all.clumps[2].group, 2);
    EXPECT_EQ(all.shapes.toc(), wordList({"brick", "crate"}));
    EXPECT_EQ(all.surfaces.toc(), wordList({"crate"}));
    EXPECT_EQ(all.surfaces.subDict("crate").get<label>("body"), 2);
    EXPECT_TRUE(joined(c.regions("balls { set solids; " + list + "}")).particles.clump.empty());
}

//- Ends that are one place: balls there are as near as they look from within
TEST(SolidChecks, overlapThroughAPeriodicEnd)
{
    BoxMesh ring;
    ring.sides(0, "cyclic");
    const ChecksCase c("walls { patches (); }", ring);
    const std::string region("a { set solids; " + list + "}");
    c.balls({0.06, 0.98});
    EXPECT_TRUE(holds(c.overlap(c.regions(region), 1e-4), "by 0.12 m"));
    c.balls({0.11, 0.9, 0.5});
    EXPECT_EQ(c.overlap(c.regions(region), 1e-4), "");
}
