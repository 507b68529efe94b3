// SPDX-License-Identifier: GPL-3.0-or-later
/*  Solids of a time: particles, bonds and clumps come back as they were written, in formats, and by
    names where the settings' order has changed; what is refused. */

#include "solidRegionCase.hpp"
#include "timeWriter.H"

using namespace Foam;

namespace
{
    const std::string contact("bonds { glue { normalStiffness 2; shearStiffness 1; } cement { "
                              "normalStiffness 2; shearStiffness 1; } } ");
    const std::string asWritten(SolidRegionCase::rockAndWood + contact
        + "groups { held { fixed all; } loose { } } ");
    const std::string otherOrder(
        "materials { iron { rho 7000; E 1e7; nu 0.2; } wood { rho 500; E 1e7; nu 0.2; } rock { rho "
        "2000; E 1e7; nu 0.2; } } bonds { cement { normalStiffness 2; shearStiffness 1; } glue { "
        "normalStiffness 2; shearStiffness 1; } } groups { loose { } held { } } ");

    //- Five balls with ids that do not count up, two of them a clump
    riprap::DemParticles balls()
    {
        riprap::DemParticles p;
        p.id = {7, 3, 12, 0, 5};
        p.material = {0, 1, 0, 1, 0};
        p.group = {0, 1, 2, 0, 1};
        p.clump = {-1, 0, -1, 0, -1};
        for (int i = 0; i < 5; ++i)
        {
            for (int d = 0; d < 3; ++d)
            {
                p.position.push_back(0.1 + 0.17*i + std::sqrt(1e-4*(d + 1)));
                p.velocity.push_back(i - d/3.0);
                p.spin.push_back(1e-9/(1 + i + d));
            }
            p.radius.push_back(0.01 + 0.001*i);
            p.mass.push_back(std::sqrt(2.0 + i));
        }
        return p;
    }

    riprap::DemBondState bonds()
    {
        riprap::DemBondState b;
        b.a = {3, 12, 7};
        b.b = {5, 7, 5};
        b.type = {0, 1, 1};
        b.broken = {0, 2, 0};
        b.restGap = {1e-3, -0.1/3, 0};
        return b;
    }

    //- One that has moved, and one that stands where it was made
    std::vector<riprap::DemClump> clumps()
    {
        std::vector<riprap::DemClump> all(2);
        for (int k = 0; k < 2; ++k)
        {
            riprap::DemClump& c = all[k];
            for (int d = 0; d < 3; ++d)
            {
                c.position[d] = 0.1*(d + 1)/(k + 3.0);
                c.velocity[d] = d + k;
                c.spin[d] = d - k;
                c.inertia[d] = 1.0/(d + k + 3);
                c.start.position[d] = 0.7*d;
            }
            c.orientation = {{0.5, 0.5, -0.5, 0.5}};
            c.start.orientation = {{0.6, 0, 0.8, 0}};
            c.mass = 1.0/3 + k;
            c.volume = 1.0/7 + k;
            c.group = 1 + k;
        }
        all[0].moved = true;
        all[1].shape = 4;
        return all;
    }

    struct FilesCase : SolidRegionCase
    {
        explicit FilesCase(const std::string& control = "writeFormat ascii; writePrecision 17;")
        :
            SolidRegionCase(BoxMesh(), asWritten, control)
        {}

        void writeSolids(const riprap::DemParticles& p) const
        {
            particleCloud cloud(solidCloudOf(p));
            addSolidNames(cloud.properties, *settings);
            writeParticleCloud(mesh(), cloud);
            writeBondFiles(mesh().time(), bonds());
            writeClumpFiles(mesh().time(), clumps());
            timeWriter::ofRun().wait();
        }

        void become(const std::string& properties)
        {
            writeDict("constant/solidProperties", properties);
            settings = std::make_unique<const demSettings>(readDemSettings(mesh()));
        }

        solidSet read() const { return readSolids(mesh(), *settings); }
        std::string readSaid() const { return messageOf([&]() { read(); }); }

