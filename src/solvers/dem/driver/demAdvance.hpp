/*  DemSolver: the loop over steps, and its guards.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <limits>
#include <sstream>

namespace riprap
{

template<class Backend, int D, class P>
DemReport DemSolver<Backend, D, P>::advance(double t, std::int64_t maxSteps)
{
    ranks_.start();
    DemReport report;
    p_.clock.read();
    const std::int64_t before = p_.clock.now.step;
    p_.clock.now.target = t;
    p_.clock.now.lastStep = maxSteps > 0 ? before + maxSteps : std::int64_t(1) << 62;
    p_.clock.write();
    stepper_.run(report.rebuilds);
    reports_.finish(report, before);
    reports_.last = report;
    return report;
}

} // namespace riprap
