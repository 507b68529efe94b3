/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    riprapFoam

Description
    Runs a particle solver in an OpenFOAM case. Which one, `solver NAME;` in
    system/controlDict says, or option -solver: a solverModule from the
    library lib<NAME>Solver.so.

Usage
    riprapFoam [-case DIR] [-solver NAME] [-dry-run | -postProcess]
    mpirun -np N riprapFoam [-case DIR] [-solver NAME] -parallel
    riprapFoam [-case DIR] -advise 2%
\*---------------------------------------------------------------------------*/

#include "allRanks.H"
#include "argList.H"
#include "buildInfo.H"
#include "caseTime.H"
#include "checkControlDict.H"
#include "checkFunctionObjects.H"
#include "documentation.H"
#include "editedFiles.H"
#include "fileOperation.H"
#include "functionObject.H"
#include "pictures.H"
#include "postProcessTimes.H"
#include "readMesh.H"
#include "runForecast.H"
#include "runProgram.H"
#include "sceneNeeds.H"
#include "setParticlesRecord.H"
#include "solverModule.H"
#include "stopSignals.H"
#include "timePlan.H"
#include "timeWriter.H"
#include "wallTimes.H"

#include <unistd.h>

using namespace Foam;

//- What several processes cannot do
static void checkParallel(const argList& args)
{
    if (!Pstream::parRun())
    {
        return;
    }
    for (const char* option : {"advise", "postProcess", "dry-run"})
    {
        if (args.found(option))
        {
            FatalErrorInFunction
                << "Options -parallel and -" << option << " exclude each other:"
                << " it runs on one process, with the case that is not divided"
                << exit(FatalError);
        }
    }
    if (fileHandler().type() != "uncollated")
    {
        FatalErrorInFunction
            << "File handler " << fileHandler().type() << ": with -parallel"
            << " riprapFoam writes a file for each process; valid is"
            << " uncollated" << exit(FatalError);
    }
}


//- All that has been written so far is there
static void waitForWriting(caseTime& runTime)
{
    const wallTimes::part timed("waiting for writing");
    runTime.settle();
}


//- Function objects that may look at the files of a time
static bool filesAreRead(const Time& runTime)
{
    const dictionary* functions = runTime.controlDict().findDict("functions");
    if (!functions)
    {
        return false;
    }
    for (const entry& e : *functions)
    {
        const word type
        (
            e.isDict() ? e.dict().getOrDefault<word>("type", word::null) : word()
        );
        if (type == "systemCall" || type == "coded") return true;
    }
    return false;
}


//- As plan.run(), in which function objects write, too
static bool goesOn(caseTime& runTime, timePlan& plan)
{
    if (filesAreRead(runTime))
    {
        waitForWriting(runTime);
    }
    runTime.checkWriting();

    bool more;
    {
        const wallTimes::part timed("function objects");
        more = plan.run();
    }
    const wallTimes::part timed("writing");
    runTime.finishWrite();
    return more;
}


//- Does a function object that is not riprap's look at fields of the mesh?
static bool fieldsAreRead(const Time& runTime)
{
    const dictionary* functions = runTime.controlDict().findDict("functions");
    if (!functions)
    {
        return false;
    }
    for (const entry& e : *functions)
    {
        if (!e.isDict())
        {
            continue;
        }
        fileNameList libs;
        e.dict().readIfPresent("functionObjectLibs", libs);
        e.dict().readIfPresent("libs", libs);
        bool others = libs.empty();
        for (const fileName& lib : libs)
        {
            others = others || lib.lessExt().name() != "libriprapFoam";
        }
        if (others)
        {
            return true;
        }
    }
    return false;
}


