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

    progress_.start();
    // A signal between two calls would find no step to end
    report_ = scene_->advance(t, singleStep || interrupted_ ? 1 : 0);
    progress_.stop(report_.steps, report_.steps*int64_t(run_.particles));

    cloud_->moved();
    run_.time = report_.time;
    run_.steps += report_.steps;
    run_.particles = report_.particles;

    checkStop();
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
