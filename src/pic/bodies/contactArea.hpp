/*  Water between solids that touch (paper 2, section 2.2.2, Eq. 20 and Figure 3). Solids keep a gap
    of two cells, through which more water passes than does between true surfaces: particles in the
    contact area are slowed,

        v = C v,        C = beta + (1 - beta) s/(2 dx) at the distance s < 2 dx from the contact
                        point along the tangent,

    so that the area is 4 dx long. Once a step, as in the paper, slows the water the more the
    shorter the steps are. With a time T for which C is meant a step dt leaves

        v = C^(dt/T) v,

    a drag of rate ln(1/C)/T whatever the step. The paper leaves the area's width open; here it is 3
    dx, the gap and what the surfaces' bend adds. The pressure drives water through the area all the
    same, and what it gives to particles beside those that are slowed, which share their faces,
    nothing takes away again: with FLIP they become faster step by step, without bound. So all
    particles in the area and up to contactBeyond from it take the grid's velocity, and v is that.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include "pic/grid/particles.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

//- Reach of the area along the tangent and along the normal, in cells
static constexpr double contactAlong = 2, contactAcross = 1.5;

//- The grid's velocity is taken so far beyond, in cells: what particles in the area share faces
//  with
static constexpr double contactBeyond = 1.5;

template<int D>
struct ContactArea
{
    Vec<D, double> point;       // above the block's corner [m]
    Vec<D, double> normal;      // of length 1
};

//- Boxes of the size of an area's reach: who looks at those about its own finds every area that
//  reaches it. Areas are sorted by boxes, the first axis first
template<int D>
struct ContactBoxes
{
    double edge;                        // [m]
    int n[3] = {1, 1, 1};

    explicit ContactBoxes(const UniformGrid<D>& grid)
    {
        edge = std::sqrt((contactAlong + contactBeyond)*(contactAlong + contactBeyond)
                   + (contactAcross + contactBeyond)*(contactAcross + contactBeyond))
            *grid.h;
        for (int d = 0; d < D; ++d) n[d] = int(grid.n[d]*grid.h/edge) + 3;
    }

    //- Along an axis; those beyond the block are the last on their side
    HD int along(double x, int d) const
    {
        const int i = floorInt(x/edge) + 1;
        return i < 0 ? 0 : i < n[d] ? i : n[d] - 1;
    }

    HD int number(const Vec<D, double>& x) const
    {
        int b = 0;
        for (int d = D - 1; d >= 0; --d) b = b*n[d] + along(x.c[d], d);
        return b;
    }

    //- f(first, last) for the rows of boxes about a point
    template<class F>
    HD void eachRow(const Vec<D, double>& x, const F& f) const
    {
        int at[3] = {0, 0, 0};
        for (int d = 0; d < D; ++d) at[d] = along(x.c[d], d);
        for (int k = D == 3 ? -1 : 0; k <= (D == 3 ? 1 : 0); ++k)
            for (int j = -1; j <= 1; ++j)
            {
                const int y = at[1] + j, z = at[2] + k;
                if (y < 0 || y >= n[1] || z < 0 || z >= n[2]) continue;
                const int row = n[0]*(y + n[1]*z);
                f(row + (at[0] > 0 ? at[0] - 1 : 0),
                    row + (at[0] < n[0] - 1 ? at[0] + 1 : n[0] - 1));
            }
    }
};

//- What is left of a velocity after so many of the steps or times for which C is meant; one: C to
//  the bit
HD double keptVelocity(double C, double times) { return times == 1 ? C : std::pow(C, times); }

template<int D, class R>
struct SlowBetweenSolids
{
    static constexpr const char* name = "slowBetweenSolids";
    UniformGrid<D> grid;
    PicParticles<D, R> particles;
    ContactBoxes<D> boxes;
    int count;
    const int* box;                     // of each area, ascending
    const ContactArea<D>* areas;
    double beta;
    // how many of those that beta is meant for a step is: 1, or dt/T
    double times;
    const R* u[D];                      // the grid's velocity that particles have after the step

    HD void operator()(int i) const
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = particles.x[d][i];
        double factor = 1;
        bool near = false;
        boxes.eachRow(x, [&](int first, int last)
        {
            for (int k = firstFrom(first); k < count && box[k] <= last; ++k)
            {
                const Vec<D, double> r = x - areas[k].point;
                const double across = dot(r, areas[k].normal),
                             along2 = squaredNorm(r) - across*across;
                const double along = along2 > 0 ? sqrt(along2) : 0;
                if (along >= (contactAlong + contactBeyond)*grid.h
                    || absolute(across) > (contactAcross + contactBeyond)*grid.h)
                    continue;
                near = true;
                if (along >= contactAlong*grid.h || absolute(across) > contactAcross*grid.h)
                    continue;
                factor = minimum(factor, beta + (1 - beta)*along/(contactAlong*grid.h));
            }
        });
        if (!near) return;
        const double kept = keptVelocity(factor, times);
        for (int d = 0; d < D; ++d)
            particles.v[d][i] = R(kept)*sampleFace<2, D, R>(grid, u[d], d, x);
    }

private:

    //- The first area of this box or a later one
    HD int firstFrom(int b) const
    {
        int low = 0, high = count;
        while (low < high)
        {
            const int middle = (low + high)/2;
            if (box[middle] < b) low = middle + 1;
            else high = middle;
        }
        return low;
    }
};

} // namespace riprap
