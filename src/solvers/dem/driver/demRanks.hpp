/*  DemSolver on several ranks (CPU): each owns the particles of its brick, and has ghosts of those of others that they may touch.

    Ghosts stand among a rank's own particles in the order of their cells, marked as asleep: they act, and nothing acts on them. That order is
    the one of one process, so pairs have the same owner there, forces are added up in the same order, and results are the same bits. What a pair
    across a border remembers is kept by both ranks, each of which works it out.

    In a step ranks send positions and velocities of ghosts, and agree on the clock's flags. At a rebuild particles change their ranks with all
    their fields, histories of contacts and of walls.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

//- A guard has fired: the rank of the worst particle says which it is, and all report it
template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::findOffenderOfRanks(DemReport& report)
{
    Transport& ranks = *p_.set.config.ranks;
    const int n = p_.order.active();
    const std::vector<double> offence = offences(n);
    int worst = -1;
    for (int i = 0; i < n; ++i) if (!ranks_.ghost(i) && (worst < 0 || offence[i] > offence[worst])) worst = i;
    const double here = worst < 0 ? -1 : offence[worst], most = ranks_.largest(here);
    const int speaker = ranks.size() - int(ranks_.largest(here == most ? ranks.size() - ranks.rank() : 0));
    std::vector<RankBytes> out(ranks.size()), in;
    if (ranks.rank() == speaker && worst >= 0)
    {
        describeOffender(report, worst, offence[worst]);
        RankBytes said;
        putValues(said, &report.stop);
        putValues(said, &report.stopId);
        putValues(said, report.stopPosition.data(), 3);
        putValues(said, &report.stopValue);
        putValues(said, report.stopMessage.data(), report.stopMessage.size());
        out.assign(ranks.size(), said);
    }
    ranks.exchange(out, in);
    if (ranks.rank() == speaker || in[speaker].empty()) return;
    const unsigned char* from = in[speaker].data();
    const unsigned char* const end = from + in[speaker].size();
    takeValues(from, &report.stop);
    takeValues(from, &report.stopId);
    takeValues(from, report.stopPosition.data(), 3);
    takeValues(from, &report.stopValue);
    report.stopMessage.assign(reinterpret_cast<const char*>(from), std::size_t(end - from));
}

} // namespace riprap
