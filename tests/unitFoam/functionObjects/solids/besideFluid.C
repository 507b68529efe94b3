// SPDX-License-Identifier: GPL-3.0-or-later
/*  Function objects where solids and fluid run: forces of both, bodies that gauges ride on. */

#include "demMotion.H"
#include "demSceneObject.H"
#include "functionTable.hpp"
#include "gaugeBody.H"
#include "runningFluid.hpp"
#include "runningScenes.H"

using namespace Foam;
using functionObjects::gaugeBody;

namespace
{
    //- Half a metre of water at rest in a tank of x and z; the left side and the lid may move.
    //  Beside it, and not felt by it, solids on the same mesh: two disks of group raft, one of
    //  group free, which is pressed into the floor by 1 mm
    struct BothScenes : RunningSph
    {
        demSettings ofSolids;
        solidSet solids;
        autoPtr<wallBodies> solidWalls, solidGroups;
        Pair<scalar> moving{0, 0};
        labelList typeOfBondType;
        riprap::DemInput input;
        std::unique_ptr<riprap::DemScene> dem;
        riprap::DemReport last;
        autoPtr<demSceneObject> demObject;

        explicit BothScenes(const std::string& left = "piston")
        :
            RunningSph(tank(2, 1, 1, 10),
                "maxVelocity 3; smoothingLength { ratio 2; } walls { motion { " + left
                    + " { patches (xMin); solidBodyMotionFunction linearMotion; "
                      "linearMotionCoeffs { velocity (-0.1 0 0); } } } }")
        {
            start(0.025, {{point(0, 0, 0), point(1, 0.5, 0.5), Zero, 0.5}});
            writeDict("constant/solidProperties",
                "device cpu; precision double; contact { normal linear; tangential none; } "
                "materials { rock { rho 1000; "
                "} } pairs { default { stiffness 1e5; restitution 1; } } groups { raft { } } walls "
                "{ "
                "patches (zMin); material rock; motion { floor { patches (zMin); "
                "solidBodyMotionFunction linearMotion; velocity (0 0 0); } } }");
            ofSolids = readDemSettings(mesh());
            for (const point& x :
                {point(0.4, 0.5, 0.8), point(0.5, 0.5, 0.8), point(0.25, 0.5, 0.049)})
                add(x);
            solids.particles.group = {1, 1, 0};
            solidWalls.reset(new wallBodies(time(), ofSolids.walls.motion));
            solidGroups.reset(new wallBodies(time(), ofSolids.groupMotion));
            input = demInputWithMotion(
                mesh(), ofSolids, solids, solidWalls(), solidGroups(), moving, typeOfBondType);
            dem = riprap::createDemScene(ofSolids.config, input);
            demObject.reset(new demSceneObject(mesh(), *dem, ofSolids, input, last));
        }

        //- What gauges ride on that name this
        gaugeBody on(const std::string& name)
        {
            gaugeBody body(mesh());
            body.find(::entries("body " + name + ";"), "f");
            return body;
        }

    private:

        void add(const point& x)
        {
            riprap::DemParticles& p = solids.particles;
            p.position.insert(p.position.end(), {x.x(), x.y(), x.z()});
            p.velocity.resize(p.position.size(), 0.0);
            p.spin.resize(p.position.size(), 0.0);
            p.radius.push_back(0.05);
            p.mass.push_back(7.8);
            p.material.push_back(0);
            p.id.push_back(int(p.id.size()));
        }
    };

    vector vectorOf(const FunctionTable& table, const std::string& name)
    {
        return vector(table.last(name + "_x"), table.last(name + "_y"), table.last(name + "_z"));
    }
}

TEST(RunningScenes, both)
{
    BothScenes c;
    EXPECT_EQ(functionObjects::runningFluid(c.mesh()), c.object.get());
    EXPECT_EQ(functionObjects::runningSolids(c.mesh()), c.demObject.get());
}

