/*  Water between solids that touch (paper 2, section 2.2.2, Eq. 20 and Figure 3). Solids keep a gap of two cells, through which more water passes than does between
    true surfaces: particles in the contact area are slowed,

        v = C v,        C = beta + (1 - beta) s/(2 dx)    at the distance s < 2 dx from the contact point along the tangent,

    so that the area is 4 dx long. The paper leaves its width open; here it is 3 dx, the gap and what the surfaces' bend adds. The pressure drives water through the
    area all the same, and what it gives to particles beside those that are slowed, which share their faces, nothing takes away again: with FLIP they become
    faster step by step, without bound. So all particles in the area and up to contactBeyond from it take the grid's velocity, and v is that.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/particles.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

//- Reach of the area along the tangent and along the normal, in cells
static constexpr double contactAlong = 2, contactAcross = 1.5;

//- The grid's velocity is taken so far beyond, in cells: what particles in the area share faces with
static constexpr double contactBeyond = 1.5;

template<int D>
struct ContactArea
{
    Vec<D, double> point;       // above the block's corner [m]
    Vec<D, double> normal;      // of length 1
};

template<int D, class R>
struct SlowBetweenSolids
{
    static constexpr const char* name = "slowBetweenSolids";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    const int* first;                   // contacts that reach each cell
    const int* contact;
    const ContactArea<D>* areas;
    double beta;
    const R* u[D];                      // the grid's velocity that particles have after the step

    HD void operator()(int i) const
    {
        typename UniformGrid<D>::Index c{{0, 0, 0}};
        Vec<D, double> x;
        for (int d = 0; d < D; ++d)
        {
            x.c[d] = particles.x[d][i];
            c.c[d] = floorInt(x.c[d]/grid.h);
        }
        const int cell = grid.cell(c);
        double factor = 1;
        bool near = false;
        for (int k = first[cell]; k < first[cell + 1]; ++k)
        {
            const ContactArea<D>& area = areas[contact[k]];
            const Vec<D, double> r = x - area.point;
            const double across = dot(r, area.normal), along2 = squaredNorm(r) - across*across;
            const double along = along2 > 0 ? sqrt(along2) : 0;
            if (along >= (contactAlong + contactBeyond)*grid.h || absolute(across) > (contactAcross + contactBeyond)*grid.h) continue;
            near = true;
            if (along >= contactAlong*grid.h || absolute(across) > contactAcross*grid.h) continue;
            factor = minimum(factor, beta + (1 - beta)*along/(contactAlong*grid.h));
        }
        if (near) for (int d = 0; d < D; ++d) particles.v[d][i] = R(factor)*sampleFace<2, D, R>(grid, u[d], d, x);
    }
};

} // namespace riprap
