/*  The pressure equation of one cell (paper 2, Eqs. 3 to 5), times rho h/|S|, so that its
    coefficients are pure numbers:

        sum over faces of a (p_c - p_n)  =  -(rho h/dt) sum over faces of +-(a u* + (1 - a) w)

    a: open part of the face, w: velocity of the wall that closes the rest, + where the face's
    direction points out of the cell. Towards a dry cell p = 0 lies at theta = phi_c/(phi_c - phi_n)
    of the distance (ghost fluid: Gibou et al. 2002, J. Comput. Phys. 176, 205): the term is a
    p_c/theta. At an open end of the block p = 0 at the face itself: 2 a p_c.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/deterministicAtomics.hpp"
#include "pic/pressure/conjugateGradient.hpp"
#include "pic/grid/pressureFields.hpp"

namespace riprap
{

//- p = 0 at an open end lies half a cell from the centre
static constexpr double endTheta = 0.5;

//- Part of the distance from a wet cell to a dry one that lies in water
template<class R>
HD double surfaceTheta(R wet, R dry)
{
    const double theta = double(wet)/(double(wet) - double(dry));
    return theta > smallestTheta ? theta : smallestTheta;
}

template<int D>
HD typename UniformGrid<D>::Index gridIndex(const Place<D>& c)
{
    typename UniformGrid<D>::Index x{{0, 0, 0}};
    for (int d = 0; d < D; ++d) x.c[d] = c.x[d];
    return x;
}

//- Which cells are wet: 1 or 0, in the order of the grid
template<int D, class R>
struct MarkWet
{
    static constexpr const char* name = "pressureMarkWet";
    PressureFields<D, R> f;
    int* wet;

    HD void operator()(int i) const { wet[i] = isWet(f, i, f.grid.cellIndex(i)); }
};

//- The same row by row of tiles; flag: of tiles, raised where a cell is wet
template<int D, class R>
struct MarkWetRows
{
    static constexpr const char* name = "pressureMarkWet";
    static constexpr int rowsLog = tileCellsLog - tileLog<D>(0);
    PressureFields<D, R> f;
    GridShape<D> shape;
    int* wet;
    int* flag;

    HD void operator()(int i) const
    {
        const int tile = i >> rowsLog;
        const Place<D> p = rowOfTile(shape, tile, i & ((1 << rowsLog) - 1));
        if (!shape.inside(p)) return;
        auto x = gridIndex<D>(p);
        const int first = f.grid.cell(x),
                  count = shape.n[0] - p.x[0] < rowCells ? shape.n[0] - p.x[0] : rowCells;
        const R surface = R(-wetDepth*f.grid.h);
        int deep = 0;
        for (int k = 0; k < count; ++k)
        {
            deep |= f.phi[first + k] < surface;
            wet[first + k] = 0;
        }
        if (!deep) return;
        int any = 0;
        for (int k = 0; k < count; ++k, ++x.c[0]) any |= wet[first + k] = isWet(f, first + k, x);
        if (any) raise(flag + tile);
    }
};

//- What leaves a cell through its faces, over their area [m/s]
template<int D, class R>
HD double outflow(const PressureFields<D, R>& f, const typename UniformGrid<D>::Index& x)
{
    double flux = 0;
    for (int d = 0; d < D; ++d)
        for (int side = 0; side < 2; ++side)
        {
            const int face = f.grid.faceOf(d, x, side);
            const double a = f.aperture[d][face],
                         wall = f.wallVelocity[d] ? (1 - a)*double(f.wallVelocity[d][face]) : 0;
            flux += (side ? 1 : -1)*(a*double(f.u[d][face]) + wall);
        }
    return flux;
}

template<int D, class R>
struct Assemble
{
    static constexpr const char* name = "pressureAssemble";
    PressureFields<D, R> f;
    const int* wet;
    FineData<D> out;

    HD void operator()(int i) const { cell(out.shape.place(i)); }

    HD void cell(const Place<D>& c) const
    {
        const int i = c.c;
        double lower[D], s = 0, flux = 0, guess = 0;
        for (int d = 0; d < D; ++d) lower[d] = 0;
        if (out.shape.inside(c))
        {
            const auto x = gridIndex<D>(c);
            const int cell = f.grid.cell(x);
            if (wet[cell])
            {
                guess = f.p[cell];
                flux = outflow(f, x);
                for (int d = 0; d < D; ++d)
                    for (int side = 0; side < 2; ++side)
                    {
                        const double a = f.aperture[d][f.grid.faceOf(d, x, side)];
                        if (!(a > 0)) continue;
                        const int n = f.grid.neighbour(x, d, side ? 1 : -1);
                        if (n < 0) s += a/endTheta;
                        else if (!wet[n]) s += a/surfaceTheta(f.phi[cell], f.phi[n]);
                        // its own neighbour in a ring of one: no force
                        else if (side == 0 && n != cell) lower[d] = a;
                    }
            }
        }
        for (int d = 0; d < D; ++d) out.a[d][i] = lower[d];
        out.s[i] = s;
        out.rhs[i] = -f.density*f.grid.h/f.timeStep*flux;
        out.x[i] = guess;
    }
};

//- The same where the coefficients are those of the last projection: of the active tiles only
template<int D, class R>
struct AssembleSource
{
    static constexpr const char* name = "pressureSource";
    PressureFields<D, R> f;
    const int* wet;
    FineData<D> out;
    TiledCells<D> cells;

    HD void operator()(int i) const
    {
        Place<D> c;
        if (!cells.at(i, c)) return;
        double flux = 0, guess = 0;
        if (out.shape.inside(c))
        {
            const auto x = gridIndex<D>(c);
            const int cell = f.grid.cell(x);
            if (wet[cell])
            {
                flux = outflow(f, x);
                if (out.inverse[c.c] > 0) guess = f.p[cell];
            }
        }
        out.rhs[c.c] = -f.density*f.grid.h/f.timeStep*flux;
        out.x[c.c] = guess;
    }

    HD void row(const Place<D>& first) const
    {
        const bool in = out.shape.inside(first);
        const int count = !in
            ? 0
            : (out.shape.n[0] - first.x[0] < rowCells ? out.shape.n[0] - first.x[0] : rowCells);
        double flux[rowCells];
        for (int k = 0; k < rowCells; ++k) flux[k] = 0;
        const auto x = gridIndex<D>(first);
        for (int d = 0; d < D && in; ++d)
        {
            const int low = f.grid.faceOf(d, x, 0), high = f.grid.faceOf(d, x, 1);
            const R* a = f.aperture[d];
            const R* u = f.u[d];
            INDEPENDENT
            for (int k = 0; k < count; ++k)
                flux[k] += double(a[high + k])*double(u[high + k])
                    - double(a[low + k])*double(u[low + k]);
            const R* w = f.wallVelocity[d];
            if (!w) continue;
            INDEPENDENT
            for (int k = 0; k < count; ++k)
                flux[k] += (1 - double(a[high + k]))*double(w[high + k])
                    - (1 - double(a[low + k]))*double(w[low + k]);
        }
        const int cell = in ? f.grid.cell(x) : 0;
        const double scale = -f.density*f.grid.h/f.timeStep;
        INDEPENDENT
        for (int k = 0; k < count; ++k) flux[k] *= scale;
        INDEPENDENT
        for (int k = 0; k < count; ++k)
        {
            const bool is = wet[cell + k] != 0, unknown = out.inverse[first.c + k] > 0;
            const double guess = f.p[cell + k];
            out.rhs[first.c + k] = is ? flux[k] : 0.0;
            out.x[first.c + k] = is & unknown ? guess : 0.0;
        }
        for (int k = count; k < rowCells; ++k) out.rhs[first.c + k] = out.x[first.c + k] = 0;
    }
};

} // namespace riprap
