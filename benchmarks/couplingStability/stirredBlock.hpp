/*  A block of solid particles in stirred, pressed water without friction, in a periodic box (2D):
    nothing is dissipated, so that whatever total energy does is the scheme's.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/sphDemScene.hpp"

namespace riprap
{

struct StirredBlock
{
    std::string kind = "pressureGradient";
    std::string force = "held";
    double densityRatio = 1;
    bool rigid = false;             // else bonded
    int across = 6;                 // solid particles of the block's side
    double sizeRatio = 1;           // of solid to fluid particles
    double young = 1e6;             // of the bonds [Pa]
    double dampingRatio = 0;        // of the bonds
    double courant = 0.4;           // c0 dt/h
    double solidStep = 0.3;         // stepFraction of the solids
    double speed = 0.3;             // of the water at the start [m/s]
    double compression = 0.01;      // of the water at the start: nothing is in tension
    double disorder = 0;            // of the water's lattice at the start, in spacings
    double settle = 0;              // before energy is looked at [s]
    double duration = 0.1;          // after that [s]
    PrecisionKind precision = PrecisionKind::mixed;

    static constexpr double spacing = 0.025, smoothing = 1.5, soundSpeed = 10, density = 1000;
};

struct StirredResult
{
    bool stopped = false;           // by a guard
    // change of the total energy over the kinetic energy at the start, largest in size
    double energy = 0;
    double end = 0;                 // the same at the end
    // energy of the solids at the end over the kinetic energy at the start
    double solids = 0;
    int subcycles = 0;
    int inside = 0;                 // water particles within the block at the end
    std::int64_t steps = 0;
};

StirredResult stir(const StirredBlock&);

} // namespace riprap
