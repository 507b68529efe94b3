/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "logRanks.H"
#include "moduleLog.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::logRanks(pstreamTransport& ranks, const riprap::RankReport& here)
{
    std::vector<std::int64_t> sums
    {
        int64_t(here.owned), int64_t(here.ghosts), here.arrivals,
        here.bytesInSteps, here.bytesAtRebuilds
    };
    ranks.sum(sums);
    std::vector<double> most(1, here.owned);
    ranks.largest(most);

    const int n = ranks.size();
    Info<< "Processes = " << n << ", largest part = "
        << most[0]*n/max(scalar(sums[0]), scalar(1))
        << " of the mean, ghosts = " << sums[1] << ", bricks cut = "
        << here.divisions << nl
        << "Sent in all: steps " << bytesText(sums[3]).c_str()
        << ", rebuilds " << bytesText(sums[4]).c_str() << ", particles to"
        << " other processes " << sums[2] << endl;
}


// ************************************************************************* //
