// SPDX-License-Identifier: GPL-3.0-or-later

#include "solvers/sph/driver/sphAll.hpp"

std::unique_ptr<riprap::SphScene> riprap::sphCpu3Mixed
(const SphConfig& c, const FluidInput& f, const WallInput& w, WallMotion m, SolidPart s)
{
    return std::make_unique<SphSolver<Cpu, 3, Mixed>>(c, f, w, std::move(m), std::move(s));
}
