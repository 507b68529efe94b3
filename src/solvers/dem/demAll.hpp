/*  DemSolver with all its parts, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/device.hpp"
#include "solvers/dem/demSetup.hpp"
#include "solvers/dem/demStep.hpp"
#include "solvers/dem/demSkin.hpp"
#include "solvers/dem/demLists.hpp"
#include "solvers/dem/demAdvance.hpp"
#include "solvers/dem/demCoupling.hpp"
#include "solvers/dem/demOutput.hpp"
#include "solvers/dem/demRanks.hpp"
#include "solvers/dem/demSleep.hpp"
#include "solvers/dem/demState.hpp"
#include "solvers/dem/demInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::string DemSolver<Backend, D, P>::deviceName() const { return deviceLabel(Backend()); }

} // namespace riprap
