/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    One OpenFOAM time step: as many particle steps as it takes.
\*---------------------------------------------------------------------------*/

#include "picDem.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::picDem::takeSteps(scalar t, int64_t maxSteps)
{
    const scalar before = scene_->time();
    advanceScene(*scene_, t, maxSteps, report_, run_);
    cloud_->moved();
    run_.particles = report_.fluid;
    for (std::size_t k = 0; k < report_.passed.size(); ++k)
    {
        run_.passed[settings_.config.openings[k].name] = report_.passed[k];
    }

    if (solids_)
    {
        solids_->moved();
    }
    checkStop();
    countEscaped(report_, run_, settings_.guards);
    checkProgress(before, report_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::solverModules::picDem::advance(scalar t, bool singleStep)
{
    // OpenFOAM reads fvSolution again when it is edited
    if (runTime_.runTimeModifiable() && pressure_.read(solverOfPressure()))
    {
        Info<< "The pressure is solved by the edited entries of"
            << " system/fvSolution" << nl << endl;
        ranks_.warnOfEdits(asRead_, settings_, pressure_, bool(solids_));
    }
    takeSteps(t, singleStep ? 1 : 0);

    return report_.time;
}


// ************************************************************************* //
