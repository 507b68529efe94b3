/*  The fill of a new scene where solids are: what the particles of lagrangian/fluid left out there
    is water wherever its level reaches.

    A cell near a solid takes the fill of its neighbours at the same height, as far as there are
    any, however wide the solid is, then of those above and below: the water that rests about a
    solid is filled as if the solid were not there, so that the surface meets it as it comes, and a
    film over a wide deck reaches its middle.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <algorithm>
#include <vector>
#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

//- known: cells that no solid is near; up: the direction of gravity, -1: none
template<int D>
void fillSolids(const UniformGrid<D>& g, const std::vector<char>& known,
    const std::vector<double>& open, int up, std::vector<double>& fill)
{
    constexpr int layers = 8;           // twice the band of phi
    std::vector<char> filled = known;
    const auto pass = [&](bool alongUp)
    {
        bool any = false;
        std::vector<char> next = filled;
        std::vector<double> value = fill;
        for (int i = 0; i < g.cells(); ++i)
        {
            if (filled[i]) continue;
            double sum = 0;
            int count = 0;
            for (int d = 0; d < D; ++d)
            {
                if (d == up && !alongUp) continue;
                for (int offset = -1; offset <= 1; offset += 2)
                {
                    const int j = g.neighbour(g.cellIndex(i), d, offset);
                    if (j < 0 || !filled[j]) continue;
                    sum += fill[j];
                    ++count;
                }
            }
            if (!count) continue;
            value[i] = sum/count;
            next[i] = 1;
            any = true;
        }
        filled.swap(next);
        fill.swap(value);
        return any;
    };
    if (up >= 0) while (pass(false)) {}
    for (int k = 0; k < layers; ++k) pass(true);
    // gaps that no cell is clear of: what their particles say
    for (int i = 0; i < g.cells(); ++i)
        if (!filled[i]) fill[i] = open[i] > 0 ? std::min(fill[i]/open[i], 1.0) : 0;
}

} // namespace riprap
