/*  A grid divided over ranks: bricks of whole cells, cut across directions that do not end in
    themselves, by recursive bisection of the water that a run begins with.

    A rank's part of the grid is its brick and what lies around it, as deep as passes between two
    exchanges see. Parts begin and end at whole tiles and rows of the grid, so that passes over them
    visit and add up in the order of one process. Sides of a part that are none of the block are
    ends of memory: what passes make of cells there is replaced by what the owner has.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <stdexcept>
#include <vector>
#include "core/ranks/transport.hpp"
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

//- Cells, or faces, from `low` to before `high`, numbered as in the whole block
struct CellBox
{
    int low[3] = {0, 0, 0}, high[3] = {1, 1, 1};

    bool empty() const { return count() == 0; }
    int count() const
    {
        int n = 1;
        for (int d = 0; d < 3; ++d) n *= high[d] > low[d] ? high[d] - low[d] : 0;
        return n;
    }
    HD bool has(const int* c) const
    {
        bool in = true;
        for (int d = 0; d < 3; ++d) in = in && c[d] >= low[d] && c[d] < high[d];
        return in;
    }
    CellBox with(const CellBox& other) const
    {
        CellBox both;
        for (int d = 0; d < 3; ++d)
        {
            both.low[d] = low[d] > other.low[d] ? low[d] : other.low[d];
            both.high[d] = high[d] < other.high[d] ? high[d] : other.high[d];
        }
        return both;
    }
};

//- There is not a brick for each rank
struct TooManyRanks : std::invalid_argument
{
    using std::invalid_argument::invalid_argument;
};

template<int D>
class GridBricks
{
public:

    //- Bricks are of whole units: along the first axis rows of ActiveRows, along others tiles
    static constexpr int unit(int d) { return d == 0 ? 32 : (d < D ? 8 : 1); }
    //- So many cells around a brick are right after an exchange
    static constexpr int depth = 8;

    //- x: of the water, D a particle, above the block's corner; share: of a cell that one fills.
    //  @throws TooManyRanks
    GridBricks(Transport& ranks, const UniformGrid<D>& whole, const std::vector<double>& x,
        double share);

    Transport& ranks() const { return ranks_; }
    int rank() const { return ranks_.rank(); }
    int size() const { return ranks_.size(); }
    const UniformGrid<D>& whole() const { return whole_; }
    //- Water sticks to a side of the block, which slides
    void stick(int d, int side, const double (&slide)[3])
    {
        whole_.sticks[d][side] = true;
        for (int e = 0; e < D; ++e) whole_.slide[d][side][e] = slide[e];
    }

    const CellBox& brick(int rank) const { return bricks_[rank]; }
    const CellBox& brick() const { return bricks_[rank()]; }
    //- A brick and what is around it
    CellBox part(int rank) const;
    //- The grid of this rank's part
    UniformGrid<D> partGrid() const;
    //- The rank whose brick has a cell of the block
    int owner(const typename UniformGrid<D>::Index& c) const { return ownerOf_[unitOf(c)]; }
    //- Those whose parts have it
    const std::vector<int>& seenBy(const typename UniformGrid<D>::Index& c) const
    {
        return seenBy_[unitOf(c)];
    }

    //- Whether a rank needs the particles of a cell of its part: rows of 32 cells are longer than
    //  it sees
    bool needs(int rank, const typename UniformGrid<D>::Index& c) const
    {
        const CellBox& box = bricks_[rank];
        return c.c[0] >= box.low[0] - around() && c.c[0] < box.high[0] + around();
    }

    //- The faces of direction d that a rank has for others: those below its cells, at the end of
    //  the block those above them, too. Of a part: all about its cells
    CellBox facesOfBrick(int rank, int d) const;
    CellBox facesOfPart(int rank, int d) const;

private:

    int unitOf(const typename UniformGrid<D>::Index& c) const
    {
        int u = 0;
        for (int d = D - 1; d >= 0; --d) u = u*units_[d] + c.c[d]/unit(d);
        return u;
    }
    void divide(const CellBox& box, int firstRank, int ranks, const std::vector<double>& load);
    //- Rows of tiles are listed by what is within so many cells, and one tile more where the block
    //  ends in itself (ActiveRows::find)
    int around() const
    {
        bool rings = false;
        for (int d = 0; d < D; ++d) rings = rings || whole_.periodic[d];
        return rings ? 2*depth : depth;
    }
    bool cuts(int d) const { return d < D && !whole_.periodic[d]; }
    int most(const CellBox& units) const;
    double loadOf(const CellBox& units, const std::vector<double>& load) const;

    Transport& ranks_;
    UniformGrid<D> whole_;
    int units_[3] = {1, 1, 1};
    std::vector<CellBox> bricks_;
    std::vector<int> ownerOf_;              // of units
    std::vector<std::vector<int>> seenBy_;
};

} // namespace riprap
