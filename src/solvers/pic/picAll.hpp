/*  PicSolver with all its parts, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/device.hpp"
#include "solvers/pic/picSetup.hpp"
#include "solvers/pic/picCut.hpp"
#include "solvers/pic/picOpenings.hpp"
#include "solvers/pic/picSolids.hpp"
#include "solvers/pic/picStep.hpp"
#include "solvers/pic/picViscosity.hpp"
#include "solvers/pic/picForces.hpp"
#include "solvers/pic/picMomentum.hpp"
#include "solvers/pic/picAdvance.hpp"
#include "solvers/pic/picOutput.hpp"
#include "solvers/pic/picState.hpp"
#include "solvers/pic/picInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::string PicSolver<Backend, D, P>::deviceName() const { return deviceLabel(Backend()); }

} // namespace riprap
