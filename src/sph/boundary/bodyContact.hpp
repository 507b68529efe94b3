/*  Bodies that move freely among the fluid have faces as walls do (wallFaces.hpp), and get what
    faces take from the fluid: equal and opposite, at the place of the contact. It is summed in
    whole units, so that sums do not depend on an order, and handed over once a step.

    Only bodies that a particle is near to are asked: those of which a point lies in the cells about
    it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/neighbours/cellGrid.hpp"
#include "core/loops/deterministicAtomics.hpp"
#include "sph/boundary/wallFaces.hpp"

namespace riprap
{

//- Units in which contacts are counted, of a particle's mass: 1e-9 m/s and 1e-9 m2/s2 about
static constexpr double faceUnit = 1.0/1073741824;

//- What faces of a body gave to the fluid in a step: impulse, and moment about the body's centre,
//  of a particle's mass
struct FaceBlow { std::int64_t impulse[3], moment[3]; };

template<int D, class P>
struct BodyContact
{
    using real = typename P::real;
    static constexpr int most = 4;      // that a particle is near to at once

    // points of each cell; null: no body has faces, or none is near fluid
    const int* start;
    CellGrid<D, P> grid;
    const std::uint32_t* key;   // of a point
    const int* groupOfKey;      // of faces; -1: its body has none
    // [m] from a face to a point of its body, both moved since points were sorted
    real reach;
    int first;                  // group of the first body
    FaceBlow* blow;             // of each body

    //- Groups of bodies near x; returns how many
    HD_APART int near(const Box<D, P>& box, const Vec<D, std::int64_t>& x, int* found) const
    {
        Vec<D, real> r;
        for (int d = 0; d < D; ++d) r.c[d] = box.pairRelative(d, box.pairPosition(d, x.c[d]));
        int count = 0;
        grid.forEachRangeWithin(r, reach, start, [&](int begin, int end)
        {
            for (int i = begin; i < end && count < most; ++i)
            {
                const int group = groupOfKey[key[i]];
                bool known = group < 0;
                for (int k = 0; k < count; ++k) known = known || found[k] == group;
                if (!known) found[count++] = group;
            }
        });
        return count;
    }

    //- The fluid's velocity changes by du at x
    HD void count(const WallFaces<D>& faces, int group, const Vec<D, double>& x,
        const Vec<D, double>& du) const
    {
        if (group < first) return;
        Vec<3, double> arm{{0, 0, 0}}, u{{0, 0, 0}};
        for (int d = 0; d < D; ++d)
        {
            arm.c[d] = x.c[d] - faces.pose[group].t[d];
            u.c[d] = du.c[d];
        }
        const Vec<3, double> turn = cross(arm, u);
        FaceBlow& b = blow[group - first];
        for (int d = 0; d < 3; ++d)
        {
            addShared(&b.impulse[d], std::int64_t(rint(u.c[d]/faceUnit)));
            addShared(&b.moment[d], std::int64_t(rint(turn.c[d]/faceUnit)));
        }
    }
};

} // namespace riprap
