/*  Smooth parts of the pressure between many free bodies, for their deflation (deflation.hpp).

    Where bodies crowd, all of them moving one way is a slow mode as well: its pressure is nearly
    linear over many bodies, with a dipole at each. The local solutions have the dipoles; what is
    linear in between are hats on a lattice, the product over the directions of max(0, 1 - |x -
    x_k|/H). Under a surface only those that have two bodies or more in reach are needed: a body by
    itself has no such mode. In closed water even one body drives a flow back everywhere, and all of
    them are taken (hatsEverywhere): GAMG takes 1.4 to 2 times as many iterations without, our
    V-cycle a tenth more in 2D and as many in 3D. Heavy bodies are but walls, and our V-cycle needs
    no hats between them; GAMG does in 2D (DeflationControls::heavyHats): its coarse levels are the
    worse the more walls there are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>
#include "api/linearSolver.hpp"

namespace riprap
{

using CellCorner = std::array<int, 3>;

//- Columns of Z that are zero outside of a box of cells
struct DeflationPiece
{
    CellCorner low{{0, 0, 0}}, high{{0, 0, 0}};
    int modes = 0;
    bool hat = false;
    std::vector<int> row;
    std::vector<double> value;          // modes a row
    // faces to other ranks with a cell in the box on this side, and on the other
    std::vector<int> out, in;

    bool holds(const CellCorner& x) const
    {
        return low[0] <= x[0] && x[0] <= high[0] && low[1] <= x[1] && x[1] <= high[1]
            && low[2] <= x[2] && x[2] <= high[2];
    }
};

inline CellCorner cornerOf(const ReducedSystem& s, int cell)
{
    return {{cell % s.n[0], cell/s.n[0] % s.n[1], cell/(s.n[0]*s.n[1])}};
}

//- Which row a cell has, in the box of those that have one
struct RowsOfCells
{
    CellCorner low{{0, 0, 0}}, high{{-1, -1, -1}};
    std::vector<int> row;

    void set(const ReducedSystem& s)
    {
        low = {{s.n[0], s.n[1], s.n[2]}};
        high = {{-1, -1, -1}};
        for (const int cell : s.cell)
        {
            const CellCorner x = cornerOf(s, cell);
            for (int d = 0; d < 3; ++d)
            {
                low[d] = std::min(low[d], x[d]);
                high[d] = std::max(high[d], x[d]);
            }
        }
        if (s.cell.empty()) low = {{0, 0, 0}};
        row.assign(
            std::size_t(high[0] - low[0] + 1)*(high[1] - low[1] + 1)*(high[2] - low[2] + 1),
            -1);
        for (int i = 0; i < s.rows(); ++i) row[at(cornerOf(s, s.cell[i]))] = i;
    }

    std::size_t at(const CellCorner& x) const
    {
        return x[0] - low[0]
            + std::size_t(high[0] - low[0] + 1)
            *(x[1] - low[1] + std::size_t(high[1] - low[1] + 1)*(x[2] - low[2]));
    }

    //- Rows in a box: f(row, cell's index)
    template<class F>
    void each(const CellCorner& from, const CellCorner& to, const F& f) const
    {
        CellCorner x, a, b;
        for (int d = 0; d < 3; ++d)
        {
            a[d] = std::max(low[d], from[d]);
            b[d] = std::min(high[d], to[d]);
        }
        for (x[2] = a[2]; x[2] <= b[2]; ++x[2])
            for (x[1] = a[1]; x[1] <= b[1]; ++x[1])
                for (x[0] = a[0]; x[0] <= b[0]; ++x[0])
                {
                    const int r = row[at(x)];
                    if (r >= 0) f(r, x);
                }
    }
};

//- The lattice of the hats' middles, which spans the grid; spacing: H [cells], about
struct HatLattice
{
    int dimensions;
    int intervals[3] = {0, 0, 0};
    double width[3] = {1, 1, 1};        // cells

    HatLattice(const ReducedSystem& s, double spacing) : dimensions(s.dimensions)
    {
        for (int d = 0; d < dimensions; ++d)
        {
            intervals[d] = std::max(1, int(std::lround(s.n[d]/spacing)));
            width[d] = double(s.n[d])/intervals[d];
        }
    }

    template<class F>
    static void each(const CellCorner& first, const CellCorner& last, const F& f)
    {
        CellCorner at;
        for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
            for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
                for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) f(at);
    }

    template<class F> void each(const F& f) const
    {
        each({{0, 0, 0}}, {{intervals[0], intervals[1], intervals[2]}}, f);
    }

    //- Those whose hats reach cells from low to high
    template<class F> void eachAt(const CellCorner& low, const CellCorner& high, const F& f) const
    {
        CellCorner first{{0, 0, 0}}, last{{0, 0, 0}};
        for (int d = 0; d < dimensions; ++d)
        {
            first[d] = std::max(0, int(std::floor(low[d]/width[d])));
            last[d] = std::min(intervals[d], int(std::ceil((high[d] + 1)/width[d])));
        }
        each(first, last, f);
    }

    DeflationPiece hat(const ReducedSystem& s, const RowsOfCells& rows, const CellCorner& at) const
    {
        DeflationPiece hat;
        hat.modes = 1;
        hat.hat = true;
        for (int d = 0; d < dimensions; ++d)
        {
            hat.low[d] = std::max(0, int(std::ceil((at[d] - 1)*width[d] - 0.5)));
            hat.high[d] = std::min(s.n[d] - 1, int(std::floor((at[d] + 1)*width[d] - 0.5)));
        }
        rows.each(hat.low, hat.high, [&](int row, const CellCorner& x)
        {
            double value = 1;
            for (int d = 0; d < dimensions; ++d)
                value *= std::max(0.0, 1 - std::fabs((x[d] + 0.5)/width[d] - at[d]));
            if (!(value > 0)) return;
            hat.row.push_back(row);
            hat.value.push_back(value);
        });
        return hat;
    }
};

//- low, high: the cells beside each body; spacing: H [cells], about. Some may have no rows
inline std::vector<DeflationPiece> hatsBetween(const ReducedSystem& s, const RowsOfCells& rows,
    const std::vector<CellCorner>& low, const std::vector<CellCorner>& high, double spacing,
    bool closed)
{
    constexpr int least = 2;            // bodies
    constexpr double mostABody = 4, mostOfFew = 500;
    double cells = 1;
    for (int d = 0; d < s.dimensions; ++d) cells *= s.n[d];
    if (closed)
        spacing = std::max(spacing,
            std::pow(cells/std::max(mostOfFew, mostABody*low.size()), 1.0/s.dimensions));
    const HatLattice lattice(s, spacing);
    std::map<CellCorner, int> reached;  // bodies that each hat reaches, ordered
    for (std::size_t b = 0; b < low.size(); ++b)
        lattice.eachAt(low[b], high[b], [&](const CellCorner& at) { ++reached[at]; });
    if (closed) lattice.each([&](const CellCorner& at) { reached[at] = least; });
    std::vector<DeflationPiece> hats;
    for (const auto& node : reached)
        if (node.second >= least) hats.push_back(lattice.hat(s, rows, node.first));
    return hats;
}

} // namespace riprap
