// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/ranks/rowPieces.hpp"
#include <algorithm>
#include <cmath>

namespace riprap
{

void RowPieces::set(const std::vector<PieceGrid>& grids, double reach, int least, double most)
{
    grids_ = grids;
    reach_ = reach;
    pieces_.clear();
    first_.assign(1, 0);
    firstCell_.assign(1, 0);
    double rows = 0;
    for (const PieceGrid& g : grids) rows += double(g.n[1])*g.n[2];
    for (const PieceGrid& g : grids)
    {
        const int longest = g.n[0]/least;
        const int pieces = int(std::max(1.0, std::min(double(longest), std::floor(most/rows))));
        pieces_.push_back(pieces);
        first_.push_back(first_.back() + pieces*g.n[1]*g.n[2]);
        firstCell_.push_back(firstCell_.back() + g.n[0]*g.n[1]*g.n[2]);
    }
}

int RowPieces::begin(int grid, int along) const
{
    return int((long long)grids_[grid].n[0]*along/pieces_[grid]);
}

int RowPieces::along(int grid, int x) const
{
    const int n = grids_[grid].n[0], pieces = pieces_[grid];
    int k = int((long long)x*pieces/n);
    while (k + 1 < pieces && begin(grid, k + 1) <= x) ++k;
    return k;
}

int RowPieces::of(int cell) const
{
    int grid = 0;
    while (cell >= firstCell_[grid + 1]) ++grid;
    cell -= firstCell_[grid];
    const int n = grids_[grid].n[0];
    return first_[grid] + cell/n*pieces_[grid] + along(grid, cell % n);
}

int RowPieces::number(int grid, int along, int y, int z) const
{
    const PieceGrid& g = grids_[grid];
    const int row = int(((long long)y*g.stride[1] + (long long)z*g.stride[2])/g.n[0]);
    return first_[grid] + row*pieces_[grid] + along;
}

RowPieces::Place RowPieces::place(int piece) const
{
    int grid = 0;
    while (piece >= first_[grid + 1]) ++grid;
    piece -= first_[grid];
    const PieceGrid& g = grids_[grid];
    const int row = piece/pieces_[grid];
    const bool yFirst = g.stride[1] <= g.stride[2];
    const int inner = yFirst ? g.n[1] : g.n[2];
    Place p{grid, {{piece % pieces_[grid], row % inner, row/inner}}};
    if (!yFirst) std::swap(p.at[1], p.at[2]);
    return p;
}

RowPieces::Point RowPieces::centre(int piece) const
{
    const Place p = place(piece);
    const PieceGrid& g = grids_[p.grid];
    Point c;
    c[0] = g.lower[0] + 0.5*(begin(p.grid, p.at[0]) + begin(p.grid, p.at[0] + 1))*g.size[0];
    for (int d = 1; d < 3; ++d) c[d] = g.lower[d] + (p.at[d] + 0.5)*g.size[d];
    return c;
}

bool RowPieces::boxAround(int piece, Point& low, Point& high) const
{
    const Place p = place(piece);
    const PieceGrid& a = grids_[p.grid];
    for (int d = 0; d < 3; ++d)
    {
        const int from = d ? p.at[d] : begin(p.grid, p.at[0]),
                  to = d ? p.at[d] + 1 : begin(p.grid, p.at[0] + 1);
        low[d] = a.lower[d] + from*a.size[d];
        high[d] = a.lower[d] + to*a.size[d];
        double beyond = 0;
        bool periodic = false;
        for (int k = 0; k < int(grids_.size()); ++k)
        {
            // as near() goes, and to the centre of the piece that this ends in
            const PieceGrid& b = grids_[k];
            const int cells = d ? 1 : b.n[0]/pieces_[k] + 2;
            beyond = std::max(beyond, a.radius + b.radius + reach_ + 0.01*a.size[d]
                + (1.01 + cells)*b.size[d]);
            periodic = periodic || b.periodic[d];
        }
        low[d] -= beyond;
        high[d] += beyond;
        if (periodic && (low[d] < a.lower[d] || high[d] > a.lower[d] + a.n[d]*a.size[d]))
            return false;
    }
    return true;
}

std::vector<int> RowPieces::near(int piece) const
{
    const Place p = place(piece);
    const PieceGrid& a = grids_[p.grid];
    double low[3], high[3];
    for (int d = 0; d < 3; ++d)
    {
        low[d] = a.lower[d] + (d ? p.at[d] : begin(p.grid, p.at[0]))*a.size[d];
        high[d] = a.lower[d] + (d ? p.at[d] + 1 : begin(p.grid, p.at[0] + 1))*a.size[d];
    }
    std::vector<int> found;
    for (int k = 0; k < int(grids_.size()); ++k)
    {
        const PieceGrid& b = grids_[k];
        // cells of the axis within the distance. Which cell a particle is in was rounded
        const auto cells = [&](int d)
        {
            const double distance = a.radius + b.radius + reach_ + 0.01*(a.size[d] + b.size[d]);
            const int from = int(std::floor((low[d] - distance - b.lower[d])/b.size[d]));
            const int to = int(std::floor((high[d] + distance - b.lower[d])/b.size[d]));
            std::vector<int> in;
            if (b.periodic[d])
                for (int c = from; c <= to && c < from + b.n[d]; ++c)
                    in.push_back((c % b.n[d] + b.n[d]) % b.n[d]);
            else
                // beyond the ends are the cells at the ends
                for (int c = std::min(std::max(from, 0), b.n[d] - 1);
                     c <= std::max(std::min(to, b.n[d] - 1), 0); ++c)
                    in.push_back(c);
            return in;
        };
        std::vector<int> pieces;
        for (const int x : cells(0)) pieces.push_back(along(k, x));
        std::sort(pieces.begin(), pieces.end());
        pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
        const std::vector<int> ys = cells(1), zs = cells(2);
        for (const int z : zs)
            for (const int y : ys)
                for (const int x : pieces) found.push_back(number(k, x, y, z));
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace riprap
