/*  What acts on the grid's velocity before the pressure, u* = u + dt g, and what becomes of it
    after.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/extrapolate.hpp"
#include "pic/grid/mirror.hpp"

namespace riprap
{

//- Closed faces have their wall's velocity
template<int D, class R>
struct ApplyForces
{
    static constexpr const char* name = "applyForces";
    const R* aperture;
    const R* wallVelocity;      // nullptr: walls rest
    const R* from;
    R* u;
    R gravity;                  // g dt of this direction [m/s]
    // rates of zones that absorb waves [1/s], nullptr: there are none (absorb.hpp)
    const R* absorb;
    R timeStep;

    HD void operator()(int i) const
    {
        const R kept = absorb ? 1/(1 + absorb[i]*timeStep) : R(1);
        u[i] = aperture[i] > R(0) ? from[i]*kept + gravity
                                  : (wallVelocity ? wallVelocity[i] : R(0));
    }
};

//- What the step before this one has left: `after` becomes the velocity that particles bring, less
//  what they had beyond the projected one, which `last` becomes
template<class R>
struct KeepLast
{
    static constexpr const char* name = "keepLast";
    const R* u;
    const R* before;
    R* after;
    R* last;

    HD void operator()(int i) const
    {
        after[i] = before[i] - (after[i] - u[i]);
        last[i] = u[i];
    }
};

//- What half a drift makes of the velocity: `after`, that of its divergence, which the pressure
//  holds back while particles move; `last`, that of the projected velocity. See Projection::project
template<class R>
struct HalfDrift
{
    static constexpr const char* name = "halfDrift";
    const R* u;                 // projected, without forces
    R* after;                   // before: what was projected
    R* last;
    R part;                     // half the coming drift over the one before; 0: there was none

    HD void operator()(int i) const
    {
        after[i] = part*(u[i] - after[i]);
        last[i] = part*(u[i] - last[i]);
    }
};

//- Of the pressure that makes `after`: its impulse, -rho times which gradient `after` is [Pa s]
struct HalfImpulse
{
    static constexpr const char* name = "halfImpulse";
    const double* p;            // of the first solution
    double* ahead;
    double time;                // half the coming drift over the one before, of the kick [s]

    HD void operator()(int i) const { ahead[i] = time*p[i]; }
};

//- What the water feels in a step: the pressure that is solved for, and by which particles are left
//  ahead
struct WholePressure
{
    static constexpr const char* name = "wholePressure";
    const int* wet;
    const double* p;
    const double* ahead;
    double* whole;
    double timeStep;

    HD void operator()(int i) const { whole[i] = wet[i] ? p[i] + ahead[i]/timeStep : 0; }
};

//- Of the projected velocity u: what particles take (after), what has changed, and what carries
//  them
template<class R>
struct VelocityChange
{
    static constexpr const char* name = "velocityChange";
    const R* u;
    const R* before;
    R* du;
    R* after;                   // nullptr: u itself
    R* carrier;                 // nullptr: u itself

    HD void operator()(int i) const
    {
        R value = u[i];
        if (after) value = after[i] += u[i];
        if (carrier) carrier[i] += u[i];
        du[i] = value - before[i];
    }
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
