/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    A written time holds the scene's exact state beside the cloud. It is used
    where it belongs to the cloud, so that a run continues bit for bit; where
    it does not (the cloud was edited, the device or the precision is another
    one), the cloud's fields are, and the log says so.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"
#include "cloudComparison.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::solverModules::sphDem::canContinue(const particleCloud& cloud)
{
    if (!hasSphRun(runTime_))
    {
        return startFromCloud();
    }

    run_ = readSphRun(runTime_);

    string why;
    if (solids_ && !solids_->canContinue(why))
    {
        return notUsed(why);
    }
    return mayContinue(run_, cloud.size());
}


namespace Foam
{

static void warnOfOtherDensity(scalar now, scalar before)
{
    if (mag(now - before) > 1e-9*before)
    {
        WarningInFunction
            << "Entry rho of constant/fluidProperties is " << now
            << ", and was " << before << " in the run that is continued. The"
            << " new one is used: every particle keeps its relative density"
            << " rho/rho0, so that mass, density and pressure change by the"
            << " same factor" << endl;
    }
}

}


bool Foam::solverModules::sphDem::loadState
(
    const particleCloud& cloud,
    const sphRestart& before
)
{
    const riprap::SphConfig& config = settings_.config;
    if (!domainKept_)
    {
        return notUsed
        (
            "walls move beyond the domain that it was written for (another"
            " endTime, or another motion)"
        );
    }

    try
    {
        // Of several processes the first tells the others
        std::vector<std::int32_t> state;
        if (Pstream::master()) state = readSphState(runTime_);
        scene_->loadState(state);
    }
    catch (const std::invalid_argument& e)
    {
        return notUsed(e.what());
    }

    // Older states do not say
    const scalar density = before.density > 0 ? before.density : config.density;

    const cloudComparison compare(config, cloud, scene_->fluid());
    const scalar closeX = 1e-3*config.spacing + 1e-5*mesh_.bounds().mag();
    const char* changed =
        asWritten_ ? nullptr : compare.changed(closeX, density);
    if (changed)
    {
        return notUsed
        (
            "the cloud has been changed since it was written (" +
            std::string(changed) + ")"
        );
    }

    if (!asWritten_ && solids_ && !solids_->sameAsCloud(rewritten_))
    {
        return notUsed
        (
            "lagrangian/solids has been changed since it was written"
        );
    }

    Info<< "Continuing exactly from time " << runTime_.timeName()
        << nl << endl;

    warnOfOtherDensity(config.density, density);
    return true;
}


//- Edits of fields that are not read
void Foam::solverModules::sphDem::warnUnread(const particleCloud& cloud) const
{
    const cloudComparison compare(settings_.config, cloud, scene_->fluid());

    if (const label n = compare.otherPressures())
    {
        WarningInFunction
            << "Field p of lagrangian/fluid at time " << runTime_.timeName()
            << " is not what rho gives, at " << n << " particles: it, or the"
            << " equation of state, has been changed. p is not read where rho"
            << " is there: edit rho instead" << endl;
    }
    if (const label n = compare.otherSmoothingLengths())
    {
        WarningInFunction
            << "Field h of lagrangian/fluid at time " << runTime_.timeName()
            << " is not what smoothingLength of constant/sphProperties gives,"
            << " at " << n << " particles. h is never read: smoothingLength"
            << " and rho decide" << endl;
    }
}


// ************************************************************************* //
