/*  SphSolver with all its parts, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/device.hpp"
#include "scene/sphSetup.hpp"
#include "scene/sphNeighbours.hpp"
#include "scene/sphStep.hpp"
#include "scene/sphFaces.hpp"
#include "scene/sphForces.hpp"
#include "scene/sphSolids.hpp"
#include "scene/sphAdvance.hpp"
#include "scene/sphStiffness.hpp"
#include "scene/sphOutput.hpp"
#include "scene/sphState.hpp"
#include "scene/sphInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::string SphSolver<Backend, D, P>::deviceName() const { return deviceLabel(Backend()); }

} // namespace riprap
