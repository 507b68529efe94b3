// SPDX-License-Identifier: GPL-3.0-or-later
/*  Cases whose scene of fluid runs in a test, for function objects: a tank along x, y, z, or x and
    z in 2D, gravity along -z.

        RunningSph run(tank(2, 1, 1, 20), "device cpu; maxVelocity 2;");
        run.start(0.05, {{point(0, 0, 0), point(1, 1, 0.5)}});
        const auto f = run.make("energyBalance");
        run.advance(0.01);
        f->execute();
        f->write();
        EXPECT_NEAR(run.table("energyBalance")["kinetic"], 0, 1e-3);
*/
#pragma once

#include "boxMesh.hpp"
#include "functionObject.H"
#include "functionTable.hpp"
#include "fvMesh.H"
#include "picDictionaries.H"
#include "picGrid.H"
#include "picSceneObject.H"
#include "scratchCase.hpp"
#include "sphDictionaries.H"
#include "sphSceneObject.H"
#include "sweptDomain.H"
#include "wallBodies.H"
#include "wallPoints.H"

#include <cmath>
#include <gtest/gtest.h>

//- Walls all around but for an open top, n cells along x
inline BoxMesh tank(int D, double length, double height, int n, double width = 1)
{
    BoxMesh box;
    const double h = length/n;
    box.divide(0, 0, length, n);
    box.divide(1, 0, width, D == 2 ? 1 : int(width/h + 0.5));
    box.divide(2, 0, height, int(height/h + 0.5));
    if (D == 2) box.sides(1, "empty");
    box.type[5] = "patch";
    return box;
}

//- A block of water: its pressure is that below level
struct Water
{
    Foam::point low, high;
    Foam::vector U = Foam::Zero;
    double level = -1e30;

    double pressure(const riprap::FluidConfig& config, const Foam::point& x) const
    {
        return level > x.z() ? -config.density*config.gravity[2]*(level - x.z()) : 0;
    }
};

//- What a function object has written; numbers of the last row, or another
struct WrittenTable : FunctionTable
{
    using FunctionTable::FunctionTable;

    double operator[](const std::string& column) const { return last(column); }

    double at(const std::string& column, std::size_t row) const
    {
        return FunctionTable::at(row, column);
    }
};

struct FluidCase : ScratchCase
{
    Foam::autoPtr<Foam::fvMesh> mesh;

    FluidCase(const BoxMesh& box, const std::string& control, const std::string& gravity)
    :
        ScratchCase((defaultDigits(), "adjustTimeStep yes; " + control))
    {
        write("constant/g",
            "FoamFile { version 2.0; format ascii; class uniformDimensionedVectorField; object g; "
            "}\ndimensions [0 1 -2 0 0 0 0]; value " + gravity + ";\n");
        writeDict("constant/fluidProperties", "rho 1000; nu 1e-6;");
        mesh = box.make<Foam::fvMesh>(time());
    }

    Foam::dictionary entriesOf(const std::string& type, const std::string& entries) const
    {
        return Foam::dictionary(::entries("type " + type + "; " + entries));
    }

    std::unique_ptr<Foam::functionObject> make(
        const std::string& type, const std::string& entries = "", const std::string& name = "f")
    {
        return std::unique_ptr<Foam::functionObject>(
            Foam::functionObject::New(name, time(), entriesOf(type, entries)).ptr());
    }

    //- What is said of such entries
    std::string said(const std::string& type, const std::string& entries = "")
    {
        return messageOf([&]() { make(type, entries); });
    }

    WrittenTable table(const std::string& table, const std::string& name = "f",
        const std::string& since = "0") const
    {
        return WrittenTable(read("postProcessing/" + name + '/' + since + '/' + table + ".dat"));
    }

    //- The next row of it
    static void sample(Foam::functionObject& f)
    {
        f.execute();
        f.write();
    }

    bool planar() const { return mesh->nGeometricD() == 2; }

    //- Particles a spacing apart, the first half of it from a block's corner
    template<class DensityOf>
    riprap::FluidInput lattice(const riprap::FluidConfig& config, double spacing,
        const std::vector<Water>& blocks, const DensityOf& densityOf) const
    {
        riprap::FluidInput fluid;
        for (const Water& w : blocks)
        {
            int n[3];
            for (int d = 0; d < 3; ++d) n[d] = int((w.high[d] - w.low[d])/spacing + 0.5);
            if (planar()) n[1] = 1;
            for (int i = 0; i < n[0]*n[1]*n[2]; ++i)
            {
                const int at[3] = {i % n[0], i/n[0] % n[1], i/(n[0]*n[1])};
                Foam::point x;
                for (int d = 0; d < 3; ++d) x[d] = w.low[d] + (at[d] + 0.5)*spacing;
                if (planar()) x.y() = mesh->bounds().centre().y();
                fluid.position.insert(fluid.position.end(), {x.x(), x.y(), x.z()});
                fluid.velocity.insert(fluid.velocity.end(), {w.U.x(), w.U.y(), w.U.z()});
                fluid.density.push_back(densityOf(w.pressure(config, x)));
            }
        }
        return fluid;
    }
};

