/*  The experiments of picStability; rows are printed as they come, and as CSV.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <fstream>
#include <string>
#include "scenes.hpp"

namespace riprap
{

class PicRows
{
public:
    explicit PicRows(const std::string& csv);
    void add(const std::string& test, const std::string& kind, double setting, const std::string& quantity, double measured);

private:
    std::ofstream csv_;
};

//- Largest Courant number, by bisection, up to the 2 that a scene takes, at which the energy of vortices does not grow by more than 5 %
void step(PicRows&);

//- Noise, energy and error of vortices after 4 turns over the blend
void blend(PicRows&);

//- The same over the number of particles a cell
void particles(PicRows&);

//- What steps of a sloshing tank lose or gain of volume over the tolerance of the pressure
void tolerance(PicRows&);

//- Largest speed in pools whose surface, or whose floor, lies anywhere in a cell: theta and apertures from 0 to 1
void levels(PicRows&);

} // namespace riprap
