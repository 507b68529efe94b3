// SPDX-License-Identifier: GPL-3.0-or-later

#include "solvers/dem/driver/demAll.hpp"

std::unique_ptr<riprap::DemScene> riprap::demGpu3Double(
    const DemConfig& c, const DemInput& in, const DemPlan& p)
{
    return std::make_unique<DemSolver<Gpu, 3, Double>>(c, in, p);
}
