/*  Passes over the active tiles of a level row by row, on the CPU: a row of 32 cells is a few
    registers, and no cell has to find where it is.

    A pass that can be done so has row(first cell), or addRow(first cell, sums). Rows whose ends are
    neighbours (rings) are not done so. Sums of a row have a fixed order of their own: they differ
    from those cell by cell by round-off.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/rows.hpp"
#include "pic/pressure/gridShape.hpp"

namespace riprap
{

//- Of tiles, in 2D and 3D
static constexpr int rowCells = 1 << tileLog<2>(0);
static_assert(tileLog<3>(0) == tileLog<2>(0), "rows are as long in 3D as in 2D");

struct RowSum
{
    double part[rowCells];

    HD double total()
    {
        for (int half = rowCells/2; half > 0; half /= 2)
        {
            INDEPENDENT
            for (int k = 0; k < half; ++k) part[k] += part[k + half];
        }
        return part[0];
    }
};

template<int D, class F>
struct RowsOf
{
    static constexpr const char* name = F::name;
    F f;

    HD void operator()(int i) const
    {
        Place<D> p;
        if (f.cells.row(i, p)) f.row(p);
    }
};

template<int D, class F>
struct SumsOfRows
{
    static constexpr const char* name = F::name;
    F f;

    HD void add(int i, double* sums) const
    {
        Place<D> p;
        if (f.cells.row(i, p)) f.addRow(p, sums);
    }
};

//- f over the cells of active tiles, as launches on a GPU are
template<class Backend, int D, class F>
void eachOfTiles(Context<Backend>& context, [[maybe_unused]] bool byRows, const F& f)
{
    if constexpr (!Backend::gpu)
        if (byRows)
        {
            forEachRow(context, f.cells.rows(), RowsOf<D, F>{f});
            return;
        }
    forEach(context, f.cells.all(), f);
}

template<int N, class Backend, int D, class F, class G>
void sumOfTiles(Context<Backend>& context, [[maybe_unused]] bool byRows, const F& f,
    double* partial, const G& finish)
{
    if constexpr (!Backend::gpu)
        if (byRows)
        {
            sumRowsThen<N>(context, f.cells.rows(), SumsOfRows<D, F>{f}, partial, finish);
            return;
        }
    sumThen<N>(context, f.cells.all(), f, partial, finish);
}

//- The rows of tiles of a level: f(place of each stored cell)
template<int D, class F>
struct InTiles
{
    static constexpr const char* name = F::name;
    static constexpr int rowsLog = tileCellsLog - tileLog<D>(0);
    GridShape<D> shape;
    const int* tiles;
    F f;

    HD void operator()(int i) const
    {
        Place<D> p = rowOfTile(shape, tiles[i >> rowsLog], i & ((1 << rowsLog) - 1));
        for (int k = 0; k < rowCells; ++k, ++p.c, ++p.x[0]) f.cell(p);
    }
};

} // namespace riprap
