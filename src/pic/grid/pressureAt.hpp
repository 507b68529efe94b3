/*  Pressure between the centres of cells: linear, continued past the surface so that p = 0 where
    phi = 0, and past walls as the plane through the two cells inside. Exact where p is linear.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "pic/grid/pressureFields.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

//- p of a cell; of a dry one what its wet neighbours and p = 0 on the surface between make of it, 0
//  if it has none
template<int D, class R>
HD double continuedPressure(
    const UniformGrid<D>& g, const R* phi, const double* p, const typename UniformGrid<D>::Index& c)
{
    const int i = g.cell(c);
    if (phi[i] < 0) return p[i];
    double sum = 0;
    int count = 0;
    for (int d = 0; d < D; ++d)
        for (int offset = -1; offset <= 1; offset += 2)
        {
            const int j = g.neighbour(c, d, offset);
            if (j < 0 || !(phi[j] < 0)) continue;
            sum += p[j]*double(phi[i])/double(phi[j]);
            ++count;
        }
    return count ? sum/count : 0;
}

//- p of cells that solids close, from the wet ones beside them: the line through two of them, else
//  one's value
template<int D, class R>
void extendPressure(const UniformGrid<D>& g, const R* phi, const std::vector<unsigned char>& wet,
    std::vector<double>& p)
{
    std::vector<unsigned char> known = wet;
    for (int pass = 0; pass < 2; ++pass)
    {
        const std::vector<unsigned char> before = known;
        const std::vector<double> from = p;
        for (int i = 0; i < g.cells(); ++i)
        {
            if (before[i] || !(phi[i] < R(-wetDepth*g.h))) continue;
            double sum = 0;
            int count = 0;
            for (int d = 0; d < D; ++d)
                for (int offset = -1; offset <= 1; offset += 2)
                {
                    const int one = g.neighbour(g.cellIndex(i), d, offset);
                    if (one < 0 || !before[one]) continue;
                    const int two = g.neighbour(g.cellIndex(one), d, offset);
                    sum += two >= 0 && before[two] ? 2*from[one] - from[two] : from[one];
                    ++count;
                }
            if (!count) continue;
            p[i] = sum/count;
            known[i] = 1;
        }
    }
}

//- p at a point of the block
template<int D, class R>
HD double pressureAt(
    const UniformGrid<D>& g, const R* phi, const double* p, const Vec<D, double>& x)
{
    typename UniformGrid<D>::Index low{{0, 0, 0}};
    double fraction[D];
    for (int d = 0; d < D; ++d)
    {
        const double s = x.c[d]/g.h - 0.5;
        int i = floorInt(s) - g.first[d];
        // beside a wall: the two cells inside, with weights beyond 0 .. 1
        if (!g.periodic[d] && g.n[d] > 1) i = i < 0 ? 0 : (i > g.n[d] - 2 ? g.n[d] - 2 : i);
        low.c[d] = i;
        fraction[d] = s - (i + g.first[d]);
    }
    double sum = 0;
    for (int corner = 0; corner < (1 << D); ++corner)
    {
        typename UniformGrid<D>::Index c = low;
        double w = 1;
        for (int d = 0; d < D; ++d)
        {
            const int up = corner >> d & 1;
            w *= up ? fraction[d] : 1 - fraction[d];
            c.c[d] = evenNode(g, d, c.c[d] + up);
        }
        sum += w*continuedPressure(g, phi, p, c);
    }
    return sum;
}

} // namespace riprap
