/*  Smooth parts of the pressure between many free bodies, for their deflation (deflation.hpp).

    Where bodies crowd, all of them moving one way is a slow mode as well: its pressure is nearly linear over many bodies, with a dipole at each. The local solutions have
    the dipoles; what is linear in between are hats on a lattice, the product over the directions of max(0, 1 - |x - x_k|/H). Under a surface only those that have two
    bodies or more in reach are needed: a body by itself has no such mode. In closed water even one body drives a flow back everywhere, and all of them are taken: together
    they are the constant, without which twice as many iterations are.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>
#include "pic/pressure/linearSolver.hpp"

namespace riprap
{

using CellCorner = std::array<int, 3>;

//- Columns of Z that are zero outside of a box of cells
struct DeflationPiece
{
    CellCorner low{{0, 0, 0}}, high{{0, 0, 0}};
    int modes = 0;
    std::vector<int> row;
    std::vector<double> value;          // modes a row
};

//- Rows in a box: f(row, cell's index)
template<class F>
void eachRowInBox(const ReducedSystem& s, const std::vector<int>& rowOfCell, const CellCorner& low, const CellCorner& high, const F& f)
{
    for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
            for (int i = low[0]; i <= high[0]; ++i)
            {
                const int r = rowOfCell[i + s.n[0]*(j + s.n[1]*k)];
                if (r >= 0) f(r, CellCorner{{i, j, k}});
            }
}

//- low, high: the cells beside each body; spacing: H [cells], about
inline std::vector<DeflationPiece> hatsBetween
(
    const ReducedSystem& s, const std::vector<int>& rowOfCell, const std::vector<CellCorner>& low, const std::vector<CellCorner>& high, double spacing, bool closed
)
{
    constexpr int least = 2;            // bodies
    constexpr double mostABody = 4, mostOfFew = 500;
    int intervals[3] = {0, 0, 0};       // of the lattice, which spans the grid
    double width[3] = {1, 1, 1}, cells = 1;
    for (int d = 0; d < s.dimensions; ++d) cells *= s.n[d];
    if (closed) spacing = std::max(spacing, std::pow(cells/std::max(mostOfFew, mostABody*low.size()), 1.0/s.dimensions));
    for (int d = 0; d < s.dimensions; ++d)
    {
        intervals[d] = std::max(1, int(std::lround(s.n[d]/spacing)));
        width[d] = double(s.n[d])/intervals[d];
    }
    std::map<CellCorner, int> reached;  // bodies that each hat reaches, ordered
    for (std::size_t b = 0; b < low.size(); ++b)
    {
        CellCorner first{{0, 0, 0}}, last{{0, 0, 0}};
        for (int d = 0; d < s.dimensions; ++d)
        {
            first[d] = std::max(0, int(std::floor(low[b][d]/width[d])));
            last[d] = std::min(intervals[d], int(std::ceil((high[b][d] + 1)/width[d])));
        }
        CellCorner at;
        for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
            for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
                for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) ++reached[at];
    }
    if (closed)
    {
        CellCorner at;
        for (at[2] = 0; at[2] <= intervals[2]; ++at[2])
            for (at[1] = 0; at[1] <= intervals[1]; ++at[1])
                for (at[0] = 0; at[0] <= intervals[0]; ++at[0]) reached[at] = least;
    }
    std::vector<DeflationPiece> hats;
    for (const auto& node : reached)
    {
        const auto& at = node.first;
        if (node.second < least) continue;
        DeflationPiece hat;
        hat.modes = 1;
        for (int d = 0; d < s.dimensions; ++d)
        {
            hat.low[d] = std::max(0, int(std::ceil((at[d] - 1)*width[d] - 0.5)));
            hat.high[d] = std::min(s.n[d] - 1, int(std::floor((at[d] + 1)*width[d] - 0.5)));
        }
        eachRowInBox(s, rowOfCell, hat.low, hat.high, [&](int row, const CellCorner& x)
        {
            double value = 1;
            for (int d = 0; d < s.dimensions; ++d) value *= std::max(0.0, 1 - std::fabs((x[d] + 0.5)/width[d] - at[d]));
            if (!(value > 0)) return;
            hat.row.push_back(row);
            hat.value.push_back(value);
        });
        if (!hat.row.empty()) hats.push_back(std::move(hat));
    }
    return hats;
}

} // namespace riprap
