/*  Which cells are wet, and which have water about them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/particles.hpp"
#include "pic/pressureFields.hpp"
#include "pic/transfer/mirror.hpp"

namespace riprap
{

template<int D, class R>
struct MarkWetCells
{
    static constexpr const char* name = "markWetCells";
    PressureFields<D, R> fields;
    unsigned char* wet;
    HD void operator()(int i) const { wet[i] = isWet(fields, i, fields.grid.cellIndex(i)); }
};

//- Of the cells about a cell, corners and itself included, some or all are wet, else none (0)
static constexpr unsigned char someWater = 1, allWater = 2;

//- Particles in cells that no wet one touches fly
template<int D>
struct MarkNearWater
{
    static constexpr const char* name = "markNearWater";
    UniformGrid<D> grid;
    const unsigned char* wet;
    unsigned char* near;

    HD void operator()(int i) const
    {
        const typename UniformGrid<D>::Index c = grid.cellIndex(i);
        const bool in = inner(grid, c, 1);
        bool some = false, all = true;
        for (int k = (D == 3 ? -1 : 0); k <= (D == 3 ? 1 : 0); ++k)
            for (int j = -1; j <= 1; ++j)
                for (int l = -1; l <= 1; ++l)
                {
                    int other = i + l + grid.n[0]*(j + grid.n[1]*k);
                    if (!in)
                    {
                        typename UniformGrid<D>::Index at{{c.c[0] + l, c.c[1] + j, c.c[2] + k}};
                        for (int d = 0; d < D; ++d) at.c[d] = evenNode(grid, d, at.c[d]);
                        other = grid.cell(at);
                    }
                    some = some || wet[other];
                    all = all && wet[other];
                }
        near[i] = all ? allWater : (some ? someWater : 0);
    }
};

//- Particles that fly, counted
template<int D, class R>
struct CountFlying
{
    static constexpr const char* name = "countFlying";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    const unsigned char* near;

    HD void add(int i, double* sums) const { if (!near[i]) sums[0] += particles.start[i + 1] - particles.start[i]; }
};

} // namespace riprap
