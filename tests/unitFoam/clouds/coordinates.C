// SPDX-License-Identifier: GPL-3.0-or-later
/*  Clouds as OpenFOAM's utilities leave them: barycentric coordinates, labels of another size, and
    the case's own files beside those of processors. */

#include "boxMesh.hpp"
#include "particleCloudIO.H"
#include "scratchCase.hpp"
#include "timeWriter.H"

#include <cstring>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    struct CloudCase : ScratchCase
    {
        autoPtr<polyMesh> mesh;

        CloudCase()
        {
            BoxMesh box;
            for (int d = 0; d < 3; ++d) box.divide(d, 0, 1, 2);
            mesh = box.make(time());
        }

        void file(const std::string& name, const std::string& of, const std::string& text,
            const std::string& more = "format ascii;") const
        {
            write("0/lagrangian/fluid/" + name,
                "FoamFile { version 2.0; " + more + " class " + of + "; object " + name + "; }\n"
                    + text + '\n');
        }

        std::string said() const
        {
            return messageOf([&]() { readParticleCloud(mesh(), "fluid"); });
        }
    };

    const std::string positions("Cloud<passiveParticle>");
}

//- The first corner of a tetrahedron is its cell's centre, the others are of a face
TEST(Coordinates, throughTheirTetrahedron)
{
    CloudCase c;
    const face& f = c.mesh->faces()[c.mesh->cells()[5][0]];
    const label facei = c.mesh->cells()[5][0];
    c.file("coordinates", positions, "3((1 0 0 0) 5 " + name(facei) + " 1 (0 1 0 0) 5 "
        + name(facei) + " 1 (0.25 0.25 0.25 0.25) 5 " + name(facei) + " 1)");
    ASSERT_TRUE(hasParticleCloud(c.mesh(), "fluid"));
    EXPECT_TRUE(isRounded(c.mesh(), "fluid"));
    const particleCloud cloud(readParticleCloud(c.mesh(), "fluid"));
    ASSERT_EQ(cloud.size(), 3);
    const point& centre = c.mesh->cellCentres()[5];
    EXPECT_NEAR(mag(cloud.position[0] - centre), 0, 1e-14);
    EXPECT_EQ(cloud.cell, labelList(3, 5));
    double nearest = 1;
    for (const label v : f) nearest = min(nearest, mag(cloud.position[1] - c.mesh->points()[v]));
    EXPECT_NEAR(nearest, 0, 1e-14);
    // three corners of the square face have their mean a sixth of its diagonal from its middle
    const point middle((4*cloud.position[2] - centre)/3);
    EXPECT_NEAR(mag(middle - c.mesh->faceCentres()[facei]), std::sqrt(0.5)/6, 1e-12);
    c.file("coordinates", positions, "1((1 0 0 0) 8 0 1)");
    EXPECT_EQ(c.said(), "particle 0 is in cell 8 of a mesh of 8 cells");
}

//- Written by a machine with labels of 64 bits, numbers of 32
TEST(Coordinates, ofAnotherLabelSize)
{
    CloudCase c;
    std::string block;
    const auto put = [&](const auto& value)
    { block.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
    for (const float x : {0.25f, 0.5f, 0.75f}) put(x);
    put(std::int64_t(4));
    c.file("positions", positions, "1((" + block + "))",
        "format binary; arch \"LSB;label=64;scalar=32\";");
    EXPECT_EQ(c.said(), "");
    const particleCloud cloud(readParticleCloud(c.mesh(), "fluid"));
    EXPECT_EQ(cloud.position[0], point(0.25, 0.5, 0.75));
}

TEST(Coordinates, whatIsDamaged)
{
    CloudCase c;
    c.file("positions", positions, "2((0.1 0.1 0.1) 0 (0.9 0.9 0.9) 7)");
    EXPECT_EQ(c.said(), "");
    c.file("U", "vectorField", "3((1 0 0) (1 0 0) (1 0 0))");
    EXPECT_EQ(c.said(), "holds 3 values for 2 particles");
    c.file("U", "vectorField", "2((1 0 0) (2 0 0))");
    const particleCloud cloud(readParticleCloud(c.mesh(), "fluid"));
    EXPECT_EQ(requiredVectors(c.mesh(), cloud, "U")[1], vector(2, 0, 0));
    EXPECT_EQ(messageOf([&]() { requiredScalars(c.mesh(), cloud, "rho"); }),
        "no scalar field rho; there are ()");
    EXPECT_EQ(messageOf([&]() { requiredVectors(c.mesh(), cloud, "V"); }),
        "no vector field V; there are (U)");
    c.write("0/lagrangian/fluid/p", "");
    EXPECT_EQ(c.said(), "The file is empty or cut short: it has no header of OpenFOAM's");
    EXPECT_TRUE(rm(c.path()/"0/lagrangian/fluid/p"));
    c.file("positions", positions, "-1()");
    EXPECT_TRUE(holds(c.said(), "-1 particles; a cloud, which counts them in 32 bits, can have "));
}

//- Positions and ids of the case's own folder, in the order of ids where positions are
TEST(Coordinates, undivided)
{
    CloudCase c;
    pointField x, there(2, point(0.1, 0.2, 0.3));
    there[1] = point(0.4, 0.5, 0.6);
    labelField id;
    EXPECT_FALSE(readUndivided(c.time(), "fluid", x, id));
    c.file("positions", positions, "2((0.1 0.2 0.3) 99 (0.4 0.5 0.6) -1)");
    EXPECT_FALSE(readUndivided(c.time(), "fluid", x, id));
    c.file("id", "labelField", "2(5 3)");
    ASSERT_TRUE(readUndivided(c.time(), "fluid", x, id));
    EXPECT_EQ(x, there);
    EXPECT_EQ(id, labelField(labelList({5, 3})));
    c.file("positions", positions, "2((0.1 0.2 0.3) 99 (0.4 0.5 0.6) -1)",
        std::string("format ascii; note \"") + inOrderOfIds + "\";");
    ASSERT_TRUE(readUndivided(c.time(), "fluid", x, id));
    EXPECT_EQ(x, there);
    EXPECT_EQ(id, labelField(labelList({3, 5})));
    c.file("id", "labelField", "3(1 2 3)");
    EXPECT_FALSE(readUndivided(c.time(), "fluid", x, id));
}
