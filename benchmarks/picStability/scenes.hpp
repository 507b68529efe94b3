/*  The scenes of picStability, 2D, in double precision: what may not grow in them does so by the
    scheme alone.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "api/picScene.hpp"

namespace riprap
{

//- What became of a scene
struct PicOutcome
{
    bool stopped = false;           // by a guard
    // largest over that of the start: kinetic of vortices, of the wave's mean height and speed for
    // a wave
    double energy = 0;
    double kept = 0;                // at the end over that of the start
    // rms of particles' velocities less the grid's where they are, over the rms velocity
    double noise = 0;
    double error = 0;               // of vortices' velocity, relative L2
    double speed = 0;               // largest [m/s]
    double volumeError = 0;         // largest at the end of a sample
    double volumeDrift = 0;         // largest that steps had to put right, summed, relative
    double iterations = 0;          // of the pressure a step
};

//- Settings that all scenes share: n cells a side, double, no viscosity
PicConfig picSettings(int n);

//- Taylor-Green vortices in a periodic square without viscosity, to t = `turns` of U/L: steady, all
//  energy stays
PicOutcome vortices(PicConfig, double turns);

//- Water half as deep as wide in a closed square tank under half a cosine of 5 % of its width, for
//  `periods`
PicOutcome sloshing(const PicConfig&, double periods);

//- A pool of depth `level` cells on the floor of a square tank, or on a solid whose top lies at
//  `floor` cells (0: none), for half a second
PicOutcome pool(PicConfig, double level, double floor);

} // namespace riprap
