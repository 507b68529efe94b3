/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    A written time holds the scene's exact state beside the cloud. It is used
    where it belongs to the cloud, so that a run continues bit for bit; where
    it does not, the cloud's fields are, and the log says so.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "dividedCloud.H"
#include "Map.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::solverModules::picDem::canContinue(const particleCloud& cloud)
{
    run_ = picRestart();
    if (!hasPicRun(runTime_))
    {
        return startFromCloud();
    }

    run_ = readPicRun(runTime_);
    if (Time::timeName(run_.time) != runTime_.timeName())
    {
        // Of another time: it counts what has not passed yet, or not all
        run_.passed.clear();
    }

    string why;
    if (solids_ && !solids_->canContinue(why))
    {
        return notUsed(why);
    }
    if (run_.particles > 0 && !hasCloudFolder(runTime_, "fluid"))
    {
        FatalIOErrorInFunction(runTime_.timePath()/"uniform"/"riprap"/"picRun")
            << "The water is missing: " << label(run_.particles)
            << " particles were written, and lagrangian/fluid of this time is"
            << " not there. Start from another time, or, to go on without"
            << " water, remove the folder "
            << runTime_.timePath()/"uniform"/"riprap" << exit(FatalIOError);
    }
    return mayContinue(run_, cloud.size());
}


//- To the six digits of an ascii file
bool Foam::solverModules::picDem::sameCloud(const particleCloud& cloud) const
{
    const riprap::FluidState fluid(scene_->fluid());
    const riprap::PicConfig& config = settings_.config;
    const scalar closeX = 1e-3*config.cellSize + 1e-5*mesh_.bounds().mag();
    const vectorField& U = cloud.vectors["U"];

    scalar fastest = 0;
    for (const vector& u : U)
    {
        fastest = max(fastest, mag(u));
    }
    const scalar closeU = 1e-4*fastest + SMALL;

    Map<label> entryOfId(2*cloud.size());
    const labelField& id = cloud.labels["id"];
    forAll(id, i)
    {
        entryOfId.insert(id[i], i);
    }

    bool same = label(fluid.id.size()) == cloud.size();
    for (std::size_t j = 0; same && j < fluid.id.size(); ++j)
    {
        const label i = entryOfId.lookup(fluid.id[j], -1);
        same = i >= 0;
        for (int d = 0; same && d < config.dimensions; ++d)
        {
            const int axis = config.axes[d];
            same =
                mag(cloud.position[i][axis] - fluid.position[3*j + axis])
             <= closeX
             && mag(U[i][axis] - fluid.velocity[3*j + axis]) <= closeU;
        }
    }
    return same;
}


bool Foam::solverModules::picDem::loadState(const particleCloud& cloud)
{
    try
    {
        // Of several processes the first tells the others
        std::vector<std::int32_t> words;
        if (Pstream::master()) words = readPicState(runTime_);
        scene_->loadState(words);
    }
    catch (const std::invalid_argument& e)
    {
        return notUsed(e.what());
    }

    const bool same =
        asWritten_
     || (sameCloud(cloud) && (!solids_ || solids_->sameAsCloud(rewritten_)));
    if (!same)
    {
        return notUsed("the cloud has been changed since it was written");
    }

    run_.spacing = scene_->particleSpacing();
    Info<< "Continuing exactly from time " << runTime_.timeName()
        << nl << endl;
    return true;
}


// ************************************************************************* //
