/*  DemSolver with all its parts, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/device.hpp"
#include "scene/demSetup.hpp"
#include "scene/demStep.hpp"
#include "scene/demSkin.hpp"
#include "scene/demLists.hpp"
#include "scene/demAdvance.hpp"
#include "scene/demCoupling.hpp"
#include "scene/demOutput.hpp"
#include "scene/demSleep.hpp"
#include "scene/demState.hpp"
#include "scene/demInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::string DemSolver<Backend, D, P>::deviceName() const { return deviceLabel(Backend()); }

} // namespace riprap