        //- With another text in a file beside the cloud's fields or of bonds or clumps
        std::string saidWith(
            const std::string& file, const std::string& from, const std::string& to)
        {
            const std::string whole(ScratchCase::read(file));
            std::string changed(whole);
            EXPECT_TRUE(holds(whole, from)) << whole;
            changed.replace(changed.rfind(from), from.size(), to);
            write(file, changed);
            std::string said(readSaid());
            write(file, whole);
            return said;
        }
    };

    //- Numbers of the particles above in the order of their ids
    const std::vector<int> order{3, 1, 4, 0, 2};

    void expectBonds(const solidSet& s, const std::vector<std::int32_t>& type)
    {
        const riprap::DemBondState b(bonds());
        EXPECT_EQ(s.bonds.a, b.a);
        EXPECT_EQ(s.bonds.b, b.b);
        EXPECT_EQ(s.bonds.gap, b.restGap);
        EXPECT_EQ(s.bonds.type, type);
        EXPECT_EQ(s.brokenBond, (std::vector<bool>{false, true, false}));
        EXPECT_EQ(s.lostBonds, 0);
    }

    void expectClumps(const solidSet& s, const std::vector<int>& group)
    {
        const auto given = clumps();
        ASSERT_EQ(s.clumps.size(), given.size());
        for (std::size_t k = 0; k < given.size(); ++k)
        {
            const riprap::DemClump &c = s.clumps[k], &g = given[k];
            EXPECT_EQ(c.position, g.position);
            EXPECT_EQ(c.velocity, g.velocity);
            EXPECT_EQ(c.spin, g.spin);
            EXPECT_EQ(c.inertia, g.inertia);
            EXPECT_EQ(c.orientation, g.orientation);
            EXPECT_EQ(c.mass, g.mass);
            EXPECT_EQ(c.volume, g.volume);
            EXPECT_EQ(c.group, group[k]);
            EXPECT_EQ(c.shape, g.shape);
            EXPECT_TRUE(c.moved);
            EXPECT_EQ(c.start.position, g.moved ? g.start.position : g.position);
            EXPECT_EQ(c.start.orientation, g.moved ? g.start.orientation : g.orientation);
        }
    }
}

TEST(SolidFiles, comeBackToTheBit)
{
    for (const char* format : {"writeFormat ascii; writePrecision 17;", "writeFormat binary;",
             "writeFormat ascii; writePrecision 17; writeCompression on;"})
    {
        const FilesCase c(format);
        const riprap::DemParticles p(balls());
        c.writeSolids(p);
        const solidSet s(c.read());
        ASSERT_EQ(s.particles.size(), std::size_t(5)) << format;
        for (int k = 0; k < 5; ++k)
        {
            const int i = order[k];
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_EQ(s.particles.position[3*k + d], p.position[3*i + d]);
                EXPECT_EQ(s.particles.velocity[3*k + d], p.velocity[3*i + d]);
                EXPECT_EQ(s.particles.spin[3*k + d], p.spin[3*i + d]);
            }
            EXPECT_EQ(s.particles.id[k], p.id[i]);
            EXPECT_EQ(s.particles.radius[k], p.radius[i]);
            EXPECT_EQ(s.particles.mass[k], p.mass[i]);
            EXPECT_EQ(s.particles.material[k], p.material[i]);
            EXPECT_EQ(s.particles.group[k], p.group[i]);
            EXPECT_EQ(s.particles.clump[k], p.clump[i]);
        }
        EXPECT_TRUE(s.particles.inertia.empty());
        expectBonds(s, {0, 1, 1});
        expectClumps(s, {1, 2});
    }
}

