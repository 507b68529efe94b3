/*  Zones that absorb waves: a beach.

    In a zone water loses velocity at the rate r s^2, with s from 0 where the zone begins to 1 where
    it is whole, and 1 beyond:

        u = u0/(1 + dt r s^2)

    implicit, stable for any step. The square lets waves in without a step that would throw them
    back (Israeli & Orszag 1981, J. Comput. Phys. 41, 115). Gravity comes after it: water at rest
    stays so.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

//- Begins at `from` and grows along the line to `to`; planes normal to it are alike
template<int D>
struct AbsorbingZone
{
    Vec<D, double> from, to;    // [m]
    double rate = 0;            // [1/s]

    HD double at(const Vec<D, double>& x) const
    {
        double along = 0, length = 0;
        for (int d = 0; d < D; ++d)
        {
            along += (x.c[d] - from.c[d])*(to.c[d] - from.c[d]);
            length += (to.c[d] - from.c[d])*(to.c[d] - from.c[d]);
        }
        const double s = along <= 0 ? 0.0 : (along >= length ? 1.0 : along/length);
        return rate*s*s;
    }
};

//- Middle of a face of direction d, as everywhere from the world's origin
template<int D>
HD Vec<D, double> faceMiddle(const UniformGrid<D>& grid, int d, int face)
{
    const typename UniformGrid<D>::Index f = grid.faceIndex(d, face);
    Vec<D, double> x;
    for (int e = 0; e < D; ++e)
        x.c[e] = grid.origin[e] + (grid.first[e] + f.c[e] + (e == d ? 0.0 : 0.5))*grid.h;
    return x;
}

} // namespace riprap
