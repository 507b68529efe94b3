/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rankBalance.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readRankBalance(checkedDictionary& all, riprap::RankConfig& config, bool onGpus)
{
    checkedDictionary dict(all.subDict("parallel"));
    config.measured = dict.either("balance", "time", "particles", true);
    config.imbalance = dict.positive("imbalance", config.imbalance);
    if (onGpus) config.direct = dict.either("messages", "direct", "host", config.direct);
    dict.end();
}


// ************************************************************************* //
