/*  Faces of rigid bodies that the DEM moves, as sph/boundary/bodyContact.hpp asks for them: where
    they are at the end of a step, and what the body gets.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "coupling/solidView.hpp"
#include "sph/boundary/bodyContact.hpp"

namespace riprap
{

//- A body's faces are given in its principal axes, from its centre of mass. Its velocity is that
//  which brought it here
template<int D, class P>
struct PoseBodies
{
    static constexpr const char* name = "poseBodies";

    BodyView<D, P> bodies;
    FacePose<D>* pose;          // of each

    HD void operator()(int k) const
    {
        const ClumpData& c = bodies.clumps[k];
        FacePose<D>& p = pose[k];
        const Vec<3, double> spin = spinOf(c, c.q);
        for (int e = 0; e < D; ++e)
        {
            Vec<3, double> axis{{0, 0, 0}};
            axis.c[e] = 1;
            const Vec<3, double> turned = rotated(c.q, axis), rate = cross(spin, turned);
            for (int d = 0; d < D; ++d)
            {
                p.R[d][e] = turned.c[d];
                p.rateR[d][e] = rate.c[d];
            }
        }
        for (int d = 0; d < D; ++d)
        {
            p.t[d] = bodies.box.toMetres(d, c.x[d]);
            p.rateT[d] = c.v[d];
        }
    }
};

//- What the fluid got in this step, bodies get at once, the other way
template<int D, class P>
struct BlowBodies
{
    static constexpr const char* name = "blowBodies";

    BodyView<D, P> bodies;
    FaceBlow* blow;
    double particleMass;        // of the fluid

    HD void operator()(int k) const
    {
        FaceBlow& b = blow[k];
        bool any = false;
        Vec<3, double> impulse, moment;
        for (int d = 0; d < 3; ++d)
        {
            any = any || b.impulse[d] || b.moment[d];
            impulse.c[d] = -particleMass*faceUnit*double(b.impulse[d]);
            moment.c[d] = -particleMass*faceUnit*double(b.moment[d]);
            b.impulse[d] = b.moment[d] = 0;
        }
        ClumpData& c = bodies.clumps[k];
        if (any && bodies.groups[c.group].motion < 0)
            accelerate(
                c, bodies.groups[c.group], bodies.constraints, bodies.box, impulse, moment, 1);
    }
};

} // namespace riprap
