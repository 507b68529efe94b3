/*  The way of a point from cell to cell, up to a face that it must not pass.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

//- The way from cell c to `to` up to the first face that `closed(direction, face)` names: the point
//  stays `margin` before it. Faces on the sides of the block are left to others. \return the
//  directions in which it was stopped, as bits: 1 << 2d below, 2 << 2d above
template<int D, class F>
HD int stopAtFaces(const UniformGrid<D>& grid, typename UniformGrid<D>::Index c, Vec<D, double>& to,
    double margin, const F& closed)
{
    int stopped = 0;
    for (int d = 0; d < D; ++d)
    {
        const int before = grid.part ? grid.first[d] : 0;
        int target = floorInt(to.c[d]/grid.h) - before;
        target = target < 0 ? 0 : (target >= grid.n[d] ? grid.n[d] - 1 : target);
        while (c.c[d] != target)
        {
            const bool up = target > c.c[d];
            typename UniformGrid<D>::Index f = c;
            if (up) f.c[d] += 1;
            if (closed(d, grid.face(d, f)))
            {
                const int number = before + f.c[d];
                to.c[d] = number*grid.h + (up ? -margin : margin);
                stopped |= (up ? 2 : 1) << 2*d;
                break;
            }
            c.c[d] += up ? 1 : -1;
        }
    }
    return stopped;
}

} // namespace riprap
