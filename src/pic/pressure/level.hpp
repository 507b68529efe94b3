/*  One level of the multigrid, in single precision, and its smoother.

        (A x)_c = sum over the neighbours n of a_cn (x_c - x_n)  +  s_c x_c

    a stands at the lower face of a cell along each direction, s is what ties the cell to p = 0
    (surface, open ends). Differences before products: constants are exactly without force, however
    many faces a cell has. inverse = 1/(sum a + s), 0 where there is no unknown. Gauss-Seidel in two
    colours: a sweep of one colour reads the other alone, and may run in any order.

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

//- Is the first cell of a row of the other colour (0: red, 1: black)?
template<int D>
HD int oddRow(const Place<D>& p, int colour)
{
    for (int d = 1; d < D; ++d) colour += p.x[d];
    return colour & 1;
}

//- The sweep of a colour when all x are zero; those of the other colour are not read, and need not
//  be zero in memory
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

//- That sweep and the one of black cells after it, row by row: what red cells about a black one
//  become is found on the way. Not for rings
template<int D, class Cells>
struct FirstSweeps
{
    static constexpr const char* name = "pressureFirstSweep";
    static constexpr int length = Cells::rowCells;
    LevelData<D> level;
    Cells cells;

    HD void operator()(int i) const
    {
        Place<D> p;
        if (!cells.row(i, p)) return;
        const RowNeighbours<D> to(level.shape, p);
        const int black = oddRow(p, 1);
        const auto red = [&](int c) { return level.b[c]*level.inverse[c]; };
        float first[length], second[length];
        INDEPENDENT
        for (int k = 0; k < length; ++k)
        {
            const int c = p.c + k;
            float sum = 0;
            for (int d = 0; d < D; ++d)
                sum += level.a[d][c]*red(c + to.below[d])
                    + level.a[d][c + to.above[d]]*red(c + to.above[d]);
            first[k] = red(c);
            second[k] = (level.b[c] + sum)*level.inverse[c];
        }
        INDEPENDENT
        for (int k = 0; k < length; ++k) level.x[p.c + k] = (k & 1) == black ? second[k] : first[k];
    }
};

template<int D, class Cells>
struct Sweep
{
    static constexpr const char* name = "pressureSweep";
    LevelData<D> level;
    Cells cells;
    int colour;

    HD void operator()(int i) const
    {
        Place<D> p;
        if (!cells.half(i, colour, p)) return;
        const float inverse = level.inverse[p.c];
        if (inverse > 0) level.x[p.c] = (level.b[p.c] + level.neighbourSum(p))*inverse;
    }
};

//- The same row by row: registers hold cells of both colours, of which one keeps what it has (and
//  has 0 where there is no unknown). Not for rings
template<int D, class Cells>
struct RowSweep
{
    static constexpr const char* name = "pressureSweep";
    static constexpr int length = Cells::rowCells;
    LevelData<D> level;
    Cells cells;
    int colour;

    HD void operator()(int i) const
    {
        Place<D> p;
        if (!cells.row(i, p)) return;
        const RowNeighbours<D> to(level.shape, p);
        const int odd = oddRow(p, colour);
        float relaxed[length];
        INDEPENDENT
        for (int k = 0; k < length; ++k)
        {
            const int c = p.c + k;
            float sum = 0;
            for (int d = 0; d < D; ++d)
                sum += level.a[d][c]*level.x[c + to.below[d]]
                    + level.a[d][c + to.above[d]]*level.x[c + to.above[d]];
            relaxed[k] = (level.b[c] + sum)*level.inverse[c];
        }
        INDEPENDENT
        for (int k = 0; k < length; ++k)
        {
            const float before = level.x[p.c + k];
            level.x[p.c + k] = (k & 1) == odd ? relaxed[k] : before;
        }
    }
};

} // namespace riprap
