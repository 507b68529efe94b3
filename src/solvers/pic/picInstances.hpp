/*  What the instantiating units (one a backend, dimension and precision) offer to createPicScene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/picScene.hpp"

namespace riprap
{

using PicMaker = std::unique_ptr<PicScene>(*)(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);

std::unique_ptr<PicScene> picCpu2Mixed(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);
std::unique_ptr<PicScene> picCpu3Mixed(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);
std::unique_ptr<PicScene> picCpu2Double(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);
std::unique_ptr<PicScene> picCpu3Double(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);
std::unique_ptr<PicScene> picGpu2Mixed(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);
std::unique_ptr<PicScene> picGpu3Mixed(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);
std::unique_ptr<PicScene> picGpu2Double(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);
std::unique_ptr<PicScene> picGpu3Double(
    const PicConfig&, const FluidInput&, const PicWalls&, LinearSolver*, PicInside&&);

} // namespace riprap
