/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What stops a run: what, where, when. Nothing is written then, so that the
    last time directory is a good one.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "solidRemedies.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::string Foam::solverModules::dem::advice() const
{
    remedies helps;
    solidRemedies(helps, settings_, input_, false);
    return helps.text
    (
        "Nothing is written: the last time directory is the last good one. A"
        " shorter time step (stepFraction, or deltaT), stiffer contacts for"
        " the speeds that occur, and a start without overlaps help against"
        " most causes"
    );
}


void Foam::solverModules::dem::checkStop() const
{
    if (report_.stop != riprap::DemStop::none)
    {
        stopAt(report_, run_, report_.stopMessage);
    }
}


// ************************************************************************* //
