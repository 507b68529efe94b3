// SPDX-License-Identifier: GPL-3.0-or-later

#include "solvers/sph/driver/sphAll.hpp"

std::unique_ptr<riprap::SphScene> riprap::sphCpu3Double
(const SphConfig& c, const FluidInput& f, const WallInput& w, WallMotion m, SolidPart s)
{
    return std::make_unique<SphSolver<Cpu, 3, Double>>(c, f, w, std::move(m), std::move(s));
}
