/*  One level of the multigrid, in single precision, and its smoother.

        (A x)_c = sum over the neighbours n of a_cn (x_c - x_n)  +  s_c x_c

    a stands at the lower face of a cell along each direction, s is what ties the cell to p = 0 (surface, open ends). Differences
    before products: constants are exactly without force, however many faces a cell has. inverse = 1/(sum a + s), 0 where there
    is no unknown. Gauss-Seidel in two colours: a sweep of one colour reads the other alone, and may run in any order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/pressure/gridShape.hpp"

namespace riprap
{

template<int D>
struct LevelData
{
    GridShape<D> shape;
    float* a[D];
    float* s;
    float* inverse;
    float* x;
    float* b;

    HD float neighbourSum(const Place<D>& p) const
    {
        float sum = 0;
        for (int d = 0; d < D; ++d)
        {
            const int below = shape.below(p, d), above = shape.above(p, d);
            sum += a[d][p.c]*x[below] + a[d][above]*x[above];
        }
        return sum;
    }

    HD float residual(const Place<D>& p) const
    {
        float sum = 0;
        for (int d = 0; d < D; ++d)
        {
            const int below = shape.below(p, d), above = shape.above(p, d);
            sum += a[d][p.c]*(x[p.c] - x[below]) + a[d][above]*(x[p.c] - x[above]);
        }
        return b[p.c] - sum - s[p.c]*x[p.c];
    }
};

//- The sweep of a colour when all x are zero; those of the other colour are not read, and need not be zero in memory
template<int D, class Cells>
struct FirstSweep
{
    static constexpr const char* name = "pressureFirstSweep";
    LevelData<D> level;
    Cells cells;

    HD void operator()(int i) const
    {
        Place<D> p;
        if (!cells.half(i, 0, p)) return;
        const float inverse = level.inverse[p.c];
        if (inverse > 0) level.x[p.c] = level.b[p.c]*inverse;
    }
};

template<int D, class Cells>
struct Sweep
{
    static constexpr const char* name = "pressureSweep";
    using Start = Place<D>;
    LevelData<D> level;
    Cells cells;
    int colour;

    HD void operator()(int i) const
    {
        Place<D> p;
        if (!cells.half(i, colour, p)) return;
        relax(p);
    }

    HD void relax(const Place<D>& p) const
    {
        const float inverse = level.inverse[p.c];
        if (inverse > 0) level.x[p.c] = (level.b[p.c] + level.neighbourSum(p))*inverse;
    }

    //- The colour's cells of a row that begins at p: no cell has to find where it is
    HD void row(Place<D> p) const
    {
        const GridShape<D>& shape = level.shape;
        int odd = colour;
        for (int d = 1; d < D; ++d) odd += p.x[d];
        odd &= 1;
        if (shape.first[0] > 0)         // a ring: its ends are no neighbours in memory
        {
            p.x[0] += odd;
            p.c += odd;
            for (int k = odd; k < Cells::rowCells; k += 2, p.x[0] += 2, p.c += 2) relax(p);
            return;
        }
        int below[D], above[D];
        for (int d = 0; d < D; ++d)
        {
            below[d] = d == 0 ? -1 : shape.below(p, d) - p.c;
            above[d] = d == 0 ? 1 : shape.above(p, d) - p.c;
        }
        for (int c = p.c + odd; c < p.c + Cells::rowCells; c += 2)
        {
            const float inverse = level.inverse[c];
            if (!(inverse > 0)) continue;
            float sum = 0;
            for (int d = 0; d < D; ++d) sum += level.a[d][c]*level.x[c + below[d]] + level.a[d][c + above[d]]*level.x[c + above[d]];
            level.x[c] = (level.b[c] + sum)*inverse;
        }
    }
};

//- A pass on the CPU, row by row
template<class F>
struct RowsOf
{
    static constexpr const char* name = F::name;
    F f;

    HD void operator()(int i) const
    {
        typename F::Start p;
        if (f.cells.row(i, p)) f.row(p);
    }
};

} // namespace riprap
