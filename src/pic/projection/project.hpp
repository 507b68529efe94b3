/*  What follows from the pressure: u = u* - dt/rho grad p on every open face that has a wet cell on
    either side, with the gradient that the equation was made of, so that the fluxes of a wet cell
    sum to zero as closely as it was solved.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/extrapolate.hpp"
#include "pic/pressure/assemble.hpp"

namespace riprap
{

//- p back in the order of the grid, 0 in dry cells
template<int D, class R>
struct StorePressure
{
    static constexpr const char* name = "pressureStore";
    UniformGrid<D> grid;
    const int* wet;
    FineData<D> fine;
    double* p;

    HD void operator()(int i) const
    {
        const auto x = grid.cellIndex(i);
        int c = 0;
        for (int d = 0; d < D; ++d) c += x.c[d]*fine.shape.stride[d];
        p[i] = wet[i] ? fine.x[c] : 0;
    }
};

//- The same row by row of tiles; flag: of those that have a wet cell
template<int D, class R>
struct StorePressureRows
{
    static constexpr const char* name = "pressureStore";
    static constexpr int rowsLog = tileCellsLog - tileLog<D>(0);
    UniformGrid<D> grid;
    const int* wet;
    const int* flag;
    FineData<D> fine;
    double* p;

    HD void operator()(int i) const
    {
        const int tile = i >> rowsLog;
        const Place<D> c = rowOfTile(fine.shape, tile, i & ((1 << rowsLog) - 1));
        if (!fine.shape.inside(c)) return;
        const int first = grid.cell(gridIndex<D>(c)),
                  count = grid.n[0] - c.x[0] < rowCells ? grid.n[0] - c.x[0] : rowCells;
        if (flag[tile])
        {
            INDEPENDENT
            for (int k = 0; k < count; ++k)
            {
                const double value = fine.x[c.c + k];
                p[first + k] = wet[first + k] ? value : 0.0;
            }
        }
        else for (int k = 0; k < count; ++k) p[first + k] = 0;
    }
};

//- Velocity of face i of direction d
template<int D, class R>
struct CorrectVelocity
{
    static constexpr const char* name = "pressureProject";
    PressureFields<D, R> f;
    const int* wet;
    int d;

    HD void operator()(int i) const { (*this)(i, f.grid.faceIndex(d, i)); }

    HD void operator()(int i, const typename UniformGrid<D>::Index& x) const
    {
        if (!(f.aperture[d][i] > R(0))) return;
        const int lower = f.grid.cellOf(d, x, 0), upper = f.grid.cellOf(d, x, 1);
        const bool wetLower = lower >= 0 && wet[lower], wetUpper = upper >= 0 && wet[upper];
        if (!wetLower && !wetUpper) return;
        double difference;
        if (wetLower && wetUpper) difference = f.p[upper] - f.p[lower];
        else if (wetUpper)
            difference = f.p[upper]
                /(lower < 0 ? endTheta : surfaceTheta(f.phi[upper], f.phi[lower]));
        else
            difference = -f.p[lower]
                /(upper < 0 ? endTheta : surfaceTheta(f.phi[lower], f.phi[upper]));
        f.u[d][i] = R(double(f.u[d][i]) - f.timeStep/(f.density*f.grid.h)*difference);
    }

    //- The faces of a row from number i and indices x on, up to before `end`: those between two wet
    //  cells in registers
    HD void row(int i, typename UniformGrid<D>::Index x, int end) const
    {
        const int number = i - x.c[0];
        const auto one = [&](int k)
        {
            typename UniformGrid<D>::Index at = x;
            at.c[0] = k;
            (*this)(number + k, at);
        };
        int from = x.c[0], to = end;
        if (d > 0 && (x.c[d] == 0 || x.c[d] == f.grid.n[d]))
        {
            for (; from < to; ++from) one(from);
            return;
        }
        if (d == 0 && from == 0) one(from++);
        if (d == 0 && to == f.grid.n[0] + 1 && to > from) one(--to);
        int stride = 1;
        for (int a = 0; a < d; ++a) stride *= f.grid.n[a];
        constexpr int most = 33;
        double after[most];
        const int count = to - from, upper = f.grid.cell(x) - x.c[0] + from, face = number + from;
        const double scale = f.timeStep/(f.density*f.grid.h);
        R* u = f.u[d] + face;
        const R* a = f.aperture[d] + face;
        int surface = 0;
        INDEPENDENT
        for (int k = 0; k < count; ++k)
        {
            after[k] = double(u[k]) - scale*(f.p[upper + k] - f.p[upper + k - stride]);
            surface |= wet[upper + k] ^ wet[upper + k - stride];
        }
        INDEPENDENT
        for (int k = 0; k < count; ++k)
        {
            const R before = u[k], corrected = R(after[k]);
            const int both = wet[upper + k] & wet[upper + k - stride] & int(a[k] > R(0));
            u[k] = both ? corrected : before;
        }
        if (surface)
            for (int k = 0; k < count; ++k)
                if (wet[upper + k] != wet[upper + k - stride]) one(from + k);
    }
};

} // namespace riprap
