/*  The cell that a point is in, and where in it.

    Particles keep that in the precision of the pairs (PlaceInCell), from one sort to the next:
    differences between neighbours are as exact in single precision wherever in the block they are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

template<int D, class R>
struct InCell
{
    int c[D];
    R t[D];                     // 0 .. 1

    HD InCell() {}
    HD InCell(const UniformGrid<D>& g, const Vec<D, double>& x) : InCell(g, 1/g.h, x) {}

    //- inverse: 1/h
    HD InCell(const UniformGrid<D>& g, double inverse, const Vec<D, double>& x) : InCell(inverse, x)
    {
        if (!g.part) return;
        UNROLL
        for (int a = 0; a < D; ++a) c[a] -= g.first[a];
    }

    //- As numbered in the whole block
    HD InCell(double inverse, const Vec<D, double>& x)
    {
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            const double s = x.c[a]*inverse;
            c[a] = floorInt(s);
            t[a] = R(s - c[a]);
        }
    }

    //- Of a point that lies further by `by` in cells
    HD InCell ahead(const R* v, R by) const
    {
        InCell to;
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            const R s = t[a] + by*v[a];
            const int cells = floorInt(s);
            to.c[a] = c[a] + cells;
            to.t[a] = s - cells;
        }
        return to;
    }

    HD typename UniformGrid<D>::Index index() const
    {
        typename UniformGrid<D>::Index i{{0, 0, 0}};
        for (int a = 0; a < D; ++a) i.c[a] = c[a];
        return i;
    }

    HD int cell(const UniformGrid<D>& g) const { return g.cell(index()); }
};

//- Of a particle; of its cell the index along the first axis of the whole block
template<class R>
struct alignas(16) PlaceInCell
{
    R t[3];
    R cell;
};

} // namespace riprap
