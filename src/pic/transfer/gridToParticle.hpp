/*  Grid to particles: what the step has made of the grid's velocity u, a change by du. A scheme's
    formula (schemes/) says what of it a particle takes:

        v_p = formula(v_p, sum_f W du_f, sum_f W u_f), C_p the affine part of u where particles keep
        it

    Particles with no water about them fall: v_p += g dt.

    Beside the surface du is that of the water continued to faces that no pressure has projected. A
    particle that moves with that water is given what it is given. One that does not, spray at a
    wall or between solids, would gain energy from nowhere, at each step again: there v_p is taken
    towards the grid's velocity u by as much as it takes to

        |v_p| <= max(|v_p + g dt| before, |u|)

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/particles.hpp"
#include "pic/grid/tiles.hpp"
#include "pic/transfer/innerNodes.hpp"
#include "pic/transfer/sample.hpp"
#include "pic/grid/wetCells.hpp"

namespace riprap
{

//- Around: also where the block ends in itself, or is narrower than the spline. Formula: a scheme's
template<int Order, int D, class R, bool Around, class Formula>
struct GridToParticle
{
    static constexpr const char* name = "gridToParticle";
    // measured to be fastest
    static constexpr int residentBlocks = D == 3 && Order <= 2 && sizeof(R) == 4 ? 8 : 0;
    UniformGrid<D> grid;
    double inverse;             // 1/h
    PicParticles<D, R> particles;
    const R* u[D];
    const R* du[D];
    // cells: are some or all of the cells about it wet? (wetCells.hpp)
    const unsigned char* nearWater;
    Formula formula;
    bool affine;
    R fall[D];                  // g dt [m/s]
    TileChoice<D> only;         // particles there
    bool waited;                // is du what they have waited for? Else those without water fall

    HD void operator()(int i) const
    {
        const Vec<D, double> x = particles.position(i);
        const InCell<D, R> at(grid, inverse, x);
        if (!only.has(at.index())) return;
        const unsigned char water = nearWater[at.cell(grid)];
        if (!water)
        {
            for (int d = 0; d < D; ++d)
                particles.v[d][i] += waited ? sampleFace<Order>(grid, du[d], d, x) : fall[d];
            if (affine) for (int k = 0; k < D*D; ++k) particles.affine[k][i] = 0;
            for (int k = 0; k < D*Formula::memory; ++k) particles.memory[k][i] = 0;
            return;
        }
        const bool bounds = Formula::own && water == someWater && formula.keepsOwn();
        R ofGrid[D], fallen2 = 0;
        if (affine) takeAll<true>(x, at, i, bounds, ofGrid, fallen2);
        else takeAll<false>(x, at, i, bounds, ofGrid, fallen2);
        if (bounds) bound(ofGrid, fallen2, i);
    }

private:

    //- asked: for the grid's velocity
    template<bool Affine>
    HD void takeAll(const Vec<D, double>& x, const InCell<D, R>& at, int i, bool asked, R* ofGrid,
        R& fallen2) const
    {
        using Inner = InnerNodes<Order, D, R, Affine>;
        const auto fallen = [&]([[maybe_unused]] int d)
        {
            if constexpr (Formula::own)
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
                    const R velocity = sampleAffineAround<Order>(grid, u[d], d, x, gradient);
                    const R change = Formula::own ? sampleAround<Order>(grid, du[d], d, x) : R(0);
                    ofGrid[d] = give<Affine>(d, i, velocity, change, gradient.c);
                }
            }
        }
    }

    //- \return the grid's velocity, as far as it is asked for
    template<bool Affine>
    HD R takeBlock(int d, const Window<Order, D, R, Affine>& block, int i, bool asked) const
    {
        R velocity = 0, change = 0, gradient[D];
        if constexpr (Affine)
        {
            velocity = block.sum(u[d], gradient);
            for (int a = 0; a < D; ++a) gradient[a] *= R(inverse);
        }
        else if (formula.readsGrid() || asked) velocity = block.sum(u[d]);
        if (Formula::own && formula.keepsOwn()) change = block.sum(du[d]);
        return give<Affine>(d, i, velocity, change, gradient);
    }

    template<bool Affine>
    HD R give(int d, int i, R velocity, R change, [[maybe_unused]] const R* gradient) const
    {
        constexpr int memory = Formula::memory;
        if constexpr (Affine)
            for (int a = 0; a < D; ++a) particles.affine[d*D + a][i] = gradient[a];
        R kept[memory + 1] = {};
        for (int k = 0; k < memory; ++k) kept[k] = particles.memory[d*memory + k][i];
        particles.v[d][i] = formula.velocity(
            Formula::own ? particles.v[d][i] : R(0), change, velocity, kept);
        for (int k = 0; k < memory; ++k) particles.memory[d*memory + k][i] = kept[k];
        return velocity;
    }

    //- u + s (v - u) with the largest s up to 1 that is no faster than the faster of u and the
    //  particle that has but fallen
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
        for (int d = 0; d < D; ++d)
            particles.v[d][i] = ofGrid[d] + part*(particles.v[d][i] - ofGrid[d]);
    }
};

//- Velocities of one direction at the time of the positions, for output: with the part of the last
//  change that is still to come
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
    // what particles of these tiles have not taken yet; nullptr: all have taken all
    const R* pending;
    TileChoice<D> slow;

    HD void operator()(int i) const
    {
        const Vec<D, double> x = particles.position(i);
        const InCell<D, R> at(grid, x);
        const bool water = nearWater[at.cell(grid)];
        result[i] = particles.v[component][i]
            + (water ? part*sampleFace<Order>(grid, du, component, x) : fall);
        if (pending && slow.has(at.index()))
            result[i] += sampleFace<Order>(grid, pending, component, x);
    }
};

} // namespace riprap
