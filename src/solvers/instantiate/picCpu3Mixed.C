// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/pic/driver/picAll.hpp"

std::unique_ptr<riprap::PicScene> riprap::picCpu3Mixed(
    const PicConfig& c, const FluidInput& f, const PicWalls& w, LinearSolver* s, PicInside&& i)
{
    return std::make_unique<PicSolver<Cpu, 3, Mixed>>(c, f, w, s, std::move(i));
}
