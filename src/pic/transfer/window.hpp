/*  The nodes about a point as a block of memory, all within the grid.

    What lies beyond a side is a linear function of the nodes inside (mirror.hpp): weights of such
    images are added to those nodes' own, along each axis by itself, so that points beside walls
    cost no more than others. Only around a periodic end and in blocks of fewer layers than the
    spline has nodes there is no such block.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/inCell.hpp"
#include "pic/transfer/bSpline.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

//- Values of nodes `low` .. of an axis are w of the field: the same for nodes within the block.
//  \return the first of these
template<int Order, int D, class R>
HD int foldWeights(const UniformGrid<D>& g, int component, int axis, int low, R* w)
{
    constexpr int nodes = Order + 1;
    const int n = g.n[axis], layers = axis == component ? n + 1 : n,
              first = low < 0 ? 0 : layers - nodes;
    R sum[nodes] = {};
    UNROLL
    for (int i = 0; i < nodes; ++i)
    {
        const int j = low + i;
        const bool upper = j >= layers;
        int one = j, two = -1;                  // the value is a that of one + b that of two
        R a = 1, b = 0;
        if (j < 0 || upper)
        {
            if (axis == component)              // odd about the side
            {
                one = upper ? n : 0;
                two = upper ? 2*n - j : -j;
                a = 2;
                b = -1;
            }
            else if (component >= 0 && g.sticks[axis][upper] && n > 1)      // linear
            {
                const int beyond = upper ? j - n + 1 : -j;
                one = upper ? n - 1 : 0;
                two = upper ? n - 2 : 1;
                a = R(1 + beyond);
                b = R(-beyond);
            }
            else one = evenNode(g, axis, j);
        }
        UNROLL
        for (int k = 0; k < nodes; ++k)
            sum[k] += (one - first == k ? a*w[i] : R(0)) + (two - first == k ? b*w[i] : R(0));
    }
    UNROLL
    for (int k = 0; k < nodes; ++k) w[k] = sum[k];
    return first;
}

//- The same for three nodes, of which one at most lies beyond a side: in a cell of a block that
//  does not end in itself and is three cells wide
struct BeyondSide
{
    bool is, upper;
    bool even;                  // its value is that of the node at the side; else 2 that - the next

    //- low: the first node, from that of cell c; faces: they lie on the faces of this axis
    template<int D>
    HD BeyondSide(const UniformGrid<D>& g, int axis, int c, int low, bool faces)
        : is(c + low < 0 || c + low + 2 >= g.n[axis] + (faces ? 1 : 0)), upper(c > 0),
          even(!faces && !g.sticks[axis][upper])
    {}

    HD int shift() const { return upper ? -1 : 1; }

    template<class R>
    HD void fold(R* w) const
    {
        const R beyond = upper ? w[2] : w[0], one = even ? beyond : 2*beyond,
                two = even ? R(0) : -beyond;
        if (upper)
        {
            w[2] = w[1] + one;
            w[1] = w[0] + two;
            w[0] = 0;
        }
        else
        {
            w[0] = w[1] + one;
            w[1] = w[2] + two;
            w[2] = 0;
        }
    }
};

//- component: the direction of the faces that are the nodes, -1: cells. Slopes: with what gives the
//  field's gradient, times h: of order 1 that of the interpolation, of orders 2 and 3 the first
//  moment over the spline's second moment
template<int Order, int D, class R, bool Slopes = false>
struct Window
{
    static constexpr int nodes = Order + 1;
    using Spline = BSpline<Order>;

    bool whole = true;          // else there is no such block
    int first = 0;              // number of the first node
    int stride[2];              // along the second axis and the third
    R w[D][nodes];
    R slope[Slopes ? D : 1][nodes];

    HD Window() {}
    HD Window(const UniformGrid<D>& g, int component, const InCell<D, R>& x)
    {
        // nodes on a side of the block that points within it see
        constexpr int beyond = (Order + 1)/2;
        int step = 1;
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            const bool own = a == component;
            // from the node that has the cell's number
            const R s = own ? x.t[a] : x.t[a] - R(0.5);
            int low = Spline::firstInCell(s, own);
            const R f = s - low;
            Spline::weights(f, w[a]);
            if constexpr (Slopes) slopes(f, w[a], slope[a]);
            low += x.c[a];
            const int layers = g.n[a] + (own ? 1 : 0);
            if (low < 0 || low + Order >= layers)
            {
                if (g.periodic[a] || layers < nodes || low < -beyond
                    || low + Order >= layers + beyond)
                    whole = false;
                else
                {
                    if constexpr (Slopes) foldWeights<Order>(g, component, a, low, slope[a]);
                    low = foldWeights<Order>(g, component, a, low, w[a]);
                }
            }
            first += low*step;
            step *= layers;
            if (a < 2) stride[a] = step;
        }
    }

    HD R sum(const R* u) const
    {
        R all = 0;
        UNROLL
        for (int k = 0; k < (D == 3 ? nodes : 1); ++k)
        {
            R plane = 0;
            UNROLL
            for (int j = 0; j < nodes; ++j)
            {
                const R* row = u + (first + j*stride[0] + (D == 3 ? k*stride[1] : 0));
                R line = 0;
                UNROLL
                for (int i = 0; i < nodes; ++i) line += w[0][i]*row[i];
                plane += w[1][j]*line;
            }
            if constexpr (D == 3) all += w[2][k]*plane;
            else all = plane;
        }
        return all;
    }

    //- Also the gradient, times h
    HD R sum(const R* u, R* gradient) const
    {
        static_assert(Slopes, "a window that has slopes");
        R all = 0;
        for (int a = 0; a < D; ++a) gradient[a] = 0;
        UNROLL
        for (int k = 0; k < (D == 3 ? nodes : 1); ++k)
        {
            R plane = 0, planeX = 0, planeY = 0;
            UNROLL
            for (int j = 0; j < nodes; ++j)
            {
                const R* row = u + (first + j*stride[0] + (D == 3 ? k*stride[1] : 0));
                R line = 0, lineX = 0;
                UNROLL
                for (int i = 0; i < nodes; ++i)
                {
                    line += w[0][i]*row[i];
                    lineX += slope[0][i]*row[i];
                }
                plane += w[1][j]*line;
                planeX += w[1][j]*lineX;
                planeY += slope[1][j]*line;
            }
            if constexpr (D == 3)
            {
                all += w[2][k]*plane;
                gradient[0] += w[2][k]*planeX;
                gradient[1] += w[2][k]*planeY;
                gradient[2] += slope[2][k]*plane;
            }
            else
            {
                all = plane;
                gradient[0] = planeX;
                gradient[1] = planeY;
            }
        }
        return all;
    }

    HD static void slopes(R f, const R* weight, R* slope)
    {
        if constexpr (Order == 1) Spline::slopes(f, slope);
        else for (int i = 0; i < nodes; ++i) slope[i] = weight[i]*(i - f)*R(1/Spline::secondMoment);
    }
};

} // namespace riprap
