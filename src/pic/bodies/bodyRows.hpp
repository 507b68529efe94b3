/*  J on the grid (bodyTerm.hpp): for each body the cells beside it, row by row of its block, with a
    value for each of its ways to move; and the sums J^T p.

    A sum is taken over each row, and then over the rows of a body: the same bits however the work
    is shared out.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/bodies/bodyShares.hpp"

namespace riprap
{

//- How many cells of a row may have J, and from which on
template<int D>
struct FindBodyCells
{
    static constexpr const char* name = "findBodyCells";
    BodyBlocks<D> blocks;
    ShareRows<D> shares;
    int* count;
    int* x;

    HD void operator()(int r) const
    {
        count[r] = x[r] = 0;
        if (r >= blocks.firstRow[blocks.count]) return;        // one more, for the sum
        const BlockRow row = blocks.row(r);
        const UniformGrid<D>& g = blocks.grid;
        const PlacedBody<D>& body = blocks.body[row.body];
        const typename UniformGrid<D>::Index c = blocks.first(row);
        for (int d = 1; d < D; ++d) if (c.c[d] >= g.n[d]) return;
        int low = g.n[0], high = -1;
        const auto join = [&](int d, int j, int k)
        {
            if (j >= body.size[1] || k >= body.size[2]) return;
            const int of = FaceRow<D>::number(blocks, row.body, d, j, k),
                      n = shares.first[of + 1] - shares.first[of];
            if (!n) return;
            const int from = shares.x[of] - (d == 0), to = shares.x[of] + n - 1;
            low = from < low ? from : low;
            high = to > high ? to : high;
        };
        for (int d = 0; d < D; ++d)
        {
            join(d, row.j, row.k);
            if (d > 0) join(d, row.j + (d == 1), row.k + (d == 2));
        }
        low = low > 0 ? low : 0;
        high = high < g.n[0] ? high : g.n[0] - 1;
        if (high < low) return;
        x[r] = low;
        count[r] = high - low + 1;
    }
};

template<int D, int Lanes>
struct FillBodyCells
{
    static constexpr const char* name = "fillBodyCells";
    BodyBlocks<D> blocks;
    ShareRows<D> shares;
    const int* first;
    const int* x;
    CellBox own;                    // cells that count: J is 0 in others
    int* cell;
    double* j;                      // bodyModes a cell [m2, m3]

    HD void operator()(int thread) const
    {
        constexpr int modes = bodyModes<D>;
        const int r = thread/Lanes, lane = thread % Lanes;
        if (first[r] + lane >= first[r + 1]) return;
        const BlockRow row = blocks.row(r);
        const UniformGrid<D>& g = blocks.grid;
        const PlacedBody<D>& body = blocks.body[row.body];
        typename UniformGrid<D>::Index c = blocks.first(row);
        c.c[0] = x[r] + lane;
        for (int at = first[r] + lane; at < first[r + 1]; at += Lanes, c.c[0] += Lanes)
        {
            double sum[modes] = {};
            for (int d = 0; d < D; ++d)
                for (int side = 0; side < 2; ++side)
                {
                    const int rowJ = row.j + (d == 1 && side), rowK = row.k + (d == 2 && side);
                    if (rowJ >= body.size[1] || rowK >= body.size[2]) continue;
                    const int s = shares.at(FaceRow<D>::number(blocks, row.body, d, rowJ, rowK),
                        c.c[0] + (d == 0 && side));
                    if (s < 0) continue;
                    const double flux = (side ? -1 : 1)*shares.share[s]*g.area();
                    for (int m = 0; m < modes; ++m)
                        sum[m] += flux*modeVelocity(m, d, shares.arm[s]);
                }
            int whole[3] = {0, 0, 0};
            for (int d = 0; d < D; ++d) whole[d] = g.first[d] + c.c[d];
            const bool mine = own.has(whole);
            cell[at] = g.cell(c);
            for (int m = 0; m < modes; ++m) j[at*modes + m] = mine ? sum[m] : 0;
        }
    }
};

//- Of a field over the entries of each row; nullptr: of ones
template<int modes>
struct SumRowsOfBodies
{
    static constexpr const char* name = "sumBodyRows";
    const int* first;
    const int* place;
    const double* value;            // modes an entry
    const double* field;
    double* sums;                   // modes a row

    HD void operator()(int r) const
    {
        double sum[modes] = {};
        for (int i = first[r]; i < first[r + 1]; ++i)
        {
            const double p = field ? field[place[i]] : 1;
            for (int m = 0; m < modes; ++m) sum[m] += value[i*modes + m]*p;
        }
        for (int m = 0; m < modes; ++m) sums[r*modes + m] = sum[m];
    }
};

//- One number for each body and mode
struct SumBodies
{
    static constexpr const char* name = "sumBodies";
    int modes;
    const int* firstRow;
    const double* ofRow;
    double* sums;

    HD void operator()(int i) const
    {
        const int b = i/modes, m = i % modes;
        double sum = 0;
        for (int r = firstRow[b]; r < firstRow[b + 1]; ++r) sum += ofRow[r*modes + m];
        sums[i] = sum;
    }
};

} // namespace riprap
