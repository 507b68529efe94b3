/*  What acts on the grid's velocity before the pressure: gravity and viscosity, explicit, and walls.

        u* = u + dt (g + nu lap u)

    lap u by differences between faces of the same direction. Beyond a side of the block the tangential velocity is the mirror image of that inside (slip) or its
    opposite, so that it vanishes at the wall (noSlip); beyond the surface it is the extrapolated one: no stress.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/transfer/mirror.hpp"

namespace riprap
{

template<int D, class R>
struct ApplyForces
{
    static constexpr const char* name = "applyForces";
    UniformGrid<D> grid;
    int component;
    const R* aperture;
    const R* wallVelocity;      // nullptr: walls rest
    const R* before;
    R* u;
    R gravity;                  // g dt of this direction [m/s]
    R diffusion;                // nu dt/h^2
    bool noSlip;

    HD void operator()(int i) const
    {
        if (!(aperture[i] > R(0))) { u[i] = wallVelocity ? wallVelocity[i] : R(0); return; }
        R change = gravity;
        if (diffusion > 0)
        {
            const typename UniformGrid<D>::Index f = grid.faceIndex(component, i);
            R sum = 0;
            for (int d = 0; d < D; ++d)
                for (int offset = -1; offset <= 1; offset += 2)
                {
                    typename UniformGrid<D>::Index at = f;
                    at.c[d] += offset;
                    const bool beyond = !grid.periodic[d] && d != component && (at.c[d] < 0 || at.c[d] >= grid.n[d]);
                    const R value = faceValue(grid, before, component, at);
                    sum += (beyond && noSlip ? -value : value) - before[i];
                }
            change += diffusion*sum;
        }
        u[i] = before[i] + change;
    }
};

//- du = u - u before the step, where the water flows
template<class R>
struct VelocityChange
{
    static constexpr const char* name = "velocityChange";
    const R* u;
    const R* before;
    R* du;
    const R* excess;            // nullptr: none
    R part;                     // of excess that is added
    HD void operator()(int i) const { du[i] = u[i] - before[i] + (excess ? part*excess[i] : R(0)); }
};

//- The last layer of faces along a periodic direction is a copy of the first
template<int D, class R>
struct CopyPeriodic
{
    static constexpr const char* name = "copyPeriodic";
    UniformGrid<D> grid;
    int component;
    R* u;

    HD void operator()(int i) const
    {
        typename UniformGrid<D>::Index f = grid.faceIndex(component, i);
        if (f.c[component] != grid.n[component]) return;
        f.c[component] = 0;
        u[i] = u[grid.face(component, f)];
    }
};

} // namespace riprap
