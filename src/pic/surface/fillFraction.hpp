/*  The surface held by the particles.

    The fill of a cell is what the particles put there, alpha = V_p/V_c sum_p W(x_c - x_p) with the
    quadratic spline. Under a flat surface at the
    distance phi it is the spline's integral up to -phi: alpha = 1/2 + (3/4 t - t^3/3), t = -phi/h,
    |t| < 1/2. The phi so found is rough, as
    particles are, but it does not drift. So the carried phi is left alone but where a cell is as
    good as full and phi says that it is dry, or as good as empty and phi says wet: there it is
    taken to the least that makes the cell what it is. Water that broke up or was lost by the
    advection is put right, and a pool at rest stays flat however its particles lie.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/extendSurface.hpp"
#include "pic/grid/particles.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

//- In cells: the surface that the fill tells must be further away than this for the cell to be held
//  by it. The fill tells half a cell at most, and cells are wet from 0.01 cells on (wetDepth), so
//  0.49 would be the weakest hold that makes full cells wet and empty ones dry; 0.45 allows
//  particles to leave one fortieth of the cell empty. A stronger one moves surfaces that the flow
//  carries right: 0.3 feeds waves 1.4 % in 25 periods (docs/verification/picSloshing.md)
static constexpr double surfaceTolerance = 0.45;

//- phi/h of a flat surface that fills a cell's neighbourhood to alpha, within +-1/2
template<class R>
HD R surfaceOfFill(R alpha)
{
    const R half = R(0.5), full = R(1.0/3.0);           // alpha - 1/2 at t = 1/2
    const R fill = maximum(-full, minimum(alpha - half, full));
    R t = fill/R(0.75);
    for (int k = 0; k < 4; ++k) t -= (R(0.75)*t - t*t*t/3 - fill)/maximum(R(0.75) - t*t, R(0.25));
    return -maximum(-half, minimum(t, half));
}

//- The spline of a cell's middle for a particle at t in a cell `offset` further, seen in a mirror
//  or not
template<class R>
HD R fillWeight(int offset, bool mirrored, R t)
{
    if (offset == 0) return R(0.75) - (t - R(0.5))*(t - R(0.5));
    return (offset < 0) != mirrored ? R(0.5)*t*t : R(0.5)*(1 - t)*(1 - t);
}

//- From the particles of the cells about cell c; beyond the sides stand those cells' mirror images,
//  or what comes around
template<int D, class R>
HD R fillOf(const UniformGrid<D>& g, const PicParticles<D, R>& particles,
    const typename UniformGrid<D>::Index& c, R particleCells)
{
    const bool in = inner(g, c, 1);
    R sum = 0;
    for (int k = (D == 3 ? -1 : 0); k <= (D == 3 ? 1 : 0); ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
            {
                const int offset[3] = {i, j, k};
                typename UniformGrid<D>::Index at = c;
                bool mirrored[3] = {false, false, false};
                for (int d = 0; d < D; ++d)
                {
                    at.c[d] += offset[d];
                    if (in) continue;
                    mirrored[d] = !g.periodic[d] && (at.c[d] < 0 || at.c[d] >= g.n[d]);
                    at.c[d] = evenNode(g, d, at.c[d]);
                }
                const int cell = g.cell(at);
                for (int p = particles.start[cell]; p < particles.start[cell + 1]; ++p)
                {
                    const PlaceInCell<R> place = particles.place[p];
                    R w = 1;
                    for (int d = 0; d < D; ++d) w *= fillWeight(offset[d], mirrored[d], place.t[d]);
                    sum += w;
                }
            }
    return sum*particleCells;
}

template<int D, class R>
struct HoldSurface
{
    static constexpr const char* name = "holdSurface";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    R particleCells;            // volume of a particle in cells
    // cells: their open parts, and what particles can fill of their neighbourhoods (cutCells/
    const R* open;
    const R* openWeight;        // extendSurface.hpp); nullptr: no solids
    R* phi;
    R band;

    HD void operator()(int i, const typename UniformGrid<D>::Index& c) const
    {
        if (open && open[i] < R(knownOpening)) return;
        const R h = R(grid.h);
        // deep in the water a void among particles is no bubble; far above it a single particle is
        // no water
        if (absolute(phi[i]) >= band || phi[i] < R(-1.5)*h) return;
        const R alpha = fillOf(
            grid, particles, c, openWeight ? particleCells/openWeight[i] : particleCells);
        const R own = surfaceOfFill(alpha)*h, tolerance = R(surfaceTolerance)*h;
        if (own - tolerance > 0) phi[i] = maximum(phi[i], own - tolerance);
        if (own + tolerance < 0) phi[i] = minimum(phi[i], own + tolerance);
    }
};

} // namespace riprap
