/*  Values of staggered velocities, of their gradients and of fields of cells at any point, by
    B-splines.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/window.hpp"

namespace riprap
{

//- Nodes and weights about a point; offset d: 0 for nodes at i h, 1/2 for those at (i + 1/2) h
template<int Order, int D, class R>
struct Stencil
{
    static constexpr int nodes = Order + 1;
    using Spline = BSpline<Order>;
    typename UniformGrid<D>::Index first{{0, 0, 0}};
    R fraction[D];              // of the point beyond the first node
    R w[D][nodes];

    //- component: the direction of the faces that are the nodes, -1: cells
    HD Stencil(const UniformGrid<D>& g, int component, const Vec<D, double>& x)
    {
        const double inverse = 1/g.h;
        for (int a = 0; a < D; ++a)
        {
            const double s = x.c[a]*inverse - (a == component ? 0.0 : 0.5);
            first.c[a] = Spline::first(s);
            fraction[a] = R(s - first.c[a]);
            Spline::weights(fraction[a], w[a]);
        }
        if (g.part) for (int a = 0; a < D; ++a) first.c[a] -= g.first[a];
    }

    //- f(weight, index of the node, its number along each axis within the stencil) over the nodes
    template<class F>
    HD void forEachNode(const F& f) const
    {
        for (int k = 0; k < (D == 3 ? nodes : 1); ++k)
            for (int j = 0; j < nodes; ++j)
                for (int i = 0; i < nodes; ++i)
                {
                    R weight = w[0][i]*w[1][j];
                    typename UniformGrid<D>::Index at{{first.c[0] + i, first.c[1] + j, 0}};
                    if constexpr (D == 3) { weight *= w[2][k]; at.c[2] = first.c[2] + k; }
                    f(weight, at, i, j, k);
                }
    }
};

//- Component d of a velocity, node by node: where the nodes lie around a periodic end. By value: no
//  caller's variable must have an address
template<int Order, int D, class R>
HD_APART R sampleAround(UniformGrid<D> g, const R* u, int d, Vec<D, double> x)
{
    const Stencil<Order, D, R> stencil(g, d, x);
    R sum = 0;
    stencil.forEachNode([&](R w, const typename UniformGrid<D>::Index& at, int, int, int)
        { sum += w*faceValue(g, u, d, at); });
    return sum;
}

//- The same and its affine part: the gradient of the linear field that the nodes' values make about
//  the point (orders 2 and 3: first moments over the spline's second moment; order 1: the gradient
//  of the interpolation;
//  Jiang, Schroeder, Selle, Teran & Stomakhin 2015, section 5.3 and Eq. 14)
template<int Order, int D, class R>
HD_APART R sampleAffineAround(
    UniformGrid<D> g, const R* u, int d, Vec<D, double> x, Vec<D, R>& gradient)
{
    const Stencil<Order, D, R> stencil(g, d, x);
    R sum = 0, slope[D][Order + 1];
    for (int a = 0; a < D; ++a)
    {
        gradient.c[a] = 0;
        if constexpr (Order == 1) BSpline<1>::slopes(stencil.fraction[a], slope[a]);
    }
    stencil.forEachNode([&](R w, const typename UniformGrid<D>::Index& at, int i, int j, int k)
    {
        const R value = faceValue(g, u, d, at);
        sum += w*value;
        const int node[3] = {i, j, k};
        for (int a = 0; a < D; ++a)
        {
            if constexpr (Order == 1)
            {
                R derivative = slope[a][node[a]];
                for (int b = 0; b < D; ++b) if (b != a) derivative *= stencil.w[b][node[b]];
                gradient.c[a] += derivative*value;
            }
            else gradient.c[a] += w*(node[a] - stencil.fraction[a])*value;
        }
    });
    const R scale = R((Order == 1 ? 1.0 : 1.0/BSpline<Order>::secondMoment)/g.h);
    for (int a = 0; a < D; ++a) gradient.c[a] *= scale;
    return sum;
}

//- Is there a place in the block where a window is not whole?
template<int D>
bool needsAround(const UniformGrid<D>& g, int order)
{
    bool needs = false;
    for (int d = 0; d < D; ++d) needs = needs || g.periodic[d] || g.n[d] < order + 1;
    return needs;
}

//- Component d of a velocity at a point
template<int Order, int D, class R>
HD R sampleFace(const UniformGrid<D>& g, const R* u, int d, const Vec<D, double>& x)
{
    const Window<Order, D, R> window(g, d, InCell<D, R>(g, x));
    return window.whole ? window.sum(u) : sampleAround<Order>(g, u, d, x);
}

//- A field of cells at a point
template<int Order, int D, class R>
HD R sampleCell(const UniformGrid<D>& g, const R* a, const Vec<D, double>& x)
{
    const Window<Order, D, R> window(g, -1, InCell<D, R>(g, x));
    if (window.whole) return window.sum(a);
    const Stencil<Order, D, R> stencil(g, -1, x);
    R sum = 0;
    stencil.forEachNode([&](R w, const typename UniformGrid<D>::Index& at, int, int, int)
        { sum += w*cellValue(g, a, at); });
    return sum;
}

} // namespace riprap
