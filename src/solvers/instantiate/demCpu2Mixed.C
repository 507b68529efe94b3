// SPDX-License-Identifier: GPL-3.0-or-later

#include "solvers/dem/driver/demAll.hpp"

std::unique_ptr<riprap::DemScene> riprap::demCpu2Mixed(
    const DemConfig& c, const DemInput& in, const DemPlan& p)
{
    return std::make_unique<DemSolver<Cpu, 2, Mixed>>(c, in, p);
}
