// SPDX-License-Identifier: GPL-3.0-or-later
/*  What mesh and constant/g say about the space of particles. */

#include "api/sphScene.hpp"
#include "boxMesh.hpp"
#include "particleDomain.H"
#include "scratchCase.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    const char* const header = "FoamFile { version 2.0; format ascii; class "
                               "uniformDimensionedVectorField; object g; }\n";

    BoxMesh box()
    {
        BoxMesh box;
        box.divide(0, -1, 2, 3);
        box.divide(1, 0.5, 1, 1);
        box.divide(2, 3, 5, 2);
        return box;
    }

    std::string said(const BoxMesh& box, const std::string& g)
    {
        ScratchCase c;
        c.write("constant/g", header + g);
        const auto mesh = box.make(c.time());
        return messageOf([&]() { readParticleDomain(mesh()); });
    }

    const char* const down = "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);";
}

TEST(ParticleDomain, dimensionsBoundsAndGravity)
{
    ScratchCase c;
    c.write("constant/g", header + std::string(down));
    const auto mesh = box().make(c.time());
    const particleDomain d(readParticleDomain(mesh()));
    EXPECT_EQ(d.dimensions, 3);
    EXPECT_EQ(d.domainMin, (riprap::Vector3{{-1, 0.5, 3}}));
    EXPECT_EQ(d.domainMax, (riprap::Vector3{{2, 1, 5}}));
    EXPECT_EQ(d.gravity, (riprap::Vector3{{0, 0, -9.81}}));
    for (int a = 0; a < 3; ++a)
    {
        EXPECT_EQ(d.axes[a], a);
        EXPECT_FALSE(d.periodic[a]);
    }
    riprap::SphConfig config;
    setDomain(config, d);
    EXPECT_EQ(config.dimensions, 3);
    EXPECT_EQ(config.domainMax, d.domainMax);
    EXPECT_EQ(config.gravity, d.gravity);
}

TEST(ParticleDomain, emptyAndPeriodicAxes)
{
    const int expected[3][3] = {{1, 2, 0}, {0, 2, 1}, {0, 1, 2}};
    for (int empty = 0; empty < 3; ++empty)
    {
        ScratchCase c;
        c.write("constant/g", header + std::string(down));
        BoxMesh flat(box());
        flat.sides(empty, "empty");
        flat.divide(empty, 0, 1, 1);
        flat.sides((empty + 1) % 3, "cyclic");
        const auto mesh = flat.make(c.time());
        testing::internal::CaptureStdout();
        const particleDomain d(readParticleDomain(mesh()));
        const std::string log(testing::internal::GetCapturedStdout());
        EXPECT_EQ(d.dimensions, 2);
        for (int a = 0; a < 3; ++a)
        {
            EXPECT_EQ(d.axes[a], expected[empty][a]);
            EXPECT_EQ(d.periodic[a], a == (empty + 1) % 3);
        }
        // gravity along the empty axis is ignored
        EXPECT_EQ(d.gravity[2], empty == 2 ? 0 : -9.81);
    }
}

TEST(ParticleDomain, whatParticlesCannotUse)
{
    BoxMesh line(box());
    line.sides(0, "empty");
    line.sides(1, "empty");
    EXPECT_EQ(said(line, down), "The mesh has 1 directions that are not empty: particles need two "
                                "or three");
    BoxMesh mirror(box());
    mirror.type[3] = "symmetryPlane";
    EXPECT_TRUE(holds(said(mirror, down), "Patch yMax has the type symmetryPlane, which particles "
                                          "cannot use; valid are wall, patch (open), empty"));
    // a periodic pair that does not span the mesh: cells beyond it on one side
    BoxMesh sheared(box());
    sheared.sides(0, "cyclic");
    sheared.map = [](const point& p) { return point(p.x(), p.y(), p.z() + 0.2*p.x()); };
    EXPECT_TRUE(holds(said(sheared, down), "of type cyclic cannot be used: particles need periodic "
                                           "patches that are moved copies of each other"));
}

TEST(ParticleDomain, gravityInMetresPerSecondSquared)
{
    EXPECT_EQ(said(box(), "dimensions [0 1 -1 0 0 0 0]; value (0 0 -9.81);"),
        "constant/g: entry dimensions is [0 1 -1 0 0 0 0]: it must be [0 1 -2 0 0 0 0]");
    EXPECT_EQ(said(box(), "dimensions [0 1 -2 0 0 0 0]; value (0 0 -1e8);"),
        "constant/g: entry value is (0 0 -1e+08): it must be an acceleration in m/s2, at most 1e7");
    EXPECT_NE(said(box(), "dimensions [0 1 -2 0 0 0 0]; value { x 1; }"), "");
}

TEST(ParticleDomain, dictionariesThatMustBeThere)
{
    ScratchCase c;
    c.writeDict("constant/fluidProperties", "rho 1000;");
    EXPECT_EQ(readConstant("fluidProperties", c.time()).get<scalar>("rho"), 1000);
    c.writeDict("constant/fluidProperties", "rho 1000; rho 2;");
    EXPECT_TRUE(holds(messageOf([&]() { readConstant("fluidProperties", c.time()); }),
        "Entry rho is there twice"));
    EXPECT_NE(messageOf([&]() { readConstant("sphProperties", c.time()); }), "");
}
