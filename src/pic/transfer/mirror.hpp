/*  What the fields of the grid are beyond the block: periodic copies, or mirror images at its sides, where a wall stands.

    The velocity along the direction in which one looks is odd about its value at the side, u(-s) = 2 u(0) - u(s), and so are the components along a
    side that water sticks to, about the side's velocity; all other components and scalars are even. Particles near a side are seen with their images, so that what is mapped near walls is as exact as inside.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/uniformGrid.hpp"

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

//- Value of component d at face nodes I that may lie up to two beyond the sides
template<int D, class R>
HD R faceValue(const UniformGrid<D>& g, const R* u, int d, typename UniformGrid<D>::Index f)
{
    R sign = 1, offset = 0;
    for (int a = 0; a < D; ++a)
    {
        if (a == d) continue;
        const int at = f.c[a], upper = at >= g.n[a];
        f.c[a] = evenNode(g, a, at);
        if ((at < 0 || upper) && g.sticks[a][upper])
        {
            offset += 2*sign*R(g.slide[a][upper][d]);
            sign = -sign;
        }
    }
    const int n = g.n[d], i = f.c[d];
    if (i >= 0 && i <= n) return offset + sign*u[g.face(d, f)];
    if (g.periodic[d])
    {
        f.c[d] = i < 0 ? i + n : i - n;
        return offset + sign*u[g.face(d, f)];
    }
    f.c[d] = i < 0 ? 0 : n;
    const R side = u[g.face(d, f)];
    const int m = i < 0 ? -i : 2*n - i;
    f.c[d] = m < 0 ? 0 : (m > n ? n : m);
    return offset + sign*(2*side - u[g.face(d, f)]);
}

//- For what has no part of the sides' own velocity: changes, solutions of the linear equation
template<int D>
UniformGrid<D> atRest(UniformGrid<D> g)
{
    for (auto& axis : g.slide) for (auto& side : axis) for (double& v : side) v = 0;
    return g;
}

//- Value of a field of cells, even about the sides
template<int D, class R>
HD R cellValue(const UniformGrid<D>& g, const R* a, typename UniformGrid<D>::Index c)
{
    for (int d = 0; d < D; ++d) c.c[d] = evenNode(g, d, c.c[d]);
    return a[g.cell(c)];
}

} // namespace riprap
