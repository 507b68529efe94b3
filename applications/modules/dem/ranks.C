/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Several processes: what they cannot share yet, and what the log says of
    them.
\*---------------------------------------------------------------------------*/

#include "dem.H"
#include "logPrecision.H"
#include "moduleLog.H"

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

    const riprap::DemRankReport& here = report_.rank;
    std::vector<std::int64_t> sums
    {
        int64_t(here.owned), int64_t(here.ghosts), here.arrivals,
        here.bytesInSteps, here.bytesAtRebuilds
    };
    ranks_->sum(sums);
    std::vector<double> most(1, here.owned);
    ranks_->largest(most);

    const int n = ranks_->size();
    Info<< "Processes = " << n << ", largest part = "
        << most[0]*n/max(scalar(sums[0]), scalar(1))
        << " of the mean, ghosts = " << sums[1] << ", bricks cut = "
        << here.divisions << nl
        << "Sent in all: steps " << bytesText(sums[3]).c_str()
        << ", rebuilds " << bytesText(sums[4]).c_str() << ", particles to"
        << " other processes " << sums[2] << endl;
}


// ************************************************************************* //
