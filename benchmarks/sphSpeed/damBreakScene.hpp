/*  The scene that is timed: a column of water 1 m wide, 2 m high and (3D) 1 m deep at the left end
    of a tank 4 m long, 2.5 m high and as deep as the column, open at the top. Fluid on a cubic
    lattice; walls are lattice layers of the same spacing, as many as the kernel's support needs.

    Unless it starts at rest, the column moves as u = k (x, -y, 0), k = 2/s: free of divergence,
    along the floor and the left wall, 2 m/s at the front and 4 m/s at the top. So particles move
    past one another, and neighbours are sought anew as often as in a dam break under way, after a
    few hundred steps instead of thousands.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "speedOptions.hpp"

namespace riprap
{

struct DamBreakScene
{
    SphConfig config;
    FluidInput fluid;
    WallInput walls;
};

DamBreakScene makeDamBreak(const SpeedOptions&, double particles);

} // namespace riprap
