/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What stops a run: what, where, when. Nothing is written then, so that the
    last time directory is a good one.
\*---------------------------------------------------------------------------*/

#include "picDem.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

const char* Foam::solverModules::picDem::advice() const
{
    return
        "Nothing is written: the last time directory is the last good one. A"
        " smaller maxCo or deltaT, or a smaller tolerance of p in"
        " system/fvSolution helps against most causes";
}


void Foam::solverModules::picDem::checkStop() const
{
    using riprap::StopReason;

    if (report_.stop == StopReason::none)
    {
        return;
    }

    OStringStream what;
    if (report_.stop == StopReason::notANumber)
    {
        what<< "has a velocity that is not a number";
    }
    else if (report_.stop == StopReason::solids)
    {
        FatalErrorInFunction
            << "Guard at time " << report_.time << " s, particle step "
            << run_.steps << ": " << report_.stopMessage.c_str() << nl
            << advice() << exit(FatalError);
    }
    else if (report_.stop == StopReason::tooFast)
    {
        what<< report_.stopMessage.c_str();
    }
    else
    {
        what<< "would go " << report_.stopValue << " cells in a step;"
            << " guards/Courant allows " << settings_.config.maxCourantEver;
    }

    stopAt(report_, run_, what.str());
}


// ************************************************************************* //
