/*  Motion of particles. Forces are known at the positions at hand; a step is kick and drift, then
    the pass over contacts:

        leapfrog  v_{n+1/2} = v_{n-1/2} + a_n (dt_{n-1} + dt_n)/2,    x_{n+1} = x_n + v_{n+1/2} dt_n
        Verlet    v_{n+1/2} = v_n + a_n dt/2, x_{n+1} likewise, v_{n+1} = v_{n+1/2} + a_{n+1} dt/2
                  after the pass (paper 2, Eqs. 21 to 23, X_k = X_a)

    spins alike. Contacts see half-step velocities with the new positions, so that a spring's
    stretch is exactly what the bodies did. Local damping (paper 1, Eq. 25) acts on each component
    of the unbalanced force and moment, viscous damping is -c m v.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/localFrames.hpp"
#include "dem/motion/clump.hpp"
#include "dem/motion/motionTable.hpp"
#include "dem/lists/solidRecords.hpp"

namespace riprap
{

//- Accelerations of a particle
template<int D, class P>
struct SolidMotion
{
    using real = typename P::real;

    SolidFields<D, P> fields;
    const GroupData<D, real>* groups;
    real gravity[D];
    const real* external;       // by key: D + spins numbers; null: none
    DemClockData* clock;
    const int* active;

    //- v and w changed by forces over dt
    HD void kick(int i, Vec<D, double>& v, Spin<D, real>& w, real dt) const
    {
        kick(groups[fields.group[i]], external ? fields.id[i] : 0, fields.mass[i],
            fields.inverseInertia[i], fields.force(i), fields.momentOn(i), v, w, dt);
    }

    HD void kick(const GroupData<D, real>& g, int id, real mass, real inverse, Vec<D, real> f,
        Spin<D, real> m, Vec<D, double>& v, Spin<D, real>& w, real dt) const
    {
        const real perMass = dt/mass;
        const real* more = external ? external + (long long)id*(D + spins<D>) : nullptr;
        for (int d = 0; d < D; ++d) f.c[d] += g.gravity*mass*gravity[d] + g.force[d];
        for (int c = 0; c < spins<D>; ++c) m.c[c] += g.moment[c];
        if (more)
        {
            for (int d = 0; d < D; ++d) f.c[d] += more[d];
            for (int c = 0; c < spins<D>; ++c) m.c[c] += more[D + c];
        }
        if (g.damped)
        {
            for (int d = 0; d < D; ++d)
            {
                const real speed = real(v.c[d]);
                f.c[d] = locallyDamped(f.c[d], speed, g.localDamping) - g.viscous*mass*speed;
            }
            for (int c = 0; c < spins<D>; ++c)
                m.c[c] = locallyDamped(m.c[c], w.c[c], g.localDamping)
                    - g.viscousSpin/inverse*w.c[c];
        }
        for (int d = 0; d < D; ++d) v.c[d] += double(g.free[d]*perMass*f.c[d]);
        for (int c = 0; c < spins<D>; ++c) w.c[c] += g.freeSpin*dt*inverse*m.c[c];
    }
};

template<int D, class P>
struct MoveSolids : SolidMotion<D, P>
{
    using real = typename P::real;
    using position = typename P::position;
    static constexpr const char* name = "moveSolids";

    Box<D, P> box;
    SolidRecords<D, P> solids;
    bool verlet;
    position* reference[D];     // where neighbours were found
    LocalFrames<D, P> frames;       // fused steps: what the way since then is measured against
    real halfSkin;
    // [m] more than its speed foretells, that a particle may go in a step: blows of a fluid
    real suddenDisplacement;
    std::int64_t domainMin[D], domainMax[D];        // fixed point; everything where periodic
    MotionTable motions;
    const ClumpData* clumps;    // null: there are none
    const double* offset;       // of a clump's member from its centre, in the body: 3 a key
    // do dashpots of a clump's members take the clump's mass (clumpState.hpp)?
    bool sharesMass;

    HD bool inside(const Vec<D, std::int64_t>& x) const
    {
        bool in = true;
        for (int d = 0; d < D; ++d) in = in && x.c[d] >= domainMin[d] && x.c[d] <= domainMax[d];
        return in;
    }

    HD void operator()(int i) const
    {
        const SolidFields<D, P>& s = this->fields;
        if (this->clock->active && i < *this->active && !s.asleep(i))
            move(i, s.force(i), s.momentOn(i));
    }

    HD void move(int i, const Vec<D, real>& force, const Spin<D, real>& moment) const
    {
        const DemClockData& t = *this->clock;
        const SolidFields<D, P>& s = this->fields;
        Vec<D, std::int64_t> x = s.position(i);
        Vec<D, double> v = s.velocity(i);
        Spin<D, real> w = s.spin(i);
        const bool member = clumps && s.clump[i] >= 0;
        if (member) follow(clumps[s.clump[i]], s.id[i], x, v, w);
        else
        {
            const GroupData<D, real>& group = this->groups[s.group[i]];
            const real dt = real(verlet ? 0.5*t.dt : 0.5*(t.previousDt + t.dt));
            if (group.motion >= 0) prescribe(group.motion, t.time - 0.5*t.dt, x, v, w);
            else
                this->kick(group, this->external ? s.id[i] : 0, s.mass[i], s.inverseInertia[i],
                    force, moment, v, w, dt);
            for (int d = 0; d < D; ++d)
                x.c[d] += std::int64_t(rint(v.c[d]*t.dt*box.unitsPerMetre[d]));
        }
        for (int d = 0; d < D; ++d) { s.x[d][i] = x.c[d]; s.v[d][i] = v.c[d]; }
        for (int c = 0; c < spins<D>; ++c) s.w[c][i] = w.c[c];
        if (s.turn[0]) followTurn(i, w, t.dt);
        Vec<D, position> p;
        for (int d = 0; d < D; ++d) p.c[d] = box.pairPosition(d, x.c[d]);
        solids.store(i, p,
            ContactBody<D, real>{convert<real>(v), w, s.radius[i], massInContacts(i)},
            s.material[i]);
        checkSkin(i, p, x, convert<real>(v), t, this->clock);
    }

    HD real massInContacts(int i) const
    {
        const SolidFields<D, P>& s = this->fields;
        return sharesMass && s.clump[i] >= 0 ? real(contactMass(clumps[s.clump[i]])) : s.mass[i];
    }

    //- A member of a rigid body is where the body has it
    HD void follow(const ClumpData& c, int key, Vec<D, std::int64_t>& x, Vec<D, double>& v,
        Spin<D, real>& w) const
    {
        const double* o = offset + 3*(long long)key;
        const Vec<3, double> arm = rotated(c.q, Vec<3, double>{{o[0], o[1], o[2]}}),
                             spin = spinOf(c, c.q);
        const Vec<3, double> u = cross(spin, arm);
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = c.x[d] + std::int64_t(rint(arm.c[d]*box.unitsPerMetre[d]));
            v.c[d] = c.v[d] + u.c[d];
        }
        for (int k = 0; k < spins<D>; ++k) w.c[k] = real(spin.c[D == 2 ? 2 : k]);
    }

    //- v = V + W x (x - centre) at time t
    HD void prescribe(int motion, double t, const Vec<D, std::int64_t>& x, Vec<D, double>& v,
        Spin<D, real>& w) const
    {
        Vec<3, double> arm{{0, 0, 0}}, spin{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
            arm.c[d] = box.toMetres(d, x.c[d]) - motions.at(motion, 6 + d, t);
        for (int d = 0; d < 3; ++d) spin.c[d] = motions.at(motion, 3 + d, t);
        const Vec<3, double> u = cross(spin, arm);
        for (int d = 0; d < D; ++d) v.c[d] = motions.at(motion, d, t) + u.c[d];
        for (int k = 0; k < spins<D>; ++k) w.c[k] = real(spin.c[D == 2 ? 2 : k]);
    }

    HD void followTurn(int i, const Spin<D, real>& w, double dt) const
    {
        const SolidFields<D, P>& s = this->fields;
        if constexpr (D == 2) s.turn[0][i] += real(double(w.c[0])*dt);
        else
        {
            double q[4], r[4];
            for (int k = 0; k < 4; ++k) q[k] = double(s.turn[k][i]);
            turn(q, convert<double>(w), dt, r);
            for (int k = 0; k < 4; ++k) s.turn[k][i] = real(r[k]);
        }
    }

    //- Ask for new neighbours before the next step could carry the particle past half the skin, or
    //  at once where this one did. Refuse a step of more than its radius: it would go through what
    //  it meets
    HD void checkSkin(int i, const Vec<D, position>& p, const Vec<D, std::int64_t>& x,
        const Vec<D, real>& v, const DemClockData& t, DemClockData* raised) const
    {
        if (frames.frame) return checkFrame(i, p, x, v, t, raised);
        real distance2 = 0, speed2 = 0;
        for (int d = 0; d < D; ++d)
        {
            const real s = box.template separation<real>(d, p.c[d], reference[d][i]);
            distance2 += s*s;
            speed2 += v.c[d]*v.c[d];
        }
        // 5/4 of a step's way must be left
        const real distance = squareRoot(distance2),
                   left = halfSkin - suddenDisplacement - distance, way = real(1.25*t.fullDt);
        const bool enough = left >= 0 && way*way*speed2 <= left*left;
        if (!enough || !inside(x)) raised->needRebuild = 1;
        // not so written that a number which is none slips through
        if (!(distance <= halfSkin))
        {
            raiseOnce(raised->far);
            raiseOnce(raised->far + 1);
            checkStep(i, speed2, t, raised);
        }
    }

    //- Under a fluid's forces any way that was not foreseen is too far: steps there follow the
    //  speed (DemSolver::subcycles), so it was one blow
    HD void checkStep(int i, real speed2, const DemClockData& t, DemClockData* raised) const
    {
        const real step = real(t.dt), radius = this->fields.radius[i];
        if (suddenDisplacement > 0 || !(step*step*speed2 <= radius*radius))
            raised->halt = DemHalt::tooFar;
    }

    //- The same against what is around it
    HD void checkFrame(int i, const Vec<D, position>& p, const Vec<D, std::int64_t>& x,
        const Vec<D, real>& v, const DemClockData& t, DemClockData* raised) const
    {
        Vec<D, position> from;
        for (int d = 0; d < D; ++d) from.c[d] = reference[d][i];
        const WaySince<real> way = frames.since(
            box, from, p, v, real(t.time - t.searched), real(1.25*t.fullDt));
        if (!(way.relativeNext + suddenDisplacement <= halfSkin
                && way.wholeNext + suddenDisplacement <= way.limit))
            raiseOnce(raised->aged);
        if (!(way.wholeNext + suddenDisplacement <= halfSkin)) raiseOnce(raised->aged + 1);
        const bool farHere = !(way.relative <= halfSkin && way.whole <= way.limit),
                   farWay = !(way.whole <= halfSkin);
        if (farHere) raiseOnce(raised->far);
        if (farWay) raiseOnce(raised->far + 1);
        if (farHere && farWay) checkStep(i, squaredNorm(v), t, raised);
        if (!inside(x)) raised->needRebuild = 1;
    }
};

//- Verlet's second half of the kick
template<int D, class P>
struct FinishVerlet : SolidMotion<D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "finishVerlet";

    bool clumps;

    HD void operator()(int i) const
    {
        if (!this->clock->forcesDue() || i >= *this->active) return;
        const SolidFields<D, P>& s = this->fields;
        if (s.asleep(i) || (clumps && s.clump[i] >= 0) || this->groups[s.group[i]].motion >= 0)
            return;
        Vec<D, double> v = s.velocity(i);
        Spin<D, real> w = s.spin(i);
        this->kick(i, v, w, real(0.5*this->clock->dt));
        for (int d = 0; d < D; ++d) s.v[d][i] = v.c[d];
        for (int c = 0; c < spins<D>; ++c) s.w[c][i] = w.c[c];
    }
};

//- Energies of particles that are no members of clumps: of translation, of rotation, in gravity.
//  `half`: what velocities are behind
template<int D, class P>
struct SumEnergies : SolidMotion<D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "energies";

    Box<D, P> box;
    real half;

    HD void add(int i, double* sums) const
    {
        const SolidFields<D, P>& s = this->fields;
        if (i >= *this->active || (s.clump && s.clump[i] >= 0) || s.ghost(i)) return;
        const GroupData<D, real>& group = this->groups[s.group[i]];
        Vec<D, double> v = s.velocity(i);
        Spin<D, real> w = s.spin(i);
        if (group.motion < 0 && !s.asleep(i)) this->kick(i, v, w, half);
        const double mass = double(s.mass[i]);
        sums[0] += 0.5*mass*squaredNorm(v);
        sums[1] += 0.5/double(s.inverseInertia[i])*double(squaredNorm(w));
        if (group.gravity > 0)
            for (int d = 0; d < D; ++d)
                sums[2] -= mass*double(this->gravity[d])*box.toMetres(d, s.x[d][i]);
    }
};

//- Momentum of particles that are no members of clumps, about the origin: linear, then angular
template<int D, class P>
struct SumMomentum : SolidMotion<D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "momentum";

    Box<D, P> box;
    real half;                  // what velocities are behind

    HD void add(int i, double* sums) const
    {
        const SolidFields<D, P>& s = this->fields;
        if (i >= *this->active || (s.clump && s.clump[i] >= 0) || s.ghost(i)) return;
        Vec<D, double> v = s.velocity(i), x;
        Spin<D, real> w = s.spin(i);
        if (this->groups[s.group[i]].motion < 0 && !s.asleep(i)) this->kick(i, v, w, half);
        const double mass = double(s.mass[i]);
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = box.toMetres(d, s.x[d][i]);
            sums[d] += mass*v.c[d];
        }
        for (int c = 0; c < spins<D>; ++c)
        {
            const int a = D == 2 ? 0 : (c + 1) % 3, b = D == 2 ? 1 : (c + 2) % 3;
            sums[D + c] += mass*(x.c[a]*v.c[b] - x.c[b]*v.c[a])
                + double(w.c[c])/double(s.inverseInertia[i]);
        }
    }
};

//- Particles of a group; mass, m x and m u of those that are no members of clumps
template<int D, class P>
struct SumGroup : SolidMotion<D, P>
{
    using real = typename P::real;
    static constexpr const char* name = "groupSums";

    Box<D, P> box;
    real half;
    int group;

    HD void add(int i, double* sums) const
    {
        const SolidFields<D, P>& s = this->fields;
        if (i >= *this->active || s.group[i] != group || s.ghost(i)) return;
        sums[0] += 1;
        if (s.clump && s.clump[i] >= 0) return;
        Vec<D, double> v = s.velocity(i);
        Spin<D, real> w = s.spin(i);
        if (this->groups[group].motion < 0 && !s.asleep(i)) this->kick(i, v, w, half);
        const double mass = double(s.mass[i]);
        sums[1] += mass;
        for (int d = 0; d < D; ++d)
        {
            sums[2 + d] += mass*box.toMetres(d, s.x[d][i]);
            sums[2 + D + d] += mass*v.c[d];
        }
    }
};

//- How far particles of a group reach along an axis: up from the box's lower end, or down from its
//  upper one [m]
template<int D, class P>
struct GroupReach
{
    static constexpr const char* name = "groupReach";

    SolidFields<D, P> fields;
    Box<D, P> box;
    const int* active;
    int group, axis;
    bool up;

    HD double value(int i) const
    {
        if (i >= *active || fields.group[i] != group || fields.ghost(i)) return 0;
        const double x = box.toMetres(axis, fields.x[axis][i]) - box.lower[axis],
                     reach = double(fields.radius[i]) + (up ? x : box.length[axis] - x);
        return reach > 0 ? reach : 0;
    }
};

} // namespace riprap
