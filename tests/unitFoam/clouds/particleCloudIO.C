// SPDX-License-Identifier: GPL-3.0-or-later
/*  Clouds in time directories: the same bits come back; what is damaged is named. */

#include "boxMesh.hpp"
#include "particleCloudIO.H"
#include "scratchCase.hpp"
#include "timeWriter.H"

#include <gtest/gtest.h>
#include <random>

using namespace Foam;

namespace
{
    particleCloud cloudOf(label n)
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> in(0, 1);
        particleCloud c("fluid", n);
        labelField id(n);
        scalarField rho(n);
        vectorField U(n);
        forAll(id, i)
        {
            c.position[i] = point(in(random), in(random), in(random));
            id[i] = 3*i + 1;
            rho[i] = 1e3*in(random);
            U[i] = vector(in(random) - 0.5, 1e-9*in(random), 1e12*in(random));
        }
        c.labels.set("id", id);
        c.scalars.set("rho", rho);
        c.vectors.set("U", U);
        c.properties.add("spacing", 0.01);
        return c;
    }

    BoxMesh block()
    {
        BoxMesh box;
        for (int d = 0; d < 3; ++d) box.divide(d, 0, 1, 3);
        return box;
    }

    void expectSame(const particleCloud& a, const particleCloud& b)
    {
        EXPECT_EQ(a.position, b.position);
        EXPECT_EQ(a.labels["id"], b.labels["id"]);
        EXPECT_EQ(a.scalars["rho"], b.scalars["rho"]);
        EXPECT_EQ(a.vectors["U"], b.vectors["U"]);
    }
}

TEST(ParticleCloudIO, comesBackToTheBit)
{
    for (const char* format : {"writeFormat binary;", "writeFormat ascii; writePrecision 17;",
             "writeFormat ascii; writePrecision 17; writeCompression on;"})
    {
        for (const label n : {0, 1, 5000})
        {
            ScratchCase c(format);
            const auto mesh = block().make(c.time());
            EXPECT_FALSE(hasParticleCloud(mesh(), "fluid"));
            const particleCloud cloud(cloudOf(n));
            writeParticleCloud(mesh(), cloud);
            timeWriter::ofRun().wait();
            ASSERT_TRUE(hasParticleCloud(mesh(), "fluid")) << format;
            EXPECT_FALSE(hasParticleCloud(mesh(), "solids"));
            EXPECT_FALSE(isRounded(mesh(), "fluid"));
            const particleCloud back(readParticleCloud(mesh(), "fluid"));
            ASSERT_EQ(back.size(), n);
            if (n) expectSame(back, cloud);
            forAll(back.position, i)
                EXPECT_TRUE(mesh->pointInCell(back.position[i], back.cell[i]));
            const dictionary properties(readCloudProperties(c.time(), "fluid"));
            EXPECT_EQ(properties.get<scalar>("spacing"), 0.01);
            EXPECT_EQ(properties.get<word>("geometry"), "positions");
            EXPECT_EQ(properties.subDict("processor0").get<label>("particleCount"), n);
        }
    }
}

//- As reconstructPar leaves them: fields in another order than positions, which are in that of ids
TEST(ParticleCloudIO, fieldsFollowTheOrderOfIds)
{
    ScratchCase c("writeFormat ascii; writePrecision 17;");
    const auto mesh = block().make(c.time());
    const particleCloud cloud(cloudOf(40));
    particleCloud turned(cloud);
    labelList order(identity(40));
    Foam::reverse(order);
    turned.labels["id"] = labelField(cloud.labels["id"], order);
    turned.scalars["rho"] = scalarField(cloud.scalars["rho"], order);
    turned.vectors["U"] = vectorField(cloud.vectors["U"], order);
    writeParticleCloud(mesh(), turned);
    timeWriter::ofRun().wait();
    // what the header says of positions in the order of ids
    std::string text = c.read("0/lagrangian/fluid/positions");
    EXPECT_FALSE(holds(text, inOrderOfIds));
    text.insert(text.find("object"), std::string("note \"") + inOrderOfIds + "\"; ");
    c.write("0/lagrangian/fluid/positions", text);
    testing::internal::CaptureStdout();
    const particleCloud back(readParticleCloud(mesh(), "fluid"));
    EXPECT_TRUE(holds(testing::internal::GetCapturedStdout(), "they are put in the order of ids"));
    expectSame(back, cloud);
}

TEST(ParticleCloudIO, damagedFiles)
{
    ScratchCase c("writeFormat ascii;");
    const auto mesh = block().make(c.time());
    const auto read = [&]() { return messageOf([&]() { readParticleCloud(mesh(), "fluid"); }); };
    writeParticleCloud(mesh(), cloudOf(10));
    timeWriter::ofRun().wait();
    EXPECT_EQ(read(), "");

    const std::string rho(c.read("0/lagrangian/fluid/rho"));
    c.write("0/lagrangian/fluid/rho", "");
    EXPECT_EQ(read(), "The file is empty or cut short: it has no header of OpenFOAM's");
    const std::size_t at = rho.find("\n10(");
    ASSERT_NE(at, std::string::npos);
    c.write("0/lagrangian/fluid/rho", rho.substr(0, at) + "\n2(1 2)\n");
    EXPECT_EQ(read(), "holds 2 values for 10 particles");
    c.write("0/lagrangian/fluid/rho", rho);

    const std::string positions(c.read("0/lagrangian/fluid/positions"));
    const std::size_t end = positions.rfind(") ") + 2;
    c.write("0/lagrangian/fluid/positions", positions.substr(0, end) + "99\n)\n");
    EXPECT_TRUE(holds(read(), "particle 9 is in cell 99 of a mesh of 27 cells"));
    c.write("0/lagrangian/fluid/positions", positions.substr(0, positions.size()/2));
    EXPECT_NE(read(), "");
}

TEST(ParticleCloudIO, fieldsThatAreNeeded)
{
    ScratchCase c;
    const auto mesh = block().make(c.time());
    particleCloud cloud(cloudOf(3));
    EXPECT_EQ(requiredScalars(mesh(), cloud, "rho"), cloud.scalars["rho"]);
    EXPECT_EQ(requiredVectors(mesh(), cloud, "U"), cloud.vectors["U"]);
    EXPECT_TRUE(holds(messageOf([&]() { requiredScalars(mesh(), cloud, "p"); }), "rho"));
    cloud.scalars["rho"].resize(2);
    EXPECT_EQ(messageOf([&]() { writeParticleCloud(mesh(), cloud); }),
        "field rho of cloud fluid has 2 values for 3 particles");
    timeWriter::ofRun().wait();
}
