/*  The velocity about a point, to second order in the distance from it, s in cells:

        u(x + h s) = u + G s + 1/2 s (H s)

    G and H are the derivatives of what B-splines of order 2 or 3 make of the grid's velocity. A
    Runge-Kutta step of order 3 that starts there needs no more: what is left out is of the third
    order in s, as is the step's own error (where s leaves the piece of a quadratic spline, s^2
    times a jump of H that is of the order of h); and the grid is read once, not once a stage.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/innerNodes.hpp"
#include "pic/transfer/window.hpp"

namespace riprap
{

//- Values, first and second derivatives of one component
template<int D, class R>
struct LocalField
{
    static constexpr int pairs = D*(D - 1)/2;
    R value, slope[D], curvature[D], mixed[pairs];      // mixed: of xy, xz, yz

    HD R at(const R* s) const
    {
        R sum = value;
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            R along = slope[a] + R(0.5)*curvature[a]*s[a];
            UNROLL
            for (int b = a + 1; b < D; ++b) along += mixed[a + b - 1]*s[b];
            sum += s[a]*along;
        }
        return sum;
    }

    //- Of nodes first[..], with the weights of the value, of its slope and of its curvature along
    //  each axis
    template<int Nodes, class W>
    HD void sum(const R* first, const int* stride, const W& weights)
    {
        value = 0;
        UNROLL
        for (int a = 0; a < D; ++a) slope[a] = curvature[a] = 0;
        UNROLL
        for (int m = 0; m < pairs; ++m) mixed[m] = 0;
        UNROLL
        for (int k = 0; k < (D == 3 ? Nodes : 1); ++k)
        {
            R plane = 0, x = 0, xx = 0, y = 0, xy = 0, yy = 0;
            UNROLL
            for (int j = 0; j < Nodes; ++j)
            {
                const R* row = first + (j*stride[0] + (D == 3 ? k*stride[1] : 0));
                R line = 0, lineX = 0, lineXX = 0;
                UNROLL
                for (int i = 0; i < Nodes; ++i)
                {
                    line += weights.w(0, i)*row[i];
                    lineX += weights.slope(0, i)*row[i];
                    lineXX += weights.curvature(0, i)*row[i];
                }
                plane += weights.w(1, j)*line;
                x += weights.w(1, j)*lineX;
                xx += weights.w(1, j)*lineXX;
                y += weights.slope(1, j)*line;
                xy += weights.slope(1, j)*lineX;
                yy += weights.curvature(1, j)*line;
            }
            const R wz = D == 3 ? weights.w(D - 1, k) : R(1);
            value += wz*plane;
            slope[0] += wz*x;
            slope[1] += wz*y;
            curvature[0] += wz*xx;
            curvature[1] += wz*yy;
            mixed[0] += wz*xy;
            if constexpr (D == 3)
            {
                const R sz = weights.slope(2, k);
                slope[2] += sz*plane;
                curvature[2] += weights.curvature(2, k)*plane;
                mixed[1] += sz*x;
                mixed[2] += sz*y;
            }
        }
    }
};

//- Weights of a line of nodes about a point, and their derivatives
template<int Order, class R>
struct LineOfNodes
{
    static constexpr int nodes = Order + 1;
    int low;                    // the first node, from that of the cell's number
    R w[nodes], slope[nodes], curvature[nodes];

    //- s: of the point beyond the node of the cell's number
    HD void set(R s, bool faces)
    {
        low = BSpline<Order>::firstInCell(s, faces);
        BSpline<Order>::weights(s - low, w);
        BSpline<Order>::slopes(s - low, slope);
        BSpline<Order>::curvatures(s - low, curvature);
    }

    //- Of three nodes one that lies beyond a side follows from the others
    template<int D>
    HD void fold(const UniformGrid<D>& g, int axis, int c, bool faces)
    {
        const BeyondSide beyond(g, axis, c, low, faces);
        if (!beyond.is) return;
        beyond.fold(w);
        beyond.fold(slope);
        beyond.fold(curvature);
        low += beyond.shift();
    }
};

//- Those of a component
template<int Order, int D, class R>
struct InnerLines
{
    const LineOfNodes<Order, R>* own;
    const LineOfNodes<Order, R>* across;
    int component;

    HD const LineOfNodes<Order, R>& along(int a) const
    {
        return a == component ? own[a] : across[a];
    }
    HD R w(int a, int i) const { return along(a).w[i]; }
    HD R slope(int a, int i) const { return along(a).slope[i]; }
    HD R curvature(int a, int i) const { return along(a).curvature[i]; }
};

//- Those beside a side, with the images of the nodes beyond it
template<int Order, int D, class R>
struct FoldedLines
{
    static constexpr int nodes = Order + 1;
    R weights[D][3][nodes];
    HD R w(int a, int i) const { return weights[a][0][i]; }
    HD R slope(int a, int i) const { return weights[a][1][i]; }
    HD R curvature(int a, int i) const { return weights[a][2][i]; }
};

template<int Order, int D, class R>
struct LocalVelocity
{
    static constexpr int nodes = Order + 1;
    LocalField<D, R> of[D];

    HD void at(const R* s, R* v) const
    {
        UNROLL
        for (int d = 0; d < D; ++d) v[d] = of[d].at(s);
    }

    //- Where InnerNodes has the cell. Folds: also beside sides
    template<bool Folds>
    HD void find(const UniformGrid<D>& g, const R* const* u, const InCell<D, R>& x)
    {
        LineOfNodes<Order, R> own[D], across[D];
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            own[a].set(x.t[a], true);
            across[a].set(x.t[a] - R(0.5), false);
            if constexpr (Folds)
            {
                own[a].fold(g, a, x.c[a], true);
                across[a].fold(g, a, x.c[a], false);
            }
        }
        UNROLL
        for (int d = 0; d < D; ++d)
        {
            const InnerLines<Order, D, R> lines{own, across, d};
            int first = 0, step = 1, stride[3];
            UNROLL
            for (int a = 0; a < D; ++a)
            {
                first += (x.c[a] + lines.along(a).low)*step;
                step *= g.layers(d, a);
                stride[a] = step;
            }
            of[d].template sum<nodes>(u[d] + first, stride, lines);
        }
    }
};

//- The same in any cell; \return false where the nodes are no block (window.hpp)
template<int Order, int D, class R>
HD bool findAnywhere(LocalVelocity<Order, D, R>& local, const UniformGrid<D>& g, const R* const* u,
    const InCell<D, R>& x)
{
    constexpr int nodes = Order + 1, beyond = nodes/2;
    for (int d = 0; d < D; ++d)
    {
        FoldedLines<Order, D, R> lines;
        int first = 0, step = 1, stride[3];
        for (int a = 0; a < D; ++a)
        {
            const bool own = a == d;
            LineOfNodes<Order, R> line;
            line.set(own ? x.t[a] : x.t[a] - R(0.5), own);
            int low = x.c[a] + line.low;
            const int layers = g.layers(d, a);
            const bool outside = low < 0 || low + Order >= layers;
            if (outside
                && (g.periodic[a] || layers < nodes || low < -beyond
                    || low + Order >= layers + beyond))
                return false;
            if (outside)
            {
                foldWeights<Order>(g, d, a, low, line.slope);
                foldWeights<Order>(g, d, a, low, line.curvature);
                low = foldWeights<Order>(g, d, a, low, line.w);
            }
            for (int i = 0; i < nodes; ++i)
            {
                lines.weights[a][0][i] = line.w[i];
                lines.weights[a][1][i] = line.slope[i];
                lines.weights[a][2][i] = line.curvature[i];
            }
            first += low*step;
            step *= layers;
            stride[a] = step;
        }
        local.of[d].template sum<nodes>(u[d] + first, stride, lines);
    }
    return true;
}

} // namespace riprap
