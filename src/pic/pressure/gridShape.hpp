/*  How a level of the multigrid lies in memory, and which of its cells a pass visits.

    Cells are stored x first, each side padded to whole tiles; arrays have a margin of one plane at
    both ends, so that the neighbours of any cell can be read. What lies beyond the grid has no
    coefficients. Passes visit active tiles only: those with an unknown in them. Cells are red or
    black as the sum of their indices is even or odd.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include "core/loops/rows.hpp"

namespace riprap
{

//- log2 of the sides of a tile of 512 cells: rows of 32, so that a warp reads one line of memory
template<int D> HD constexpr int tileLog(int d) { return d == 0 ? 5 : (D == 2 ? 4 : 2); }
static constexpr int tileCellsLog = 9;

//- A cell: its number and its indices
template<int D>
struct Place
{
    int c;
    int x[D];
};

template<int D>
struct GridShape
{
    int n[D];               // cells of the grid
    int size[D];            // cells stored
    int stride[D];
    // from the first cell along d to the one below it, from the last to the one above: around if
    // periodic
    int first[D], last[D];
    int tiles[D];
    int tileCount, cells, margin;

    //- tiled: else sides are only even, as half() of dense passes needs them
    void set(const int* cellsAlong, const bool* periodic, bool tiled)
    {
        cells = tileCount = 1;
        for (int d = 0; d < D; ++d)
        {
            const int side = tiled ? 1 << tileLog<D>(d) : 2;
            n[d] = cellsAlong[d];
            tiles[d] = (n[d] + side - 1)/side;
            size[d] = tiles[d]*side;
            stride[d] = cells;
            first[d] = periodic[d] ? (n[d] - 1)*stride[d] : -stride[d];
            last[d] = -first[d];
            cells *= size[d];
            tileCount *= tiles[d];
        }
        margin = stride[D - 1];
    }

    //- The same level apart from its neighbours in memory: one cell more between rows, and between
    //  planes a row more, which nobody writes. What lies beside the grid, or beyond the cut of an
    //  odd ring, is one of them
    HD GridShape<D> spaced() const
    {
        GridShape<D> s(*this);
        int next = 1;
        for (int d = 0; d < D; ++d)
        {
            s.stride[d] = next;
            next *= d < D - 1 ? size[d] + 1 : size[d];
            const bool ring = first[d] > 0 && n[d] % 2 == 0;
            s.first[d] = ring ? (n[d] - 1)*s.stride[d] : -s.stride[d];
            s.last[d] = -s.first[d];
        }
        s.cells = next;
        s.margin = s.stride[D - 1];
        return s;
    }

    //- Are the ends of rows along the first axis neighbours, which they are not in memory?
    HD bool ringRows() const { return first[0] > 0; }

    HD int below(const Place<D>& p, int d) const
    {
        return p.c + (p.x[d] == 0 ? first[d] : -stride[d]);
    }
    HD int above(const Place<D>& p, int d) const
    {
        return p.c + (p.x[d] == n[d] - 1 ? last[d] : stride[d]);
    }

    //- Place i of all that are stored
    HD Place<D> place(int i) const
    {
        Place<D> p;
        p.c = i;
        for (int d = 0; d < D - 1; ++d) { p.x[d] = i % size[d]; i /= size[d]; }
        p.x[D - 1] = i;
        return p;
    }

    HD bool inside(const Place<D>& p) const
    {
        bool in = true;
        for (int d = 0; d < D; ++d) in = in && p.x[d] < n[d];
        return in;
    }

    HD int tileOf(const Place<D>& p) const
    {
        int t = 0;
        for (int d = D - 1; d >= 0; --d) t = t*tiles[d] + (p.x[d] >> tileLog<D>(d));
        return t;
    }
};

//- The first cell of a row of tile t
template<int D>
HD Place<D> rowOfTile(const GridShape<D>& shape, int t, int row)
{
    Place<D> p;
    p.c = 0;
    for (int d = 0; d < D; ++d)
    {
        p.x[d] = (d == D - 1 ? t : t % shape.tiles[d]) << tileLog<D>(d);
        t /= shape.tiles[d];
        if (d > 0)
        {
            p.x[d] += row & ((1 << tileLog<D>(d)) - 1);
            row >>= tileLog<D>(d);
        }
        p.c += p.x[d]*shape.stride[d];
    }
    return p;
}

//- From a cell of a row along the first axis to its neighbours: the same for all of the row, unless
//  the row is a ring
template<int D>
struct RowNeighbours
{
    int below[D], above[D];

    HD RowNeighbours(const GridShape<D>& shape, const Place<D>& p)
    {
        below[0] = -1;
        above[0] = 1;
        for (int d = 1; d < D; ++d)
        {
            below[d] = shape.below(p, d) - p.c;
            above[d] = shape.above(p, d) - p.c;
        }
    }
};

//- Where a tile begins
template<int D> using TileOrigin = Place<D>;

//- Cells of active tiles. A pass is launched over capacity tiles, of which *count exist
template<int D>
struct TiledCells
{
    const TileOrigin<D>* list;
    const int* count;
    int capacity;
    int stride[D];

    HD int all() const { return capacity << tileCellsLog; }
    HD int halves() const { return capacity << (tileCellsLog - 1); }

    HD bool at(int i, Place<D>& p) const { return find(i, tileCellsLog, 0, p); }

    //- Rows along the first axis, of so many cells
    static constexpr int rowCells = 1 << tileLog<D>(0);
    HD int rows() const { return capacity << (tileCellsLog - tileLog<D>(0)); }

    HD int rowLength() const { return rowCells; }

    //- The first cell of row i
    HD bool row(int i, Place<D>& p) const { return at(i << tileLog<D>(0), p); }

    //- Cell i of one colour (0: red, 1: black)
    HD bool half(int i, int colour, Place<D>& p) const
    {
        if (!find(i, tileCellsLog - 1, 1, p)) return false;
        int sum = colour;
        for (int d = 1; d < D; ++d) sum += p.x[d];
        p.x[0] += sum & 1;
        p.c += sum & 1;
        return true;
    }

private:

    HD bool find(int i, int log, int halved, Place<D>& p) const
    {
        const int tile = i >> log;
        if (tile >= *count) return false;
        p = list[tile];
        int lane = i & ((1 << log) - 1);
        for (int d = 0; d < D; ++d)
        {
            const int bits = tileLog<D>(d) - (d == 0 ? halved : 0);
            int x = lane & ((1 << bits) - 1);
            lane >>= bits;
            if (d == 0) x <<= halved;
            p.x[d] += x;
            p.c += x*stride[d];
        }
        return true;
    }
};

//- All cells of a small level
template<int D>
struct DenseCells
{
    static constexpr int most = 1 << 15;        // cells: quotients are exact
    int cells = 1;

    explicit HD DenseCells(const GridShape<D>& shape)
    {
        for (int d = 0; d < D; ++d)
        {
            size_[d] = shape.size[d];
            stride_[d] = shape.stride[d];
            cells *= size_[d];
            if (d < D - 1) inverse_[d] = 0xffffffffu/unsigned(size_[d]) + 1;
        }
    }

    HD int all() const { return cells; }
    HD int halves() const { return cells/2; }
    HD int rows() const { return cells/size_[0]; }
    HD int rowLength() const { return size_[0]; }
    HD bool row(int i, Place<D>& p) const { return at(i*size_[0], p); }

    HD bool at(int i, Place<D>& p) const
    {
        p.c = 0;
        for (int d = 0; d < D - 1; ++d)
        {
            const int quotient = size_[d] == 1
                ? i
                : int(std::uint64_t(unsigned(i))*inverse_[d] >> 32);
            p.x[d] = i - quotient*size_[d];
            p.c += p.x[d]*stride_[d];
            i = quotient;
        }
        p.x[D - 1] = i;
        p.c += i*stride_[D - 1];
        return true;
    }

    HD bool half(int i, int colour, Place<D>& p) const
    {
        at(2*i, p);
        int sum = colour;
        for (int d = 1; d < D; ++d) sum += p.x[d];
        p.x[0] += sum & 1;
        p.c += sum & 1;
        return true;
    }

private:
    int size_[D], stride_[D];
    unsigned inverse_[D];       // 2^32 over size, rounded up: a product instead of a division
};

} // namespace riprap
