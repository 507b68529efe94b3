/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    One OpenFOAM time step: as many particle steps as it takes.
\*---------------------------------------------------------------------------*/

#include "dem.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::dem::takeSteps(scalar t, int64_t maxSteps)
{
    const scalar before = scene_->time();

    moving_ = Pair<scalar>(before, t);
    advanceScene(*scene_, t, maxSteps, report_, run_);
    cloud_->moved();
    run_.particles = report_.particles;

    checkStop();
    countEscaped(report_, run_, settings_.guards);
    checkProgress(before, report_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::solverModules::dem::advance(scalar t, bool singleStep)
{
    takeSteps(t, singleStep ? 1 : 0);

    return report_.time;
}


// ************************************************************************* //
