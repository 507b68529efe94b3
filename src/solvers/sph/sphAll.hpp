/*  SphSolver with all its parts, for the instantiating units.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/device.hpp"
#include "solvers/sph/sphSetup.hpp"
#include "solvers/sph/sphNeighbours.hpp"
#include "solvers/sph/sphStep.hpp"
#include "solvers/sph/sphFaces.hpp"
#include "solvers/sph/sphForces.hpp"
#include "solvers/sph/sphSolids.hpp"
#include "solvers/sph/sphAdvance.hpp"
#include "solvers/sph/sphStiffness.hpp"
#include "solvers/sph/sphOutput.hpp"
#include "solvers/sph/sphState.hpp"
#include "solvers/sph/sphInstances.hpp"

namespace riprap
{

template<class Backend, int D, class P>
std::string SphSolver<Backend, D, P>::deviceName() const { return deviceLabel(Backend()); }

} // namespace riprap
