/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What stops a run: what, where, when. Nothing is written then, so that the
    last time directory is a good one.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

const char* Foam::solverModules::sphDem::advice() const
{
    return
        "Nothing is written: the last time directory is the last good one. A"
        " shorter time step (the Courant numbers), a larger maxVelocity, walls"
        " in closed layers or densityDiffusion help against most causes";
}


void Foam::solverModules::sphDem::checkStop() const
{
    using riprap::StopReason;

    if (report_.stop == StopReason::none)
    {
        return;
    }

    const riprap::SphConfig& config = settings_.config;

    OStringStream what;
    switch (report_.stop)
    {
        case StopReason::notANumber:
            what<< "has a value that is not a number";
            break;

        case StopReason::density:
            what<< "has a density that deviates by " << report_.stopValue
                << " (relative) from rho; guards/densityDeviation allows "
                << config.maxDensityDeviation;
            break;

        case StopReason::speed:
            what<< "has the speed " << report_.stopValue << " m/s;"
                << " guards/speedRatio allows " << config.maxSpeedRatio
                << " times maxVelocity " << config.maxVelocity << " m/s";
            break;

        default:
            what<< "has more neighbours than the list of its kind holds";
    }

    stopAt(report_, run_, what.str());
}


//- Neighbours are sought anew before particles can have moved too far; a
//  step that grew, or an impact, may still carry one further than foreseen
void Foam::solverModules::sphDem::checkSkin()
{
    if (report_.skinExceeded && ++nSkinExceeded_ == 1)
    {
        WarningInFunction
            << "Up to time " << report_.time << " s, particle step "
            << run_.steps << ": a particle moved further in one step than was"
            << " foreseen when neighbours were sought, so that pairs may have"
            << " been missed in that step. A shorter time step (the Courant"
            << " numbers) helps. The log's line 'Missed pairs' counts on"
            << endl;
    }
}


// ************************************************************************* //
