/*  Velocities of faces where none is known, from known ones, layer by layer.

    A face takes the mean over its known neighbours along the axes of u_1 + minmod(u_1 - u_2, u_2 - u_3), the values at distances of one, two and three faces:
    linear where the field is smooth, constant where it is not. Closed faces on the sides of the block are no source: what is beyond a wall says nothing
    about the water. Faces that are closed inside the block are filled: particles beside a solid see them, as if the water went on into it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/pressureFields.hpp"

namespace riprap
{

//- Layer of a face: 0 known, then the pass that has filled it
static constexpr unsigned char closedFace = 254, unknownFace = 255;

//- Through less of a face inside the block goes what a body sweeps beside it, or what leaks between bodies that touch: 13 m/s through half a per cent, in water that
//  moves at 0.3 m/s. That is the slit's, and no velocity to continue or for particles to take
static constexpr double leastKnown = 0.06;

//- Is it one of the faces at the two ends of its direction?
template<int D>
HD bool atEnd(const UniformGrid<D>& grid, int component, int along) { return !grid.periodic[component] && (along == 0 || along == grid.n[component]); }

//- Known are faces through which a wet cell's water flows
template<int D, class R>
struct MarkByWetCells
{
    static constexpr const char* name = "markWetFaces";
    UniformGrid<D> grid;
    const unsigned char* wet;   // cells
    const R* aperture;          // of this direction's faces
    const R* distance;          // of their middles to solids that water sticks to; nullptr: there are none
    int component;
    unsigned char* layer;

    HD void operator()(int i) const
    {
        const typename UniformGrid<D>::Index f = grid.faceIndex(component, i);
        const int low = grid.cellOf(component, f, 0), high = grid.cellOf(component, f, 1);
        const bool known = (low >= 0 && wet[low]) || (high >= 0 && wet[high]);
        const bool end = atEnd(grid, component, f.c[component]);
        // what an open face whose middle lies in the solid has is the solid's velocity, and tells nothing of the water's slope
        if (distance && !(distance[i] > R(0)) && !end) layer[i] = unknownFace;
        else if (aperture[i] > R(end ? 0 : leastKnown)) layer[i] = known ? 0 : unknownFace;
        else layer[i] = end ? closedFace : unknownFace;
    }
};

//- Known are faces that particles have brought a velocity to
template<int D, class R>
struct MarkByMass
{
    static constexpr const char* name = "markMassFaces";
    UniformGrid<D> grid;
    int component;
    const R* mass;
    const R* aperture;
    unsigned char* layer;

    HD void operator()(int i) const
    {
        const bool side = !(aperture[i] > R(0)) && atEnd(grid, component, grid.faceIndex(component, i).c[component]);
        layer[i] = side ? closedFace : (mass[i] > R(1e-3) ? 0 : unknownFace);
    }
};

//- One pass over the faces of a cell: those below it along each axis, at the end of the block those above it, too
template<int D, class R>
struct Extrapolate
{
    static constexpr const char* name = "extrapolate";
    UniformGrid<D> grid;
    unsigned char pass;         // 1, 2, ...
    unsigned char* layer[D];
    R* field[4][D];             // all extrapolated alike
    int fields;

    HD void operator()(typename UniformGrid<D>::Index c) const
    {
        UNROLL
        for (int d = 0; d < D; ++d)
        {
            fill(d, c);
            if (c.c[d] < grid.n[d] - 1) continue;
            typename UniformGrid<D>::Index last = c;
            last.c[d] += 1;
            fill(d, last);
        }
    }

private:

    static constexpr int reach = 3;             // faces looked at along an axis

    HD void fill(int component, const typename UniformGrid<D>::Index& f) const
    {
        const int i = grid.face(component, f);
        if (layer[component][i] != unknownFace) return;
        bool inside = true;
        UNROLL
        for (int d = 0; d < D; ++d) inside = inside && f.c[d] >= reach && f.c[d] < grid.layers(component, d) - reach;
        if (inside) fillFrom<true>(component, f, i);
        else fillFrom<false>(component, f, i);
    }

    //- Inside: all that is looked at lies within the block
    template<bool Inside>
    HD void fillFrom(int component, const typename UniformGrid<D>::Index& f, int i) const
    {
        R sum[4] = {0, 0, 0, 0};
        int count = 0, stride = 1;
        UNROLL
        for (int d = 0; d < D; ++d)
        {
            for (int direction = -1; direction <= 1; direction += 2)
            {
                const auto known = [&](int steps) { return along<Inside>(component, i, f.c[d], d, stride, direction*steps); };
                const int one = known(1);
                if (one < 0) continue;
                const int two = known(2), three = two < 0 ? -1 : known(3);
                for (int k = 0; k < 4; ++k) if (k < fields) sum[k] += continued(field[k][component], one, two, three);
                ++count;
            }
            stride *= grid.layers(component, d);
        }
        if (!count) return;
        for (int k = 0; k < 4; ++k) if (k < fields) field[k][component][i] = sum[k]/count;
        layer[component][i] = pass;
    }

    //- Known face at an offset along axis d, where face i has index x; -1: none
    template<bool Inside>
    HD int along(int component, int i, int x, int d, int stride, int offset) const
    {
        int by = offset;
        if constexpr (!Inside)
        {
            const int to = x + offset;
            if (to < 0 || to >= grid.layers(component, d))
            {
                if (!grid.periodic[d]) return -1;
                by += to < 0 ? grid.n[d] : -grid.n[d];
            }
        }
        const int j = i + by*stride;
        return layer[component][j] < pass ? j : -1;
    }

    HD R continued(const R* u, int one, int two, int three) const
    {
        if (three < 0) return u[one];
        const R s = u[one] - u[two], t = u[two] - u[three];
        if (s*t <= 0) return u[one];
        return u[one] + (absolute(s) < absolute(t) ? s : t);
    }
};

} // namespace riprap