//- Of each method: settings, a scene and its registered object
struct RunningSph : FluidCase
{
    Foam::sphSettings settings;
    Foam::wallPoints walls;
    Foam::autoPtr<Foam::wallBodies> bodies;
    std::unique_ptr<riprap::SphScene> scene;
    riprap::SphReport report;
    Foam::autoPtr<Foam::sphSceneObject> object;

    explicit RunningSph(const BoxMesh& box, const std::string& properties = "maxVelocity 1;",
        const std::string& control = "", const std::string& gravity = "(0 0 -10)")
    :
        FluidCase(box, control, gravity)
    {
        writeDict("constant/sphProperties", "device cpu; " + properties);
        settings = Foam::readSphSettings(mesh());
        bodies.reset(new Foam::wallBodies(time(), settings.walls.motion));
    }

    //- From the time now; again: a scene that knows nothing of the one before
    void start(double spacing, const std::vector<Water>& blocks)
    {
        object.clear();
        settings = Foam::readSphSettings(mesh());
        settings.config.startTime = time().value();
        Foam::setSpacing(settings, spacing);
        const riprap::WallInput input(wallInput());
        scene = riprap::createSphScene(settings.config,
            lattice(settings.config, spacing, blocks,
                [&](double p) { return Foam::densityOfPressure(settings.config, p); }),
            input, bodies->motion());
        object.reset(new Foam::sphSceneObject(
            mesh(), *scene, settings.config, report, bodies(), walls));
    }

    //- By a time step of the case
    void step()
    {
        ++time();
        report = scene->advance(time().value());
    }

private:

    riprap::WallInput wallInput()
    {
        Foam::wallPointsControls controls;
        controls.spacing = settings.config.wallSpacing;
        controls.layers = Foam::wallLayers(settings);
        const auto surfaces = Foam::wallGeometry(time());
        walls = Foam::generateWallPoints(
            mesh(), Foam::wallPatches(mesh()), surfaces.get(), controls);
        const Foam::labelList bodyOf(bodies->bodyOf(walls.names));
        Foam::List<Foam::boundBox> reference(bodies->size());
        riprap::WallInput input;
        input.nBodies = bodies->size();
        for (int i = 0; i < walls.size(); ++i)
        {
            const int body = bodyOf[walls.source[i]];
            for (int d = 0; d < 3; ++d) input.position.push_back(walls.position[i][d]);
            for (int d = 0; d < 3; ++d) input.normal.push_back(walls.normal[i][d]);
            input.part.push_back(walls.source[i]);
            input.body.push_back(body);
            if (body >= 0) reference[body].add(walls.position[i]);
        }
        Foam::coverMotion(
            mesh(), bodies(), reference, Foam::wallThickness(settings), settings.config);
        return input;
    }
};

struct RunningPic : FluidCase
{
    Foam::picSettings settings;
    Foam::autoPtr<Foam::wallBodies> bodies;
    std::unique_ptr<riprap::PicScene> scene;
    riprap::PicReport report;
    Foam::autoPtr<Foam::picSceneObject> object;

    explicit RunningPic(const BoxMesh& box, const std::string& properties = "",
        const std::string& control = "", const std::string& gravity = "(0 0 -10)")
    :
        FluidCase(box, control, gravity)
    {
        writeDict("constant/picProperties", "device cpu; precision double; " + properties);
        settings = Foam::readPicSettings(mesh());
        bodies.reset(new Foam::wallBodies(time(), settings.motion));
    }

    //- From the time now
    void start(double spacing, const std::vector<Water>& blocks)
    {
        const Foam::picGrid grid(mesh(), settings.config);
        grid.set(settings.config);
        settings.config.spacing = spacing;
        scene = riprap::createPicScene(settings.config,
            lattice(settings.config, spacing, blocks, [](double) { return 1000; }), grid.walls());
        Foam::wordList names;
        for (const Foam::label patch : Foam::wallPatches(mesh()))
            names.append(mesh->boundaryMesh()[patch].name());
        object.reset(new Foam::picSceneObject(mesh(), *scene, settings.config, report, bodies(),
            names, Foam::labelList(names.size(), -1)));
    }

    //- By a time step of the case
    void step()
    {
        ++time();
        report = scene->advance(time().value());
    }
};
