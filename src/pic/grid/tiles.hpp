/*  Tiles of 64 cells, and which of them have particles.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellSort.hpp"
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

template<int D>
struct CellTiles
{
    static constexpr int side = D == 3 ? 4 : 8, cells = 64;
    int n[3] = {1, 1, 1};

    CellTiles() = default;
    explicit CellTiles(const UniformGrid<D>& g)
    {
        for (int d = 0; d < D; ++d) n[d] = (g.n[d] + side - 1)/side;
    }

    HD int count() const { return n[0]*n[1]*n[2]; }

    //- The first cell of tile t
    HD typename UniformGrid<D>::Index first(int t) const
    {
        typename UniformGrid<D>::Index c{{t % n[0]*side, t/n[0] % n[1]*side, 0}};
        if constexpr (D == 3) c.c[2] = t/(n[0]*n[1])*side;
        return c;
    }

    //- The tile of a cell
    HD int of(const typename UniformGrid<D>::Index& c) const
    {
        const int row = n[0]*(c.c[1]/side);
        if constexpr (D == 3) return c.c[0]/side + row + n[0]*n[1]*(c.c[2]/side);
        else return c.c[0]/side + row;
    }
};

//- Cells of tiles in one state; of all tiles if there are no states
template<int D>
struct TileChoice
{
    const unsigned char* state;     // of tiles; nullptr: there are none
    CellTiles<D> tiles;
    unsigned char wanted;

    HD bool has(const typename UniformGrid<D>::Index& c) const
    {
        return !state || state[tiles.of(c)] == wanted;
    }
};

//- f(first cell, one past the last) of the rows of a tile
template<int D, class F>
HD void eachRowOf(const UniformGrid<D>& grid, const CellTiles<D>& tiles, int t, const F& f)
{
    const typename UniformGrid<D>::Index first = tiles.first(t);
    int end[3] = {1, 1, 1};
    for (int d = 0; d < D; ++d)
        end[d] = first.c[d] + tiles.side < grid.n[d] ? first.c[d] + tiles.side : grid.n[d];
    for (int k = first.c[2]; k < end[2]; ++k)
        for (int j = first.c[1]; j < end[1]; ++j)
            f(typename UniformGrid<D>::Index{{first.c[0], j, k}}, end[0]);
}

//- start: where particles of each cell begin
template<int D>
HD int particlesOf(
    const UniformGrid<D>& grid, const CellTiles<D>& tiles, int t, const int* start)
{
    int count = 0;
    eachRowOf(grid, tiles, t, [&](const typename UniformGrid<D>::Index& c, int end)
    {
        const int cell = grid.cell(c);
        count += start[cell + end - c.c[0]] - start[cell];
    });
    return count;
}

//- 1 for each tile that has particles
template<int D>
struct HasParticles
{
    static constexpr const char* name = "hasParticles";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* start;           // of the cells' particles
    int* flag;                  // tiles + 1

    HD void operator()(int t) const
    {
        flag[t] = t < tiles.count() && particlesOf(grid, tiles, t, start) > 0;
    }
};

//- Tiles that have particles, in order, and each one's place among them; -1: it has none
struct ListOccupied
{
    static constexpr const char* name = "listOccupied";
    const int* before;          // flags, summed up
    int* place;
    int* list;

    HD void operator()(int t) const
    {
        const bool occupied = before[t + 1] > before[t];
        place[t] = occupied ? before[t] : -1;
        if (occupied) list[before[t]] = t;
    }
};

template<class Backend, int D>
class OccupiedTiles
{
public:

    //- sort: of the particles
    void find(Context<Backend>& context, const UniformGrid<D>& grid, CellSort<Backend>& sort)
    {
        tiles_ = CellTiles<D>(grid);
        const int n = tiles_.count();
        flag_.allocate(context, std::size_t(n) + 1);
        for (auto* a : {&place_, &list_}) a->allocate(context, n);
        forEach(context, n + 1, HasParticles<D>{grid, tiles_, sort.start(), flag_.data()});
        sort.scan(context, flag_.data(), n + 1);
        forEach(context, n, ListOccupied{flag_.data(), place_.data(), list_.data()});
        context.toHost(&count_, flag_.data() + n, sizeof(int));
    }

    const CellTiles<D>& tiles() const { return tiles_; }
    int count() const { return count_; }
    const int* list() const { return list_.data(); }
    const int* place() const { return place_.data(); }
    std::size_t bytes() const { return flag_.bytes() + place_.bytes() + list_.bytes(); }

private:
    CellTiles<D> tiles_;
    Array<Backend, int> flag_, place_, list_;
    int count_ = 0;
};

//- Some tiles
template<int D>
struct TileList
{
    CellTiles<D> tiles;
    const int* list;
    int count;

    TileList(const CellTiles<D>& of, const int* tileList, int tileCount)
        : tiles(of), list(tileList), count(tileCount)
    {}
    template<class Backend> TileList(const OccupiedTiles<Backend, D>& all)
        : tiles(all.tiles()), list(all.list()), count(all.count())
    {}
};

} // namespace riprap
