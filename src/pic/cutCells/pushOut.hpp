/*  Particles that have come into a solid are put on its surface, the shortest way, and lose the
    velocity into it, and what the correction of positions gave them for the way into it. Nothing
    thin is passed on that way.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/solidField.hpp"
#include "pic/transfer/positionCorrection.hpp"
#include "pic/transfer/stopAtFaces.hpp"

namespace riprap
{

template<int D, class R>
struct PushOut
{
    static constexpr const char* name = "pushOut";
    // where surfaces are bent the first way out ends beside the surface
    static constexpr int passes = 3;
    SolidField<D, R> solids;
    PicParticles<D, R> particles;
    double margin;                              // [m]
    R* shift[D];                                // of the correction [m]; nullptr: there is none
    // those that stood in such tiles are left alone: cells of the first ones
    TileChoice<D> waiting;
    const std::uint32_t* from;
    int first;

    HD void operator()(int i) const
    {
        const UniformGrid<D>& grid = solids.grid;
        if (waiting.state && i < first && waiting.has(grid.cellIndex(int(from[i])))) return;
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        Vec<D, double> x, normal;
        bool inside = true;
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = particles.x[d][i];
            c.c[d] = floorInt(x.c[d]/grid.h) - (grid.part ? grid.first[d] : 0);
            inside = inside && c.c[d] >= 0 && c.c[d] < grid.n[d];
        }
        if (!inside || solids.distance[NodeGrid<D>{grid}.node(c)] > clearOfCell*grid.h + margin
            || solids.clear(c, margin))
            return;
        if (!(solids.at(x, normal) < margin)) return;
        const Vec<D, double> before = x;
        for (int pass = 0; pass < passes; ++pass)
        {
            const double distance = solids.at(x, normal);
            if (!(distance < margin)) break;
            const double slope = std::sqrt(squaredNorm(normal));
            // deeper than distances are known, or between two solids
            if (!(slope > 0.1)) break;
            x = x + ((margin - distance)/maximum(slope, 0.5)/slope)*normal;
            for (int d = 0; d < D; ++d)
            {
                double start = margin;
                const int end = grid.n[d] + (grid.part ? grid.first[d] : 0);
                if (grid.part) start += grid.low(d);
                x.c[d] = maximum(start, minimum(x.c[d], end*grid.h - margin));
            }
        }
        stopAtFaces(
            grid, c, x, margin, [&](int d, int face) { return solids.sealed[d][face] != 0; });
        for (int d = 0; d < D; ++d) takeBack(particles, shift, i, d, x.c[d] - before.c[d]);
        const double slope2 = squaredNorm(normal);
        const Vec<D, R> wall = solids.velocity(before);
        double into = 0;
        for (int d = 0; d < D; ++d) into += normal.c[d]*double(particles.v[d][i] - wall.c[d]);
        for (int d = 0; d < D; ++d)
        {
            particles.x[d][i] = x.c[d];
            if (into < 0 && slope2 > 0.01) particles.v[d][i] -= R(into*normal.c[d]/slope2);
        }
    }
};

} // namespace riprap
