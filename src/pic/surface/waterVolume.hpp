/*  Volume of the water under phi, and the shift of phi that holds it.

    A cell is cut by the plane phi_c + grad phi.(x - x_c) = 0: with m_d = h |d phi/d x_d| and a =
    sum m/2 - phi_c, the part of it under the plane is
        2D   (a^2 - sum (a - m_d)+^2 + (a - m_1 - m_2)+^2)/(2 m_1 m_2)
        3D   (a^3 - sum (a - m_d)+^3 + sum (a - m_d - m_e)+^3 - (a - m_1 - m_2 - m_3)+^3)/(6 m_1 m_2
             m_3)
    (Scardovelli & Zaleski 2000, J. Comput. Phys. 164). The volume that steps lose or gain, of the
    order of the truncation error, is given back by moving the surface everywhere by the same
    distance, (V - V0)/S.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/math.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

//- (b+^D - (b - m)+^D)/m: differences of nearly equal powers would drown in round-off where m is
//  small
template<int D>
HD double powerDifference(double b, double m)
{
    if (b <= 0) return 0;
    const double lower = b > m ? b - m : 0.0, part = b > m ? 1.0 : b/m;
    return part*(D == 2 ? b + lower : b*b + b*lower + lower*lower);
}

//- Part of a unit cell under a plane: phi at its centre and its differences over the cell. Exact to
//  round-off for every plane: the sums of the formulas are taken where a is small against what they
//  are divided by, and without the smallest difference in any denominator
template<int D>
HD double cutFraction(double phi, double* m)
{
    double sum = 0;
    for (int d = 0; d < D; ++d) { m[d] = absolute(m[d]); sum += m[d]; }
    if (phi <= -0.5*sum) return 1;
    if (phi >= 0.5*sum) return 0;
    for (int d = 0; d < D; ++d)
        for (int e = d + 1; e < D; ++e)
            if (m[e] < m[d])
            {
                const double t = m[d];
                m[d] = m[e];
                m[e] = t;
            }
    const double a = 0.5*sum - absolute(phi);           // the smaller part
    double v;
    if constexpr (D == 2) v = powerDifference<2>(a, m[0])/(2*m[1]);
    else if (a >= m[0] + m[1] && a <= m[2]) v = (a - 0.5*(m[0] + m[1]))/m[2];
    else
    {
        const auto part = [&](double b) { return powerDifference<3>(b, m[0]); };
        v = (part(a) - part(a - m[1]) - part(a - m[2]) + part(a - m[1] - m[2]))/(6*m[1]*m[2]);
    }
    return phi < 0 ? 1 - v : v;
}

//- Part of a cell that is water, phi moved by `shift`
template<int D, class R>
HD double waterFraction(const UniformGrid<D>& g, const R* phi, int i,
    const typename UniformGrid<D>::Index& c, double shift)
{
    const double value = phi[i] + shift;
    if (absolute(value) > 2*g.h) return value < 0 ? 1 : 0;
    const CellNeighbours<D, R> near(g, phi, c);
    double m[D];
    for (int d = 0; d < D; ++d) m[d] = 0.5*(double(near.above.c[d]) - double(near.below.c[d]));
    return cutFraction<D>(value, m);
}

template<int D, class R>
HD double waterFraction(const UniformGrid<D>& g, const R* phi, int i, double shift)
{
    return waterFraction(g, phi, i, g.cellIndex(i), shift);
}

//- Volumes in cells: with phi as it is, a little higher, a little lower
template<int D, class R>
struct WaterVolume
{
    static constexpr const char* name = "waterVolume";
    UniformGrid<D> grid;
    const R* phi;
    const R* open;              // cells: part that is not solid; nullptr: all of each
    double probe;               // [m]

    HD void add(int i, double* sums) const { add(i, grid.cellIndex(i), sums); }

    HD void add(int i, const typename UniformGrid<D>::Index& c, double* sums) const
    {
        const double whole = open ? double(open[i]) : 1.0;
        if (!(whole > 0)) return;
        sums[0] += whole*waterFraction(grid, phi, i, c, 0);
        sums[1] += whole*waterFraction(grid, phi, i, c, probe);
        sums[2] += whole*waterFraction(grid, phi, i, c, -probe);
    }
};

template<int D, class R>
struct ShiftSurface
{
    static constexpr const char* name = "shiftSurface";
    R* phi;
    R shift, band;
    HD void operator()(int i) const { if (absolute(phi[i]) < band) phi[i] += shift; }
};

} // namespace riprap
