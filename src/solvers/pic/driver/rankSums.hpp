/*  Sums over the cells of a scene on several ranks. By rank: each adds up its brick's. Or, where
    each solves for the pressure of the whole grid, in the order of one process: of fields that
    ranks have gathered, over all ranks' rows in their order, by the kernel of one process, so that
    the bits are the same.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

//- Over the cells of rows that are in the brick
template<int D, class F>
struct SumOfBrick
{
    static constexpr const char* name = F::name;
    SumRows<D, F> of;
    CellBox brick;

    HD void add(int i, double* sums) const
    {
        typename UniformGrid<D>::Index c = of.list[i/CellRows<D>::length];
        c.c[0] += i % CellRows<D>::length;
        for (int d = 0; d < D; ++d) c.c[d] += of.grid.first[d];
        if (brick.has(c.c)) of.add(i, sums);
    }
};

//- Over all cells of the brick
template<int D, class F>
struct SumOfAllBrick
{
    static constexpr const char* name = F::name;
    UniformGrid<D> grid;
    F f;
    CellBox brick;

    HD void add(int i, double* sums) const
    {
        typename UniformGrid<D>::Index c = grid.cellIndex(i);
        for (int d = 0; d < D; ++d) c.c[d] += grid.first[d];
        if (brick.has(c.c)) f.add(i, sums);
    }
};

//- The same bits on all ranks; whole numbers are exact
template<int N, class Backend, int D, class P, class F>
std::array<double, N> sumByRank(PicParts<Backend, D, P>& p, const F& f)
{
    Context<Backend>& context = p.set.context;
    const UniformGrid<D>& grid = p.set.grid;
    const CellBox& brick = p.set.bricks->brick();
    std::array<double, N> all;
    if (p.rows.found())
        all = sumOver<N>(context, p.rows.count()*CellRows<D>::length,
            SumOfBrick<D, F>{{grid, p.rows.list(), f}, brick});
    else all = sumOver<N>(context, grid.cells(), SumOfAllBrick<D, F>{grid, f, brick});
    std::vector<double> sums(all.begin(), all.end());
    addByRank(p.halo->ranks(), sums);
    std::copy(sums.begin(), sums.end(), all.begin());
    return all;
}

//- First cells of the rows of all ranks, in the block and the order of one process
template<class Backend, int D, class P>
std::vector<Vec<3, int>> rowsOfAll(PicParts<Backend, D, P>& p)
{
    const UniformGrid<D>& whole = p.set.whole();
    std::vector<Vec<3, int>> rows(p.rows.count());
    p.set.context.toHost(rows.data(), p.rows.list(), rows.size()*sizeof(rows[0]));
    std::vector<std::int64_t> own;
    for (Vec<3, int>& row : rows)
    {
        for (int d = 0; d < D; ++d) row.c[d] += p.set.grid.first[d];
        if (p.set.bricks->brick().has(row.c)) own.push_back(whole.cell(row));
    }
    join(p.halo->ranks(), own);
    std::sort(own.begin(), own.end());
    rows.clear();
    for (const std::int64_t cell : own) rows.push_back(whole.cellIndex(int(cell)));
    return rows;
}

//- f: of the whole block's fields
template<int N, class Backend, int D, class P, class F>
std::array<double, N> sumInOrder(PicParts<Backend, D, P>& p, const F& f)
{
    Context<Backend>& context = p.set.context;
    if (!p.rows.found()) return sumOver<N>(context, p.set.whole().cells(), f);
    Array<Backend, Vec<3, int>> rows;
    rows.upload(context, rowsOfAll(p));
    return sumOver<N>(context, int(rows.size())*CellRows<D>::length,
        SumRows<D, F>{p.set.whole(), rows.data(), f});
}

} // namespace riprap
