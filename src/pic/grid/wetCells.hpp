/*  Which cells are wet, and which have water about them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/particles.hpp"
#include "pic/grid/pressureFields.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

template<int D, class R>
struct MarkWetCells
{
    static constexpr const char* name = "markWetCells";
    PressureFields<D, R> fields;
    unsigned char* wet;
    HD void operator()(int i) const { (*this)(i, fields.grid.cellIndex(i)); }
    HD void operator()(int i, const typename UniformGrid<D>::Index& c) const
    {
        wet[i] = isWet(fields, i, c);
    }

    //- A row of cells from number i and indices c on, up to before `end`: most lie wholly outside
    HD void row(int i, typename UniformGrid<D>::Index c, int end) const
    {
        const R surface = R(-wetDepth*fields.grid.h);
        const int count = end - c.c[0];
        int deep = 0;
        for (int k = 0; k < count; ++k)
        {
            deep |= fields.phi[i + k] < surface;
            wet[i + k] = 0;
        }
        if (deep) for (int k = 0; k < count; ++k, ++c.c[0]) (*this)(i + k, c);
    }
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

    HD void operator()(int i) const { (*this)(i, grid.cellIndex(i)); }

    HD void operator()(int i, const typename UniformGrid<D>::Index& c) const
    {
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

    //- A row of cells from number i and indices c on, up to before `end`
    HD void row(int i, typename UniformGrid<D>::Index c, int end) const
    {
        bool in = true;
        for (int d = 1; d < D; ++d) in = in && c.c[d] >= 1 && c.c[d] < grid.n[d] - 1;
        const int number = i - c.c[0];
        const auto one = [&](int x)
        {
            typename UniformGrid<D>::Index at = c;
            at.c[0] = x;
            (*this)(number + x, at);
        };
        int from = c.c[0], to = end;
        if (!in) { for (int x = from; x < to; ++x) one(x); return; }
        if (from == 0) one(from++);
        if (to == grid.n[0] && to > from) one(--to);
        const unsigned char* own = wet + number;
        for (int x = from; x < to; ++x)
        {
            unsigned char some = 0, all = 1;
            for (int k = (D == 3 ? -1 : 0); k <= (D == 3 ? 1 : 0); ++k)
                for (int j = -1; j <= 1; ++j)
                    for (int l = -1; l <= 1; ++l)
                    {
                        const unsigned char w = own[x + l + grid.n[0]*(j + grid.n[1]*k)];
                        some |= w;
                        all &= w;
                    }
            near[number + x] = all ? allWater : (some ? someWater : 0);
        }
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

    HD void add(int i, double* sums) const
    {
        if (!near[i]) sums[0] += particles.start[i + 1] - particles.start[i];
    }
};

} // namespace riprap