TEST(SolidFiles, namesCountNotNumbers)
{
    FilesCase c;
    riprap::DemParticles p(balls());
    p.inertia = {1, 2, 3, 4, 5};
    c.writeSolids(p);
    c.become(otherOrder);
    const solidSet s(c.read());
    // free, held, loose are free, loose, held now; rock and wood come after iron, turned round
    const std::vector<std::int32_t> group{0, 2, 1}, material{2, 1};
    for (int k = 0; k < 5; ++k)
    {
        EXPECT_EQ(s.particles.group[k], group[p.group[order[k]]]);
        EXPECT_EQ(s.particles.material[k], material[p.material[order[k]]]);
        EXPECT_EQ(s.particles.inertia[k], p.inertia[order[k]]);
    }
    expectBonds(s, {1, 0, 0});
    expectClumps(s, {2, 1});
    // one is no more
    c.become(std::string(SolidRegionCase::rockAndWood) + contact + "groups { held { } }");
    EXPECT_EQ(c.readSaid(), "Unknown group loose; constant/solidProperties has (free held)");
    c.become(std::string(SolidRegionCase::rockAndWood) + "groups { held { } loose { } }");
    EXPECT_EQ(c.readSaid(), "Unknown bond type glue; constant/solidProperties has ()");
}

TEST(SolidFiles, brokenBonds)
{
    const FilesCase c;
    // 12 has left, with its broken bond
    riprap::DemParticles p(balls());
    p.id[2] = 13;
    c.writeSolids(p);
    solidSet s(c.read());
    EXPECT_EQ(s.lostBonds, 1);
    EXPECT_EQ(s.bonds.a, (std::vector<std::int32_t>{3, 7}));
    EXPECT_EQ(s.dropBroken(), 0);

    const FilesCase whole;
    whole.writeSolids(balls());
    s = whole.read();
    EXPECT_EQ(s.dropBroken(), 1);
    EXPECT_EQ(s.bonds.a, (std::vector<std::int32_t>{3, 7}));
    EXPECT_EQ(s.bonds.b, (std::vector<std::int32_t>{5, 5}));
    EXPECT_EQ(s.bonds.type, (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(s.bonds.gap, (std::vector<double>{1e-3, 0}));
    EXPECT_EQ(s.brokenBond, (std::vector<bool>{false, false}));
}

//- Of other programs, or of older files: the least that a cloud needs
TEST(SolidFiles, whatMayBeMissing)
{
    FilesCase c;
    c.writeSolids(balls());
    const fileName fields(c.path()/"0/lagrangian/solids"),
        files(c.path()/"0/uniform/lagrangian/solids");
    for (const char* field : {"mass", "omega", "origId", "group", "clump"}) rm(fields/field);
    for (const char* field : {"startPosition", "shape"}) rm(files/"clumps"/field);
    rmDir(files/"bonds");
    const solidSet s(c.read());
    const riprap::DemParticles p(balls());
    for (int i = 0; i < 5; ++i)
    {
        EXPECT_EQ(s.particles.id[i], i);
        EXPECT_EQ(s.particles.group[i], 0);
        EXPECT_NEAR(s.particles.mass[i], (p.material[i] ? 500 : 2000)*ballOf(p.radius[i]), 1e-15);
        EXPECT_EQ(s.particles.spin[i], 0);
    }
    EXPECT_TRUE(s.particles.clump.empty());
    EXPECT_TRUE(s.bonds.a.empty());
    ASSERT_EQ(s.clumps.size(), std::size_t(2));
    EXPECT_EQ(s.clumps[0].start.position, s.clumps[0].position);
    EXPECT_EQ(s.clumps[0].volume, 0);
    EXPECT_EQ(s.clumps[1].shape, -1);
    // without names numbers are those of the settings
    rm(files/"cloudProperties");
    rmDir(files/"clumps");
    c.become(otherOrder);
    EXPECT_EQ(c.read().particles.material[1], 1);
    // nothing to write
    writeBondFiles(c.time(), riprap::DemBondState());
    writeClumpFiles(c.time(), {});
    timeWriter::ofRun().wait();
    EXPECT_FALSE(isDir(files/"bonds") || isDir(files/"clumps"));
}

//- Masses are the cloud's, made with the density of then
TEST(SolidFiles, densitiesThatHaveChanged)
{
    FilesCase c;
    c.writeSolids(balls());
    std::string other(otherOrder);
    other.replace(other.find("rho 2000"), 8, "rho 2100");
    c.become(other);
    const std::string said(c.readSaid());
    EXPECT_TRUE(holds(said,
        "Material rock: rho is 2100, and the masses of lagrangian/solids at time 0 were made with "
        "2000 ("))
        << said;
    EXPECT_TRUE(holds(said, "Run setParticles to make them anew, or take rho back"));
    // one that no particle has may change, and all where the cloud has no masses
    rm(c.path()/"0/lagrangian/solids/mass");
    EXPECT_EQ(c.readSaid(), "");
    FilesCase rocks;
    riprap::DemParticles p(balls());
    p.material.assign(5, 0);
    rocks.writeSolids(p);
    other = otherOrder;
    other.replace(other.find("rho 500"), 7, "rho 600");
    rocks.become(other);
    EXPECT_EQ(rocks.readSaid(), "");
}

TEST(SolidFiles, whatIsRefused)
{
    FilesCase c;
    EXPECT_TRUE(holds(c.readSaid(), "There are no particles at time 0: "));
    c.writeSolids(balls());
    EXPECT_EQ(c.readSaid(), "");
    const std::string fields("0/lagrangian/solids/"), files("0/uniform/lagrangian/solids/");
    EXPECT_EQ(c.saidWith(fields + "material", "5(0 1 0 1 0)", "5(0 1 0 2 0)"),
        "lagrangian/solids/material has the value 2 at entry 0: it counts from 0 in (rock wood)");
    EXPECT_EQ(c.saidWith(fields + "group", "5(0 1 2 0 1)", "5(0 -1 2 0 1)"),
        "lagrangian/solids/group has the value -1 at entry 1: it counts from 0 in (free held "
        "loose)");
    EXPECT_TRUE(holds(c.saidWith(fields + "origId", "5(7 3 12 0 5)", "5(7 3 12 3 5)"),
        "lagrangian/solids/origId: 1 ids occur more than once"));
    EXPECT_TRUE(holds(c.saidWith(files + "bonds/b", "3(5 7 5)", "3(5 7 7)"),
        "/bonds/a\": bond 2 joins the particles 7 and 7, which are not two of lagrangian/solids"));
    EXPECT_TRUE(holds(c.saidWith(files + "bonds/a", "3(3 12 7)", "3(4 12 7)"), "bond 0 joins the "
        "particles 4 and 5, which are not two of lagrangian/solids"));
    EXPECT_EQ(c.saidWith(files + "bonds/broken", "3(0 2 0)", "2(0 2)"),
        "The file has 2 values, others beside it 3");
    EXPECT_EQ(c.saidWith(files + "clumps/group", "2(1 2)", "1(1)"),
        "The file has 1 values, others beside it 2");
    rm(c.path()/(fields + "radius"));
    EXPECT_EQ(c.readSaid(), "no scalar field radius; there are (mass)");
}

//- Files of text with OpenFOAM's six digits: orientations are of length one again
TEST(SolidFiles, orientationsOfFewDigits)
{
    FilesCase c("writeFormat ascii; writePrecision 3;");
    riprap::DemClump turned;
    for (int d = 0; d < 4; ++d) turned.orientation[d] = (d + 1)/std::sqrt(30.0);
    turned.mass = 1;
    writeParticleCloud(c.mesh(), solidCloudOf(balls()));
    writeClumpFiles(c.mesh().time(), {turned, turned});
    timeWriter::ofRun().wait();
    double length = 0;
    for (const double q : c.read().clumps[1].orientation) length += q*q;
    EXPECT_NEAR(length, 1, 1e-15);
}

TEST(SolidFiles, numbersThatMeanNothing)
{
    FilesCase c;
    c.writeSolids(balls());
    const std::string files("0/uniform/lagrangian/solids/");
    EXPECT_TRUE(holds(c.saidWith(files + "bonds/type", "3(0 1 1)", "3(0 7 1)"),
        "bonds/type has the value 7 at entry 1: it counts from 0 in (glue cement)"));
    EXPECT_TRUE(holds(c.saidWith(files + "clumps/group", "2(1 2)", "2(1 9)"),
        "clumps/group has the value 9 at entry 1: it counts from 0 in (free held loose)"));
    // names are those of the settings where the cloud has none
    rm(c.path()/(files + "cloudProperties"));
    EXPECT_EQ(c.readSaid(), "");
}
