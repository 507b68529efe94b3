/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What stops a run: what, where, when. Nothing is written then, so that the
    last time directory is a good one.
\*---------------------------------------------------------------------------*/

#include "dem.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const char* const advice =
    "Nothing is written: the last time directory is the last good one. A"
    " shorter time step (stepFraction, or deltaT), stiffer contacts for the"
    " speeds that occur, and a start without overlaps help against most causes";


static point toPoint(const riprap::Vector3& x)
{
    return point(x[0], x[1], x[2]);
}

} // End namespace Foam


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::dem::checkStop() const
{
    if (report_.stop == riprap::DemStop::none)
    {
        return;
    }

    const point where(toPoint(report_.stopPosition));
    FatalErrorInFunction
        << "Guard at time " << report_.time << " s, particle step "
        << run_.steps << ": particle " << report_.stopId << " at " << where
        << " (nearest patch: " << boundary_.patch(where) << "): "
        << report_.stopMessage.c_str() << nl << advice << exit(FatalError);
}


void Foam::solverModules::dem::countEscaped()
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
