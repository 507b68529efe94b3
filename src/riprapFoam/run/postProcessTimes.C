/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "postProcessTimes.H"
#include "missingFunction.H"
#include "listed.H"
#include "functionObjectList.H"
#include "timeManifest.H"
#include "timeSelector.H"
#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Its errors are warnings: another time may be better
static bool succeeds(const std::function<void()>& process)
{
    bool good = true;
    const bool threw = FatalError.throwExceptions(), ioThrew = FatalIOError.throwExceptions();
    try
    {
        process();
    }
    catch (const IOerror& err)
    {
        Warning<< err << endl;
        good = false;
    }
    catch (const error& err)
    {
        Warning<< err << endl;
        good = false;
    }
    FatalError.throwExceptions(threw);
    FatalIOError.throwExceptions(ioThrew);
    return good;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::addPostProcessOptions(int argc, char* argv[])
{
    argList::addBoolOption
    (
        argList::postProcessOptionName,
        "Execute function objects on written times only"
    );

    if (!argList::postProcess(argc, argv))
    {
        return false;
    }

    timeSelector::addOptions();
    #include "addFunctionObjectOptions.H"

    functionObject::postProcess = true;
    return true;
}


Foam::instantList Foam::selectPostProcessTimes
(
    Time& runTime,
    const argList& args
)
{
    wordList functions;
    if (args.found("funcs")) functions.append(args.getList<word>("funcs"));
    if (args.found("func")) functions.append(args.get<word>("func"));
    for (const word& function : functions)
    {
        const std::string missing(missingFunction(function));
        if (!missing.empty())
        {
            FatalErrorInFunction
                << "Option -postProcess: " << missing.c_str() << exit(FatalError);
        }
    }

    DynamicList<instant> times;
    for (const instant& t : timeSelector::select0(runTime, args))
    {
        // What timeSelector gives where there is no other
        if (t.name() == runTime.constant()) continue;

        const timeManifest& manifest(timeManifest::of(runTime.path()/t.name()));
        if
        (
            manifest.is == timeManifest::kind::unfinished
         || manifest.is == timeManifest::kind::picture
         || manifest.is == timeManifest::kind::damaged
        )
        {
            Warning
                << "Time " << t.name() << " is passed over: "
                << manifest.why.c_str() << nl << endl;
            continue;
        }
        times.append(t);
    }

    if (times.empty())
    {
        wordList written;
        for (const instant& t : runTime.times())
        {
            if (t.name() != runTime.constant()) written.append(t.name());
        }
        FatalErrorInFunction
            << "Option -postProcess: no written time is selected; there are "
            << listed(written).c_str() << exit(FatalError);
    }
    return instantList(times);
}


void Foam::postProcessTimes
(
    const argList& args,
    Time& runTime,
    fvMesh& mesh,
    solverModule& module,
    const instantList& times
)
{
    // Holds the function objects of -func and -dict
    dictionary functionsDict;
    HashSet<wordRe> selectedFields;
    autoPtr<functionObjectList> functions;
    label failed = 0;

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << nl << endl;
        mesh.readUpdate();

        const auto process = [&]()
        {
            module.initialise();
            module.updateFields();

            // After the scene is there: function objects look it up
            if (!functions.valid())
            {
                functions = functionObjectList::New
                (
                    args,
                    runTime,
                    functionsDict,
                    selectedFields
                );
            }
            functions->execute();
            if (timei == times.size() - 1)
            {
                functions->end();
            }
        };
        if (!succeeds(process)) ++failed;
        Info<< endl;
    }

    if (failed)
    {
        FatalErrorInFunction
            << failed << " of " << times.size() << " times could not be"
            << " processed: see the warnings above" << exit(FatalError);
    }
}


// ************************************************************************* //