static void runLoop(caseTime& runTime, solverModule& module)
{
    timePlan plan(runTime);
    editedFiles edited(runTime);
    const stopSignals signals(module);
    const timeWriter::session writing;

    // Function objects begin with a sample
    if (fieldsAreRead(runTime))
    {
        module.updateFields();
    }

    Info<< "\nStarting time loop\n" << endl;
    wallTimes::ofRun().started();

    while (goesOn(runTime, plan))
    {
        plan.advanceTo
        (
            module.advance(plan.target(), plan.sampleInterval() == 0)
        );

        Info<< "Time = " << runTime.timeName() << nl << endl;
        module.report();
        edited.warn();

        const char* signal = signals.received();
        if (signal || runTime.writeTime() || fieldsAreRead(runTime))
        {
            module.updateFields();
        }

        if (signal || runTime.writeTime())
        {
            waitForWriting(runTime);
        }
        const wallTimes::part timed("writing");
        if (signal)
        {
            Info<< "Stopping on " << signal << ": writing this time\n" << endl;
            runTime.writeAndEnd();
        }
        else
        {
            runTime.write();
        }
        runTime.requireWritten();

        runTime.printExecutionTime(Info);
    }
    waitForWriting(runTime);
    wallTimes::ofRun().write(runTime, timeWriter::ofRun().seconds());
}


//- Becomes the program riprapAdvise, which calls -dry-run
static void advise(const argList& args)
{
    const std::string error(args["advise"]), path(args.path());
    const char* excluded[] = {"dry-run", "postProcess", "solver"};
    for (const char* option : excluded)
    {
        if (args.found(option))
        {
            FatalErrorInFunction
                << "Options -advise and -" << option << " exclude each other"
                << exit(FatalError);
        }
    }
    Info<< flush;
    execlp
    (
        "riprapAdvise", "riprapAdvise", error.c_str(), "-case", path.c_str(),
        static_cast<char*>(nullptr)
    );
    FatalErrorInFunction
        << "Option -advise needs the program riprapAdvise, which is not in PATH:"
        << " . etc/bashrc of riprap" << exit(FatalError);
}


static void runCase(const argList& args, bool postProcess)
{
    checkControlDict(args.globalPath()/"system"/Time::controlDictName);
    autoPtr<caseTime> time(caseTime::New(args, postProcess));
    caseTime& runTime = time.ref();

    if (postProcess && args.found("dry-run"))
    {
        FatalErrorInFunction
            << "Options -dry-run and -postProcess exclude each other"
            << exit(FatalError);
    }

    instantList times;
    if (postProcess)
    {
        times = selectPostProcessTimes(runTime, args);
    }

    autoPtr<fvMesh> mesh(readMesh(runTime));

    word name(args.getOrDefault<word>("solver", word::null));
    if (name.empty())
    {
        name = runTime.controlDict().get<word>("solver");
    }
    auto module = solverModule::New(name, runTime, *mesh);

    if (postProcess)
    {
        postProcessTimes(args, runTime, *mesh, *module, times);
        return;
    }

    requireSetParticles(runTime);
    module->initialise();
    pictures::check(runTime);

    if (args.found("dry-run"))
    {
        const scalar start = wallTimes::ofRun().sinceBegin();
        const scalar interval = timePlan(runTime).sampleInterval();
        checkFunctionObjects(runTime);
        const runEffort effort(module->dryRun(interval));
        foretellRun
        (
            runTime, *module, effort, interval, start, fieldsAreRead(runTime)
        );
        sceneNeeds needs;
        module->needs(needs);
        needs.log(Info());
        Info<< "Nothing was written" << nl << endl;
    }
    else
    {
        runLoop(runTime, *module);
    }
}


// * * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    wallTimes::ofRun();

    argList::addNote("Particle solvers in an OpenFOAM case");
    argList::addOption("solver", "name", "Solver module, e.g. sphDem");
    argList::addBoolOption("dry-run", "Check and describe the run only");
    argList::addOption
    (
        "advise",
        "error",
        "Propose solver, spacing and device for this error, e.g. 2%"
    );
    #include "setRootCaseListOptions.H"
    const bool postProcess = addPostProcessOptions(argc, argv);

    showDocumentation
    (
        argc,
        argv,
        "docs/guide/running",
        "applications/solvers/riprapFoam/riprapFoam.C"
    );
    const argList args(argc, argv);
    writeBuildInfo(Info);
    #include "setRootCaseListOutput.H"
    if (!args.checkRootCase())
    {
        FatalError.exit();
    }

    runProgram
    ([&]()
    {
        checkParallel(args);
        shareThreads();
        if (args.found("advise"))
        {
            advise(args);
        }
        if (postProcess && args.found("list"))
        {
            functionObjectList::list();
            return;
        }
        runCase(args, postProcess);
        Info<< "End\n" << endl;
    });
    return 0;
}


// ************************************************************************* //
