// SPDX-License-Identifier: GPL-3.0-or-later
/*  Fluids of scenes in time directories: particles, records and states come back, and a scene goes
    on from them to the bit. */

#include "fluidCloud.H"
#include "picCloud.H"
#include "picRestart.H"
#include "runningFluid.hpp"
#include "sphRestart.H"
#include "timeWriter.H"

using namespace Foam;

namespace
{
    const double third = 1.0/3;
    const double t0 = 0.01, t1 = 0.02;

    const Water dam{point(0, 0, 0), point(0.4, 0.5, 0.6), Zero, 0.6};

    template<class Record>
    Record recordOf(double spacing)
    {
        Record run;
        run.spacing = spacing;
        run.time = third;
        run.particles = 48;
        run.initialParticles = 50;
        run.escaped = 2;
        run.steps = int64_t(1) << 40;
        run.device = "cpu";
        run.precision = "mixed";
        return run;
    }

    //- Particles in the order of ids
    particleCloud byId(const riprap::FluidState& state)
    {
        particleCloud c("fluid");
        c.position = toVectors(state.position);
        c.vectors.set("U", toVectors(state.velocity));
        c.scalars.set("p", toField<scalar>(state.pressure));
        c.scalars.set("rho", toField<scalar>(state.density));
        c.labels.set("id", toField<label>(state.id));
        sortByLabel(c, "id");
        return c;
    }

    //- As written at t0, by a thread while the scene moves on or at once
    template<class Run, class Cloud>
    particleCloud written(Run& run, Cloud& cloud, bool later)
    {
        timeWriter& writer = timeWriter::ofRun();
        writer.freeCores(later);
        writer.begin(run.time().timePath(), later);
        cloud.write();
        particleCloud now(byId(run.scene->fluid()));
        run.scene->advance(t1);
        cloud.moved();
        fileNameList required;
        for (const word& file : cloud.stateFiles())
            required.append(fileName("uniform/riprap")/file);
        writer.finish(fileNameList(), false, required);
        writer.wait();
        writer.freeCores(false);
        return now;
    }

    void expectSame(const particleCloud& a, const particleCloud& b)
    {
        EXPECT_EQ(a.labels["id"], b.labels["id"]);
        EXPECT_EQ(a.position, b.position);
        EXPECT_EQ(a.vectors["U"], b.vectors["U"]);
        EXPECT_EQ(a.scalars["p"], b.scalars["p"]);
    }

    void expectSameRecord(const restartRecord& a, const restartRecord& b)
    {
        EXPECT_EQ(a.time, b.time);
        EXPECT_EQ(a.particles, b.particles);
        EXPECT_EQ(a.initialParticles, b.initialParticles);
        EXPECT_EQ(a.escaped, b.escaped);
        EXPECT_EQ(a.steps, b.steps);
        EXPECT_EQ(a.device, b.device);
    }

    //- Written, read and continued
    template<class Run, class Cloud, class Record, class ReadState>
    void goesOn(Run& run, const Record& record, bool later, const ReadState& readState)
    {
        run.scene->advance(t0);
        Cloud cloud(run.mesh(), *run.scene, *run.scene, record);
        const particleCloud now(written(run, cloud, later));
        const particleCloud back(readParticleCloud(run.mesh(), "fluid"));
        expectSame(back, now);
        EXPECT_EQ(cloud.nParcels(), now.size());
        const particleCloud then(byId(run.scene->fluid()));
        run.start(0.1, {dam});
        run.scene->loadState(readState(run.time()));
        EXPECT_NEAR(run.scene->time(), t0, 1e-12);
        run.scene->advance(t1);
        expectSame(byId(run.scene->fluid()), then);
    }
}

TEST(FluidCloud, goesOnToTheBit)
{
    for (const bool later : {true, false})
    {
        RunningSph run(tank(2, 1, 1, 10), "maxVelocity 3;", "writeFormat binary;");
        run.start(0.1, {dam});
        sphRestart record(recordOf<sphRestart>(third));
        record.maxVelocity = 2*third;
        record.soundSpeed = 20*third;
        record.density = 1000*third;
        record.wild = 7;
        EXPECT_FALSE(hasSphRun(run.time()));
        goesOn<RunningSph, fluidCloud>(run, record, later, readSphState);
        ASSERT_TRUE(hasSphRun(run.time()));
        const sphRestart back(readSphRun(run.time()));
        expectSameRecord(back, record);
        EXPECT_EQ(back.spacing, third);
        EXPECT_EQ(back.maxVelocity, 2*third);
        EXPECT_EQ(back.density, 1000*third);
        EXPECT_EQ(back.wild, 7);
        const dictionary properties(readCloudProperties(run.time(), "fluid"));
        EXPECT_EQ(properties.get<scalar>("soundSpeed"), 20*third);
        EXPECT_EQ(properties.get<scalar>("density"), 1000*third);
        EXPECT_EQ(fluidSpacing(run.time()), third);
    }
}

