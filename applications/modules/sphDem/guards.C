/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What stops a run: what, where, when. Nothing is written then, so that the
    last time directory is a good one.
\*---------------------------------------------------------------------------*/

#include "sphDem.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static point toPoint(const riprap::Vector3& x)
{
    return point(x[0], x[1], x[2]);
}


static const char* const advice =
    "Nothing is written: the last time directory is the last good one. A"
    " shorter time step (the Courant numbers), a larger maxVelocity, walls in"
    " closed layers or densityDiffusion help against most causes";

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::sphDem::checkStop() const
{
    using riprap::StopReason;

    if (report_.stop == StopReason::none)
    {
        return;
    }

    const riprap::SphConfig& config = settings_.config;
    const point where(toPoint(report_.stopPosition));

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

    FatalErrorInFunction
        << "Guard at time " << report_.time << " s, particle step "
        << run_.steps << ": particle " << report_.stopId << " at " << where
        << " (nearest patch: " << boundary_.patch(where) << ") "
        << what.str().c_str() << nl << advice << exit(FatalError);
}


void Foam::solverModules::sphDem::countEscaped()
{
    if (report_.escaped.empty())
    {
        return;
    }

    escaped_.add(report_.escaped);
    run_.escaped += report_.escaped.size();

    escaped_.stopAbove
    (
        settings_.guards.stopAtEscape ? 0 : settings_.guards.maxEscaped,
        report_,
        run_,
        advice
    );
}


// ************************************************************************* //
