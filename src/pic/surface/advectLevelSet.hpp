/*  The surface carried by the flow: phi(x) becomes the phi where the flow came from, at a distance
    dt.

    The way back is a Runge-Kutta step of order 3 in the extended velocity (semi-Lagrangian: Strain
    1999, J. Comput. Phys. 151); phi there comes from the cubic polynomials through four cells an
    axis, kept within the values of the cells around the point so that a kink cannot ring. Only
    cells within the band are carried; beyond it phi is the band's width.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/moveParticles.hpp"

namespace riprap
{

//- Weights of the cubic through the values at -1, 0, 1, 2 at a point f in 0 .. 1
template<class R>
HD void cubicWeights(R f, R* w)
{
    w[0] = -f*(f - 1)*(f - 2)/6;
    w[1] = (f + 1)*(f - 1)*(f - 2)/2;
    w[2] = -(f + 1)*f*(f - 2)/2;
    w[3] = (f + 1)*f*(f - 1)/6;
}

//- A field of cells at a point, cubic, within the values of the 2^D cells around it
template<int D, class R>
HD R cubicAt(const UniformGrid<D>& g, const R* a, const Vec<D, double>& x)
{
    typename UniformGrid<D>::Index first{{0, 0, 0}};
    R w[D][4];
    UNROLL
    for (int d = 0; d < D; ++d)
    {
        const double s = x.c[d]/g.h - 0.5;
        first.c[d] = floorInt(s) - 1;
        cubicWeights(R(s - first.c[d] - 1), w[d]);
    }
    if (g.part) for (int d = 0; d < D; ++d) first.c[d] -= g.first[d];
    bool in = true;
    for (int d = 0; d < D; ++d) in = in && first.c[d] >= 0 && first.c[d] + 3 < g.n[d];
    R sum = 0, low = R(1e30), high = R(-1e30);
    UNROLL
    for (int k = 0; k < (D == 3 ? 4 : 1); ++k)
        UNROLL
        for (int j = 0; j < 4; ++j)
            UNROLL
            for (int i = 0; i < 4; ++i)
            {
                typename UniformGrid<D>::Index at{{first.c[0] + i, first.c[1] + j, 0}};
                R weight = w[0][i]*w[1][j];
                bool around = (i == 1 || i == 2) && (j == 1 || j == 2);
                if constexpr (D == 3)
                {
                    at.c[2] = first.c[2] + k;
                    weight *= w[2][k];
                    around = around && (k == 1 || k == 2);
                }
                const R value = in ? a[g.cell(at)] : cellValue(g, a, at);
                sum += weight*value;
                if (around) { low = minimum(low, value); high = maximum(high, value); }
            }
    return maximum(low, minimum(sum, high));
}

template<int Order, int D, class R, bool Around = true>
struct AdvectLevelSet
{
    static constexpr const char* name = "advectLevelSet";
    UniformGrid<D> grid;
    const R* u[D];
    const R* from;
    R* to;
    double timeStep;
    R band;                     // [m]

    HD void operator()(int i) const { (*this)(i, grid.cellIndex(i)); }

    HD void operator()(int i, const typename UniformGrid<D>::Index& c) const
    {
        if (absolute(from[i]) >= band) { to[i] = from[i]; return; }
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = (c.c[d] + 0.5)*grid.h;
        if (grid.part)
            for (int d = 0; d < D; ++d) x.c[d] = (grid.first[d] + c.c[d] + 0.5)*grid.h;
        to[i] = cubicAt(
            grid, from, intoBlock(grid, carried<Order, Around>(grid, u, x, -timeStep, 3)));
    }
};

} // namespace riprap
