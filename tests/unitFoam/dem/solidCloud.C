// SPDX-License-Identifier: GPL-3.0-or-later
/*  What a scene of solids writes: the cloud, bodies, bonds and the exact state, read back. */

#include "timeWriter.H"
#include "writtenSolids.hpp"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{
    //- Spheres that fall on each other, one that slips over the floor; inertias of their own
    void addHeap(RunningSolids& c)
    {
        c.add(point(0.5, 0.5, 0.05), 0.05, vector(0.1, 0, 0), vector(1, 2, 3));
        c.add(point(0.51, 0.5, 0.16), 0.05, vector(0, 0, -1), Zero, "raft");
        c.add(point(0.3, 0.3, 0.3), 0.1/3);
        c.add(point(0.3, 0.7, 0.05 - 1e-4*1000*4*std::acos(-1.0)/3*1.25e-4), 0.05,
            vector(0.4, 0, 0));
        riprap::DemParticles& p = c.solids.particles;
        for (std::size_t i = 0; i < p.size(); ++i) p.inertia.push_back(0.01/(i + 3));
    }

    const std::string heap(rock("groups { raft { } }", "",
        "stiffness 1e5; restitution 0.8; friction 0.3;", "normal linear; tangential history;"));

    vector vectorOf(const std::vector<double>& v, int i)
    {
        return vector(v[3*i], v[3*i + 1], v[3*i + 2]);
    }
}

//- What the scene has, by id; what never changes as it was given, whatever the scene's precision is
TEST(SolidCloud, readBack)
{
    std::string mixed(heap);
    mixed.replace(mixed.find("double"), 6, "mixed");
    WrittenSolids c(mixed);
    addHeap(c);
    const riprap::DemParticles given(c.solids.particles);
    c.startCloud();
    c.writeAt(0.1);
    const solidSet back(readSolids(c.fv(), c.settings));
    const riprap::DemState now(c.scene->motion());
    ASSERT_EQ(back.particles.size(), 4u);
    for (int j = 0; j < 4; ++j)
    {
        const int i = now.id[j];
        EXPECT_EQ(back.particles.id[i], i);
        EXPECT_EQ(vectorOf(back.particles.position, i), vectorOf(now.position, j));
        EXPECT_EQ(vectorOf(back.particles.velocity, i), vectorOf(now.velocity, j));
        EXPECT_EQ(vectorOf(back.particles.spin, i), vectorOf(now.spin, j));
        EXPECT_EQ(back.particles.radius[i], given.radius[i]);
        EXPECT_EQ(back.particles.mass[i], given.mass[i]);
        EXPECT_EQ(back.particles.inertia[i], given.inertia[i]);
        EXPECT_EQ(back.particles.group[i], i == 1);
    }
    const particleCloud cloud(readParticleCloud(c.fv(), "solids"));
    const labelField& contacts = cloud.labels["contacts"];
    const riprap::DemState all(c.scene->particles());
    forAll(contacts, k)
    {
        const label id = cloud.labels["origId"][k];
        for (int j = 0; j < 4; ++j)
        {
            if (all.id[j] != id) continue;
            EXPECT_EQ(contacts[k], all.contacts[j]);
            EXPECT_LT(mag(cloud.vectors["force"][k] - vectorOf(all.force, j)), 1e-12);
            EXPECT_LT(mag(cloud.vectors["moment"][k] - vectorOf(all.moment, j)), 1e-12);
        }
    }
    EXPECT_EQ(readCloudProperties(c.time(), "solids").get<wordList>("groups"),
        wordList({"free", "raft"}));
    EXPECT_EQ(c.cloud->stateFiles(), wordList({"demRun", "demState"}));
    EXPECT_EQ(readDemRun(c.time()).time, c.time().value());
}

//- From the state and the cloud, in the middle of contacts that slip: the same bits as without a
//  stop
TEST(SolidCloud, goesOnToTheBit)
{
    WrittenSolids c(heap);
    addHeap(c);
    c.startCloud();
    c.writeAt(0.13);
    ASSERT_GT(c.scene->contacts().a.size(), 0u);
    const riprap::DemConfig before(c.settings.config);
    const auto there = c.scene->saveState();
    c.scene->advance(0.3);
    const riprap::DemState expected(c.scene->particles());
    c.settings.config.timeStep = c.record.timeStep;
    c.goOn();
    EXPECT_TRUE(matchesCloud(c.solids.particles, *c.scene, c.settings.config, 1, 17));
    EXPECT_EQ(c.scene->saveState(), there);
    c.scene->advance(0.3);
    const riprap::DemState now(c.scene->particles());
    EXPECT_EQ(now.position, expected.position);
    EXPECT_EQ(now.velocity, expected.velocity);
    EXPECT_EQ(now.spin, expected.spin);
    EXPECT_EQ(now.force, expected.force);
}

