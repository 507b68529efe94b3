/*  Particles carried through the step's velocity field, which is frozen meanwhile.

    order 2:    x += dt u(x + dt/2 u(x)) (midpoint)
    order 3:    x += dt (2 k1 + 3 k2 + 4 k3)/9, k2 = u(x + dt/2 k1), k3 = u(x + 3/4 dt k2) (Ralston
                1962)

    Splines of order 2 and 3 are looked at once a step, where it begins (localVelocity.hpp), and
    where a particle goes farther than a cell at each stage.

    Particles with no water about them fall: x += dt v, in pieces of a cell at most; those that come
    to the water on the way are carried by it from there. Sides of the block that are closed keep
    particles inside, at least `margin` away; they lose the velocity into the wall. Where a side is
    open they leave. Closed faces inside the block let no particle pass either. What walls take back
    of the way that the correction of positions has pushed a particle is taken back from its
    velocity as well: it has become that of a place that is not reached, and in a corner, where
    particles push each other against walls step by step, it would grow without bound.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/particles.hpp"
#include "pic/grid/tiles.hpp"
#include "pic/transfer/positionCorrection.hpp"
#include "pic/transfer/innerNodes.hpp"
#include "pic/transfer/localVelocity.hpp"
#include "pic/transfer/sample.hpp"
#include "pic/transfer/stopAtFaces.hpp"

namespace riprap
{

//- Velocity of the grid at a point anywhere. Around: also where the block ends in itself, or is
//  narrower than the spline
template<int Order, bool Around, int D, class R>
HD Vec<D, R> sampleVelocity(const UniformGrid<D>& g, const R* const* u, Vec<D, double> x)
{
    // a point on an upper side is the last cell's: what that beyond sees lies out of the field
    constexpr double inside = 1e-6;         // cells: more than single precision rounds off
    if (!Around && !g.part)
        for (int d = 0; d < D; ++d) x.c[d] = minimum(x.c[d], (g.n[d] - inside)*g.h);
    else if (!Around)
        for (int d = 0; d < D; ++d) x.c[d] = minimum(x.c[d], (g.first[d] + g.n[d] - inside)*g.h);
    const InCell<D, R> at(g, x);
    Vec<D, R> v;
    UNROLL
    for (int d = 0; d < D; ++d)
    {
        const Window<Order, D, R> window(g, d, at);
        if (!Around || window.whole) v.c[d] = window.sum(u[d]);
        else if constexpr (Around) v.c[d] = sampleAround<Order>(g, u[d], d, x);
    }
    return v;
}

//- A point taken back into the block; into the copy at the other end where it is periodic
template<int D>
HD Vec<D, double> intoBlock(const UniformGrid<D>& g, Vec<D, double> x)
{
    for (int d = 0; d < D; ++d)
    {
        double start = 0, length = g.n[d]*g.h;
        if (g.part) { start = g.low(d); length = g.high(d); }
        if (g.periodic[d])
            x.c[d] = x.c[d] < 0 ? x.c[d] + length : (x.c[d] >= length ? x.c[d] - length : x.c[d]);
        else x.c[d] = maximum(start, minimum(x.c[d], length));
    }
    return x;
}

//- The same for a point anywhere in the block. By value: no caller's variable must have an address
template<int Order, bool Around, int D, class R>
HD_APART Vec<D, double> carriedAnywhere(
    UniformGrid<D> g, Vec<3, const R*> field, Vec<D, double> x, double dt, int order)
{
    const R* const u[3] = {field.c[0], field.c[1], field.c[2]};
    const auto ahead = [&](const Vec<D, R>& v, double by)
    { return intoBlock(g, x + by*convert<double>(v)); };
    const Vec<D, R> k1 = sampleVelocity<Order, Around>(g, u, x);
    const Vec<D, R> k2 = sampleVelocity<Order, Around>(g, u, ahead(k1, 0.5*dt));
    if (order == 2) return x + dt*convert<double>(k2);
    const Vec<D, R> k3 = sampleVelocity<Order, Around>(g, u, ahead(k2, 0.75*dt));
    return x + (dt/9)*(2.0*convert<double>(k1) + 3.0*convert<double>(k2) + 4.0*convert<double>(k3));
}

//- Where the field takes a point in dt (negative: where it came from). at: its place; inverse: 1/h
template<int Order, bool Around = true, int D, class R>
HD Vec<D, double> carried(const UniformGrid<D>& g, double inverse, const R* const* u,
    const InCell<D, R>& at, const Vec<D, double>& x, double dt, int order)
{
    R k1[D], k2[D], k3[D];
    const R cells = R(dt*inverse);
    bool inside = sampleInside<Order>(g, u, at.c, at.t, k1);
    if (inside)
    {
        const InCell<D, R> half = at.ahead(k1, R(0.5)*cells);
        inside = sampleInside<Order>(g, u, half.c, half.t, k2);
    }
    Vec<D, double> to;
    if (inside && order == 2)
    {
        UNROLL
        for (int d = 0; d < D; ++d) to.c[d] = x.c[d] + dt*k2[d];
        return to;
    }
    if (inside)
    {
        const InCell<D, R> more = at.ahead(k2, R(0.75)*cells);
        inside = sampleInside<Order>(g, u, more.c, more.t, k3);
    }
    if (!inside)
        return carriedAnywhere<Order, Around>(
            g, Vec<3, const R*>{{u[0], u[1], u[D - 1]}}, x, dt, order);
    UNROLL
    for (int d = 0; d < D; ++d) to.c[d] = x.c[d] + (dt/9)*(2.0*k1[d] + 3.0*k2[d] + 4.0*k3[d]);
    return to;
}

template<int Order, bool Around = true, int D, class R>
HD Vec<D, double> carried(
    const UniformGrid<D>& g, const R* const* u, const Vec<D, double>& x, double dt, int order)
{ return carried<Order, Around>(g, 1/g.h, u, InCell<D, R>(g, x), x, dt, order); }

//- A step through what is known of the field about its beginning; \return whether it stays so near
//  that this is enough
template<int Order, int D, class R>
HD bool carriedBy(const LocalVelocity<Order, D, R>& local, R cells, const Vec<D, double>& x,
    double dt, int order, Vec<D, double>& to)
{
    constexpr R farthest = 1;           // cells
    R k1[D], k2[D], s[D];
    bool near = true;
    UNROLL
    for (int d = 0; d < D; ++d)
    {
        k1[d] = local.of[d].value;
        s[d] = R(0.5)*cells*k1[d];
        near = near && absolute(cells*k1[d]) < farthest;
    }
    local.at(s, k2);
    if (order == 2)
    {
        UNROLL
        for (int d = 0; d < D; ++d) to.c[d] = x.c[d] + dt*k2[d];
        return near;
    }
    UNROLL
    for (int d = 0; d < D; ++d) s[d] = R(0.75)*cells*k2[d];
    UNROLL
    for (int d = 0; d < D; ++d)
        to.c[d] = x.c[d] + (dt/9)*(2.0*k1[d] + 3.0*k2[d] + 4.0*local.of[d].at(s));
    return near;
}

//- The same for a point anywhere in the block
template<int Order, bool Around, int D, class R>
HD_APART Vec<D, double> carriedBeside(
    UniformGrid<D> g, Vec<3, const R*> field, Vec<D, double> x, double dt, int order)
{
    const R* const u[3] = {field.c[0], field.c[1], field.c[2]};
    LocalVelocity<Order, D, R> local;
    Vec<D, double> to;
    if (findAnywhere(local, g, u, InCell<D, R>(g, x))
        && carriedBy(local, R(dt/g.h), x, dt, order, to))
        return to;
    return carriedAnywhere<Order, Around>(g, field, x, dt, order);
}

//- Where the field takes a particle: splines of order 2 and 3 are looked at once, for where the
//  particle is
template<int Order, bool Around = true, int D, class R>
HD Vec<D, double> carriedNear(const UniformGrid<D>& g, double inverse, const R* const* u,
    const InCell<D, R>& at, const Vec<D, double>& x, double dt, int order)
{
    if constexpr (Order == 1) return carried<Order, Around>(g, inverse, u, at, x, dt, order);
    else
    {
        using Nodes = InnerNodes<Order, D, R>;
        const R cells = R(dt*inverse);
        LocalVelocity<Order, D, R> local;
        Vec<D, double> to;
        if (Nodes::inside(g, at.c))
        {                   // NOLINT(bugprone-branch-clone): the other one differs for Order 2
            local.template find<false>(g, u, at);
            if (carriedBy(local, cells, x, dt, order, to)) return to;
        }
        else if (Order == 2 && (!Around || Nodes::has(g, at.c)))
        {
            local.template find<(Order == 2)>(g, u, at);
            if (carriedBy(local, cells, x, dt, order, to)) return to;
        }
        const Vec<3, const R*> field{{u[0], u[1], u[D - 1]}};
        if constexpr (Order == 2) return carriedAnywhere<Order, Around>(g, field, x, dt, order);
        else return carriedBeside<Order, Around>(g, field, x, dt, order);
    }
}

template<int Order, int D, class R, bool Around = true>
struct MoveParticles
{
    static constexpr const char* name = "moveParticles";
    // measured to be fastest
    static constexpr int residentBlocks = D == 3 && Order <= 2 && sizeof(R) == 4 ? 8 : 0;
    UniformGrid<D> grid;
    double inverse;             // 1/h
    PicParticles<D, R> particles;
    const R* u[D];
    const R* aperture[D];
    const unsigned char* nearWater;
    // what position correction adds [m], and what walls have left of it; nullptr: none
    R* shift[D];
    // closed faces of the sides through which water leaves; nullptr: there are none
    const unsigned char* gate[D];
    double timeStep;
    int order;                  // 2 or 3
    bool inside;                // are there closed faces inside the block?
    double margin;              // [m]
    // cells that particles come to, and their numbers, for the sort; nullptr: they will be moved
    // again
    std::uint32_t* keys;
    std::uint32_t* indices;
    TileChoice<D> only;         // particles there
    double lag;                 // by which those in water are behind; timeStep holds it [s]
    // cells that they stood in before any moved; nullptr: all are moved at once
    const std::uint32_t* from;

    HD void operator()(int i) const
    {
        const Vec<D, double> x = particles.position(i);
        const InCell<D, R> at(grid, inverse, x);
        const typename UniformGrid<D>::Index c = at.index();
        if (!only.has(from ? grid.cellIndex(int(from[i])) : c)) return;
        if (nearWater[grid.cell(c)])
            arriveInWater(
                i, c, carriedNear<Order, Around>(grid, inverse, u, at, x, timeStep, order));
        else fly(i, c, x);
    }

    //- Free fall from cell c
    HD void fly(int i, typename UniformGrid<D>::Index c, Vec<D, double> x) const
    {
        double most = 0;
        for (int d = 0; d < D; ++d) most = maximum(most, double(absolute(particles.v[d][i])));
        const double step = timeStep - lag;
        const int pieces = most*step*inverse < maxPieces ? 1 + int(most*step*inverse) : maxPieces;
        const double piece = step/pieces;
        for (int k = 1; k < pieces; ++k)
        {
            const Vec<D, double> to = stopped(i, c, x + piece*convert<double>(velocity(i)));
            const InCell<D, R> at(grid, inverse, to);
            bool in = true;
            for (int d = 0; d < D; ++d) in = in && at.c[d] >= 0 && at.c[d] < grid.n[d];
            if (!in)
            {
                arrive(i, c, x + (step - (k - 1)*piece)*convert<double>(velocity(i)));
                return;
            }
            x = to;
            c = at.index();
            if (!nearWater[grid.cell(c)]) continue;
            const double left = step - k*piece;
            arrive(i, c,
                carriedAnywhere<Order, Around>(
                    grid, Vec<3, const R*>{{u[0], u[1], u[D - 1]}}, x, left, order));
            return;
        }
        arrive(i, c, x + piece*convert<double>(velocity(i)));
    }

    //- Of a particle that the water has carried from cell c
    HD void arriveInWater(int i, const typename UniformGrid<D>::Index& c, Vec<D, double> to) const
    {
        if (shift[0]) for (int d = 0; d < D; ++d) to.c[d] += shift[d][i];
        arrive(i, c, to);
    }

    HD void arrive(int i, const typename UniformGrid<D>::Index& c, Vec<D, double> to) const
    {
        to = stopped(i, c, to);
        UNROLL
        for (int d = 0; d < D; ++d)
        {
            to.c[d] = confined(to.c[d], d, c, i);
            particles.x[d][i] = to.c[d];
        }
        if (!keys) return;
        keys[i] = cellKey<D, R>(grid, inverse, to);
        indices[i] = i;
    }

private:

    static constexpr int maxPieces = 64;

    //- The way from cell c as far as closed faces inside the block let it
    HD Vec<D, double> stopped(
        int i, const typename UniformGrid<D>::Index& c, Vec<D, double> to) const
    {
        if (!inside) return to;
        const Vec<D, double> free = to;
        const int at = stopAtFaces(
            grid, c, to, margin, [&](int d, int face) { return !(aperture[d][face] > R(0)); });
        if (at) for (int d = 0; d < D; ++d)
        {
            takeBack(particles, shift, i, d, to.c[d] - free.c[d]);
            R& v = particles.v[d][i];
            if ((at >> 2*d & 1 && v < 0) || (at >> 2*d & 2 && v > 0)) v = 0;
        }
        return to;
    }

    HD Vec<D, R> velocity(int i) const
    {
        Vec<D, R> v;
        for (int d = 0; d < D; ++d) v.c[d] = particles.v[d][i];
        return v;
    }

    //- The coordinate after walls and periodic ends have had their say
    HD double confined(double x, int d, typename UniformGrid<D>::Index c, int i) const
    {
        double start = margin, length = grid.n[d]*grid.h;
        if (grid.part) { start += grid.low(d); length = grid.high(d); }
        if (grid.periodic[d])
        {
            x = x < 0 ? x + length : (x >= length ? x - length : x);
            return x < length ? x : 0.0;
        }
        const bool low = x < start, high = x > length - margin;
        if (!low && !high) return x;
        c.c[d] = low ? 0 : grid.n[d];
        const int face = grid.face(d, c);
        if (aperture[d][face] > R(0) || (gate[d] && gate[d][face])) return x;
        const double wall = low ? start : length - margin;
        takeBack(particles, shift, i, d, wall - x);
        R& v = particles.v[d][i];
        if (low ? v < 0 : v > 0) v = 0;
        return wall;
    }
};

} // namespace riprap
