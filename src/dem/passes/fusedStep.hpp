/*  A whole step in one kernel (GPU): forces at the positions at hand, then kick and drift. A
    particle reads its neighbours' old records and writes its own new ones; what walls that are
    surfaces and bonds do to it has been put beside it by kernels of their own, over those alone
    that have any.

    Every thread works out the step's clock for itself from that of the step before; flags go to the
    new clock, so that a step begins for all particles or for none.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/bond/bondPass.hpp"
#include "dem/passes/gatherPass.hpp"
#include "dem/motion/mover.hpp"
#include "dem/walls/wallPass.hpp"

namespace riprap
{

template<class Backend, int D, class P, class Law>
struct FusedStep
{
    using real = typename P::real;
    using position = typename P::position;
    using Own = OwnWords<real>;
    static constexpr const char* name = "step";
    static constexpr int residentBlocks = sizeof(real) == 4 ? (Law::template history<D> > 4 ? 6 : 8)
                                                            : 4;

    ContactGather<Backend, D, P, Law> contacts;
    MoveSolids<D, P> mover;
    StepState<D, P> state;
    const DemClockData* now;
    DemClockData* next;

    WallPass<D, P, Law> walls;
    BondTable bonds;
    const BondForce<D, real>* bondForce;
    bool sleeping;                  // may anyone be asleep?

    HD void operator()(int i) const
    {
        if (!begins(i) || i >= *contacts.active) return;
        if (sleeping && (state.own[i].flags & Own::asleep)) return;
        int material;
        const Vec<D, position> high = state.from.position(i);
        const ContactBody<D, real> self = state.from.body(i, material);
        Vec<D, real> force = filled<D>(real(0));
        Spin<D, real> moment = filled<spins<D>>(real(0));
        // first, while there is little else in registers
        if (state.own[i].flags & Own::nearWall) addWalls(i, self, material, force, moment);
        contacts.sum(i, high, self, material, real(now->dt), force, moment);
        const Own own = state.own[i];
        if (own.flags & Own::bonded)
            GatherBonds<D, P>::sum(bonds, bondForce, own.id, force, moment);
        move(i, high, self, own, material, force, moment);
    }

private:

    HD bool begins(int i) const
    {
        const DemClockData t = ticked(*now);
        if (i == 0) publish(t);
        return t.active;
    }

    //- While steps go on, flags are raised by those whom they concern; what the steps before have
    //  raised stays
    HD void publish(const DemClockData& t) const
    {
        next->time = t.time;
        next->target = t.target;
        next->dt = t.dt;
        next->previousDt = t.previousDt;
        next->windowEnd = t.windowEnd;
        next->fullDt = t.fullDt;
        next->searched = t.searched;
        next->step = t.step;
        next->lastStep = t.lastStep;
        next->active = t.active;
        next->needWindow = t.needWindow;
        for (int k = 0; k < 2; ++k)
        {
            if (t.aged[k]) next->aged[k] = 1;
            if (t.far[k]) next->far[k] = 1;
        }
        if (t.active) return;
        next->needRebuild = t.needRebuild;
        next->halt = t.halt;
    }

    //- Planes here; surfaces, which take more, have had their pass
    HD void addWalls(int i, const ContactBody<D, real>& self, int material, Vec<D, real>& force,
        Spin<D, real>& moment) const
    {
        const WallMemory<D, real>& memory = walls.memory;
        for (int e = memory.entryFirst[i]; e < memory.entryFirst[i + 1]; ++e)
        {
            const WallData& w = walls.walls[memory.entry[e].wall];
            if (w.plane)
            {
                Vec<D, real> f = filled<D>(real(0));
                Spin<D, real> m = filled<spins<D>>(real(0));
                real energy = 0, overlap = 0;
                walls.planeForce(
                    e, w, self, material, walls.inMetres(state.place(i)), f, m, energy, overlap);
                force = force + f;
                moment = moment + m;
                continue;
            }
            const real* kept = memory.force + (long long)e*wallWords<D>;
            for (int d = 0; d < D; ++d) force.c[d] += kept[d];
            for (int c = 0; c < spins<D>; ++c) moment.c[c] += kept[D + c];
        }
    }

    HD void move(int i, const Vec<D, position>& high, const ContactBody<D, real>& self,
        const Own& own, int material, const Vec<D, real>& force, const Spin<D, real>& moment) const
    {
        // once more: cheaper than to hold it in registers all along
        const DemClockData t = ticked(*now);
        Vec<D, std::int64_t> x;
        Vec<D, double> v;
        Spin<D, real> w = self.spin;
        for (int d = 0; d < D; ++d)
        {
            const LowWords<P> low = state.low[d][i];
            x.c[d] = state.whole(high.c[d], low);
            v.c[d] = state.wholeVelocity(self.velocity.c[d], low);
        }
        const GroupData<D, real>& group = mover.groups[own.group];
        if (group.motion >= 0) mover.prescribe(group.motion, t.time - 0.5*t.dt, x, v, w);
        else
            mover.kick(group, own.id, self.mass, own.inverseInertia, force, moment, v, w,
                real(0.5*(t.previousDt + t.dt)));
        Vec<D, position> p;
        for (int d = 0; d < D; ++d)
        {
            x.c[d] += std::int64_t(rint(v.c[d]*t.dt*mover.box.unitsPerMetre[d]));
            p.c[d] = mover.box.pairPosition(d, x.c[d]);
            state.low[d][i] = state.lowOf(x.c[d], v.c[d]);
        }
        if (mover.fields.turn[0]) mover.followTurn(i, w, t.dt);
        const Vec<D, real> single = convert<real>(v);
        state.to.store(i, p, ContactBody<D, real>{single, w, self.radius, self.mass}, material);
        mover.checkSkin(i, p, x, single, t, next);
    }
};

} // namespace riprap
