/*  What the instantiating units (one a backend, dimension and precision) offer to createSphScene.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphDemScene.hpp"

namespace riprap
{

//- Solids that are made, for the scene that takes them; empty: none
struct SolidPart
{
    std::unique_ptr<DemScene> scene;
    CouplingConfig coupling;
    // of each: mass of the water that its pressure moves over its own, or that of the rigid body
    // that it is of
    std::vector<double> added;
    std::vector<double> volume;
    WallFaceInput faces;        // of rigid bodies
    std::vector<std::int32_t> clump;            // of each particle; empty: there are none
    int clumps = 0;
    double largestRadius = 0;   // [m]
};

using SphMaker = std::unique_ptr<SphScene>(*)(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);

std::unique_ptr<SphScene> sphCpu2Mixed(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);
std::unique_ptr<SphScene> sphCpu3Mixed(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);
std::unique_ptr<SphScene> sphCpu2Double(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);
std::unique_ptr<SphScene> sphCpu3Double(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);
std::unique_ptr<SphScene> sphGpu2Mixed(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);
std::unique_ptr<SphScene> sphGpu3Mixed(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);
std::unique_ptr<SphScene> sphGpu2Double(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);
std::unique_ptr<SphScene> sphGpu3Double(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);

//- The device that a scene of so many particles is made on
DeviceKind deviceOf(const SphConfig&, std::size_t particles);

//- With solids that are on the device that the configuration chooses
std::unique_ptr<SphScene> createSphScene(
    const SphConfig&, const FluidInput&, const WallInput&, WallMotion, SolidPart);

} // namespace riprap
