/*  What the fields of the grid are beyond the block: periodic copies, or mirror images at its
    sides, where a wall stands.

    The velocity along the direction in which one looks is odd about its value at the side, u(-s) =
    2 u(0) - u(s). Components along a side are even where water slides; where it sticks they are
    continued linearly from the two nodes inside, so that neither a layer that the grid resolves is
    bent nor one that it does not resolve is spread over a cell: the wall acts by its stress alone
    (pic/terms/viscosity.hpp). Scalars are even. Particles near a side are seen with their images,
    so that what is mapped near walls is as exact as inside.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/uniformGrid.hpp"

namespace riprap
{

//- Index of a node that is even about the sides: nodes at (i + 1/2) h
template<int D>
HD int evenNode(const UniformGrid<D>& g, int axis, int i)
{
    const int n = g.n[axis];
    if (g.periodic[axis]) return i < 0 ? i + n : (i >= n ? i - n : i);
    i = i < 0 ? -1 - i : (i >= n ? 2*n - 1 - i : i);
    return i < 0 ? 0 : (i >= n ? n - 1 : i);            // a block of fewer cells than the stencil
}

//- Value of component d at face nodes that may lie up to two beyond the sides along d, and lie
//  within them across
template<int D, class R>
HD R valueAlong(const UniformGrid<D>& g, const R* u, int d, typename UniformGrid<D>::Index f)
{
    const int n = g.n[d], i = f.c[d];
    if (i >= 0 && i <= n) return u[g.face(d, f)];
    if (g.periodic[d])
    {
        f.c[d] = i < 0 ? i + n : i - n;
        return u[g.face(d, f)];
    }
    f.c[d] = i < 0 ? 0 : n;
    const R side = u[g.face(d, f)];
    const int m = i < 0 ? -i : 2*n - i;
    f.c[d] = m < 0 ? 0 : (m > n ? n : m);
    return 2*side - u[g.face(d, f)];
}

//- The same anywhere about the block
template<int D, class R>
HD R faceValue(const UniformGrid<D>& g, const R* u, int d, typename UniformGrid<D>::Index f)
{
    int axis[2] = {0, 0}, inward[2] = {0, 0}, beyond[2] = {0, 0}, sticky = 0;
    for (int a = 0; a < D; ++a)
    {
        if (a == d) continue;
        const int i = f.c[a], n = g.n[a], upper = i >= n;
        if ((i < 0 || upper) && g.sticks[a][upper] && n > 1)
        {
            axis[sticky] = a;
            inward[sticky] = upper ? -1 : 1;
            beyond[sticky++] = upper ? i - n + 1 : -i;
            f.c[a] = upper ? n - 1 : 0;
        }
        else f.c[a] = evenNode(g, a, i);
    }
    if (!sticky) return valueAlong(g, u, d, f);
    R sum = 0;
    for (int corner = 0; corner < (1 << sticky); ++corner)
    {
        typename UniformGrid<D>::Index at = f;
        int w = 1;
        for (int k = 0; k < sticky; ++k)
        {
            const bool second = corner >> k & 1;
            w *= second ? -beyond[k] : 1 + beyond[k];
            if (second) at.c[axis[k]] += inward[k];
        }
        sum += w*valueAlong(g, u, d, at);
    }
    return sum;
}

//- Do cells up to `reach` away all lie within the block?
template<int D>
HD bool inner(const UniformGrid<D>& g, const typename UniformGrid<D>::Index& c, int reach)
{
    bool in = true;
    for (int d = 0; d < D; ++d) in = in && c.c[d] >= reach && c.c[d] < g.n[d] - reach;
    return in;
}

//- Value of a field of cells, even about the sides
template<int D, class R>
HD R cellValue(const UniformGrid<D>& g, const R* a, typename UniformGrid<D>::Index c)
{
    for (int d = 0; d < D; ++d) c.c[d] = evenNode(g, d, c.c[d]);
    return a[g.cell(c)];
}

//- Values below and above along each axis: below.c[d], above.c[d]
template<int D, class R>
struct CellNeighbours
{
    Vec<D, R> below, above;

    HD CellNeighbours(const UniformGrid<D>& g, const R* a, const typename UniformGrid<D>::Index& c)
    {
        const int i = g.cell(c);
        int stride = 1;
        if (inner(g, c, 1))
            for (int d = 0; d < D; ++d)
            {
                below.c[d] = a[i - stride];
                above.c[d] = a[i + stride];
                stride *= g.n[d];
            }
        else
            for (int d = 0; d < D; ++d)
            {
                typename UniformGrid<D>::Index low = c, high = c;
                low.c[d] -= 1;
                high.c[d] += 1;
                below.c[d] = cellValue(g, a, low);
                above.c[d] = cellValue(g, a, high);
            }
    }
};

} // namespace riprap
