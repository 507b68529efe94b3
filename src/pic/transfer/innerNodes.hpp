/*  The nodes about a point at least two cells from the sides of the block: there the nodes of all components of the velocity are blocks of memory, whatever the sides
    are. Weights are found once for all components: along an axis a component's nodes lie either on faces (its own axis) or at the middles of cells.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/inCell.hpp"
#include "pic/shapes/bSpline.hpp"

namespace riprap
{

template<int Order, int D, class R>
struct InnerNodes
{
    static constexpr int nodes = Order + 1;

    //- Along one axis: the first node, from that of the cell's number, and the weights
    struct Line
    {
        int low;
        R w[nodes];

        //- s: of the point beyond the node of the cell's number
        HD void set(R s, bool faces)
        {
            low = BSpline<Order>::firstInCell(s, faces);
            BSpline<Order>::weights(s - low, w);
        }
    };

    Line own[D], across[D];

    HD explicit InnerNodes(const R* t)
    {
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            own[a].set(t[a], true);
            across[a].set(t[a] - R(0.5), false);
        }
    }

    //- Do the nodes of all points of a cell lie so far inside?
    HD static bool has(const UniformGrid<D>& g, const int* c)
    {
        bool in = true;
        UNROLL
        for (int a = 0; a < D; ++a) in = in && c[a] >= 2 && c[a] < g.n[a] - 2;
        return in;
    }

    //- Component d at a point in cell c
    HD R sum(const UniformGrid<D>& g, const int* c, int d, const R* u) const
    {
        int stride[3];
        const R* first = u + firstOf(g, c, d, stride);
        R all = 0;
        UNROLL
        for (int k = 0; k < (D == 3 ? nodes : 1); ++k)
        {
            R plane = 0;
            UNROLL
            for (int j = 0; j < nodes; ++j)
            {
                const R* row = first + (j*stride[1] + (D == 3 ? k*stride[2] : 0));
                R line = 0;
                UNROLL
                for (int i = 0; i < nodes; ++i) line += along(0, d).w[i]*row[i];
                plane += along(1, d).w[j]*line;
            }
            if constexpr (D == 3) all += along(2, d).w[k]*plane;
            else all = plane;
        }
        return all;
    }

private:

    HD const Line& along(int a, int d) const { return a == d ? own[a] : across[a]; }

    HD int firstOf(const UniformGrid<D>& g, const int* c, int d, int* stride) const
    {
        int first = 0, step = 1;
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            first += (c[a] + along(a, d).low)*step;
            stride[a] = step;
            step *= g.layers(d, a);
        }
        return first;
    }
};

//- Velocity of the grid at a point t in cell c, where that is inside; \return whether it is
template<int Order, int D, class R>
HD bool sampleInside(const UniformGrid<D>& g, const R* const* u, const int* c, const R* t, R* v)
{
    if (!InnerNodes<Order, D, R>::has(g, c)) return false;
    const InnerNodes<Order, D, R> at(t);
    UNROLL
    for (int d = 0; d < D; ++d) v[d] = at.sum(g, c, d, u[d]);
    return true;
}

} // namespace riprap
