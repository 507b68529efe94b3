/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Several processes: what the log says of them.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "logRanks.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::dem::logRanks()
{
    if (!ranks_.valid()) return;
    Foam::logRanks(*ranks_, report_.rank);
}


// ************************************************************************* //
