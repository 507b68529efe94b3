/*  What follows from the pressure: u = u* - dt/rho grad p on every open face that has a wet cell on either side, with the
    gradient that the equation was made of, so that the fluxes of a wet cell sum to zero as closely as it was solved.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/extrapolate.hpp"
#include "pic/pressure/assemble.hpp"

namespace riprap
{

//- p back in the order of the grid, 0 in dry cells
template<int D, class R>
struct StorePressure
{
    static constexpr const char* name = "pressureStore";
    UniformGrid<D> grid;
    const int* wet;
    FineData<D> fine;
    double* p;

    HD void operator()(int i) const
    {
        const auto x = grid.cellIndex(i);
        int c = 0;
        for (int d = 0; d < D; ++d) c += x.c[d]*fine.shape.stride[d];
        p[i] = wet[i] ? fine.x[c] : 0;
    }
};

//- Velocity of face i of direction d
template<int D, class R>
struct CorrectVelocity
{
    static constexpr const char* name = "pressureProject";
    PressureFields<D, R> f;
    const int* wet;
    int d;

    HD void operator()(int i) const
    {
        if (!(f.aperture[d][i] > R(0))) return;
        const auto x = f.grid.faceIndex(d, i);
        const int lower = f.grid.cellOf(d, x, 0), upper = f.grid.cellOf(d, x, 1);
        const bool wetLower = lower >= 0 && wet[lower], wetUpper = upper >= 0 && wet[upper];
        if (!wetLower && !wetUpper) return;
        double difference;
        if (wetLower && wetUpper) difference = f.p[upper] - f.p[lower];
        else if (wetUpper) difference = f.p[upper]/(lower < 0 ? endTheta : surfaceTheta(f.phi[upper], f.phi[lower]));
        else difference = -f.p[lower]/(upper < 0 ? endTheta : surfaceTheta(f.phi[lower], f.phi[upper]));
        f.u[d][i] = R(double(f.u[d][i]) - f.timeStep/(f.density*f.grid.h)*difference);
    }
};

//- What particles were left ahead by at faces that are all but closed: extended from beside them (leastKnown), it is not what the impulse has done there, which bodies and walls have felt
template<int D, class R>
struct SlitsAhead
{
    static constexpr const char* name = "slitsAhead";
    CorrectVelocity<D, R> by;   // u: `after`, p: the impulse, in a step of 1

    HD void operator()(int i) const
    {
        const R a = by.f.aperture[by.d][i];
        if (!(a > R(0)) || a > R(leastKnown) || atEnd(by.f.grid, by.d, by.f.grid.faceIndex(by.d, i).c[by.d])) return;
        by.f.u[by.d][i] = 0;
        by(i);
    }
};

} // namespace riprap
