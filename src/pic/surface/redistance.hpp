/*  phi made a distance again, in a band about the surface.

    Cells next to the surface keep phi where its slope is near one already; where the flow has
    stretched or squeezed it, it is divided by its slope (Russo & Smereka 2000, J. Comput. Phys.
    163, Eq. 14). Further cells take the solution of |grad phi| = 1 from their neighbours (Godunov's
    upwind quadratic; each pass carries it one cell on), but keep what was carried to them where
    that is a distance still: the passes are of first order, the cubic advection is not.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/mirror.hpp"

namespace riprap
{

//- Slopes of phi that pass as those of a distance
template<class R> HD bool fairSlope(R slope) { return slope > R(0.75) && slope < R(1.3333); }

template<int D, class R>
HD R slopeOf(const UniformGrid<D>& g, const CellNeighbours<D, R>& phi)
{
    R sum = 0;
    for (int d = 0; d < D; ++d)
    {
        const R difference = (phi.above.c[d] - phi.below.c[d])/R(2*g.h);
        sum += difference*difference;
    }
    return squareRoot(sum);
}

//- Is there a cell of the other sign beside it?
template<int D, class R>
HD bool atSurface(R own, const CellNeighbours<D, R>& phi)
{
    const bool wet = own < 0;
    bool other = false;
    for (int d = 0; d < D; ++d)
        other = other || (phi.below.c[d] < 0) != wet || (phi.above.c[d] < 0) != wet;
    return other;
}

//- Cells at the surface: their distance; all others: the width of the band
template<int D, class R>
struct StartDistance
{
    static constexpr const char* name = "startDistance";
    UniformGrid<D> grid;
    const R* carried;
    R* phi;
    R band;
    R* copy = nullptr;          // of phi; nullptr: none

    HD void operator()(int i) const { (*this)(i, grid.cellIndex(i)); }

    HD void operator()(int i, const typename UniformGrid<D>::Index& c) const
    {
        const R distance = start(i, c);
        phi[i] = distance;
        if (copy) copy[i] = distance;
    }

private:

    HD R start(int i, const typename UniformGrid<D>::Index& c) const
    {
        const R value = carried[i], sign = value < 0 ? R(-1) : R(1);
        const CellNeighbours<D, R> about(grid, carried, c);
        if (!atSurface(value, about)) return sign*band;
        const R slope = slopeOf(grid, about),
                distance = fairSlope(slope) ? value : value/maximum(slope, R(0.2));
        return sign*minimum(absolute(distance), R(grid.h));
    }
};

//- |phi| from the smaller neighbours along each axis: (a - m1)^2 + ... = h^2 over those below a
template<int D, class R>
HD R godunov(R* m, R h)
{
    for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b)
            if (m[b] < m[a])
            {
                const R t = m[a];
                m[a] = m[b];
                m[b] = t;
            }
    R value = m[0] + h;
    for (int count = 2; count <= D && value > m[count - 1]; ++count)
    {
        R sum = 0, squares = 0;
        for (int a = 0; a < count; ++a) { sum += m[a]; squares += m[a]*m[a]; }
        value = (sum + squareRoot(maximum(sum*sum - count*(squares - h*h), R(0))))/count;
    }
    return value;
}

//- One pass: from -> to
template<int D, class R>
struct SpreadDistance
{
    static constexpr const char* name = "spreadDistance";
    UniformGrid<D> grid;
    const R* carried;
    const R* from;
    R* to;
    R band;

    HD void operator()(int i) const { (*this)(grid.cellIndex(i)); }

    //- A row of cells, up to before index `end`: most lie far from the surface, and so do those
    //  about them
    HD void row(typename UniformGrid<D>::Index c, int end) const
    {
        const int i = grid.cell(c), count = end - c.c[0];
        int stride = 1;
        bool in = c.c[0] > 0 && end < grid.n[0];
        for (int d = 1; d < D; ++d) in = in && c.c[d] > 0 && c.c[d] < grid.n[d] - 1;
        int close = !in;
        for (int d = 0; d < D && in; ++d)
        {
            for (int k = 0; k < count; ++k)
                close |= (absolute(from[i + k]) < band) | (absolute(from[i + k - stride]) < band)
                    | (absolute(from[i + k + stride]) < band);
            stride *= grid.n[d];
        }
        if (close) for (; c.c[0] < end; ++c.c[0]) (*this)(c);
        else for (int k = 0; k < count; ++k) to[i + k] = from[i + k];
    }

    HD void operator()(const typename UniformGrid<D>::Index& c) const
    {
        const int i = grid.cell(c);
        const CellNeighbours<D, R> near(grid, from, c);
        const R before = from[i];
        R m[D];
        bool far = absolute(before) >= band;
        for (int d = 0; d < D; ++d)
        {
            m[d] = minimum(absolute(near.below.c[d]), absolute(near.above.c[d]));
            far = far && m[d] >= band;
        }
        // nothing has come here, and it is not at the surface
        if (far) { to[i] = before; return; }
        const CellNeighbours<D, R> about(grid, carried, c);
        if (atSurface(carried[i], about)) { to[i] = before; return; }
        const R h = R(grid.h), distance = minimum(godunov<D>(m, h), band),
                own = absolute(carried[i]);
        const R sign = carried[i] < 0 ? R(-1) : R(1);
        const bool keep = absolute(own - distance) < R(0.3)*h && own < R(3)*h
            && fairSlope(slopeOf(grid, about));
        to[i] = sign*(keep ? own : distance);
    }
};

} // namespace riprap
