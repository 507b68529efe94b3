/*  What the grid's water is like at points: how much of a cell about the point is water, pressure
    and velocity.

    The fraction is linear between cells, so that 1/2 is where phi is 0, but the surface is no wider
    than a cell. Points in solids are dry.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/solidField.hpp"
#include "pic/grid/pressureAt.hpp"
#include "pic/transfer/moveParticles.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

template<int D, class R>
struct SamplePoints
{
    static constexpr const char* name = "samplePoints";
    // of a point: fraction, pressure [Pa], velocity [m/s]
    static constexpr int values = 2 + D;
    UniformGrid<D> grid;
    SolidField<D, R> solids;                    // distance nullptr: there are none
    const R* phi;
    const double* p;
    const R* u[D];
    const double* x;                            // D a point, above the block's corner
    double* result;

    HD void operator()(int i) const
    {
        double* r = result + std::size_t(values)*i;
        for (int k = 0; k < values; ++k) r[k] = 0;
        Vec<D, double> at;
        for (int d = 0; d < D; ++d) at.c[d] = x[std::size_t(D)*i + d];
        at = intoBlock(grid, at);
        Vec<D, double> normal;
        if (solids.distance && solids.at(at, normal) < 0) return;
        const double distance = sampleCell<1>(grid, phi, at), fraction = 0.5 - distance/grid.h;
        r[0] = fraction < 0 ? 0 : (fraction > 1 ? 1 : fraction);
        if (distance > grid.h) return;
        r[1] = distance < 0 ? pressureAt(grid, phi, p, at) : 0.0;
        for (int d = 0; d < D; ++d) r[2 + d] = sampleFace<1>(grid, u[d], d, at);
    }
};

} // namespace riprap
