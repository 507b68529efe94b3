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

    const auto refuse = [&](std::size_t n, const char* what)
    {
        if (!n) return;
        FatalErrorInFunction
            << "lagrangian/solids of time " << runTime_.timeName() << " has "
            << label(n) << ' ' << what << ", which run on one process alone:"
            << " -parallel takes particles that are not joined, and walls"
            << exit(FatalError);
    };
    refuse(solids.clumps.size(), "rigid bodies of several particles");
    refuse(solids.bonds.size(), "bonds");
}


void Foam::solverModules::dem::logRanks()
{
    if (!ranks_.valid()) return;
    Foam::logRanks(*ranks_, report_.rank);
}


// ************************************************************************* //
