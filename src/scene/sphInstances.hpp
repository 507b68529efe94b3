/*  What the instantiating units (one a backend, dimension and precision) offer to createSphScene. */
#pragma once

#include "scene/sphScene.hpp"

namespace riprap
{

using SphMaker = std::unique_ptr<SphScene>(*)(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);

std::unique_ptr<SphScene> sphCpu2Mixed(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);
std::unique_ptr<SphScene> sphCpu3Mixed(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);
std::unique_ptr<SphScene> sphCpu2Double(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);
std::unique_ptr<SphScene> sphCpu3Double(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);
std::unique_ptr<SphScene> sphGpu2Mixed(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);
std::unique_ptr<SphScene> sphGpu3Mixed(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);
std::unique_ptr<SphScene> sphGpu2Double(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);
std::unique_ptr<SphScene> sphGpu3Double(const SphConfig&, const FluidInput&, const WallInput&, WallMotion);

} // namespace riprap