//- Bodies with their pose now and that of the start, also over a second run
TEST(SolidCloud, rigidBodies)
{
    WrittenSolids c(rock("groups { raft { gravity no; } }", "patches ();"));
    c.add(point(0.4, 0.5, 0.5), 0.05);
    c.add(point(0.6, 0.5, 0.5), 0.05);
    riprap::DemClump& body = c.body(0, point(0.5, 0.5, 0.5), 3, vector(0.02, 0.05, 0.06), "raft");
    body.velocity = {{0.1, 0.2, 0}};
    body.spin = {{0, 0, 2}};
    body.volume = 0.25;
    c.startCloud();
    c.writeAt(0.2);
    for (const double t : {0.2, 0.5})
    {
        if (t > 0.3)
        {
            c.goOn();
            c.writeAt(t);
        }
        const solidSet back(readSolids(c.fv(), c.settings));
        ASSERT_EQ(back.clumps.size(), 1u);
        const riprap::DemClump& now = back.clumps[0];
        const std::array<double, 4> turned{{std::cos(t), 0, 0, std::sin(t)}};
        for (int d = 0; d < 3; ++d)
        {
            EXPECT_NEAR(now.position[d], 0.5 + t*body.velocity[d], 1e-9);
            EXPECT_NEAR(now.velocity[d], body.velocity[d], 1e-12);
            EXPECT_NEAR(now.spin[d], body.spin[d], 1e-9);
            EXPECT_EQ(now.start.position[d], 0.5);
            EXPECT_EQ(now.inertia[d], body.inertia[d]);
        }
        for (int d = 0; d < 4; ++d) EXPECT_NEAR(now.orientation[d], turned[d], 1e-7);
        EXPECT_EQ(now.start.orientation, (std::array<double, 4>{{1, 0, 0, 0}}));
        EXPECT_EQ(now.mass, 3);
        EXPECT_EQ(now.volume, 0.25);
        EXPECT_EQ(now.group, 1);
        EXPECT_EQ(back.particles.clump, (std::vector<std::int32_t>{0, 0}));
    }
}

//- Axis times angle, from 0 to pi: after 5 rad back by 2 pi - 5
TEST(SolidCloud, turned)
{
    WrittenSolids c(rock("orientation yes; groups { free { gravity no; } }", "patches ();"));
    c.add(point(0.2, 0.5, 0.5), 0.05, Zero, vector(0, 3, 4));
    c.add(point(0.5, 0.5, 0.5), 0.05);
    c.startCloud();
    for (const double angle : {1.0, 3.0, 5.0})
    {
        c.writeAt(angle/5);
        const particleCloud cloud(readParticleCloud(c.fv(), "solids"));
        const double expected = angle < 4 ? angle : angle - 2*std::acos(-1.0);
        forAll(cloud.position, k)
        {
            const bool first = cloud.labels["origId"][k] == 0;
            EXPECT_LT(mag(cloud.vectors["turned"][k] - (first ? expected : 0)*vector(0, 0.6, 0.8)),
                1e-6)
                << angle;
        }
    }
}

//- Made later by a thread that writes, while the scene moves on: the same files
TEST(SolidCloud, sameFilesLater)
{
    std::string files[2];
    for (const bool later : {false, true})
    {
        WrittenSolids c(heap);
        addHeap(c);
        c.startCloud();
        c.run(0.05);
        timeWriter& writer = timeWriter::ofRun();
        writer.freeCores(later);
        writer.begin(c.path()/"0.05", later);
        c.write();
        c.run(0.1);
        writer.finish(fileNameList());
        writer.wait();
        writer.freeCores(false);
        for (const char* name : {"positions", "U", "omega", "force", "moment", "radius", "mass",
                 "inertia", "material", "group", "contacts", "brokenBonds", "origId"})
            files[later] += c.read(std::string("0.05/lagrangian/solids/") + name);
        files[later] += c.read("0.05/uniform/riprap/demState");
    }
    EXPECT_GT(files[0].size(), 2000u);
    EXPECT_TRUE(files[0] == files[1]);
}
