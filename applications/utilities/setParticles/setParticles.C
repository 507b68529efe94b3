// SPDX-License-Identifier: GPL-3.0-or-later
/*  setParticles: fill regions of a case with particles, as system/setParticlesDict says.

        setParticles [-case DIR] [-solver NAME] [-dict FILE] [-dry-run] [-checkWalls]
        mpirun -np N setParticles -parallel [..]

    Writes at startTime, for regions of fluid, the cloud lagrangian/fluid (positions, U, rho, p, h,
    id) and the wall points as VTK/walls.vtp (picDem: neither rho, h nor wall points); for regions
    of solids the cloud lagrangian/solids, their bonds and rigid bodies. Reports counts, volumes and
    masses by region. A state file of an earlier run at that time is removed. -dry-run: writes
    nothing. -checkWalls: also says how well walls and fluid fill space together. -parallel: in a
    case that decomposePar has divided each process makes the water in its cells alone; the clouds
    are what one process and decomposePar would make of them.
*/

#include "allRanks.H"
#include "argList.H"
#include "buildInfo.H"
#include "checkControlDict.H"
#include "documentation.H"
#include "fileOperation.H"
#include "inputFile.H"
#include "IOdictionary.H"
#include "readMesh.H"
#include "runProgram.H"
#include "setParticles.H"
#include "setParticlesRecord.H"
#include "solidRegions.H"
#include "Time.H"
#include "timePlan.H"

using namespace Foam;

static IOdictionary readDict(const Time& time, const argList& args)
{
    fileName file("setParticlesDict");
    args.readIfPresent("dict", file);
    const bool path = file.find('/') != std::string::npos;
    const fileName system(
        Pstream::parRun() ? time.globalPath()/time.system() : fileName(time.system()));

    const IOobject io
    (
        path
      ? IOobject
        (
            file.isAbsolute() ? file : time.globalPath()/file,
            time,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
      : IOobject(file, system, time, IOobject::MUST_READ, IOobject::NO_WRITE, false)
    );
    checkInputFile(io.objectPath(), largestNumber);
    return IOdictionary(io);
}


// Each process writes its own files
static void checkFileHandler()
{
    if (!Pstream::parRun() || fileHandler().type() == "uncollated") return;
    FatalErrorInFunction
        << "File handler " << fileHandler().type() << ": with -parallel setParticles writes files "
        << "for each process; valid is uncollated" << exit(FatalError);
}


// Particles are what a case starts with: at startTime, even when a run would continue from the
// latest
static void goToStart(Time& time)
{
    const dictionary& control = time.controlDict();
    if (control.getOrDefault<word>("startFrom", "latestTime") == "latestTime")
    {
        time.setTime(control.getOrDefault<scalar>("startTime", 0), 0);
    }
}


static void setCase(const argList& args)
{
    checkControlDict(args.globalPath()/"system"/Time::controlDictName);
    Time runTime(Time::controlDictName, args);
    goToStart(runTime);
    Info().precision(6);             // whatever writePrecision is
    autoPtr<fvMesh> mesh(readMesh(runTime));

    const IOdictionary dict(readDict(runTime, args));

    setOptions options;
    options.dryRun = args.found("dry-run");
    options.checkWalls = args.found("checkWalls");
    options.solver = args.getOrDefault<word>(
        "solver", runTime.controlDict().getOrDefault<word>("solver", word::null));
    const bool solids = hasSet(dict, "solids");
    const auto grid(gridSettings(*mesh, dict, options));
    // First, whatever the order of regions: water may be cut at them
    const placedSolids placed(solids ? placeSolids(*mesh, dict) : placedSolids());
    // Also where there is neither: the fluid's reader says what is wrong
    if (!solids || hasSet(dict, "fluid")) setFluid(*mesh, dict, options, grid.get(), placed);
    if (solids) setSolids(*mesh, dict, options, placed);
    if (!options.dryRun) recordSetParticles(runTime, dict);

    Info<< "End" << nl << endl;
}


int main(int argc, char* argv[])
{
    argList::addNote("Fill regions with particles, as system/setParticlesDict says");
    argList::noFunctionObjects();
    argList::addOption("dict", "file", "Read this instead of system/setParticlesDict");
    argList::addOption(
        "solver", "name", "The solver module that will run, if not that of system/controlDict");
    argList::addBoolOption("dry-run", "Report only, write nothing");
    argList::addBoolOption("checkWalls", "Say how well walls and fluid fill space");

    showDocumentation(argc, argv, "docs/guide/setParticles",
        "applications/utilities/setParticles/setParticles.C");
    const argList args(argc, argv);
    writeBuildInfo(Info);
    if (!args.checkRootCase()) FatalError.exit();

    runProgram([&]()
    {
        checkFileHandler();
        shareThreads();
        setCase(args);
    });
    return 0;
}
