/*  Work of walls that move on the water, of the pressure alone: over a kick dt
        W = dt sum_cells p sum_faces (flux of the walls into the cell),
    with the fluxes (1 - a) w of what walls close of faces, as the pressure's equation has them
    (pic/grid/pressureFields.hpp): what the pressure gives to the velocities of faces it takes from
    these fluxes and from the surface, where it is 0.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/macros.hpp"
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

template<int D, class R>
struct WallWork
{
    static constexpr const char* name = "wallWork";
    UniformGrid<D> grid;
    const int* wet;
    const double* p;
    const R* flux[D];           // faces: of the walls [m/s]

    //- Of cell i, for an area of 1 and a second
    HD void add(int i, double* sums) const
    {
        if (!wet[i]) return;
        const auto c = grid.cellIndex(i);
        double out = 0;
        for (int d = 0; d < D; ++d)
            out += double(flux[d][grid.faceOf(d, c, 1)]) - double(flux[d][grid.faceOf(d, c, 0)]);
        sums[0] -= p[i]*out;
    }
};

} // namespace riprap
