/*  The kernels of a DEM rebuild: keys of particles, and what follows from their new order.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/motion/mover.hpp"
#include "dem/lists/sizeClasses.hpp"

namespace riprap
{

//- A rigid body leaves the domain as one, with the first of its members that does
template<int D, class P>
struct MarkLeavers
{
    static constexpr const char* name = "markLeavers";

    MoveSolids<D, P> mover;
    ClumpData* clumps;

    HD void operator()(int i) const
    {
        const SolidFields<D, P>& s = mover.fields;
        if (i < *mover.active && s.clump[i] >= 0 && !mover.inside(s.position(i)))
            raiseOnce(&clumps[s.clump[i]].left);
    }
};

template<int D, class P>
struct SolidKeys
{
    static constexpr const char* name = "solidKeys";

    MoveSolids<D, P> mover;
    SizeClasses<D, P> classes;
    std::uint32_t* keys;
    std::uint32_t* indices;

    HD void operator()(int i) const
    {
        const Vec<D, std::int64_t> x = mover.fields.position(i);
        Vec<D, typename P::real> r;
        for (int d = 0; d < D; ++d)
            r.c[d] = mover.box.pairRelative(d, mover.box.pairPosition(d, x.c[d]));
        const int clump = mover.clumps ? mover.fields.clump[i] : -1;
        const bool in = i < *mover.active
            && (clump < 0 ? mover.inside(x) : !mover.clumps[clump].left);
        keys[i] = std::uint32_t(in ? classes.cellOf(r, mover.fields.radius[i]) : classes.cells());
        indices[i] = std::uint32_t(i);
    }
};

//- Positions as a search reads them, of particles in whatever order
template<int D, class P>
struct RecordPlaces
{
    static constexpr const char* name = "recordPlaces";

    Box<D, P> box;
    SolidFields<D, P> fields;
    SolidRecords<D, P> solids;

    HD void operator()(int i) const
    {
        for (int d = 0; d < D; ++d) solids.a[i].x[d] = box.pairPosition(d, fields.x[d][i]);
        solids.a[i].radius = fields.radius[i];
    }
};

//- Records and reference positions of sorted particles, and where each key is
template<int D, class P>
struct PlaceSolids
{
    static constexpr const char* name = "placeSolids";

    MoveSolids<D, P> mover;
    int* slotOf;

    HD void operator()(int i) const
    {
        const SolidFields<D, P>& s = mover.fields;
        if (i == 0) mover.clock->search();
        const bool in = i < *mover.active;
        slotOf[s.id[i]] = in ? i : -1;
        if (!in) return;
        Vec<D, typename P::position> p;
        for (int d = 0; d < D; ++d)
            mover.reference[d][i] = p.c[d] = mover.box.pairPosition(d, s.x[d][i]);
        const Vec<D, typename P::real> v = convert<typename P::real>(s.velocity(i));
        mover.frames.include(mover.box, p, v);
        mover.solids.store(i, p,
            ContactBody<D, typename P::real>{v, s.spin(i), s.radius[i], mover.massInContacts(i)},
            s.material[i]);
    }
};

//- Largest of a strided share of own particles: |v|^2
template<int D, class P>
struct LargestSpeed
{
    static constexpr const char* name = "largestSpeed";
    static constexpr int shares = 4096;

    SolidFields<D, P> fields;
    const int* active;
    float* largest;

    HD void operator()(int k) const
    {
        float most = 0;
        for (int i = k; i < *active; i += shares)
        {
            if (fields.ghost(i)) continue;
            float v2 = 0;
            for (int d = 0; d < D; ++d) v2 += float(fields.v[d][i])*float(fields.v[d][i]);
            most = v2 > most ? v2 : most;
        }
        largest[k] = most;
    }
};

//- Which particles are near walls: flags, then their list
struct FlagNearWalls
{
    static constexpr const char* name = "flagNearWalls";
    const int* entries;         // of each particle
    int* flag;
    HD void operator()(int i) const { flag[i] = entries[i] > 0; }
};

struct ListNearWalls
{
    static constexpr const char* name = "listNearWalls";
    const int* entryFirst;
    const int* first;
    int* list;
    HD void operator()(int i) const { if (entryFirst[i + 1] > entryFirst[i]) list[first[i]] = i; }
};

//- Numbers from all over the device, side by side for the host
struct CollectTotals
{
    static constexpr const char* name = "collectTotals";
    const int* kept;
    const int* entries;
    const int* wallEntries;
    const int* wallElements;
    const int* nearWalls;
    int* total;

    HD void operator()(int) const
    {
        const int* from[5] = {kept, entries, wallEntries, wallElements, nearWalls};
        for (int k = 0; k < 5; ++k) total[k] = from[k] ? *from[k] : 0;
    }
};

} // namespace riprap
