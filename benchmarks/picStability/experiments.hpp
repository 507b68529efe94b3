/*  The experiments of picStability.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "picRows.hpp"
#include "scenes.hpp"

namespace riprap
{

//- Largest Courant number, by bisection, up to the 2 that a scene takes, at which the energy of
//  vortices does not grow by more than 5 %
void step(PicRows&);

//- Noise, energy and error of vortices after 4 turns over the blend
void blend(PicRows&);

//- The same over the number of particles a cell
void particles(PicRows&);

//- What steps of a sloshing tank lose or gain of volume over the tolerance of the pressure
void tolerance(PicRows&);

//- Largest speed in pools whose surface, or whose floor, lies anywhere in a cell: theta and
//  apertures from 0 to 1
void levels(PicRows&);

} // namespace riprap
