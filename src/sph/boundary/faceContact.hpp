/*  Faces of walls keep particles out: one that has come behind a face is put back onto it, and its
    velocity relative to the wall loses the part that points into it. What that takes from the
    particle is counted: momentum, and kinetic and potential energy, with the velocity that belongs
    to the end of the step.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/precision.hpp"
#include "sph/boundary/bodyContact.hpp"
#include "sph/state/clock.hpp"

namespace riprap
{

template<int D, class P>
struct FaceContact
{
    using real = typename P::real;

    WallFaces<D> faces;
    BodyContact<D, P> bodies;
    double clearance;           // [m] in front of the face that a particle is put to

    //- At the end of a drift. kick: of the half step that is still to come, as far as it is known
    HD void keepOut(const Box<D, P>& box, const Vec<D, real>& gravity, const Vec<D, real>& kick,
        Vec<D, std::int64_t>& x, Vec<D, real>& v, ClockData* clock) const
    {
        if (!faces.groups) return;
        // Functions that stand apart are given copies: what they are given stands in memory, and
        // most particles shall stay in registers
        constexpr int most = BodyContact<D, P>::most;
        int near[most], count = 0;
        if (bodies.start)
        {
            const Vec<D, std::int64_t> place = x;
            int found[most];
            count = bodies.near(box, place, found);
            UNROLL
            for (int k = 0; k < most; ++k) near[k] = k < count ? found[k] : 0;
        }
        Vec<D, double> at;
        for (int d = 0; d < D; ++d) at.c[d] = box.toMetres(d, x.c[d]);
        bool behind = faces.near(at);
        UNROLL
        for (int k = 0; k < most; ++k)
            if (k < count) behind = behind || faces.near(near[k], at);
        if (!behind) return;
        int given[most];
        for (int k = 0; k < most; ++k) given[k] = k < count ? near[k] : 0;
        const Vec<D, real> rest = kick;
        Vec<D, std::int64_t> place = x;
        Vec<D, real> velocity = v;
        putBack(box, gravity, rest, at, given, count, place, velocity, clock);
        x = place;
        v = velocity;
    }

private:

    //- Out of one face after another: in a corner of two parts the way out of one may lead behind
    //  the other. Walls have the last word: a body may lie on one
    HD_APART void putBack(const Box<D, P>& box, const Vec<D, real>& gravity,
        const Vec<D, real>& kick, Vec<D, double> at, const int* near, int count,
        Vec<D, std::int64_t>& x, Vec<D, real>& v, ClockData* clock) const
    {
        constexpr int most = 4;
        FaceHit<D> hit = faces.find(at, near, count);
        if (!(hit.depth > 0)) return;
        const bool body = count && hit.group >= bodies.first;
        Vec<D, double> u = convert<double>(v);
        const Vec<D, double> from = at, before = u;
        for (int k = 0; k < most && hit.depth > 0; ++k)
        {
            Vec<D, double> normal = hit.normal;
            at = hit.nearest + clearance*normal;
            if (hit.overRim > 0)
            {
                const Vec<D, double> over = hit.rimNearest + clearance*hit.rimNormal;
                if (!(faces.find(over, near, count).depth > 0))
                {
                    normal = hit.rimNormal;
                    at = over;
                }
            }
            const double approach = dot(u - faces.velocity(hit.group, at), normal);
            if (approach < 0)
            {
                u = u - approach*normal;
                if (count) bodies.count(faces, hit.group, at, -approach*normal);
            }
            hit = faces.find(at, near, k < most - 2 ? count : 0);
        }
        double energy = 0;
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = box.toFixedInside(d, at.c[d]);
            v.c[d] = real(u.c[d]);
            energy += 0.5*(u.c[d] - before.c[d])*(u.c[d] + before.c[d] + 2*double(kick.c[d]))
                - double(gravity.c[d])*(at.c[d] - from.c[d]);
            addShared(
                &clock->faces.impulse[d], std::int64_t(rint((u.c[d] - before.c[d])/faceUnit)));
        }
        addShared(&clock->faces.energy, std::int64_t(rint(energy/faceUnit)));
        addShared(&clock->faces.contacts, std::int64_t(1));
        if (body) addShared(&clock->faces.atBodies, std::int64_t(1));
    }
};

//- Poses of the groups that move, at the time of the clock (sph/boundary/movingWall.hpp)
template<int D, class PoseTable>
struct PoseFaces
{
    static constexpr const char* name = "poseFaces";

    PoseTable table;
    int axes[3];
    FacePose<D>* pose;          // of group 1 + body
    const ClockData* clock;

    HD void operator()(int body) const
    {
        FacePose<D>& p = pose[1 + body];
        double acceleration;
        for (int d = 0; d < D; ++d)
        {
            table.evaluate(body, 9 + axes[d], clock->time, p.t[d], p.rateT[d], acceleration);
            for (int e = 0; e < D; ++e)
                table.evaluate(body, 3*axes[d] + axes[e], clock->time, p.R[d][e], p.rateR[d][e],
                    acceleration);
        }
    }
};

} // namespace riprap
