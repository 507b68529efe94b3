/*  The nodes about a point whose nodes, of all components of the velocity, are blocks of memory: of
    quadratic splines in all cells but those beside a periodic end, of others in cells away from the
    sides. Weights are found once for all components: along an axis a component's nodes lie either
    on faces (its own axis) or at the middles of cells; those beyond a side are folded as a window
    folds them.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/window.hpp"

namespace riprap
{

//- Slopes: as in a window
template<int Order, int D, class R, bool Slopes = false>
struct InnerNodes
{
    static constexpr int nodes = Order + 1;
    using Block = Window<Order, D, R, Slopes>;

    //- Along one axis: the first node, from that of the cell's number, and the weights
    struct Line
    {
        int low;
        R w[nodes], slope[Slopes ? nodes : 1];

        //- In cell c of an axis; s: of the point beyond the node of the cell's number
        HD void set(const UniformGrid<D>& g, int axis, int c, R s, bool faces)
        {
            low = BSpline<Order>::firstInCell(s, faces);
            BSpline<Order>::weights(s - low, w);
            if constexpr (Slopes) Block::slopes(s - low, w, slope);
            if constexpr (Order == 2) if (c == 0 || c == g.n[axis] - 1) fold(g, axis, c, faces);
        }

    private:

        HD void fold(const UniformGrid<D>& g, int axis, int c, bool faces)
        {
            const BeyondSide beyond(g, axis, c, low, faces);
            if (!beyond.is) return;
            if constexpr (Slopes) beyond.fold(slope);
            beyond.fold(w);
            low += beyond.shift();
        }
    };

    Line own[D], across[D];

    //- c: the cell, t: where in it
    HD InnerNodes(const UniformGrid<D>& g, const int* c, const R* t)
    {
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            own[a].set(g, a, c[a], t[a], true);
            across[a].set(g, a, c[a], t[a] - R(0.5), false);
        }
    }

    //- Are the nodes of all points of a cell within the block, without any folding?
    HD static bool inside(const UniformGrid<D>& g, const int* c)
    {
        constexpr int margin = Order == 3 ? 2 : 1;
        bool in = true;
        UNROLL
        for (int a = 0; a < D; ++a) in = in && c[a] >= margin && c[a] < g.n[a] - margin;
        return in;
    }

    //- Are the nodes of all points of a cell blocks, folded or not?
    HD static bool has(const UniformGrid<D>& g, const int* c)
    {
        if constexpr (Order != 2) return inside(g, c);
        bool in = true;
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            const bool folds = !g.periodic[a] && g.n[a] > Order;
            in = in && c[a] >= (folds ? 0 : 1) && c[a] < g.n[a] - (folds ? 0 : 1);
        }
        return in;
    }

    //- Those of component d of a point in cell c
    HD Block window(const UniformGrid<D>& g, const int* c, int d) const
    {
        Block block;
        int step = 1;
        UNROLL
        for (int a = 0; a < D; ++a)
        {
            const Line& line = along(a, d);
            block.first += (c[a] + line.low)*step;
            step *= g.layers(d, a);
            if (a < 2) block.stride[a] = step;
            UNROLL
            for (int i = 0; i < nodes; ++i)
            {
                block.w[a][i] = line.w[i];
                if constexpr (Slopes) block.slope[a][i] = line.slope[i];
            }
        }
        return block;
    }

    //- Component d at a point in cell c
    HD R sum(const UniformGrid<D>& g, const int* c, int d, const R* u) const
    {
        return window(g, c, d).sum(u);
    }

private:

    HD const Line& along(int a, int d) const { return a == d ? own[a] : across[a]; }
};

//- Velocity of the grid at a point t in cell c, where the nodes are blocks; \return whether they
//  are
template<int Order, int D, class R>
HD bool sampleInside(const UniformGrid<D>& g, const R* const* u, const int* c, const R* t, R* v)
{
    if (!InnerNodes<Order, D, R>::has(g, c)) return false;
    const InnerNodes<Order, D, R> at(g, c, t);
    UNROLL
    for (int d = 0; d < D; ++d) v[d] = at.sum(g, c, d, u[d]);
    return true;
}

} // namespace riprap
