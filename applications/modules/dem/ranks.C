/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Several processes: what they cannot share yet, and what the log says of
    them.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "logRanks.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::solverModules::dem::requireDivisible(const solidSet& solids) const
{
    if (!ranks_.valid()) return;

    if (solids.clumps.empty()) return;

    FatalErrorInFunction
        << "lagrangian/solids of time " << runTime_.timeName() << " has "
        << label(solids.clumps.size()) << " rigid bodies of several particles,"
        << " which run on one process alone: -parallel takes particles, bonded"
        << " or not, and walls" << exit(FatalError);
}


void Foam::solverModules::dem::logRanks()
{
    if (!ranks_.valid()) return;
    Foam::logRanks(*ranks_, report_.rank);
}


// ************************************************************************* //
