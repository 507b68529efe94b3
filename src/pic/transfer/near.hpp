/*  Particles about a point of the grid, and the images of nodes that particles near the sides of the block see.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/particles.hpp"

namespace riprap
{

//- f(particle) for all particles in the cells that lie within `reach` (in cells) of a point at s (in cells from the corner);
//  cells beyond the block do not exist
template<int D, class F>
HD void forEachNear(const UniformGrid<D>& g, const int* start, const double* s, double reach, const F& f)
{
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int a = 0; a < D; ++a)
    {
        low[a] = floorInt(s[a] - reach);
        high[a] = floorInt(s[a] + reach);
        low[a] = low[a] < 0 ? 0 : low[a];
        high[a] = high[a] >= g.n[a] ? g.n[a] - 1 : high[a];
    }
    if (low[0] > high[0]) return;
    for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j)
        {
            const int row = g.n[0]*(j + g.n[1]*k);
            for (int p = start[row + low[0]]; p < start[row + high[0] + 1]; ++p) f(p);
        }
}

//- f(s) for the middle of a cell at s and those of its images that particles in the block can see
template<int D, class F>
HD void forEachImage(const UniformGrid<D>& g, const double* node, double reach, const F& f)
{
    double variant[D][3];
    int variants[3] = {1, 1, 1};
    for (int a = 0; a < D; ++a)
    {
        const double s = node[a], n = g.n[a];
        variant[a][0] = s;
        const auto add = [&](double at) { variant[a][variants[a]++] = at; };
        if (g.periodic[a])
        {
            if (s < reach) add(s + n);
            if (n - s < reach) add(s - n);
        }
        else
        {
            if (s > 0 && s < reach) add(-s);
            if (s < n && n - s < reach) add(2*n - s);
        }
    }
    for (int k = 0; k < (D == 3 ? variants[2] : 1); ++k)
        for (int j = 0; j < variants[1]; ++j)
            for (int i = 0; i < variants[0]; ++i)
            {
                double s[D] = {variant[0][i], variant[1][j]};
                if constexpr (D == 3) s[2] = variant[2][k];
                f(s);
            }
}

} // namespace riprap
