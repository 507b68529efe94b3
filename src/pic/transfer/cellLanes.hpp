/*  Grid to particles and their motion on the CPU in 2D with quadratic splines: the particles of a
    cell in the lanes of a register.

    All of them see the same nodes, four along a component's own axis and three across it, so that
    each node is read once for a cell and nothing is gathered; a node that a particle does not see
    has no weight. The numbers are those of GridToParticle and MoveParticles to round-off. Cells
    beside the sides, and those without water about them, are done by these.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstring>
#include "core/loops/rows.hpp"
#include "pic/transfer/gridToParticle.hpp"
#include "pic/transfer/moveParticles.hpp"
#include "pic/grid/tiles.hpp"

namespace riprap
{

template<class R, bool Around, class Formula> struct GridToCells;
template<class R, bool Around> struct MoveCells;

#ifndef __CUDACC__

//- Weights of the nodes along one axis from that below the cell's own on
template<class R, int Nodes>
struct LaneLine
{
    using Lanes = Pack<R>;
    Lanes w[Nodes];

    //- Three weights of consecutive nodes: of four nodes where it is `upper` those from the second
    //  on
    void set(const Lanes* three, typename Lanes::mask upper)
    {
        const typename Lanes::vec none{};
        if constexpr (Nodes == 3) for (int i = 0; i < 3; ++i) w[i] = three[i];
        else
        {
            w[0] = Lanes(upper ? none : three[0].v);
            w[1] = Lanes(upper ? three[0].v : three[1].v);
            w[2] = Lanes(upper ? three[1].v : three[2].v);
            w[3] = Lanes(upper ? three[2].v : none);
        }
    }
};

template<class R>
struct ParticleLanes
{
    using Lanes = Pack<R>;
    static constexpr int lanes = Lanes::width;
    LaneLine<R, 4> own[2], ownSlope[2], ownCurvature[2];
    LaneLine<R, 3> across[2], acrossSlope[2], acrossCurvature[2];

    //- Moments: slopes as an affine map has them (window.hpp), else derivatives
    template<bool Moments>
    void set(const PlaceInCell<R>* place)
    {
        Lanes t[4];
        loadRows([&](int l) { return place[l].t; }, t);
        for (int a = 0; a < 2; ++a)
        {
            const typename Lanes::mask upper = t[a].v >= Lanes(R(0.5)).v, never = t[a].v != t[a].v;
            const Lanes f(upper ? t[a].v : (t[a] + Lanes(R(1))).v);
            line<Moments>(f, upper, own[a], ownSlope[a], ownCurvature[a]);
            line<Moments>(t[a] - Lanes(R(0.5)) + Lanes(R(1)), never, across[a], acrossSlope[a],
                acrossCurvature[a]);
        }
    }

    //- The first `count` lanes
    static void store(Lanes v, R* to, int count)
    {
        if (count >= lanes) { std::memcpy(to, &v, sizeof(v)); return; }
        R part[lanes];
        std::memcpy(part, &v, sizeof(v));
        int k = 0;
        if (lanes > 4 && count & 4) { std::memcpy(to, part, 4*sizeof(R)); k = 4; }
        if (count & 2) { std::memcpy(to + k, part + k, 2*sizeof(R)); k += 2; }
        if (count & 1) to[k] = part[k];
    }

private:
    template<bool Moments, int Nodes>
    static void line(Lanes f, typename Lanes::mask upper, LaneLine<R, Nodes>& w,
        LaneLine<R, Nodes>& slope, LaneLine<R, Nodes>& curvature)
    {
        const Lanes a = Lanes(R(1.5)) - f, b = f - Lanes(R(1)), c = f - Lanes(R(0.5)), half(R(0.5));
        const Lanes value[3] = {half*a*a, Lanes(R(0.75)) - b*b, half*c*c};
        w.set(value, upper);
        if constexpr (Moments)
        {
            const Lanes scale(R(1/BSpline<2>::secondMoment));
            const Lanes moment[3] = {value[0]*(Lanes(R(0)) - f)*scale,
                value[1]*(Lanes(R(1)) - f)*scale, value[2]*(Lanes(R(2)) - f)*scale};
            slope.set(moment, upper);
        }
        else
        {
            const Lanes first[3] = {-a, Lanes(R(-2))*b, c},
                        second[3] = {Lanes(R(1)), Lanes(R(-2)), Lanes(R(1))};
            slope.set(first, upper);
            curvature.set(second, upper);
        }
    }
};

//- Cells of a tile that have particles: few(cell, its indices, first particle, last + 1)
template<class F>
void eachCellOf(
    const UniformGrid<2>& grid, const CellTiles<2>& tiles, int tile, const int* start, const F& f)
{
    const UniformGrid<2>::Index first = tiles.first(tile);
    UniformGrid<2>::Index c = first;
    for (c.c[1] = first.c[1]; c.c[1] < first.c[1] + tiles.side && c.c[1] < grid.n[1]; ++c.c[1])
        for (c.c[0] = first.c[0]; c.c[0] < first.c[0] + tiles.side && c.c[0] < grid.n[0]; ++c.c[0])
        {
            const int cell = grid.cell(c);
            if (start[cell + 1] > start[cell]) f(cell, c, start[cell], start[cell + 1]);
        }
}

template<class R, bool Around, class Formula>
struct GridToCells
{
    static constexpr const char* name = "gridToParticle";
    using Lanes = Pack<R>;
    GridToParticle<2, 2, R, Around, Formula> one;
    CellTiles<2> tiles;
    const int* list;            // of tiles that have particles

    void operator()(int t) const
    {
        eachCellOf(one.grid, tiles, list[t], one.particles.start,
            [&](int cell, const UniformGrid<2>::Index& c, int from, int to)
            {
                if (!one.nearWater[cell] || !inner(one.grid, c, 1))
                {
                    for (int p = from; p < to; ++p) one(p);
                    return;
                }
                const bool bounds = one.nearWater[cell] == someWater && one.formula.keepsOwn();
                for (int p = from; p < to; p += Lanes::width) take(c, p, to - p, bounds);
            });
    }

private:

    void take(const UniformGrid<2>::Index& c, int p, int count, bool bounds) const
    {
        ParticleLanes<R> w;
        w.template set<true>(one.particles.place + p);
        Lanes before[2], grid[2], now[2];
        for (int d = 0; d < 2; ++d) before[d] = Lanes::load(one.particles.v[d] + p);
        component<0>(w.own[0], w.ownSlope[0], w.across[1], w.acrossSlope[1], c, p, count, before[0],
            grid[0], now[0]);
        component<1>(w.across[0], w.acrossSlope[0], w.own[1], w.ownSlope[1], c, p, count, before[1],
            grid[1], now[1]);
        if (bounds) bound(before, grid, now);
        for (int d = 0; d < 2; ++d) w.store(now[d], one.particles.v[d] + p, count);
    }

    template<int d, int Nx, int Ny>
    void component(const LaneLine<R, Nx>& wx, const LaneLine<R, Nx>& sx, const LaneLine<R, Ny>& wy,
        const LaneLine<R, Ny>& sy, const UniformGrid<2>::Index& c, int p, int count, Lanes before,
        Lanes& ofGrid, Lanes& now) const
    {
        const int width = one.grid.layers(d, 0), first = c.c[0] - 1 + width*(c.c[1] - 1);
        Lanes value(R(0)), x(R(0)), y(R(0)), change(R(0));
        for (int j = 0; j < Ny; ++j)
        {
            const R* u = one.u[d] + first + j*width;
            const R* du = one.du[d] + first + j*width;
            Lanes line(R(0)), lineX(R(0)), lineD(R(0));
            for (int i = 0; i < Nx; ++i)
            {
                line += wx.w[i]*Lanes(u[i]);
                lineX += sx.w[i]*Lanes(u[i]);
                lineD += wx.w[i]*Lanes(du[i]);
            }
            value += wy.w[j]*line;
            x += wy.w[j]*lineX;
            y += sy.w[j]*line;
            change += wy.w[j]*lineD;
        }
        ofGrid = value;
        if (one.affine)
        {
            const Lanes inverse(R(one.inverse));
            ParticleLanes<R>::store(x*inverse, one.particles.affine[2*d] + p, count);
            ParticleLanes<R>::store(y*inverse, one.particles.affine[2*d + 1] + p, count);
        }
        constexpr int memory = Formula::memory;
        Lanes kept[memory + 1];
        for (int k = 0; k < memory; ++k)
            kept[k] = Lanes::load(one.particles.memory[d*memory + k] + p);
        now = one.formula.velocity(before, change, value, kept);
        for (int k = 0; k < memory; ++k)
            ParticleLanes<R>::store(kept[k], one.particles.memory[d*memory + k] + p, count);
    }

    //- GridToParticle::bound
    void bound(const Lanes* before, const Lanes* grid, Lanes* now) const
    {
        Lanes fallen2(R(0)), grid2(R(0)), now2(R(0)), mixed(R(0)), off2(R(0)), off[2];
        for (int d = 0; d < 2; ++d)
        {
            const Lanes fallen = before[d] + Lanes(one.fall[d]);
            off[d] = now[d] - grid[d];
            fallen2 += fallen*fallen;
            grid2 += grid[d]*grid[d];
            now2 += now[d]*now[d];
            mixed += off[d]*grid[d];
            off2 += off[d]*off[d];
        }
        const Lanes most = maximum(fallen2, grid2);
        const typename Lanes::mask faster = (now2.v > most.v) & (off2.v > Lanes(R(0)).v);
        const Lanes under = maximum(mixed*mixed + off2*(most - grid2), Lanes(R(0)));
        const Lanes part = minimum(
            Lanes(R(1)), (squareRoot(under) - mixed)/Lanes(faster ? off2.v : Lanes(R(1)).v));
        for (int d = 0; d < 2; ++d) now[d] = Lanes(faster ? (grid[d] + part*off[d]).v : now[d].v);
    }
};

template<class R, bool Around, class Formula>
GridToCells<R, Around, Formula> cellsOf(
    const GridToParticle<2, 2, R, Around, Formula>& one, const CellTiles<2>& tiles, const int* list)
{ return {one, tiles, list}; }

template<class R, bool Around>
struct MoveCells
{
    static constexpr const char* name = "moveParticles";
    using Lanes = Pack<R>;
    MoveParticles<2, 2, R, Around> one;
    CellTiles<2> tiles;
    const int* list;

    void operator()(int t) const
    {
        eachCellOf(one.grid, tiles, list[t], one.particles.start,
            [&](int cell, const UniformGrid<2>::Index& c, int from, int to)
            {
                if (!one.nearWater[cell] || !inner(one.grid, c, 1))
                {
                    for (int p = from; p < to; ++p) one(p);
                    return;
                }
                for (int p = from; p < to; p += Lanes::width)
                    move(c, p, to - p < Lanes::width ? to - p : Lanes::width);
            });
    }

private:

    //- LocalField of the lanes
    struct Field
    {
        Lanes value, x, y, xx, xy, yy;

        Lanes at(Lanes s, Lanes r) const
        {
            const Lanes half(R(0.5));
            return value + s*(x + half*xx*s + xy*r) + r*(y + half*yy*r);
        }
    };

    template<int d, int Nx, int Ny>
    Field find(const LaneLine<R, Nx>& wx, const LaneLine<R, Nx>& sx, const LaneLine<R, Nx>& cx,
        const LaneLine<R, Ny>& wy, const LaneLine<R, Ny>& sy, const LaneLine<R, Ny>& cy,
        const UniformGrid<2>::Index& c) const
    {
        const int width = one.grid.layers(d, 0), first = c.c[0] - 1 + width*(c.c[1] - 1);
        const Lanes none(R(0));
        Field f{none, none, none, none, none, none};
        for (int j = 0; j < Ny; ++j)
        {
            const R* u = one.u[d] + first + j*width;
            Lanes line = none, lineX = none, lineXX = none;
            for (int i = 0; i < Nx; ++i)
            {
                line += wx.w[i]*Lanes(u[i]);
                lineX += sx.w[i]*Lanes(u[i]);
                lineXX += cx.w[i]*Lanes(u[i]);
            }
            f.value += wy.w[j]*line;
            f.x += wy.w[j]*lineX;
            f.xx += wy.w[j]*lineXX;
            f.y += sy.w[j]*line;
            f.xy += sy.w[j]*lineX;
            f.yy += cy.w[j]*line;
        }
        return f;
    }

    void move(const UniformGrid<2>::Index& c, int p, int count) const
    {
        ParticleLanes<R> w;
        w.template set<false>(one.particles.place + p);
        const Field f[2] = {find<0>(w.own[0], w.ownSlope[0], w.ownCurvature[0], w.across[1],
                                w.acrossSlope[1], w.acrossCurvature[1], c),
            find<1>(w.across[0], w.acrossSlope[0], w.acrossCurvature[0], w.own[1], w.ownSlope[1],
                w.ownCurvature[1], c)};
        const Lanes cells(R(one.timeStep*one.inverse)), half = Lanes(R(0.5))*cells,
                                                          more = Lanes(R(0.75))*cells;
        Lanes k1[2], k2[2], k3[2];
        for (int d = 0; d < 2; ++d) k1[d] = f[d].value;
        for (int d = 0; d < 2; ++d) k2[d] = f[d].at(half*k1[0], half*k1[1]);
        for (int d = 0; d < 2; ++d) k3[d] = f[d].at(more*k2[0], more*k2[1]);
        const Lanes farthest = maximum(absolute(cells*k1[0]), absolute(cells*k1[1]));
        for (int l = 0; l < count; ++l)
        {
            if (!(farthest.v[l] < R(1))) { one(p + l); continue; }      // of a cell: stage by stage
            Vec<2, double> to;
            for (int d = 0; d < 2; ++d)
                to.c[d] = one.particles.x[d][p + l]
                    + (one.order == 2 ? one.timeStep*k2[d].v[l]
                                      : (one.timeStep/9)
                                *(2.0*k1[d].v[l] + 3.0*k2[d].v[l] + 4.0*k3[d].v[l]));
            one.arriveInWater(p + l, c, to);
        }
    }
};

#endif

} // namespace riprap
