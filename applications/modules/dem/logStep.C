/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The log of an OpenFOAM time step.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "logPrecision.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solverModules::dem::report()
{
    const logPrecision digits;

    Info<< "Particle steps = " << report_.steps << " (" << run_.steps
        << "), deltaT = " << scene_->plan().timeStep << " s, limit: "
        << scene_->plan().cause.c_str() << nl
        << "max(mag(U)) = " << report_.maxSpeed << " m/s, neighbour lists = "
        << report_.rebuilds;
    if (settings_.config.sleepSpeed > 0)
    {
        Info<< ", asleep = " << int64_t(report_.asleep);
    }
    if (input_.bonds.size())
    {
        Info<< ", broken bonds = "
            << int64_t(report_.brokenBonds) + run_.brokenBefore;
    }
    Info<< endl;

    logRanks();
    logEscaped(report_.escaped.size(), run_);
    logPassedWalls();
    checkOverlaps();

    logProgress();
}


// ************************************************************************* //
