/*  A free rigid body in the pressure equation (paper 2, Eqs. 5 and 6).

        (A + J M^-1 J^T) p = (J V* - div(a u*))/dt,    V = V* - dt M^-1 J^T p

    J V is the flux that the body's velocity V pushes into each cell, s S v.n over its faces (s: the
    body's share of the face, v taken at the centroid of that share), so that -J^T p is the force
    and moment of the water, by the same faces: momentum is exchanged exactly. Modes: 2D vx, vy,
    spin; 3D vx, vy, vz and the spins.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <stdexcept>
#include <vector>
#include "core/simd/vec.hpp"

namespace riprap
{

template<int D> inline constexpr int bodyModes = D == 2 ? 3 : 6;

//- L with L L^T = M^-1, by rows; l is zero on entry
inline void rootOfInverseMass(int modes, const double* inverseMass, double* l)
{
    // a body that is held in some ways has no root there
    const double roundOff = 1e-12;
    for (int a = 0; a < modes; ++a)
        for (int b = 0; b <= a; ++b)
        {
            const double own = inverseMass[a*modes + b];
            double sum = own;
            for (int k = 0; k < b; ++k) sum -= l[a*modes + k]*l[b*modes + k];
            if (a != b) l[a*modes + b] = l[b*modes + b] > 0 ? sum/l[b*modes + b] : 0;
            else if (sum < -roundOff*own)
                throw std::invalid_argument("the mass of a body is not positive");
            else l[a*modes + a] = sum <= roundOff*own ? 0 : std::sqrt(sum);
        }
}

//- Is a body's mean density below this, along any direction in which it gives way?
inline bool isLighter(int modes, const double* inverseMass, double volume, double density)
{
    bool lighter = false;
    for (int m = 0; m < (modes == 3 ? 2 : 3); ++m)
        lighter = lighter || inverseMass[m*modes + m]*density*volume > 1;
    return lighter;
}

struct BodyTerm
{
    int modes = 0;
    std::vector<int> cell;                  // cells beside the body, of the grid
    std::vector<double> j;                  // modes values a cell [m2, m3]
    std::vector<double> inverseMass;        // modes x modes
    std::vector<double> velocity;           // V*, and then V
    // as its shares of the faces across `up` see it [m3]: what buoyancy acts on
    double volume = 0;

    //- J^T p
    std::vector<double> gather(const double* p) const
    {
        std::vector<double> sum(modes, 0.0);
        for (std::size_t i = 0; i < cell.size(); ++i)
            for (int m = 0; m < modes; ++m) sum[m] += j[i*modes + m]*p[cell[i]];
        return sum;
    }

    //- V from V* and p
    void advance(const double* p, double dt)
    {
        const std::vector<double> impulse = gather(p);
        for (int a = 0; a < modes; ++a)
            for (int b = 0; b < modes; ++b) velocity[a] -= dt*inverseMass[a*modes + b]*impulse[b];
    }

    bool lighterThan(double density) const
    {
        return isLighter(modes, inverseMass.data(), volume, density);
    }

    //- L with L L^T = M^-1, by rows
    std::vector<double> rootOfInverseMass() const
    {
        std::vector<double> l(modes*modes, 0.0);
        riprap::rootOfInverseMass(modes, inverseMass.data(), l.data());
        return l;
    }
};

//- How fast mode m moves a point at r from the centre along d
template<int D>
HD double modeVelocity(int m, int d, const Vec<D, double>& r)
{
    if (m < D) return m == d ? 1 : 0;
    if (D == 2) return d == 0 ? -r[1] : r[0];
    const int e = m - D;                    // spin about e: (e x r) along d
    if (d == (e + 1) % 3) return -r[(e + 2) % 3];
    if (d == (e + 2) % 3) return r[(e + 1) % 3];
    return 0;
}

} // namespace riprap
