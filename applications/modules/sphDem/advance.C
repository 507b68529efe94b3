/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    One OpenFOAM time step: as many particle steps as it takes.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::solverModules::sphDem::advance(scalar t, bool singleStep)
{
    writeWalls();

    const scalar before = scene_->time();
    advanceScene(*scene_, t, singleStep, report_, run_);
    cloud_->moved();

    run_.particles = report_.fluid;

    if (solids_)
    {
        solids_->moved();
    }
    checkStop();
    countWild();
    checkSkin();
    countEscaped(report_, run_, settings_.guards);
    checkProgress(before, report_);

    return report_.time;
}


// ************************************************************************* //
