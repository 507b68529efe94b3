/*  The scene that gateSpeed times: the elastic gate of Antoci et al. (2007) as deep as its tank is
    wide. Water 0.1 m x 0.14 m x 0.1 m at rest under its pressure, behind a gate 79 mm high and 5 mm
    thick that hangs from a clamp (four rows), with bonds of E = 10 MPa; no local damping. In its
    place, for comparison: the same particles held, or wall points on the water's lattice.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphDemScene.hpp"

namespace riprap
{

enum class GateKind {wall, held, elastic};

struct GateOptions
{
    DeviceKind device = DeviceKind::automatic;
    PrecisionKind precision = PrecisionKind::mixed;
    std::string integrator = "symplectic";
    std::string solids = "velocityVerlet";
    std::string coupling = "pressureGradient";
    double particles = 20000;       // of water
    double stepFraction = 0.9;      // of the gate's sqrt(m/k); its bonds stand 1
    double size = 1;                // of the gate's particles over the water's
    int develop = 100, steps = 100, repeat = 5;
    bool kernels = false;
};

struct GateScene
{
    SphConfig config;
    FluidInput fluid;
    WallInput walls;
    SolidInput solids;              // empty with a wall
};

GateScene makeGate(const GateOptions&, GateKind);

} // namespace riprap
