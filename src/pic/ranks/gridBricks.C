/*  Bricks by recursive bisection.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include "pic/ranks/gridBricks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace riprap
{

namespace
{

//- What a dry cell costs, of a wet one
constexpr double dryCell = 0.02;

}

template<int D>
GridBricks<D>::GridBricks(
    Transport& ranks, const UniformGrid<D>& whole, const std::vector<double>& x, double share)
:
    ranks_(ranks), whole_(whole), bricks_(ranks.size())
{
    CellBox all;
    double cells = 1;
    for (int d = 0; d < D; ++d)
    {
        all.high[d] = units_[d] = (whole.n[d] + unit(d) - 1)/unit(d);
        cells *= unit(d);
    }
    std::vector<double> load(all.count(), dryCell*cells);
    for (std::size_t p = 0; p < x.size()/D; ++p)
    {
        int u = 0;
        for (int d = D - 1; d >= 0; --d)
        {
            const int c = int(std::floor(x[p*D + d]/whole.h));
            u = u*units_[d] + std::max(0, std::min(c, whole.n[d] - 1))/unit(d);
        }
        load[u] += share;
    }
    ownerOf_.assign(all.count(), 0);
    divide(all, 0, ranks.size(), load);
    seenBy_.resize(all.count());
    typename UniformGrid<D>::Index c{{0, 0, 0}};
    for (int r = 0; r < ranks.size(); ++r)
    {
        const CellBox box = part(r);
        for (c.c[2] = box.low[2]; c.c[2] < box.high[2]; c.c[2] += unit(2))
            for (c.c[1] = box.low[1]; c.c[1] < box.high[1]; c.c[1] += unit(1))
                for (c.c[0] = box.low[0]; c.c[0] < box.high[0]; c.c[0] += unit(0))
                    seenBy_[unitOf(c)].push_back(r);
    }
}

//- Bricks that a box of units can be cut into
template<int D>
int GridBricks<D>::most(const CellBox& units) const
{
    int n = 1;
    for (int d = 0; d < D; ++d) if (cuts(d)) n *= units.high[d] - units.low[d];
    return n;
}

template<int D>
double GridBricks<D>::loadOf(const CellBox& units, const std::vector<double>& load) const
{
    double sum = 0;
    for (int k = units.low[2]; k < units.high[2]; ++k)
        for (int j = units.low[1]; j < units.high[1]; ++j)
            for (int i = units.low[0]; i < units.high[0]; ++i)
                sum += load[i + units_[0]*(j + units_[1]*k)];
    return sum;
}

//- Where the loads of both sides are to each other as their ranks, across the direction in which
//  that and the copies beside the cut cost least
template<int D>
void GridBricks<D>::divide(
    const CellBox& box, int firstRank, int ranks, const std::vector<double>& load)
{
    if (ranks == 1)
    {
        CellBox& brick = bricks_[firstRank];
        for (int d = 0; d < D; ++d)
        {
            brick.low[d] = box.low[d]*unit(d);
            brick.high[d] = std::min(box.high[d]*unit(d), whole_.n[d]);
        }
        for (int k = box.low[2]; k < box.high[2]; ++k)
            for (int j = box.low[1]; j < box.high[1]; ++j)
                for (int i = box.low[0]; i < box.high[0]; ++i)
                    ownerOf_[i + units_[0]*(j + units_[1]*k)] = firstRank;
        return;
    }
    const int lower = ranks/2;
    const double all = loadOf(box, load);
    double least = 1e300;
    CellBox best[2];
    for (int d = 0; d < D; ++d)
    {
        const int length = box.high[d] - box.low[d];
        if (!cuts(d) || length < 2) continue;
        CellBox side[2] = {box, box}, cut[2];
        double own = 1e300;
        for (int at = box.low[d] + 1; at < box.high[d]; ++at)
        {
            side[0].high[d] = side[1].low[d] = at;
            if (most(side[0]) < lower || most(side[1]) < ranks - lower) continue;
            const double off = std::abs(loadOf(side[0], load) - all*lower/ranks);
            if (!(off < own)) continue;
            own = off;
            cut[0] = side[0];
            cut[1] = side[1];
        }
        const double copies = all*depth/(double(length)*unit(d));
        if (!(own + copies < least)) continue;
        least = own + copies;
        best[0] = cut[0];
        best[1] = cut[1];
    }
    if (!(least < 1e300))
        throw TooManyRanks(std::to_string(this->size())
            + " processes are too many for this mesh: each needs 32 cells along x and 8 along "
              "other directions, and there are no cuts across periodic directions");
    divide(best[0], firstRank, lower, load);
    divide(best[1], firstRank + lower, ranks - lower, load);
}

template<int D>
CellBox GridBricks<D>::part(int rank) const
{
    CellBox box = bricks_[rank];
    for (int d = 0; d < D; ++d)
    {
        const int u = unit(d), more = (around() + u - 1)/u*u;
        box.low[d] = std::max(box.low[d] - more, 0);
        box.high[d] = std::min(box.high[d] + more, whole_.n[d]);
    }
    return box;
}

template<int D>
UniformGrid<D> GridBricks<D>::partGrid() const
{
    UniformGrid<D> grid = whole_;
    grid.part = true;
    const CellBox box = part(rank());
    for (int d = 0; d < D; ++d)
    {
        grid.first[d] = box.low[d];
        grid.n[d] = box.high[d] - box.low[d];
    }
    return grid;
}

template<int D>
CellBox GridBricks<D>::facesOfBrick(int rank, int d) const
{
    CellBox box = bricks_[rank];
    if (box.high[d] == whole_.n[d]) ++box.high[d];
    return box;
}

template<int D>
CellBox GridBricks<D>::facesOfPart(int rank, int d) const
{
    CellBox box = part(rank);
    ++box.high[d];
    return box;
}

template class GridBricks<2>;
template class GridBricks<3>;

} // namespace riprap
