/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "postProcessTimes.H"
#include "functionObjectList.H"
#include "timeSelector.H"

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
    return timeSelector::select0(runTime, args);
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

    forAll(times, timei)
    {
        runTime.setTime(times[timei], timei);
        Info<< "Time = " << runTime.timeName() << nl << endl;
        mesh.readUpdate();

        FatalIOError.throwExceptions();
        try
        {
            module.initialise();

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
        }
        catch (const IOerror& err)
        {
            Warning<< err << endl;
        }
        Info<< endl;
    }
}


// ************************************************************************* //
