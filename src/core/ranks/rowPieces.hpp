/*  Pieces of rows of cells: the units by which a scene is divided over ranks.

    Cells are stored row by row, x fastest. A piece is some cells of a row side by side, so its
    particles lie side by side in memory too, and pieces in their order are the cells in theirs. One
    rank has all particles of a piece; hence where a particle stands in the order of one process
    follows from the numbers of particles in pieces, and each rank can tell.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <array>
#include <vector>

namespace riprap
{

//- Cells of one size of particles (CellGrid, in plain numbers)
struct PieceGrid
{
    int n[3] = {1, 1, 1}, stride[3] = {1, 1, 1};    // stride[0] is 1, one of the others n[0]
    double lower[3] = {}, size[3] = {1, 1, 1};      // [m]; of an axis that is not there: one cell
    bool periodic[3] = {};
    double radius = 0;                              // of the largest particles in it [m]
};

class RowPieces
{
public:

    using Point = std::array<double, 3>;

    //- reach: what is added to two radii. Pieces are of `least` cells or more, and about `most` in
    //  all, unless there are more rows
    void set(const std::vector<PieceGrid>& grids, double reach, int least = 4, double most = 32768);

    int count() const { return first_.back(); }
    int cells() const { return firstCell_.back(); }

    //- The piece of a cell, which is counted through all grids
    int of(int cell) const;

    Point centre(int piece) const;

    //- Those whose particles may touch some of this piece, itself included, ascending
    std::vector<int> near(int piece) const;

    //- A box that has the centres of all of these. \return false: it goes on at the other side
    bool boxAround(int piece, Point& low, Point& high) const;

private:

    struct Place { int grid; std::array<int, 3> at; };      // piece along x, row along y and z
    Place place(int piece) const;
    int number(int grid, int along, int y, int z) const;
    int begin(int grid, int along) const;                   // first cell of a piece along x
    int along(int grid, int x) const;

    std::vector<PieceGrid> grids_;
    std::vector<int> pieces_;                               // of a row of each grid
    std::vector<int> first_{0}, firstCell_{0};
    double reach_ = 0;
};

} // namespace riprap
