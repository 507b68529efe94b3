/*  The collapse of a granular column from a settled bed of 50,000 spheres, replicated along its
    periodic axis: d = 10 mm, 2500 kg/m3,
    E = 1e7 Pa, nu = 0.25, e = 0.7, mu = 0.5, Hertz-Mindlin with history, dt = 2e-5 s; y periodic
    over 30 d for each copy; walls x = 0 and z = 0 of the same law; x free. The same case runs in
    LAMMPS and LIGGGHTS. Beds of unequal spheres have a fourth column, their radii; the step is in
    proportion to the smallest.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <string>
#include "api/demScene.hpp"

namespace riprap
{

struct ColumnOptions
{
    int copies = 1;
    bool rolling = false;       // elastic-plastic rolling friction as well
    // radii between r/ratio and r, evenly by logarithm: the bed is loose then, and has to settle
    double sizeRatio = 1;
    bool triangles = false;     // walls of triangles instead of planes
    bool held = false;          // a wall before the bed: it stays as it is
};

//- A block of side^3 spheres on a cubic lattice, each bonded to its six neighbours (parallel bonds,
//  no breakage), that is let go where it has been stretched by a wave of half its length: bonds
//  work, nothing touches
void bondedScene(int side, DemConfig&, DemInput&);

void columnScene(const std::string& bed, const ColumnOptions&, DemConfig&, DemInput&);

//- The spheres of the first copy as a bed of four columns, gzipped
void writeBed(const std::string& file, const DemState&, int copies);

} // namespace riprap
