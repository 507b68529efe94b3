/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    A written time holds the scene's exact state beside the cloud. It is used
    where it belongs to the cloud, so that a run continues bit for bit; where
    it does not (the cloud was edited, the device or the precision is another
    one), the cloud's fields and bonds are, and the log says so: contacts
    then begin without a history.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "sceneState.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::solverModules::dem::canContinue(const solidSet& solids)
{
    if (!hasDemRun(runTime_))
    {
        return startFromCloud();
    }

    run_ = readDemRun(runTime_);
    return mayContinue(run_, solids.particles.size());
}


bool Foam::solverModules::dem::loadState(const solidSet& solids)
{
    try
    {
        // Of several processes the first tells the others
        std::vector<std::int32_t> words;
        if (Pstream::master())
        {
            words = readStateWords(runTime_, demRestart::stateFile);
        }
        scene_->loadState(words);
    }
    catch (const std::invalid_argument& e)
    {
        return notUsed(e.what());
    }

    if
    (
       !asWritten_
    && !matchesCloud
        (
            solids.particles, *scene_, settings_.config, mesh_.bounds().mag(),
            rewritten_ ? run_.digits : 0
        )
    )
    {
        return notUsed("the cloud has been changed since it was written");
    }

    Info<< "Continuing exactly from time " << runTime_.timeName() << nl
        << endl;
    return true;
}


// ************************************************************************* //
