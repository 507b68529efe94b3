/*  Velocities of faces where none is known, from known ones, layer by layer.

    A face takes the mean over its known neighbours along the axes of u_1 + minmod(u_1 - u_2, u_2 -
    u_3), the values at distances of one, two and three faces: linear where the field is smooth,
    constant where it is not. Closed faces on the sides of the block are no source: what is beyond a
    wall says nothing about the water. Faces that are closed inside the block are filled: particles
    beside a solid see them, as if the water went on into it.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cstdint>
#include <cstring>
#include "core/loops/rows.hpp"
#include "pic/grid/pressureFields.hpp"

namespace riprap
{

//- Layer of a face: 0 known, then the pass that has filled it
static constexpr unsigned char closedFace = 254, unknownFace = 255;

//- Through less of a face inside the block goes what a body sweeps beside it, or what leaks between
//  bodies that touch: 13 m/s through half a per cent, in water that moves at 0.3 m/s. That is the
//  slit's, and no velocity to continue or for particles to take
static constexpr double leastKnown = 0.06;

//- Is it one of the faces at the two ends of its direction?
template<int D> HD bool atEnd(const UniformGrid<D>& grid, int component, int along)
{
    return !grid.periodic[component] && (along == 0 || along == grid.n[component]);
}

//- Known are faces through which a wet cell's water flows
template<int D, class R>
struct MarkByWetCells
{
    static constexpr const char* name = "markWetFaces";
    UniformGrid<D> grid;
    const unsigned char* wet;   // cells
    const R* aperture;          // of this direction's faces
    // of their middles to solids that water sticks to; nullptr: there are none
    const R* distance;
    int component;
    unsigned char* layer;

    HD void operator()(int i) const { (*this)(i, grid.faceIndex(component, i)); }

    HD void operator()(int i, const typename UniformGrid<D>::Index& f) const
    {
        const int low = grid.cellOf(component, f, 0), high = grid.cellOf(component, f, 1);
        const bool known = (low >= 0 && wet[low]) || (high >= 0 && wet[high]);
        const bool end = atEnd(grid, component, f.c[component]);
        // what an open face whose middle lies in the solid has is the solid's velocity, and tells
        // nothing of the water's slope
        if (distance && !(distance[i] > R(0)) && !end) layer[i] = unknownFace;
        else if (aperture[i] > R(end ? 0 : leastKnown)) layer[i] = known ? 0 : unknownFace;
        else layer[i] = end ? closedFace : unknownFace;
    }

    //- The faces of a row from number i and indices f on, up to before `end`
    HD void row(int i, typename UniformGrid<D>::Index f, int end) const
    {
        const int number = i - f.c[0];
        const auto one = [&](int k)
        {
            typename UniformGrid<D>::Index at = f;
            at.c[0] = k;
            (*this)(number + k, at);
        };
        int from = f.c[0], to = end;
        if (distance
            || (component > 0 && (f.c[component] == 0 || f.c[component] == grid.n[component])))
        {
            for (; from < to; ++from) one(from);
            return;
        }
        if (component == 0 && from == 0) one(from++);
        if (component == 0 && to == grid.n[0] + 1 && to > from) one(--to);
        int stride = 1;
        for (int a = 0; a < component; ++a) stride *= grid.n[a];
        const unsigned char* upper = wet + grid.cell(f) - f.c[0] + from;
        const R* open = aperture + number + from;
        unsigned char* is = layer + number + from;
        INDEPENDENT
        for (int k = 0; k < to - from; ++k)
            is[k] = (upper[k] | upper[k - stride])
                    & static_cast<unsigned char>(open[k] > R(leastKnown))
                ? static_cast<unsigned char>(0)
                : unknownFace;
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

    HD void operator()(int i, const typename UniformGrid<D>::Index& f) const
    {
        const bool side = !(aperture[i] > R(0)) && atEnd(grid, component, f.c[component]);
        layer[i] = side ? closedFace : (mass[i] > R(1e-3) ? 0 : unknownFace);
    }
};

//- One pass over the faces of a cell: those below it along each axis, at the end of the block those
//  above it, too
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

    //- The same for the cells of a row, up to before index `end`: of faces that are not known only
    //  those with a known one beside them are looked at
    HD void row(const typename UniformGrid<D>::Index& c, int end) const
    {
        for (int d = 0; d < D; ++d)
            for (int side = 0; side < (d > 0 && c.c[d] == grid.n[d] - 1 ? 2 : 1); ++side)
            {
                typename UniformGrid<D>::Index f = c;
                f.c[d] += side;
                fillRow(d, f, (d == 0 && end == grid.n[0] ? end + 1 : end) - c.c[0]);
            }
    }

private:

    static constexpr int reach = 3;             // faces looked at along an axis
    static constexpr int most = 40;             // of a row, in whole words

    HD void fillRow(int d, typename UniformGrid<D>::Index f, int count) const
    {
        const int first = grid.face(d, f);
        const unsigned char* own = layer[d] + first;
        bool inside = true;
        for (int a = 1; a < D; ++a) inside = inside && f.c[a] > 0 && f.c[a] < grid.layers(d, a) - 1;
        alignas(8) unsigned char look[most] = {};
        if (inside)
        {
            const int across = grid.layers(d, 0), beyond = D == 3 ? across*grid.layers(d, 1) : 0;
            for (int k = 0; k < count; ++k)
            {
                unsigned char nearest = own[k - 1] < own[k + 1] ? own[k - 1] : own[k + 1];
                nearest = own[k - across] < nearest ? own[k - across] : nearest;
                nearest = own[k + across] < nearest ? own[k + across] : nearest;
                if constexpr (D == 3)
                {
                    nearest = own[k - beyond] < nearest ? own[k - beyond] : nearest;
                    nearest = own[k + beyond] < nearest ? own[k + beyond] : nearest;
                }
                look[k] = (own[k] == unknownFace) & (nearest < pass);
            }
        }
        else for (int k = 0; k < count; ++k) look[k] = own[k] == unknownFace;
        const int from = f.c[0];
        for (int word = 0; word < most; word += 8)
        {
            std::uint64_t any;
            memcpy(&any, look + word, 8);
            if (!any) continue;
            for (int k = word; k < word + 8; ++k)
            {
                f.c[0] = from + k;
                if (look[k]) fill(d, f);
            }
        }
    }

    HD void fill(int component, const typename UniformGrid<D>::Index& f) const
    {
        const int i = grid.face(component, f);
        if (layer[component][i] != unknownFace) return;
        bool inside = true;
        UNROLL
        for (int d = 0; d < D; ++d)
            inside = inside && f.c[d] >= reach && f.c[d] < grid.layers(component, d) - reach;
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
                const auto known = [&](int steps)
                { return along<Inside>(component, i, f.c[d], d, stride, direction*steps); };
                const int one = known(1);
                if (one < 0) continue;
                const int two = known(2), three = two < 0 ? -1 : known(3);
                for (int k = 0; k < 4; ++k)
                    if (k < fields) sum[k] += continued(field[k][component], one, two, three);
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
