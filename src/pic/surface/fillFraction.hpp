/*  The surface held by the particles.

    The fill of a cell is what the particles put there, alpha = V_p/V_c sum_p W(x_c - x_p) with the quadratic spline. Under a flat surface at the
    distance phi it is the spline's integral up to -phi:  alpha = 1/2 + (3/4 t - t^3/3), t = -phi/h, |t| < 1/2. The phi so found is rough, as
    particles are, but it does not drift. So the carried phi is left alone as long as it agrees with the particles to within `tolerance` cells, and
    taken to the edge of that range where it does not: water that broke up or was lost by the advection is put right,
    and a pool at rest stays flat however its particles lie.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/extendSurface.hpp"
#include "pic/transfer/near.hpp"

namespace riprap
{

//- In cells: how far the carried surface and that of the particles may differ
static constexpr double surfaceTolerance = 0.3;

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

template<int D, class R>
HD R fillOf(const UniformGrid<D>& g, const PicParticles<D, R>& particles, const typename UniformGrid<D>::Index& c, R particleCells)
{
    double node[D];
    for (int d = 0; d < D; ++d) node[d] = c.c[d] + 0.5;
    const double inverse = 1/g.h, reach = BSpline<2>::support;
    R sum = 0;
    forEachImage<D>(g, node, reach, [&](const double* s)
    {
        forEachNear<D>(g, particles.start, s, reach, [&](int p)
        {
            R w = 1;
            for (int d = 0; d < D; ++d) w *= BSpline<2>::value(R(s[d] - particles.x[d][p]*inverse));
            sum += w;
        });
    });
    return sum*particleCells;
}

template<int D, class R>
struct HoldSurface
{
    static constexpr const char* name = "holdSurface";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    R particleCells;            // volume of a particle in cells
    const R* open;              // cells: their open parts, and what particles can fill of their neighbourhoods (cutCells/
    const R* openWeight;        // extendSurface.hpp); nullptr: no solids
    R* phi;
    R band;

    HD void operator()(int i) const
    {
        if (open && open[i] < R(knownOpening)) return;
        const R h = R(grid.h);
        // deep in the water a void among particles is no bubble; far above it a single particle is no water
        if (absolute(phi[i]) >= band || phi[i] < R(-1.5)*h) return;
        const R alpha = fillOf(grid, particles, grid.cellIndex(i), openWeight ? particleCells/openWeight[i] : particleCells);
        const R own = surfaceOfFill(alpha)*h, tolerance = R(surfaceTolerance)*h;
        if (own - tolerance > 0) phi[i] = maximum(phi[i], own - tolerance);
        if (own + tolerance < 0) phi[i] = minimum(phi[i], own + tolerance);
    }
};

} // namespace riprap
