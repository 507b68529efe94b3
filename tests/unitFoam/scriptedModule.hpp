// SPDX-License-Identifier: GPL-3.0-or-later
/*  A module that does what a test says. */
#pragma once

#include "scalarField.H"
#include "solverModule.H"
#include "timeWriter.H"

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

struct ScriptedModule : Foam::solverModule
{
    std::function<void()> begin = [] {};
    bool fields = false;
    int updates = 0, steps = 0, initialised = 0;
    int stepsLeft = 10;
    double fieldSeconds = 0, writeSeconds = 0;
    Foam::label written = 0;            // numbers in a file
    std::atomic<int> interrupts{0};

    static void waitFor(double seconds)
    {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    }

    void initialise() override
    {
        ++initialised;
        begin();
    }

    Foam::scalar advance(Foam::scalar t, bool) override { return t; }
    void report() override {}

    void updateFields() override
    {
        ++updates;
        waitFor(fieldSeconds);
    }

    bool hasFields() const override { return fields; }
    Foam::runEffort dryRun(Foam::scalar) override { return Foam::runEffort(); }
    void needs(Foam::sceneNeeds&) override {}

    bool trialStep() override
    {
        ++steps;
        return stepsLeft-- > 0;
    }

    void writeTrial() override
    {
        waitFor(writeSeconds);
        if (!written) return;
        Foam::writtenFile file(Foam::IOobject("numbers", "0", testTime(), Foam::IOobject::NO_READ,
                Foam::IOobject::NO_WRITE, false),
            "scalarField", Foam::IOstream::ASCII, Foam::IOstream::UNCOMPRESSED);
        file.add(Foam::listBody(Foam::scalarField(written, 0.25)));
        Foam::timeWriter::ofRun().put(std::move(file));
    }

    void interrupt() override { ++interrupts; }
};
