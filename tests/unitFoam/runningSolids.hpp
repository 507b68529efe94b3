// SPDX-License-Identifier: GPL-3.0-or-later
/*  A case whose solids run in the test, with function objects that see them:

        RunningSolids c(rock());
        c.add({0.5, 0.5, 0.5}, 0.1);
        c.start();
        auto f = c.function("type solidEnergies;");
        c.run(0.1);
        c.sample(f());
        EXPECT_NEAR(c.table("solidEnergies").last("momentumZ"), ..);
*/
#pragma once

#include "particleCase.hpp"
#include "functionTable.hpp"
#include "demMotion.H"
#include "demSceneObject.H"
#include "functionObject.H"
#include "fvMesh.H"
#include "solidCloud.H"

//- constant/solidProperties: spheres of 1000 kg/m3, linear springs of 1e5 N/m without dashpots or
//  friction. A group free may be among the groups
inline std::string rock(const std::string& more = "", const std::string& walls = "",
    const std::string& pair = "stiffness 1e5; restitution 1;",
    const std::string& contact = "normal linear; tangential none;")
{
    return "device cpu; precision double; materials { rock { rho 1000; E 1e7; nu 0.25; } } "
           "contact { "
        + contact + " } pairs { default { " + pair + " } } walls { material rock; " + walls + " } "
        + more;
}

struct RunningSolids : ParticleCase
{
    Foam::autoPtr<Foam::fvMesh> fv;
    Foam::demSettings settings;
    Foam::solidSet solids;
    Foam::autoPtr<Foam::wallBodies> movingWalls, movingGroups;
    Foam::Pair<Foam::scalar> moving;
    Foam::labelList typeOfBondType;
    riprap::DemInput input;
    std::unique_ptr<riprap::DemScene> scene;
    riprap::DemReport report;
    Foam::demRestart record;
    Foam::autoPtr<Foam::demSceneObject> object;

    explicit RunningSolids(const std::string& properties, const BoxMesh& box = BoxMesh(),
        const char* gravity = "(0 0 -10)", const std::string& control = "adjustTimeStep yes;")
    :
        ParticleCase(box, control, gravity)
    {
        mesh.clear();
        fv = box.make<Foam::fvMesh>(time());
        writeDict("constant/solidProperties", properties);
        settings = Foam::readDemSettings(fv());
    }

    //- A sphere, in 2D a disk, of the first material. \return its id
    int add(const Foam::point& x, double radius, const Foam::vector& velocity = Foam::Zero,
        const Foam::vector& spin = Foam::Zero, const char* group = "free")
    {
        const double pi = std::acos(-1.0);
        riprap::DemParticles& p = solids.particles;
        for (int d = 0; d < 3; ++d)
        {
            p.position.push_back(x[d]);
            p.velocity.push_back(velocity[d]);
            p.spin.push_back(spin[d]);
        }
        p.radius.push_back(radius);
        p.mass.push_back(settings.materials[0].density*pi*radius*radius
            *(settings.config.dimensions == 2 ? 1 : 4*radius/3));
        p.material.push_back(0);
        p.group.push_back(settings.group(group, settings.dict));
        p.id.push_back(int(p.id.size()));
        return p.id.back();
    }

    //- Particles that are there are a rigid body from this one on
    riprap::DemClump& body(int first, const Foam::point& centre, double mass,
        const Foam::vector& inertia, const char* group = "free")
    {
        riprap::DemParticles& p = solids.particles;
        riprap::DemClump clump;
        for (int d = 0; d < 3; ++d)
        {
            clump.position[d] = centre[d];
            clump.inertia[d] = inertia[d];
        }
        clump.mass = mass;
        clump.group = settings.group(group, settings.dict);
        p.clump.resize(p.size(), -1);
        for (std::size_t i = first; i < p.size(); ++i)
        {
            p.clump[i] = int(solids.clumps.size());
            p.group[i] = clump.group;
        }
        solids.clumps.push_back(clump);
        return solids.clumps.back();
    }

    //- Of the first type, made at the gap at hand
    void bond(int a, int b)
    {
        const riprap::DemParticles& p = solids.particles;
        double squared = 0;
        for (int d = 0; d < 3; ++d)
        {
            const double way = p.position[3*b + d] - p.position[3*a + d];
            squared += way*way;
        }
        solids.bonds.a.push_back(a);
        solids.bonds.b.push_back(b);
        solids.bonds.type.push_back(0);
        solids.bonds.gap.push_back(std::sqrt(squared) - p.radius[a] - p.radius[b]);
        solids.brokenBond.push_back(false);
    }

    //- What a scene is given, as the solver makes it
    void makeInput()
    {
        movingWalls.reset(new Foam::wallBodies(time(), settings.walls.motion));
        movingGroups.reset(new Foam::wallBodies(time(), settings.groupMotion));
        moving = Foam::Pair<Foam::scalar>(time().value(), time().value());
        input = Foam::demInputWithMotion(fv(), settings, solids, movingWalls(), movingGroups(),
            moving, typeOfBondType);
        Foam::coverSolids(fv(), movingWalls(), movingGroups(), input, settings.config);
        Foam::markWalledSides(fv(), input.walls, settings.config);
    }

    void start()
    {
        makeInput();
        object.clear();
        scene = riprap::createDemScene(settings.config, input);
        record.timeStep = scene->plan().timeStep;
        record.setDomain(settings.config);
        object.reset(new Foam::demSceneObject(fv(), *scene, settings, input, report));
    }

    //- OpenFOAM's time and the scene go to time t
    void run(double t)
    {
        time().setDeltaT(t - time().value());
        moving = Foam::Pair<Foam::scalar>(time().value(), t);
        ++time();
        report = scene->advance(t);
    }

    //- A function object of these entries
    Foam::autoPtr<Foam::functionObject> function(
        const std::string& text, const char* name = "f")
    {
        return Foam::functionObject::New(name, time(), entries(text));
    }

    //- The message with which it is refused
    std::string refused(const std::string& text)
    {
        return messageOf([&]() { function(text); });
    }

    void sample(Foam::functionObject& f)
    {
        f.execute();
        f.write();
    }

    FunctionTable table(
        const std::string& name, const std::string& begin = "0", const char* function = "f") const
    {
        return FunctionTable(
            read(std::string("postProcessing/") + function + '/' + begin + '/' + name + ".dat"));
    }

    //- State of a particle now
    Foam::vector now(const std::vector<double> riprap::DemState::*field, int id) const
    {
        const riprap::DemState s(scene->motion());
        for (std::size_t i = 0; i < s.id.size(); ++i)
        {
            const double* v = &(s.*field)[3*i];
            if (s.id[i] == id) return Foam::vector(v[0], v[1], v[2]);
        }
        throw std::runtime_error("no particle " + std::to_string(id));
    }
};

//- A sphere of group ram is driven into the floor from the touch on, at (0.3 0.6 0): the force is
//  `rate` times the time
struct RammedFloor : RunningSolids
{
    static constexpr double radius = 0.05, speed = 0.01, rate = 1e5*speed;

    explicit RammedFloor(const std::string& walls = "", const BoxMesh& box = BoxMesh(),
        double floor = 0)
    :
        RunningSolids(rock("groups { ram { motion { solidBodyMotionFunction linearMotion; velocity "
                           "(0 0 -0.01); } } }",
                          walls),
            box)
    {
        add(Foam::point(0.3, 0.6, floor + radius), radius, Foam::Zero, Foam::Zero, "ram");
    }
};
