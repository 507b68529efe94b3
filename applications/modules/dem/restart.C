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
#include "Map.H"
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
        scene_->loadState(readStateWords(runTime_, demRun::stateFile));
    }
    catch (const std::invalid_argument& e)
    {
        return notUsed(e.what());
    }

    if (!sameAs(solids))
    {
        return notUsed("the cloud has been changed since it was written");
    }

    Info<< "Continuing exactly from time " << runTime_.timeName() << nl
        << endl;
    return true;
}


//- Is what was loaded what the cloud says, to the digits of an ascii file?
bool Foam::solverModules::dem::sameAs(const solidSet& solids) const
{
    const riprap::DemConfig& config = settings_.config;
    const riprap::DemParticles& cloud = solids.particles;
    const riprap::DemState now(scene_->particles());
    if (now.id.size() != cloud.size())
    {
        return false;
    }

    Map<label> entryOfId(2*label(cloud.size()));
    scalar fastest = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        entryOfId.insert(cloud.id[i], i);
        const double* u = &cloud.velocity[3*i];
        fastest = max(fastest, mag(vector(u[0], u[1], u[2])));
    }

    const scalar closeX = 1e-5*mesh_.bounds().mag();
    const scalar closeU = 1e-4*fastest;
    for (std::size_t j = 0; j < now.id.size(); ++j)
    {
        const label i = entryOfId.lookup(now.id[j], -1);
        if (i < 0)
        {
            return false;
        }
        for (int k = 0; k < config.dimensions; ++k)
        {
            const int d = config.axes[k];
            // Not close is what NaN is, too
            if
            (
                !(mag(now.position[3*j + d] - cloud.position[3*i + d]) <= closeX)
             || !(mag(now.velocity[3*j + d] - cloud.velocity[3*i + d]) <= closeU)
            )
            {
                return false;
            }
        }
    }
    return true;
}


// ************************************************************************* //
