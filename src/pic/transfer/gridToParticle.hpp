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

//- Around: also where the block ends in itself, or is narrower than the spline
template<int Order, int D, class R, bool Around = true>
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
        const Vec<D, double> x = particles.position(i);
        const InCell<D, R> at(grid, x);
        if (!nearWater[at.cell(grid)])
        {
            for (int d = 0; d < D; ++d) particles.v[d][i] += fall[d];
            if (affine) for (int k = 0; k < D*D; ++k) particles.affine[k][i] = 0;
            return;
        }
        UNROLL
        for (int d = 0; d < D; ++d) affine ? take<true>(d, x, at, i) : take<false>(d, x, at, i);
    }

private:

    template<bool Affine>
    HD void take(int d, const Vec<D, double>& x, const InCell<D, R>& at, int i) const
    {
        const Window<Order, D, R, Affine> window(grid, d, at);
        R pic = 0, change = 0, gradient[D];
        if (!Around || window.whole)
        {
            if constexpr (Affine)
            {
                pic = window.sum(u[d], gradient);
                for (int a = 0; a < D; ++a) gradient[a] *= R(1/grid.h);
            }
            else if (picPart > 0) pic = window.sum(u[d]);
            if (picPart < 1) change = window.sum(du[d]);
        }
        else if constexpr (Around)
        {
            Vec<D, R> around;
            pic = sampleAffineAround<Order>(grid, u[d], d, x, around);
            for (int a = 0; a < D; ++a) gradient[a] = around.c[a];
            change = sampleAround<Order>(grid, du[d], d, x);
        }
        if constexpr (Affine) for (int a = 0; a < D; ++a) particles.affine[d*D + a][i] = gradient[a];
        R v = 0;
        if (picPart < 1) v += (1 - picPart)*(particles.v[d][i] + change);
        if (picPart > 0) v += picPart*pic;
        particles.v[d][i] = v;
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
        const Vec<D, double> x = particles.position(i);
        const bool water = nearWater[InCell<D, R>(grid, x).cell(grid)];
        result[i] = particles.v[component][i] + (water ? part*sampleFace<Order>(grid, du, component, x) : fall);
    }
};

} // namespace riprap
