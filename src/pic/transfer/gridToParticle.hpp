/*  Grid to particles: what the step has made of the grid's velocity.

        flip        v_p += sum_f W du_f                                 (Brackbill & Ruppel 1986)
        pic         v_p  = sum_f W u_f                                  (Harlow 1964)
        flipPic     v_p  = (1 - b) flip + b pic
        apic        v_p  = sum_f W u_f, C_p its affine part             (Jiang et al. 2015)

    du is the change of the grid's velocity over the step. Particles with no water about them fall: v_p += g dt.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/particles.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

template<int Order, int D, class R>
struct GridToParticle
{
    static constexpr const char* name = "gridToParticle";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    const R* u[D];
    const R* du[D];
    const unsigned char* nearWater;     // cells: is one of the cells about it wet?
    R picPart;                  // b: 0 flip .. 1 pic
    bool affine;
    R fall[D];                  // g dt [m/s]

    HD void operator()(int i) const
    {
        Vec<D, double> x;
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = particles.x[d][i];
            c.c[d] = floorInt(x.c[d]/grid.h);
        }
        if (!nearWater[grid.cell(c)])
        {
            for (int d = 0; d < D; ++d) particles.v[d][i] += fall[d];
            if (affine) for (int k = 0; k < D*D; ++k) particles.affine[k][i] = 0;
            return;
        }
        for (int d = 0; d < D; ++d)
        {
            R pic = 0, v = 0;
            if (affine)
            {
                R gradient[D];
                pic = sampleAffine<Order>(grid, u[d], d, x, gradient);
                for (int a = 0; a < D; ++a) particles.affine[d*D + a][i] = gradient[a];
            }
            else if (picPart > 0) pic = sampleFace<Order>(grid, u[d], d, x);
            if (picPart < 1) v += (1 - picPart)*(particles.v[d][i] + sampleFace<Order>(grid, du[d], d, x));
            if (picPart > 0) v += picPart*pic;
            particles.v[d][i] = v;
        }
    }
};

//- Velocities of one direction at the time of the positions, for output: with the part of the last change that is still to come
template<int Order, int D, class R>
struct VelocityNow
{
    static constexpr const char* name = "velocityNow";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    int component;
    const R* du;
    const unsigned char* nearWater;
    R part;                     // of du
    R fall;                     // of particles that fly [m/s]
    R* result;

    HD void operator()(int i) const
    {
        Vec<D, double> x;
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = particles.x[d][i];
            c.c[d] = floorInt(x.c[d]/grid.h);
        }
        const bool water = nearWater[grid.cell(c)];
        result[i] = particles.v[component][i] + (water ? part*sampleFace<Order>(grid, du, component, x) : fall);
    }
};

} // namespace riprap
