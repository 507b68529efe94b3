/*  phi made a distance again, in a band about the surface.

    Cells next to the surface keep phi where its slope is near one already; where the flow has stretched or squeezed it, it is divided by its slope
    (Russo & Smereka 2000, J. Comput. Phys. 163, Eq. 14). Further cells take the solution of |grad phi| = 1 from their
    neighbours (Godunov's upwind quadratic; each pass carries it one cell on), but keep what was carried to them where that is a distance
    still: the passes are of first order, the cubic advection is not.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/mirror.hpp"

namespace riprap
{

//- Slopes of phi that pass as those of a distance
template<class R> HD bool fairSlope(R slope) { return slope > R(0.75) && slope < R(1.3333); }

template<int D, class R>
HD R slopeOf(const UniformGrid<D>& g, const R* phi, const typename UniformGrid<D>::Index& c)
{
    R sum = 0;
    for (int d = 0; d < D; ++d)
    {
        typename UniformGrid<D>::Index low = c, high = c;
        low.c[d] -= 1;
        high.c[d] += 1;
        const R difference = (cellValue(g, phi, high) - cellValue(g, phi, low))/R(2*g.h);
        sum += difference*difference;
    }
    return squareRoot(sum);
}

//- Is there a cell of the other sign beside it?
template<int D, class R>
HD bool atSurface(const UniformGrid<D>& g, const R* phi, const typename UniformGrid<D>::Index& c)
{
    const bool wet = phi[g.cell(c)] < 0;
    for (int d = 0; d < D; ++d)
        for (int offset = -1; offset <= 1; offset += 2)
        {
            typename UniformGrid<D>::Index at = c;
            at.c[d] += offset;
            if ((cellValue(g, phi, at) < 0) != wet) return true;
        }
    return false;
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

    HD void operator()(int i) const
    {
        const R value = carried[i], sign = value < 0 ? R(-1) : R(1);
        if (alikeAbout(i)) { phi[i] = sign*band; return; }
        const typename UniformGrid<D>::Index c = grid.cellIndex(i);
        if (!atSurface(grid, carried, c)) { phi[i] = sign*band; return; }
        const R slope = slopeOf(grid, carried, c);
        phi[i] = fairSlope(slope) ? value : value/maximum(slope, R(0.2));
        phi[i] = sign*minimum(absolute(phi[i]), R(grid.h));
    }

private:

    //- Most cells, by numbers of cells alone: at the ends of rows that may say no, and the long way says the same
    HD bool alikeAbout(int i) const
    {
        const bool wet = carried[i] < 0;
        int stride = 1;
        for (int d = 0; d < D; ++d)
        {
            if (grid.periodic[d] || i < stride || i + stride >= grid.cells()) return false;
            if ((carried[i - stride] < 0) != wet || (carried[i + stride] < 0) != wet) return false;
            stride *= grid.n[d];
        }
        return true;
    }
};

//- |phi| from the smaller neighbours along each axis: (a - m1)^2 + ... = h^2 over those below a
template<int D, class R>
HD R godunov(R* m, R h)
{
    for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b) if (m[b] < m[a]) { const R t = m[a]; m[a] = m[b]; m[b] = t; }
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

    HD void operator()(int i) const
    {
        if (farFromAll(i)) { to[i] = from[i]; return; }
        const typename UniformGrid<D>::Index c = grid.cellIndex(i);
        if (atSurface(grid, carried, c)) { to[i] = from[i]; return; }
        R m[D];
        for (int d = 0; d < D; ++d)
        {
            typename UniformGrid<D>::Index low = c, high = c;
            low.c[d] -= 1;
            high.c[d] += 1;
            m[d] = minimum(absolute(cellValue(grid, from, low)), absolute(cellValue(grid, from, high)));
        }
        const R h = R(grid.h), distance = minimum(godunov<D>(m, h), band), own = absolute(carried[i]);
        const R sign = carried[i] < 0 ? R(-1) : R(1);
        const bool keep = absolute(own - distance) < R(0.3)*h && own < R(3)*h && fairSlope(slopeOf(grid, carried, c));
        to[i] = sign*(keep ? own : distance);
    }

private:

    //- Most cells: nothing has reached them or their neighbours yet. By numbers of cells alone: at the ends of rows that may say no, and
    //  the long way says the same
    HD bool farFromAll(int i) const
    {
        if (absolute(from[i]) < band) return false;
        int stride = 1;
        for (int d = 0; d < D; ++d)
        {
            if (grid.periodic[d] || i < stride || i + stride >= grid.cells()) return false;
            if (absolute(from[i - stride]) < band || absolute(from[i + stride]) < band) return false;
            stride *= grid.n[d];
        }
        return true;
    }
};

} // namespace riprap
