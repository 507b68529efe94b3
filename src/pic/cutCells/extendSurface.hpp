/*  The surface beside solids: what particles can fill there, and phi within.

    A particle fills the cells about it by the quadratic spline; beside a solid only the open part
    of that can ever be filled,

        w_c = sum over the cells n about c of (1/6, 2/3, 1/6)-products times open_n,

    so the fill that tells of the surface is that of the particles over w_c. Cells of which less
    than half is open do not ask the particles: phi is continued into them and on into the solid,
    layer by layer, linear where it is smooth: the surface meets a wall as it comes.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/mirror.hpp"

namespace riprap
{

//- Cells more open than this know their own surface
static constexpr double knownOpening = 0.5;

template<int D, class R>
struct OpenWeights
{
    static constexpr const char* name = "openWeights";
    UniformGrid<D> grid;
    const R* open;
    R* weight;

    HD void operator()(int i) const
    {
        const typename UniformGrid<D>::Index c = grid.cellIndex(i);
        const bool in = inner(grid, c, 1);
        R sum = 0;
        for (int k = (D == 3 ? -1 : 0); k <= (D == 3 ? 1 : 0); ++k)
            for (int j = -1; j <= 1; ++j)
                for (int l = -1; l <= 1; ++l)
                {
                    const R w = part(l)*part(j)*(D == 3 ? part(k) : R(1));
                    sum += w
                        *(in ? open[i + l + grid.n[0]*(j + grid.n[1]*k)]
                              : cellValue(grid, open,
                                  typename UniformGrid<D>::Index{
                                      {c.c[0] + l, c.c[1] + j, c.c[2] + k}}));
                }
        weight[i] = sum;
    }

private:

    HD static R part(int offset) { return offset == 0 ? R(2.0/3.0) : R(1.0/6.0); }
};

//- Layers of cells: 0 knows, the pass that has filled it, or not yet
static constexpr unsigned char unknownCell = 255;

template<class R>
struct MarkKnownCells
{
    static constexpr const char* name = "markKnownCells";
    const R* open;
    unsigned char* layer;
    HD void operator()(int i) const { layer[i] = open[i] >= R(knownOpening) ? 0 : unknownCell; }
};

template<int D, class R>
struct ExtendSurface
{
    static constexpr const char* name = "extendSurface";
    UniformGrid<D> grid;
    unsigned char pass;         // 1, 2, ...
    unsigned char* layer;
    R* phi;
    R band;

    HD void operator()(int i) const { (*this)(i, grid.cellIndex(i)); }

    HD void operator()(int i, const typename UniformGrid<D>::Index& c) const
    {
        if (layer[i] != unknownCell) return;
        R sum = 0;
        int count = 0;
        for (int d = 0; d < D; ++d)
            for (int direction = -1; direction <= 1; direction += 2)
            {
                const int one = known(c, d, direction);
                if (one < 0) continue;
                const int two = known(c, d, 2*direction),
                          three = two < 0 ? -1 : known(c, d, 3*direction);
                sum += continued(one, two, three);
                ++count;
            }
        if (!count) return;
        phi[i] = maximum(-band, minimum(sum/count, band));
        layer[i] = pass;
    }

private:

    HD int known(typename UniformGrid<D>::Index c, int d, int offset) const
    {
        c.c[d] += offset;
        if (c.c[d] < 0 || c.c[d] >= grid.n[d])
        {
            if (!grid.periodic[d]) return -1;
            c.c[d] += c.c[d] < 0 ? grid.n[d] : -grid.n[d];
        }
        const int j = grid.cell(c);
        return layer[j] < pass ? j : -1;
    }

    HD R continued(int one, int two, int three) const
    {
        if (three < 0)
            return two < 0
                ? phi[one]
                : phi[one] + maximum(-R(grid.h), minimum(phi[one] - phi[two], R(grid.h)));
        const R s = phi[one] - phi[two], t = phi[two] - phi[three];
        if (s*t <= 0) return phi[one];
        return phi[one] + (absolute(s) < absolute(t) ? s : t);
    }
};

} // namespace riprap
