/*  Where there is something to do about the water: rows of 32 cells that have water or particles within `reach` cells.

    Passes over these alone cost what the water costs, whatever the box around it. Found by tiles, hence somewhat generous.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/tiles.hpp"

namespace riprap
{

//- 1 for each tile that has particles or a wet cell
template<int D>
struct HasWater
{
    static constexpr const char* name = "hasWater";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* place;           // of tiles that have particles; -1: none
    const unsigned char* wet;
    unsigned char* has;

    HD void operator()(int t) const
    {
        bool found = place[t] >= 0;
        const typename UniformGrid<D>::Index first = tiles.first(t);
        for (int k = 0; k < tiles.cells && !found; ++k)
        {
            typename UniformGrid<D>::Index c = first;
            c.c[0] += k % tiles.side;
            c.c[1] += k/tiles.side % tiles.side;
            if constexpr (D == 3) c.c[2] += k/(tiles.side*tiles.side);
            bool in = true;
            for (int d = 0; d < D; ++d) in = in && c.c[d] < grid.n[d];
            found = in && wet[grid.cell(c)];
        }
        has[t] = found;
    }
};

//- 1 for each tile that has one of those about it
template<int D>
struct IsNearWater
{
    static constexpr const char* name = "isNearWater";
    CellTiles<D> tiles;
    bool periodic[D];
    const unsigned char* has;
    unsigned char* near;
    int reach;                  // in tiles

    HD void operator()(int t) const
    {
        const int at[3] = {t % tiles.n[0], t/tiles.n[0] % tiles.n[1], t/(tiles.n[0]*tiles.n[1])};
        bool found = false;
        for (int k = (D == 3 ? -reach : 0); k <= (D == 3 ? reach : 0) && !found; ++k)
            for (int j = -reach; j <= reach && !found; ++j)
                for (int i = -reach; i <= reach; ++i)
                {
                    int c[3] = {at[0] + i, at[1] + j, at[2] + k};
                    bool exists = true;
                    for (int d = 0; d < D; ++d)
                    {
                        const int n = tiles.n[d];
                        if (periodic[d]) c[d] = (c[d] + reach*n) % n;
                        exists = exists && c[d] >= 0 && c[d] < n;
                    }
                    found = found || (exists && has[c[0] + tiles.n[0]*(c[1] + tiles.n[1]*c[2])]);
                }
        near[t] = found;
    }
};

//- Cell rows of 32, one after the other along the first axis
template<int D>
struct CellRows
{
    static constexpr int length = 32;
    int n[3] = {1, 1, 1};       // rows along each axis

    CellRows() = default;
    explicit CellRows(const UniformGrid<D>& g)
    {
        for (int d = 0; d < D; ++d) n[d] = g.n[d];
        n[0] = (g.n[0] + length - 1)/length;
    }

    HD int count() const { return n[0]*n[1]*n[2]; }

    HD typename UniformGrid<D>::Index first(int r) const
    { return {{r % n[0]*length, r/n[0] % n[1], r/(n[0]*n[1])}}; }
};

template<int D>
struct FlagRows
{
    static constexpr const char* name = "flagRows";
    CellTiles<D> tiles;
    CellRows<D> rows;
    const unsigned char* near;  // tiles
    int* flag;                  // rows + 1

    HD void operator()(int r) const
    {
        flag[r] = 0;
        if (r == rows.count()) return;
        const typename UniformGrid<D>::Index c = rows.first(r);
        const int row = tiles.n[0]*(c.c[1]/tiles.side + (D == 3 ? tiles.n[1]*(c.c[2]/tiles.side) : 0)), from = c.c[0]/tiles.side;
        for (int i = from; i < from + rows.length/tiles.side && i < tiles.n[0]; ++i) if (near[row + i]) flag[r] = 1;
    }
};

template<int D>
struct ListRows
{
    static constexpr const char* name = "listRows";
    CellRows<D> rows;
    const int* before;          // flags, summed up
    Vec<3, int>* list;          // first cells

    HD void operator()(int r) const { if (before[r + 1] > before[r]) list[before[r]] = rows.first(r); }
};

//- f(cell's indices) for the cells of listed rows
template<int D, class F>
struct OverRows
{
    static constexpr const char* name = F::name;
    const Vec<3, int>* list;
    int n;                      // cells along the first axis
    F f;

    HD void operator()(int i) const
    {
        typename UniformGrid<D>::Index c = list[i/CellRows<D>::length];
        c.c[0] += i % CellRows<D>::length;
        if (c.c[0] < n) f(c);
    }
};

//- f[d](number of the face) for the faces below a cell along each axis d; at the end of the block those above it, too
template<int D, class F>
struct OverFaces
{
    static constexpr const char* name = F::name;
    UniformGrid<D> grid;
    F f[D];

    HD void operator()(const typename UniformGrid<D>::Index& c) const
    {
        for (int d = 0; d < D; ++d)
        {
            f[d](grid.faceOf(d, c, 0));
            if (c.c[d] == grid.n[d] - 1) f[d](grid.faceOf(d, c, 1));
        }
    }
};

template<class Backend, int D>
class ActiveRows
{
public:
    static constexpr int reach = 8;             // cells

    //- particles: tiles that have any. sort: whose scratch is used
    void find(Context<Backend>& context, const UniformGrid<D>& grid, const OccupiedTiles<Backend, D>& particles, const unsigned char* wet, CellSort<Backend>& sort)
    {
        const CellTiles<D>& tiles = particles.tiles();
        const CellRows<D> rows(grid);
        const int n = rows.count();
        for (auto* a : {&has_, &near_}) a->allocate(context, tiles.count());
        flag_.allocate(context, std::size_t(n) + 1);
        list_.allocate(context, n);
        forEach(context, tiles.count(), HasWater<D>{grid, tiles, particles.place(), wet, has_.data()});
        IsNearWater<D> near{tiles, {}, has_.data(), near_.data(), reach/tiles.side};
        for (int d = 0; d < D; ++d) near.periodic[d] = grid.periodic[d];
        for (int d = 0; d < D; ++d) if (grid.periodic[d]) near.reach = reach/tiles.side + 1;     // the last tile of a ring may be a short one
        forEach(context, tiles.count(), near);
        forEach(context, n + 1, FlagRows<D>{tiles, rows, near_.data(), flag_.data()});
        sort.scan(context, flag_.data(), n + 1);
        forEach(context, n, ListRows<D>{rows, flag_.data(), list_.data()});
        context.toHost(&count_, flag_.data() + n, sizeof(int));
        cells_ = grid.n[0];
    }

    //- f(indices) for each cell of theirs
    template<class F>
    void each(Context<Backend>& context, const F& f) const
    { forEach(context, count_*CellRows<D>::length, OverRows<D, F>{list_.data(), cells_, f}); }

    //- make(d): what is done with the number of each face of direction d that belongs to them
    template<class Make>
    void eachFace(Context<Backend>& context, const UniformGrid<D>& grid, const Make& make) const
    {
        using F = decltype(make(0));
        if constexpr (D == 2) each(context, OverFaces<D, F>{grid, {make(0), make(1)}});
        else each(context, OverFaces<D, F>{grid, {make(0), make(1), make(2)}});
    }

    std::size_t bytes() const { return has_.bytes() + near_.bytes() + flag_.bytes() + list_.bytes(); }

private:
    Array<Backend, unsigned char> has_, near_;  // tiles
    Array<Backend, int> flag_;
    Array<Backend, Vec<3, int>> list_;
    int count_ = 0, cells_ = 0;
};

} // namespace riprap
