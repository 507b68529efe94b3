/*  Grid to particles: what the step has made of the grid's velocity.

        flip        v_p += sum_f W du_f                                 (Brackbill & Ruppel 1986)
        pic         v_p  = sum_f W u_f                                  (Harlow 1964)
        flipPic     v_p  = (1 - b) flip + b pic
        apic        v_p  = sum_f W u_f, C_p its affine part             (Jiang et al. 2015)

    du is the change of the grid's velocity over the step. Particles with no water about them fall: v_p += g dt.

    Beside the surface du is that of the water continued to faces that no pressure has projected. A particle that moves with that water is given what it is given. One
    that does not, spray at a wall or between solids, would gain energy from nowhere, at each step again: there v_p is taken towards the grid's velocity u by
    as much as it takes to

        |v_p| <= max(|v_p + g dt| before, |u|)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/particles.hpp"
#include "pic/transfer/innerNodes.hpp"
#include "pic/transfer/sample.hpp"
#include "pic/grid/wetCells.hpp"

namespace riprap
{

//- Around: also where the block ends in itself, or is narrower than the spline. Pic: the share of the grid's velocity is 1 (pic, apic), so that its change is not read
template<int Order, int D, class R, bool Around = true, bool Pic = false>
struct GridToParticle
{
    static constexpr const char* name = "gridToParticle";
    static constexpr int residentBlocks = D == 3 && Order <= 2 && sizeof(R) == 4 ? 8 : 0;       // measured to be fastest
    UniformGrid<D> grid;
    double inverse;             // 1/h
    PicParticles<D, R> particles;
    const R* u[D];
    const R* du[D];
    const unsigned char* nearWater;     // cells: are some or all of the cells about it wet? (wetCells.hpp)
    R picPart;                  // b: 0 flip .. 1 pic
    bool affine;
    R fall[D];                  // g dt [m/s]

    HD void operator()(int i) const
    {
        const Vec<D, double> x = particles.position(i);
        const InCell<D, R> at(inverse, x);
        const unsigned char water = nearWater[at.cell(grid)];
        if (!water)
        {
            for (int d = 0; d < D; ++d) particles.v[d][i] += fall[d];
            if (affine) for (int k = 0; k < D*D; ++k) particles.affine[k][i] = 0;
            return;
        }
        const bool bounds = !Pic && water == someWater && picPart < 1;
        R ofGrid[D], fallen2 = 0;
        if (affine) takeAll<true>(x, at, i, bounds, ofGrid, fallen2);
        else takeAll<false>(x, at, i, bounds, ofGrid, fallen2);
        if (bounds) bound(ofGrid, fallen2, i);
    }

private:

    //- asked: for the grid's velocity
    template<bool Affine>
    HD void takeAll(const Vec<D, double>& x, const InCell<D, R>& at, int i, bool asked, R* ofGrid, R& fallen2) const
    {
        using Inner = InnerNodes<Order, D, R, Affine>;
        const auto fallen = [&]([[maybe_unused]] int d)
        {
            if constexpr (!Pic)
            {
                const R v = particles.v[d][i] + fall[d];
                fallen2 += v*v;
            }
        };
        constexpr bool always = Order == 2 && !Around;
        if (always || Inner::has(grid, at.c))
        {
            const Inner nodes(grid, at.c, at.t);
            UNROLL
            for (int d = 0; d < D; ++d)
            {
                fallen(d);
                ofGrid[d] = takeBlock<Affine>(d, nodes.window(grid, at.c, d), i, asked);
            }
            return;
        }
        if constexpr (!always)
        {
            for (int d = 0; d < D; ++d)
            {
                fallen(d);
                const typename Inner::Block block(grid, d, at);
                if (!Around || block.whole) ofGrid[d] = takeBlock<Affine>(d, block, i, asked);
                else if constexpr (Around)
                {
                    Vec<D, R> gradient;
                    const R pic = sampleAffineAround<Order>(grid, u[d], d, x, gradient);
                    const R change = Pic ? R(0) : sampleAround<Order>(grid, du[d], d, x);
                    ofGrid[d] = give<Affine>(d, i, pic, change, gradient.c);
                }
            }
        }
    }

    //- \return the grid's velocity, as far as it is asked for
    template<bool Affine>
    HD R takeBlock(int d, const Window<Order, D, R, Affine>& block, int i, bool asked) const
    {
        R pic = 0, change = 0, gradient[D];
        if constexpr (Affine)
        {
            pic = block.sum(u[d], gradient);
            for (int a = 0; a < D; ++a) gradient[a] *= R(inverse);
        }
        else if (Pic || picPart > 0 || asked) pic = block.sum(u[d]);
        if (!Pic && picPart < 1) change = block.sum(du[d]);
        return give<Affine>(d, i, pic, change, gradient);
    }

    template<bool Affine>
    HD R give(int d, int i, R pic, R change, [[maybe_unused]] const R* gradient) const
    {
        if constexpr (Affine) for (int a = 0; a < D; ++a) particles.affine[d*D + a][i] = gradient[a];
        R v = Pic ? pic : R(0);
        if constexpr (!Pic)
        {
            if (picPart < 1) v += (1 - picPart)*(particles.v[d][i] + change);
            if (picPart > 0) v += picPart*pic;
        }
        particles.v[d][i] = v;
        return pic;
    }

    //- u + s (v - u) with the largest s up to 1 that is no faster than the faster of u and the particle that has but fallen
    HD void bound(const R* ofGrid, R fallen2, int i) const
    {
        R grid2 = 0, now2 = 0, mixed = 0, off2 = 0;
        for (int d = 0; d < D; ++d)
        {
            const R v = particles.v[d][i], off = v - ofGrid[d];
            grid2 += ofGrid[d]*ofGrid[d];
            now2 += v*v;
            mixed += off*ofGrid[d];
            off2 += off*off;
        }
        const R most = maximum(fallen2, grid2);
        if (!(now2 > most) || !(off2 > R(0))) return;
        const R part = minimum(R(1), (squareRoot(mixed*mixed + off2*(most - grid2)) - mixed)/off2);
        for (int d = 0; d < D; ++d) particles.v[d][i] = ofGrid[d] + part*(particles.v[d][i] - ofGrid[d]);
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
