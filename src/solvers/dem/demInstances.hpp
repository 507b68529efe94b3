/*  What the instantiating units (one a backend, dimension and precision) offer to createDemScene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/demScene.hpp"

namespace riprap
{

using DemMaker = std::unique_ptr<DemScene>(*)(const DemConfig&, const DemInput&, const DemPlan&);

std::unique_ptr<DemScene> demCpu2Mixed(const DemConfig&, const DemInput&, const DemPlan&);
std::unique_ptr<DemScene> demCpu3Mixed(const DemConfig&, const DemInput&, const DemPlan&);
std::unique_ptr<DemScene> demCpu2Double(const DemConfig&, const DemInput&, const DemPlan&);
std::unique_ptr<DemScene> demCpu3Double(const DemConfig&, const DemInput&, const DemPlan&);
std::unique_ptr<DemScene> demGpu2Mixed(const DemConfig&, const DemInput&, const DemPlan&);
std::unique_ptr<DemScene> demGpu3Mixed(const DemConfig&, const DemInput&, const DemPlan&);
std::unique_ptr<DemScene> demGpu2Double(const DemConfig&, const DemInput&, const DemPlan&);
std::unique_ptr<DemScene> demGpu3Double(const DemConfig&, const DemInput&, const DemPlan&);

} // namespace riprap
