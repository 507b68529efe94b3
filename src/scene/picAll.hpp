/*  PicSolver with all its parts, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/device.hpp"
#include "scene/picSetup.hpp"
#include "scene/picCut.hpp"
#include "scene/picOpenings.hpp"
#include "scene/picSolids.hpp"
#include "scene/picStep.hpp"
#include "scene/picViscosity.hpp"
#include "scene/picForces.hpp"
#include "scene/picMomentum.hpp"
#include "scene/picAdvance.hpp"
#include "scene/picOutput.hpp"
#include "scene/picState.hpp"
#include "scene/picInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::string PicSolver<Backend, D, P>::deviceName() const { return deviceLabel(Backend()); }

} // namespace riprap
