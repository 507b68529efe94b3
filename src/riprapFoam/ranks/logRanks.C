/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "logRanks.H"
#include "moduleLog.H"
#include "core/ranks/joinRanks.hpp"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::logRanks(pstreamTransport& ranks, const riprap::RankReport& here)
{
    std::vector<std::int64_t> sums
    {
        int64_t(here.owned), int64_t(here.ghosts), here.arrivals,
        here.bytesInSteps, here.bytesAtRebuilds
    };
    ranks.sum(sums);
    std::vector<double> most{scalar(here.owned), here.atWork};
    ranks.largest(most);
    std::vector<double> work(1, here.atWork);
    riprap::addByRank(ranks, work);

    const int n = ranks.size();
    Info<< "Processes = " << n << ", largest part = "
        << most[0]*n/max(scalar(sums[0]), scalar(1))
        << " of the mean, ghosts = " << sums[1] << ", bricks cut = "
        << here.divisions;
    if (here.unevenBefore > 0)
    {
        Info<< " (the last time from " << here.unevenBefore << " of the mean to "
            << here.unevenAfter << ')';
    }
    Info<< nl << "Busiest process = " << most[1]*n/max(work[0], VSMALL)
        << " of the mean time in steps without waiting" << nl
        << "Sent in all: steps " << bytesText(sums[3]).c_str()
        << (here.direct ? " from GPU to GPU" : "");
    // A grid has none
    if (sums[4]) Info<< ", rebuilds " << bytesText(sums[4]).c_str();
    Info<< ", particles to other processes " << sums[2] << endl;
}


// ************************************************************************* //
