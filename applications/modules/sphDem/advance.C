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
    progress_.start();

    report_ = scene_->advance(t, singleStep ? 1 : 0);

    progress_.stop(report_.steps, report_.steps*int64_t(run_.particles));
    cloud_->moved();

    run_.time = report_.time;
    run_.steps += report_.steps;
    run_.particles = report_.fluid;

    checkStop();
    checkSkin();
    countEscaped();

    if (!(report_.time > before))
    {
        FatalErrorInFunction
            << "The particles do not move on from time " << before << ": "
            << report_.steps << " steps, the last one of "
            << report_.lastTimeStep << " s" << exit(FatalError);
    }

    return report_.time;
}


// ************************************************************************* //
