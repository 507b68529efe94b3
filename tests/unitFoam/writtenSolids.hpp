// SPDX-License-Identifier: GPL-3.0-or-later
/*  Solids that run in the test and are written as a solver writes them. */
#pragma once

#include "runningSolids.hpp"
#include "sceneState.H"

//- With files of the start, as setParticles leaves them
struct WrittenSolids : RunningSolids
{
    Foam::autoPtr<Foam::solidCloud> cloud;

    explicit WrittenSolids(const std::string& properties,
        const std::string& control = "adjustTimeStep yes; writeFormat binary;")
    :
        RunningSolids(properties, BoxMesh(), "(0 0 -10)", control)
    {
        record.device = "cpu";
        record.precision = "double";
    }

    void startCloud()
    {
        Foam::writeParticleCloud(fv(), Foam::solidCloudOf(solids.particles));
        startAnew();
    }

    void writeAt(double t)
    {
        run(t);
        write();
    }

    void write()
    {
        cloud->moved();
        record.time = time().value();
        cloud->write();
    }

    //- The scene's state as the files of this time have it, in a scene that goes on
    void goOn()
    {
        record = Foam::readDemRun(time());
        solids = Foam::readSolids(fv(), settings);
        const auto words = Foam::readStateWords(time(), Foam::demRestart::stateFile);
        startAnew(&words);
    }

    //- A scene of the solids at the time at hand, and its cloud
    void startAnew(const std::vector<std::int32_t>* state = nullptr)
    {
        cloud.clear();
        settings.config.startTime = time().value();
        start();
        if (state) scene->loadState(*state);
        cloud.reset(
            new Foam::solidCloud(fv(), *scene, *scene, settings, input, typeOfBondType, record));
    }
};
