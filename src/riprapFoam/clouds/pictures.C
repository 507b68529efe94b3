/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pictures.H"
#include "HashSet.H"
#include "didYouMean.H"
#include "polyMesh.H"
#include "sceneCloud.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::pictures& Foam::pictures::ofRun()
{
    static pictures run;
    return run;
}


void Foam::pictures::next(const Time& time, bool last)
{
    const dictionary& control = time.controlDict();
    const label interval = control.getOrDefault<label>("stateInterval", 1);
    fields_ = control.getOrDefault<wordList>("pictureFields", wordList());

    // A run that is continued counts from the state that it began with
    now_ = ++sinceState_ < interval && !last && !stateWanted_;
    if (!now_)
    {
        sinceState_ = 0;
        stateWanted_ = false;
    }
}


void Foam::pictures::check(const Time& time)
{
    const dictionary& control = time.controlDict();
    wordList fields;
    if (!control.readIfPresent("pictureFields", fields)) return;

    wordHashSet known;
    for (const polyMesh* mesh : time.lookupClass<polyMesh>())
    {
        for (const sceneCloud* cloud : mesh->lookupClass<sceneCloud>())
        {
            known.insert(cloud->fieldNames());
        }
    }
    for (const word& field : fields)
    {
        if (!known.found(field))
        {
            FatalIOErrorInFunction(control)
                << "Entry pictureFields names " << field << ", which no cloud"
                << " has; there are " << listedFor(field, known.sortedToc()).c_str()
                << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
