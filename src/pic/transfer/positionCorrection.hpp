/*  Keeps particles apart: each is pushed away from those closer than the spacing s,

        shift = c |v| dt sum_j (1 - |r_ij|/s)^2 r_ij/|r_ij|

    like the weak springs of Ando, Thuerey & Tsuruno (2012), IEEE Trans. Vis. Comput. Graph. 18, but
    by a share of the particle's own path, so that water at rest stays as it is. Particles that know
    the velocity's gradient take the velocity of their new place: without, what they carry would be
    off by an error of the order of h; where walls then keep them from going there it is taken back
    (takeBack). Near the surface only the part along the surface is taken.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/loops/rows.hpp"
#include "pic/grid/particles.hpp"
#include "pic/grid/tiles.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

//- Along d a wall has put a particle back by so much: as far as the correction had pushed it there,
//  with the velocity that this has given it
template<int D, class R>
HD void takeBack(const PicParticles<D, R>& particles, R* const* shift, int i, int d, double by)
{
    if (!shift[0] || !particles.affine[0]) return;
    R& s = shift[d][i];
    const R back = s > 0 ? maximum(-s, minimum(R(by), R(0))) : minimum(-s, maximum(R(by), R(0)));
    if (back == R(0)) return;
    s += back;
    for (int a = 0; a < D; ++a) particles.v[a][i] += particles.affine[a*D + d][i]*back;
}

//- InRegisters: for the CPU, pairs eight at a time
template<int D, class R, bool InRegisters = false>
struct CorrectPositions
{
    static constexpr const char* name = "correctPositions";
    // measured to be fastest
    static constexpr int residentBlocks = D == 3 && sizeof(R) == 4 ? 8 : 0;
    static constexpr double largest = 0.1;      // of the spacing, a step
    // cells: the surface is farther from all of a cell than one cell if from its middle by so much
    static constexpr double deep = 3.5;
    UniformGrid<D> grid;
    double inverse;             // 1/h
    PicParticles<D, R> particles;
    const R* phi;
    const unsigned char* nearWater;
    R* shift[D];
    R strength;                 // c dt [s]
    R spacing;                  // s [m]
    TileChoice<D> only;         // particles there

    HD void operator()(int i) const
    {
        const Vec<D, double> x = particles.position(i);
        const InCell<D, R> at(grid, inverse, x);
        if (!only.has(at.index())) return;
        R push[D], speed2 = 0;
        for (int d = 0; d < D; ++d)
        {
            push[d] = 0;
            speed2 += particles.v[d][i]*particles.v[d][i];
            shift[d][i] = 0;
        }
        const int cell = at.cell(grid);
        if (!nearWater[cell] || !(speed2 > R(0))) return;
        if constexpr (InRegisters) addPushesInRegisters(at, i, push);
        else addPushes(at, i, push);
        if (phi[cell] > R(-deep*grid.h) && sampleCell<1>(grid, phi, x) > R(-grid.h))
            keepAlongSurface(x, push);
        const R length = strength*squareRoot(speed2), bound = R(largest)*spacing;
        for (int d = 0; d < D; ++d)
            shift[d][i] = push[d] = maximum(-bound, minimum(length*push[d], bound));
        if (!particles.affine[0]) return;
        // the velocity becomes that of the new place, as far as the particle knows it
        for (int d = 0; d < D; ++d)
            for (int a = 0; a < D; ++a)
                particles.v[d][i] += particles.affine[d*D + a][i]*push[a];
    }

private:

    //- Cells within reach of a particle
    HD void cellsWithin(
        const InCell<D, R>& at, const PlaceInCell<R>& own, R reach, int* low, int* high) const
    {
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            low[a] = at.c[a] + floorInt(own.t[a] - reach);
            high[a] = at.c[a] + floorInt(own.t[a] + reach);
            low[a] = low[a] < 0 ? 0 : low[a];
            high[a] = high[a] >= grid.n[a] ? grid.n[a] - 1 : high[a];
        }
    }

    //- From the particles of the cells that lie within reach, row by row
    HD void addPushes(const InCell<D, R>& at, int i, R* push) const
    {
        const PlaceInCell<R> own = particles.place[i];
        const R reach = spacing*R(inverse), perReach = 1/reach;           // in cells
        int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        cellsWithin(at, own, reach, low, high);
        for (int k = low[2]; k <= high[2]; ++k)
            for (int j = low[1]; j <= high[1]; ++j)
            {
                const int row = grid.n[0]*(j + grid.n[1]*k),
                          to = particles.start[row + high[0] + 1];
                const R y = own.t[1] + R(at.c[1] - j),
                        z = D == 3 ? own.t[2] + R(at.c[D - 1] - k) : R(0);
                for (int p = particles.start[row + low[0]]; p < to; ++p)
                {
                    const PlaceInCell<R> other = particles.place[p];
                    const R r[3] = {own.t[0] - other.t[0] + (own.cell - other.cell), y - other.t[1],
                        D == 3 ? z - other.t[2] : R(0)};
                    const R r2 = r[0]*r[0] + r[1]*r[1] + r[2]*r[2];
                    if (!(r2 < reach*reach) || !(r2 > R(0))) continue;
                    const R perDistance = inverseRoot(r2), q = 1 - r2*perDistance*perReach,
                            part = q*q*perDistance;
                    for (int d = 0; d < D; ++d) push[d] += part*r[d];
                }
            }
    }

#ifndef __CUDACC__
    //- The same, pairs in the lanes of a register
    void addPushesInRegisters(const InCell<D, R>& at, int i, R* push) const
    {
        using Lanes = Pack<R>;
        const PlaceInCell<R> own = particles.place[i];
        const R reach = spacing*R(inverse);
        const Lanes perReach(1/reach), reach2(reach*reach), none(R(0)), one(R(1));
        int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        cellsWithin(at, own, reach, low, high);
        Lanes sum[D];
        for (int d = 0; d < D; ++d) sum[d] = none;
        for (int k = low[2]; k <= high[2]; ++k)
            for (int j = low[1]; j <= high[1]; ++j)
            {
                const int row = grid.n[0]*(j + grid.n[1]*k),
                          to = particles.start[row + high[0] + 1];
                Lanes from[D];
                from[0] = Lanes(own.t[0]);
                from[1] = Lanes(own.t[1] + R(at.c[1] - j));
                if constexpr (D == 3) from[2] = Lanes(own.t[2] + R(at.c[2] - k));
                for (int p = particles.start[row + low[0]]; p < to; p += Lanes::width)
                {
                    Lanes other[4], r[D];
                    loadRows([&](int l) { return particles.place[p + l].t; }, other);
                    for (int d = 0; d < D; ++d) r[d] = from[d] - other[d];
                    r[0] += Lanes(own.cell) - other[3];
                    Lanes r2 = r[0]*r[0];
                    for (int d = 1; d < D; ++d) r2 += r[d]*r[d];
                    r2 = keepFirst(r2, to - p, reach*reach);
                    const typename Lanes::mask pushes = (r2.v > none.v) & (r2.v < reach2.v);
                    const Lanes safe(pushes ? r2.v : reach2.v),
                        perDistance = inverseRoot(safe), q = one - safe*perDistance*perReach;
                    const Lanes part(pushes ? (q*q*perDistance).v : none.v);
                    for (int d = 0; d < D; ++d) sum[d] += part*r[d];
                }
            }
        for (int d = 0; d < D; ++d) push[d] = sumLanes(sum[d]);
    }
#endif

    HD void keepAlongSurface(const Vec<D, double>& x, R* push) const
    {
        R normal[D], slope2 = R(1e-12), along = 0;
        UNROLL
        for (int d = 0; d < D; ++d)
        {
            Vec<D, double> low = x, high = x;
            low.c[d] -= 0.5*grid.h;
            high.c[d] += 0.5*grid.h;
            normal[d] = (sampleCell<1>(grid, phi, high) - sampleCell<1>(grid, phi, low))/R(grid.h);
            slope2 += normal[d]*normal[d];
            along += normal[d]*push[d];
        }
        for (int d = 0; d < D; ++d) push[d] -= along*normal[d]/slope2;
    }
};

} // namespace riprap
