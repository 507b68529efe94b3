/*  DemSolver with all its parts, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/device.hpp"
#include "solvers/dem/driver/demSetup.hpp"
#include "solvers/dem/driver/demAdvance.hpp"
#include "solvers/dem/driver/demCoupling.hpp"
#include "solvers/dem/driver/demOutput.hpp"
#include "solvers/dem/driver/demState.hpp"
#include "solvers/dem/demInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::string DemSolver<Backend, D, P>::deviceName() const { return deviceLabel(Backend()); }

} // namespace riprap
