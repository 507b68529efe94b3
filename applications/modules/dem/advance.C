/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    One OpenFOAM time step: as many particle steps as it takes.
\*---------------------------------------------------------------------------*/

#include "dem.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::solverModules::dem::advance(scalar t, bool singleStep)
{
    const scalar before = scene_->time();

    moving_ = Pair<scalar>(before, t);
    advanceScene(*scene_, t, singleStep, report_, run_);
    cloud_->moved();
    run_.particles = report_.particles;

    checkStop();
    countEscaped(report_, run_, settings_.guards);
    checkProgress(before, report_);

    return report_.time;
}


// ************************************************************************* //
