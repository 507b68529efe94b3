/*  Solid particles as points among the fluid: sorted into the fluid's cells by key, with records as
    walls have them.

    Over a step of the fluid a solid moves from x_n to x_{n+1}; the fluid sees it on the straight
    line between them, with the mean velocity u = (x_{n+1} - x_n)/dt: volume that it takes is then
    the way that it went. The acceleration that extrapolation takes is that of u, smoothed over (1 +
    M/m) h/c0: h/c0 is what pressure needs to pass a particle, M = 2 rho0 V h/R the water about a
    solid particle that its pressure moves; of the parts of a rigid body M and m are the body's.
    Pressure of an acceleration that pressure makes: taken at once, it would swing where M > m.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/solidView.hpp"
#include "core/neighbours/cellGrid.hpp"
#include "core/neighbours/localFrames.hpp"
#include "sph/state/fluidFields.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

//- What is kept of the points; by slot in the fluid's cells but where it says by key
template<int D, class P>
struct SolidPoints
{
    using real = typename P::real;

    const std::uint32_t* key;   // of a slot
    const int* active;          // slots in use
    real* mass;                 // rho0 V [kg]
    const real* massOfKey;
    const real* addedOfKey;     // M/m
    std::int64_t* last[D];      // x_n, fixed point in the fluid's box
    real* own[D];               // u [m/s]
    real* velocity;             // u of the step before, D a key
    real* acceleration;         // smoothed, D a key
    real* force;                // of the fluid, D a key [N]
};

template<int D, class P>
HD Vec<D, std::int64_t> pointPosition(const Box<D, P>& box, const SolidView<D, P>& solids, int slot)
{
    Vec<D, std::int64_t> x;
    for (int d = 0; d < D; ++d)
        x.c[d] = box.toFixedInside(d, solids.box.toMetres(d, solids.fields.x[d][slot]));
    return x;
}

template<int D, class P>
struct PointKeys
{
    static constexpr const char* name = "solidPointKeys";

    Box<D, P> box;
    CellGrid<D, P> grid;
    SolidView<D, P> solids;
    std::uint32_t* keys;
    std::uint32_t* indices;

    HD void operator()(int key) const
    {
        const int slot = solids.slotOf[key];
        std::uint32_t cell = std::uint32_t(grid.cells);
        if (slot >= 0)
        {
            const Vec<D, std::int64_t> x = pointPosition(box, solids, slot);
            Vec<D, typename P::real> r;
            for (int d = 0; d < D; ++d) r.c[d] = box.pairRelative(d, box.pairPosition(d, x.c[d]));
            cell = std::uint32_t(grid.cellOf(r));
        }
        keys[key] = cell;
        indices[key] = std::uint32_t(key);
    }
};

//- Records of sorted points, at rest density and without pressure
template<class Backend, int D, class P>
struct PlacePoints
{
    using real = typename P::real;
    static constexpr const char* name = "placeSolidPoints";

    Box<D, P> box;
    SolidView<D, P> solids;
    SolidPoints<D, P> points;
    RecordsView<Backend, D, P> records;
    typename P::position* reference[D];
    FluidModel<D, P> model;
    LocalFrames<D, P> frames;

    HD void operator()(int i) const
    {
        if (i >= *points.active) return;
        const int key = int(points.key[i]);
        const Vec<D, std::int64_t> x = pointPosition(box, solids, solids.slotOf[key]);
        Vec<D, typename P::position> p;
        PairParticle<D, real> q;
        for (int d = 0; d < D; ++d)
        {
            points.last[d][i] = x.c[d];
            reference[d][i] = p.c[d] = box.pairPosition(d, x.c[d]);
            q.velocity.c[d] = points.own[d][i] = points.velocity[std::size_t(key)*D + d];
        }
        points.mass[i] = points.massOfKey[key];
        q.pressureTerm = 0;
        q.density = model.rho0;
        q.h = model.h0;
        records.storePosition(i, p);
        records.store(i, q);
        if constexpr (Backend::gpu) frames.include(box, p, q.velocity);
    }
};

//- Is there fluid in the cells about any point?
template<int D, class P>
struct MeetFluid
{
    static constexpr const char* name = "meetFluid";

    Box<D, P> box;
    CellGrid<D, P> grid;
    SolidView<D, P> solids;
    const std::uint32_t* key;
    const int* active;
    const int* fluidStart;      // of each cell
    int* meets;                 // set to 1: whoever writes it writes the same
    bool each;                  // of each slot, not of all together
    // what may come within the support, both moving, until the next sort [m]
    typename P::real reach;

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        const Vec<D, std::int64_t> x = pointPosition(box, solids, solids.slotOf[key[i]]);
        Vec<D, typename P::real> r;
        for (int d = 0; d < D; ++d) r.c[d] = box.pairRelative(d, box.pairPosition(d, x.c[d]));
        bool found = false;
        grid.forEachRangeWithin(
            r, reach, fluidStart, [&](int begin, int end) { found = found || end > begin; });
        if (found) meets[each ? i : 0] = 1;
    }
};

template<class R>
struct ClearForces
{
    static constexpr const char* name = "clearForces";

    R* force;

    HD void operator()(int i) const { force[i] = 0; }
};

//- As FluidToSolidPass leaves a point without neighbours
template<int D, class P>
struct ClearPointForces
{
    static constexpr const char* name = "clearPointForces";

    SolidPoints<D, P> points;
    typename P::real fluidMass;

    HD void operator()(int i) const
    {
        if (i >= *points.active) return;
        for (int d = 0; d < D; ++d)
            points.force[std::size_t(points.key[i])*D + d] = -fluidMass*typename P::real(0);
    }
};

//- Velocities of the start, which no step has yet shown
template<int D, class P>
struct FirstVelocities
{
    static constexpr const char* name = "firstSolidVelocities";

    SolidView<D, P> solids;
    SolidPoints<D, P> points;

    HD void operator()(int key) const
    {
        const int slot = solids.slotOf[key];
        for (int d = 0; d < D; ++d)
        {
            points.velocity[std::size_t(key)*D + d] = slot < 0
                ? 0
                : typename P::real(solids.fields.v[d][slot]);
            points.acceleration[std::size_t(key)*D + d] = 0;
            points.force[std::size_t(key)*D + d] = 0;
        }
    }
};

//- Points at the middle of a step or at its end
template<class Backend, int D, class P>
struct MovePoints
{
    using real = typename P::real;
    static constexpr const char* name = "moveSolidPoints";

    Box<D, P> box;
    SolidView<D, P> solids;
    SolidPoints<D, P> points;
    RecordsView<Backend, D, P> records;
    typename P::position* reference[D];
    real allowedWay;
    double responseTime;        // h/c0 [s]
    bool half;
    ClockData* clock;
    // GPU: what the way since the search is measured against, as the fluid's is
    LocalFrames<D, P> frames;

    HD void operator()(int i) const
    {
        if (!clock->active || i >= *points.active) return;
        const int key = int(points.key[i]), slot = solids.slotOf[key];
        // it has left since it was sorted: where it was, until the next sort
        if (slot < 0)
        {
            if (!half) checkSkin(i, records.loadPosition(i), filled<D>(real(0)));
            return;
        }
        const Vec<D, std::int64_t> x = pointPosition(box, solids, slot);
        PairParticle<D, real> q = records.template load<false>(i);
        Vec<D, typename P::position> p;
        Vec<D, real> own;
        for (int d = 0; d < D; ++d)
        {
            const std::int64_t from = points.last[d][i],
                               way = std::int64_t(std::uint64_t(x.c[d]) - std::uint64_t(from));
            const real u = real(double(way)*box.unit[d]/clock->dt);
            q.velocity.c[d] = own.c[d] = points.own[d][i] = u;
            p.c[d] = box.pairPosition(d, half ? from + way/2 : x.c[d]);
            if (!half) follow(d, i, key, x.c[d], u);
        }
        records.storePosition(i, p);
        storeVelocity(i, q);
        if (!half) checkSkin(i, p, own);
    }

private:

    //- As the fluid's Mover does
    HD void checkSkin(int i, const Vec<D, typename P::position>& p, const Vec<D, real>& u) const
    {
        const real ahead = real(1.25)*real(clock->fullDt);
        Vec<D, typename P::position> from;
        real distance2 = 0, speed2 = 0;
        for (int d = 0; d < D; ++d)
        {
            from.c[d] = reference[d][i];
            const real s = box.template separation<real>(d, p.c[d], from.c[d]);
            distance2 += s*s;
            speed2 += u.c[d]*u.c[d];
        }
        if constexpr (Backend::gpu)
            if (frames.frame)
                return clock->notice(
                    frames.since(box, from, p, u, real(clock->time - clock->searched), ahead),
                    allowedWay);
        const real distance = squareRoot(distance2);
        if (distance > allowedWay) clock->skinViolations = 1;
        if (distance + ahead*squareRoot(speed2) > allowedWay) clock->needRebuild = 1;
    }

    HD void storeVelocity(int i, PairParticle<D, real> q) const
    {
        if (records.h) q.h = records.h[i];
        records.store(i, q);
    }

    HD void follow(int d, int i, int key, std::int64_t x, real u) const
    {
        real& before = points.velocity[std::size_t(key)*D + d];
        real& a = points.acceleration[std::size_t(key)*D + d];
        const double share = 1
            - exp(-clock->dt/((1 + double(points.addedOfKey[key]))*responseTime));
        a += real(share*((double(u) - before)/clock->dt - a));
        before = u;
        points.last[d][i] = x;
    }
};

template<class R>
struct KeepForces
{
    static constexpr const char* name = "keepForces";

    const R* force;
    R* before;

    HD void operator()(int i) const { before[i] = force[i]; }
};

//- The force that solids are given over a step, by those of its beginning and of the beginning of
//  the step before (fluidForces.hpp)
template<int D, class P>
struct HoldForces
{
    using real = typename P::real;
    static constexpr const char* name = "holdForces";

    const real* force;
    const real* before;         // null: not needed
    real* external;
    double share, shareBefore;

    HD void operator()(int key) const
    {
        constexpr int width = D + spins<D>;
        for (int d = 0; d < D; ++d)
        {
            const std::size_t at = std::size_t(key)*D + d;
            external[std::size_t(key)*width + d] = real(
                share*force[at] + (before ? shareBefore*before[at] : 0));
        }
    }
};

} // namespace riprap
