/*  Solids as particles meet them: the signed distance between nodes, where it points, how fast the
    solid moves there, and faces that nothing passes however it is pushed.

    The distance is linear along each axis between the nodes. The velocity at a point is the mean of
    those of the closed parts of the faces about it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/cutCells/apertures.hpp"
#include "pic/grid/particles.hpp"
#include "pic/transfer/bSpline.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

template<int D, class R>
struct SolidField
{
    UniformGrid<D> grid;
    const double* distance;             // nodes [m], negative in solids
    const R* aperture[D];
    const R* wallVelocity[D];           // nullptr: all rest
    const unsigned char* sealed[D];     // faces that part the two sides of something thin

    //- Are all points of a cell farther from solids than `margin`, as far as its corners tell?
    HD bool clear(const typename UniformGrid<D>::Index& c, double margin) const
    {
        const NodeGrid<D> nodes{grid};
        const int first = nodes.node(c);
        bool far = true;
        for (int corner = 0; corner < (1 << D); ++corner)
        {
            int node = first;
            for (int d = 0; d < D; ++d) node += (corner >> d & 1)*nodes.stride(d);
            // what is between may be a little less, by round-off
            far = far && distance[node] > 2*margin;
        }
        return far;
    }

    //- At x above the corner of the whole block; normal: its gradient, out of the solid
    HD double at(const Vec<D, double>& x, Vec<D, double>& normal) const
    {
        const NodeGrid<D> nodes{grid};
        typename UniformGrid<D>::Index low{{0, 0, 0}};
        double f[D];
        for (int d = 0; d < D; ++d)
        {
            const double s = x.c[d]/grid.h;
            const int before = grid.part ? grid.first[d] : 0, i = floorInt(s) - before;
            low.c[d] = i < 0 ? 0 : (i >= grid.n[d] ? grid.n[d] - 1 : i);
            f[d] = s - (before + low.c[d]);
            normal.c[d] = 0;
        }
        const int first = nodes.node(low);
        double sum = 0;
        for (int corner = 0; corner < (1 << D); ++corner)
        {
            int node = first;
            double w = 1;
            for (int d = 0; d < D; ++d)
            {
                const int up = corner >> d & 1;
                node += up*nodes.stride(d);
                w *= up ? f[d] : 1 - f[d];
            }
            sum += w*distance[node];
            for (int d = 0; d < D; ++d)
            {
                double slope = (corner >> d & 1 ? 1 : -1)/grid.h;
                for (int e = 0; e < D; ++e) if (e != d) slope *= corner >> e & 1 ? f[e] : 1 - f[e];
                normal.c[d] += slope*distance[node];
            }
        }
        return sum;
    }

    //- Of the solid near x
    HD Vec<D, R> velocity(const Vec<D, double>& x) const
    {
        Vec<D, R> v;
        for (int d = 0; d < D; ++d)
        {
            v.c[d] = 0;
            if (!wallVelocity[d]) continue;
            R sum = 0, weight = 0;
            const Stencil<1, D, R> stencil(grid, d, x);
            stencil.forEachNode([&](R w, const typename UniformGrid<D>::Index& at, int, int, int)
            {
                typename UniformGrid<D>::Index f = at;
                for (int a = 0; a < D; ++a)
                {
                    if (a != d) { f.c[a] = evenNode(grid, a, f.c[a]); continue; }
                    f.c[a] = f.c[a] < 0 ? 0 : (f.c[a] > grid.n[a] ? grid.n[a] : f.c[a]);
                }
                const int i = grid.face(d, f);
                const R closed = w*(1 - aperture[d][i]);
                weight += closed;
                sum += closed*wallVelocity[d][i];
            });
            if (weight > 0) v.c[d] = sum/weight;
        }
        return v;
    }
};

} // namespace riprap