TEST(PicCloud, goesOnToTheBit)
{
    for (const bool later : {true, false})
    {
        RunningPic run(tank(2, 1, 1, 10), "", "writeFormat binary;");
        run.start(0.1, {dam});
        picRestart record(recordOf<picRestart>(third));
        record.given = 0.1*third;
        record.passed["xMax"] = {3, int64_t(1) << 50, 2*third, -third};
        EXPECT_FALSE(hasPicRun(run.time()));
        goesOn<RunningPic, picCloud>(run, record, later, readPicState);
        ASSERT_TRUE(hasPicRun(run.time()));
        const picRestart back(readPicRun(run.time()));
        expectSameRecord(back, record);
        EXPECT_EQ(back.spacing, third);
        EXPECT_EQ(back.given, 0.1*third);
        const riprap::PicPassage passed(back.passed.at("xMax"));
        EXPECT_EQ(passed.in, 3);
        EXPECT_EQ(passed.out, int64_t(1) << 50);
        EXPECT_EQ(passed.volume, 2*third);
        EXPECT_EQ(passed.pending, -third);
        EXPECT_EQ(readCloudProperties(run.time(), "fluid").get<scalar>("spacing"), third);
    }
}

TEST(FluidCloud, recordsThatAreDamaged)
{
    ScratchCase c;
    sphRestart sph(recordOf<sphRestart>(-1));
    picRestart pic(recordOf<picRestart>(0.1));
    mkDir(c.path()/"0/uniform/riprap");
    writeSphRun(c.time(), sph);
    writePicRun(c.time(), pic);
    EXPECT_TRUE(holds(messageOf([&]() { readSphRun(c.time()); }),
        "not what riprapFoam wrote: spacing -1, maxVelocity 0"));
    EXPECT_TRUE(holds(messageOf([&]() { readPicRun(c.time()); }),
        "Not what riprapFoam wrote: spacing 0.1, given 0"));
}

//- As OpenFOAM's function objects see it
TEST(FluidCloud, onARegistry)
{
    RunningSph run(tank(2, 1, 1, 10), "maxVelocity 3;");
    run.start(0.1, {dam});
    const sphRestart record;
    fluidCloud cloud(run.mesh(), *run.scene, *run.scene, record);
    objectRegistry registry(IOobject("seen", "0", run.time()));
    cloud.writeObjects(registry);
    EXPECT_EQ(cloud.fieldNames(), wordList({"id", "h", "p", "rho", "U"}));
    const particleCloud now(byId(run.scene->fluid()));
    const auto& id = registry.lookupObject<IOField<label>>("id");
    const auto& p = registry.lookupObject<IOField<scalar>>("p");
    const auto& U = registry.lookupObject<IOField<vector>>("U");
    const auto& x = registry.lookupObject<IOField<point>>("position");
    ASSERT_EQ(id.size(), 24);
    forAll(id, i)
    {
        EXPECT_EQ(x[i], now.position[id[i]]);
        EXPECT_EQ(p[i], now.scalars["p"][id[i]]);
        EXPECT_NEAR(p[i], 1e4*(0.6 - x[i].z()), 0.5);
        EXPECT_EQ(U[i], vector(0, 0, 0));
    }
}

//- Of a run, of a cloud, of what setParticles was asked for
TEST(FluidCloud, spacing)
{
    ScratchCase c;
    EXPECT_TRUE(holds(messageOf([&]() { fluidSpacing(c.time()); }), "setParticlesDict"));
    c.writeDict("system/setParticlesDict", "spacing 0.3;");
    EXPECT_EQ(fluidSpacing(c.time()), 0.3);
    const std::string properties("0/uniform/lagrangian/fluid/cloudProperties");
    c.writeDict(properties, "spacing 0.2;");
    EXPECT_EQ(messageOf([&]() { fluidSpacing(c.time()); }),
        "Entry geometry is missing: has the file been cut short?");
    c.writeDict(properties, "geometry positions; spacing 0.2;");
    EXPECT_EQ(fluidSpacing(c.time()), 0.2);
    c.writeDict(properties, "geometry positions; spacing 0;");
    EXPECT_EQ(messageOf([&]() { fluidSpacing(c.time()); }),
        "Entry spacing is 0: it must be positive");
    c.write(properties, "");
    EXPECT_EQ(messageOf([&]() { fluidSpacing(c.time()); }),
        "The file is empty or cut short: it has no header of OpenFOAM's");
}
