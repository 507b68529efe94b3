// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/pic/driver/picAll.hpp"

std::unique_ptr<riprap::PicScene> riprap::picGpu3Double(
    const PicConfig& c, const FluidInput& f, const PicWalls& w, LinearSolver* s, PicInside&& i)
{
    return std::make_unique<PicSolver<Gpu, 3, Double>>(c, f, w, s, std::move(i));
}
