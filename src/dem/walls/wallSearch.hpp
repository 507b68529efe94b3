/*  Which walls, and which of their elements, a particle may touch until the next rebuild.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/simd/precision.hpp"
#include "dem/state/solidFields.hpp"
#include "dem/walls/wallSet.hpp"

namespace riprap
{

//- A particle near a wall: its elements' numbers are element[first .. first + count)
struct WallEntry { int wall, first, count, padding; };

template<int D, class P>
struct WallSearch
{
    Box<D, P> box;
    SolidFields<D, P> fields;
    const WallData* walls;
    int wallCount;
    SurfaceView<D> surface;
    double reach;               // skin and gap
    const int* active;

    HD Vec<D, double> position(int i) const
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = box.toMetres(d, fields.x[d][i]);
        return x;
    }

    //- element(e) for each element of wall w near x (in its frame)
    template<class F>
    HD void forEachElement(
        const WallData& w, const Vec<D, double>& x, double distance, const F& f) const
    {
        int from[3] = {0, 0, 0}, to[3] = {0, 0, 0};
        for (int d = 0; d < D; ++d)
        {
            if (x.c[d] + distance < w.low[d] || x.c[d] - distance > w.high[d]) return;
            from[d] = SurfaceBuilder<D>::wallCell(w, d, x.c[d] - distance);
            to[d] = SurfaceBuilder<D>::wallCell(w, d, x.c[d] + distance);
        }
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y)
                for (int c = from[0]; c <= to[0]; ++c)
                {
                    const int cell[3] = {c, y, z}, at = w.firstCell + (z*w.n[1] + y)*w.n[0] + c;
                    for (int k = surface.cellFirst[at]; k < surface.cellFirst[at + 1]; ++k)
                    {
                        const int e = surface.cellElement[k];
                        if (firstMeeting(w, e, cell, from) && isNear(e, x, distance)) f(e);
                    }
                }
    }

    //- Where a particle is, and beside a periodic side where it will be once it has crossed it:
    //  their number. Walls at rest alone are
    //- repeated there
    HD int images(
        const WallData& w, const Vec<D, double>& x, double distance, Vec<D, double>* at) const
    {
        int count = 1;
        at[0] = x;
        for (int d = 0; d < D && w.motion < 0; ++d)
        {
            const double above = x.c[d] - box.lower[d], below = box.length[d] - above;
            if (!box.periodic[d] || minimum(above, below) >= distance) continue;
            const double shift = above < below ? box.length[d] : -box.length[d];
            for (int k = 0; k < count; ++k)
            {
                at[count + k] = at[k];
                at[count + k].c[d] += shift;
            }
            count *= 2;
        }
        return count;
    }

    //- element(e) for each element of a surface near a particle or one of its images, each once
    template<class F>
    HD void forEachRepeated(
        const WallData& w, const Vec<D, double>& x, double distance, const F& f) const
    {
        Vec<D, double> at[1 << D];
        const int count = images(w, x, distance, at);
        for (int image = 0; image < count; ++image)
            forEachElement(w, at[image], distance, [&](int e)
            {
                // a large element may be near several
                for (int before = 0; before < image; ++before)
                    if (isNear(e, at[before], distance)) return;
                f(e);
            });
    }

private:

    //- An element lies in several cells: it is met in the first of those that are searched
    HD bool firstMeeting(const WallData& w, int e, const int* cell, const int* from) const
    {
        for (int d = 0; d < D; ++d)
        {
            double low = 1e300;
            for (int k = 0; k < D; ++k)
                low = minimum(low, surface.vertex[surface.element[e*D + k]*D + d]);
            const int first = SurfaceBuilder<D>::wallCell(w, d, low);
            if (cell[d] != (first > from[d] ? first : from[d])) return false;
        }
        return true;
    }

    HD bool isNear(int e, const Vec<D, double>& x, double distance) const
    {
        Vec<D, double> v[D];
        for (int k = 0; k < D; ++k) v[k] = surface.at(surface.element[e*D + k]);
        int feature;
        return squaredNorm(x - closestPoint(v, x, feature)) < distance*distance;
    }
};

//- Counts entries and elements of a particle, or writes them
template<int D, class P, bool Write>
struct FindWalls : WallSearch<D, P>
{
    static constexpr const char* name = Write ? "writeWalls" : "countWalls";

    int* entryFirst;            // counts, then their sums
    int* elementFirst;
    WallEntry* entry;
    int* element;
    const int* place;           // where the particle still is; null: in its place

    HD void operator()(int i) const
    {
        int entries = 0, elements = 0;
        if (i < *this->active)
        {
            const int at = place ? place[i] : i;
            const Vec<D, double> x = this->position(at);
            const double distance = double(this->fields.radius[at]) + this->reach;
            for (int k = 0; k < this->wallCount; ++k)
            {
                const WallData& w = this->walls[k];
                const Vec<D, double> X = intoFrame<D>(w.frame.R, w.frame.T, x);
                const int before = elements;
                bool near = false;
                if (w.plane)
                {
                    double height = 0;
                    for (int d = 0; d < D; ++d) height += (X.c[d] - w.point[d])*w.normal[d];
                    near = height < distance;
                }
                else
                {
                    this->forEachRepeated(w, X, distance, [&](int e)
                    {
                        if constexpr (Write) element[elementFirst[i] + elements] = e;
                        else (void)e;
                        ++elements;
                    });
                    near = elements > before;
                }
                if (!near) continue;
                if constexpr (Write)
                    entry[entryFirst[i] + entries] = WallEntry{
                        k, elementFirst[i] + before, elements - before, 0};
                ++entries;
            }
        }
        if constexpr (!Write) { entryFirst[i] = entries; elementFirst[i] = elements; }
    }
};

} // namespace riprap