//- Water at rest to 5 %, as in wallForce; disks to round-off. Moments about y alone
TEST(ParticleForces, ofWaterAndSolids)
{
    BothScenes c;
    const auto table = [&](const std::string& text, const char* name)
    {
        c.make("particleForces", text, "f");
        FunctionTable now(c.read(std::string("postProcessing/f/0/") + name + ".dat"));
        rmDir(c.path()/"postProcessing");
        return now;
    };
    const std::string floor("patches (zMin);");
    const FunctionTable force(table(floor, "force")), moment(table(floor, "moment"));
    EXPECT_EQ(force.columns.size(), 16u);
    EXPECT_NEAR(vectorOf(force, "pressure").z(), -5000, 250);
    EXPECT_LT(mag(vectorOf(force, "viscous")), 1e-6);
    EXPECT_LT(mag(vectorOf(force, "normal") - vector(0, 0, -100)), 1e-6);
    EXPECT_LT(
        mag(vectorOf(force, "total") - vectorOf(force, "pressure") - vectorOf(force, "normal")),
        1e-6);
    EXPECT_NEAR(vectorOf(moment, "pressure").y(), 2500, 125);
    EXPECT_LT(mag(vectorOf(moment, "normal") - vector(0, 25, 0)), 1e-6);
    // rho g h^2/2 at a third of the depth
    const FunctionTable side(table("bodies (piston);", "moment"));
    EXPECT_NEAR(vectorOf(side, "pressure").y(), -1250*0.5/3, 25);
    EXPECT_LT(mag(vectorOf(side, "normal")), 1e-9);
    EXPECT_EQ(vectorOf(side, "pressure").x(), 0);
    // a body of walls of both scenes, and a group that the fluid does not feel
    EXPECT_LT(mag(vectorOf(table("bodies (floor);", "force"), "total") - vector(0, 0, -100)), 1e-6);
    EXPECT_LT(mag(vectorOf(table("groups (free);", "force"), "total") - vector(0, 0, 100)), 1e-6);
}

TEST(ParticleForces, partsOfBothScenes)
{
    BothScenes c;
    EXPECT_EQ(c.said("particleForces"),
        "Function object f does not say of which parts the force is wanted: one or more of the "
        "entries (patches surfaces planes bodies groups) are needed. Valid are patches (xMin xMax "
        "zMin), surfaces (), planes (), bodies (piston floor), groups (free raft)");
    c.demObject.clear();
    EXPECT_EQ(c.said("particleForces", "groups (raft);"),
        "Entry groups of function object f: raft selects none; valid are ()");
    EXPECT_EQ(c.said("particleForces", "bodies (floor);"),
        "Entry bodies of function object f: floor selects none; valid are (piston)");
}

TEST(GaugeBody, wallsThatMove)
{
    BothScenes c;
    gaugeBody body(c.on("piston"));
    EXPECT_TRUE(body.there());
    EXPECT_FALSE(body.ofSolids());
    EXPECT_EQ(body.name(), "piston");
    body.begin(dictionary(), scalarList());
    c.report = c.scene->advance(0.02);
    const riprap::WallPose pose(body.pose());
    EXPECT_NEAR(pose.translation[0], -0.1*c.scene->time(), 1e-9);
    EXPECT_NEAR(pose.rotation[0], 1, 1e-12);
    // and back from the numbers that are kept
    const scalarList state(gaugeBody::state(pose));
    ASSERT_EQ(state.size(), 12);
    EXPECT_EQ(state[9], pose.translation[0]);
    EXPECT_EQ(state[4], pose.rotation[4]);
}

TEST(GaugeBody, groupsOfSolids)
{
    BothScenes c;
    gaugeBody body(c.on("raft"));
    EXPECT_TRUE(body.ofSolids());
    EXPECT_EQ(body.name(), "raft");
    body.begin(dictionary(), scalarList());
    c.last = c.dem->advance(0.1);
    const riprap::WallPose pose(body.pose());
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(pose.translation[d], d == 2 ? -0.05 : 0, 1e-9);
    gaugeBody none(c.mesh());
    none.find(dictionary(), "f");
    EXPECT_FALSE(none.there());
    EXPECT_EQ(none.pose().translation, (riprap::Vector3{{0, 0, 0}}));
    EXPECT_EQ(none.pose().rotation, (riprap::WallPose().rotation));
}

TEST(GaugeBody, namesOfBothOrNone)
{
    BothScenes c;
    EXPECT_EQ(messageOf([&]() { c.on("rafts"); }),
        "Entry body of function object f: rafts is no group of walls that moves and none of "
        "solids; "
        "valid are, of walls, (piston), of solids, (free raft); did you mean raft?");
    BothScenes same("raft");
    EXPECT_EQ(messageOf([&]() { same.on("raft"); }),
        "Entry body of function object f: raft is a group of walls and one of solids: rename one; "
        "valid are, of walls, (raft), of solids, (free raft)");
}
