/*  DemSolver: everything that is read back.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/largest.hpp"
#include "dem/passes/contactProbe.hpp"
#include "solvers/dem/driver/demSolver.hpp"

namespace riprap
{

template<class Backend, int D, class P>
void DemSolver<Backend, D, P>::setExternalForces(const std::vector<double>& force, const std::vector<double>& moment)
{
    ranks_.requireAlone("forces from outside");
    std::vector<real> all(std::size_t(p_.particles.n)*(D + S), real(0));
    for (int i = 0; i < p_.particles.n; ++i)
    {
        const std::size_t at = 3*std::size_t(p_.particles.ids[i]);
        if (!force.empty() && at + 3 > force.size()) throw std::invalid_argument("external forces: too few for the ids");
        if (!moment.empty() && at + 3 > moment.size()) throw std::invalid_argument("external moments: too few for the ids");
        real* to = &all[std::size_t(i)*(D + S)];
        if (!force.empty()) for (int d = 0; d < D; ++d) to[d] = real(force[at + p_.set.config.axes[d]]);
        if (!moment.empty())
            for (int c = 0; c < S; ++c) to[D + c] = real(D == 2 ? p_.set.spinSign()*moment[at + p_.set.config.axes[2]] : moment[at + c]);
    }
    if (p_.sleeps()) sleepers_.wakeChanged(p_.particles.external.download(), all);
    p_.particles.external.upload(p_.set.context, all);
    p_.clumps.gather(nullptr, p_.order.slotOf.data());
}

} // namespace riprap
