/*  Keeps particles apart: each is pushed away from those closer than the spacing s,

        shift = c |v| dt sum_j (1 - |r_ij|/s)^2 r_ij/|r_ij|

    like the weak springs of Ando, Thuerey & Tsuruno (2012), IEEE Trans. Vis. Comput. Graph. 18, but by a share of the particle's own path,
    so that water at rest stays as it is. Particles that know the velocity's gradient take the velocity of their new place: without, what they carry would be off by
    an error of the order of h. Near the surface only the part along the surface is taken.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/particles.hpp"
#include "pic/transfer/near.hpp"

namespace riprap
{

template<int D, class R>
struct CorrectPositions
{
    static constexpr const char* name = "correctPositions";
    static constexpr double largest = 0.1;      // of the spacing, a step
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    const R* phi;
    const unsigned char* nearWater;
    R* shift[D];
    R strength;                 // c dt [s]
    R spacing;                  // s [m]

    HD void operator()(int i) const
    {
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        double s[D];
        Vec<D, double> x;
        R push[D], speed2 = 0;
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = particles.x[d][i];
            s[d] = x.c[d]/grid.h;
            c.c[d] = floorInt(s[d]);
            push[d] = 0;
            speed2 += particles.v[d][i]*particles.v[d][i];
            shift[d][i] = 0;
        }
        if (!nearWater[grid.cell(c)] || !(speed2 > R(0))) return;
        forEachNear<D>(grid, particles.start, s, double(spacing)/grid.h, [&](int j)
        {
            R r[D], r2 = 0;
            for (int d = 0; d < D; ++d) { r[d] = R(x.c[d] - particles.x[d][j]); r2 += r[d]*r[d]; }
            if (!(r2 < spacing*spacing) || !(r2 > R(0))) return;
            const R distance = squareRoot(r2), q = 1 - distance/spacing;
            for (int d = 0; d < D; ++d) push[d] += q*q*r[d]/distance;
        });
        R normal[D];
        const bool atSurface = sampleCell<1>(grid, phi, x) > R(-grid.h);
        if (atSurface)
        {
            R slope2 = R(1e-12), along = 0;
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
        const R length = strength*squareRoot(speed2), bound = R(largest)*spacing;
        for (int d = 0; d < D; ++d) shift[d][i] = maximum(-bound, minimum(length*push[d], bound));
    }
};

} // namespace riprap
