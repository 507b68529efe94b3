/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What stops a run: what, where, when. Nothing is written then, so that the
    last time directory is a good one.
\*---------------------------------------------------------------------------*/

#include "picDem.H"
#include "remedies.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::string Foam::solverModules::picDem::advice() const
{
    const riprap::PicConfig& config = settings_.config;

    remedies helps;
    if (solids_.valid())
    {
        helps.when(settings_.weak, "coupling implicit (is weak)");
        solids_->remediesOf(helps);
        helps.when
        (
            config.reflection > 0 && solids_->lighterThan(0.1*config.density),
            "reflection no (light solids half out of water)"
        );
    }
    if (config.adjustTimeStep) helps.above("maxCo", config.maxCourant, 0.5);
    helps.above
    (
        "tolerance of p in system/fvSolution",
        solverOfPressure().lookupOrDefault<scalar>("tolerance", 1e-6),
        1e-8
    );
    helps.when
    (
        config.transfer == "flip" && !config.transferNumbers.affine,
        "affine yes, or transfer flipPic"
    );
    return helps.text
    (
        "Nothing is written: the last time directory is the last good one. A"
        " smaller maxCo or deltaT, or a smaller tolerance of p in"
        " system/fvSolution helps against most causes"
    );
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
            << advice().c_str() << exit(FatalError);
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
