/*  Building contact lists: candidates of a particle over all size classes, counting, writing, and
    handing histories over.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/lists/contactList.hpp"
#include "dem/lists/sizeClasses.hpp"
#include "dem/lists/solidRecords.hpp"
#include "dem/state/solidFields.hpp"

namespace riprap
{

//- Bonds of a particle: its id's references, bond << 1 | end. What is bonded does not touch, unless
//  it shall
struct BondTable
{
    const int* first;           // of an id; null: there are no bonds
    const int* reference;
    const std::int32_t* ids[2]; // of the ends
    const std::int32_t* broken;
    bool contactWithin;

    HD bool keepsApart(std::int32_t a, std::int32_t b) const
    {
        if (!first || contactWithin) return false;
        for (int k = first[a]; k < first[a + 1]; ++k)
        {
            const int bond = reference[k] >> 1;
            if (!broken[bond] && ids[1 - (reference[k] & 1)][bond] == b) return true;
        }
        return false;
    }
};

template<class Backend, int D, class P>
struct ContactSearch
{
    using real = typename P::real;

    Box<D, P> box;
    SizeClasses<D, P> classes;
    SolidRecords<D, P> solids;
    const int* start;           // first particle of each cell of all classes
    // where the particles are that cells have side by side; null: just so
    const int* place;
    const std::int32_t* clump;  // null: none
    const std::int32_t* calm;   // ghosts have their mark (CPU); null: there are none
    const std::int32_t* id;
    BondTable bonds;
    real reach;                 // skin and gap: listed when the surfaces are no further apart
    real nearReach;             // those that touch, or are about to

    //- f(j, near) for every j that may touch i: all of them, or on the CPU those sorted after i
    template<class F>
    HD void forEachCandidate(int i, const F& f) const
    {
        const auto xi = solids.position(i);
        const real radius = solids.radius(i);
        Vec<D, real> relative;
        for (int d = 0; d < D; ++d) relative.c[d] = box.pairRelative(d, xi.c[d]);
        for (int k = Backend::gpu ? 0 : classes.classOf(radius); k < classes.classes; ++k)
        {
            const real distance = radius + classes.largest[k] + reach;
            classes.grid[k].forEachRangeWithin(relative, distance, start + classes.firstCell[k],
                [&](int begin, int end)
                {
                    if (!Backend::gpu && begin <= i) begin = i + 1;
                    for (int k = begin; k < end; ++k)
                    {
                        const int j = Backend::gpu ? place[k] : k;
                        const SolidA<D, P> other = solids.a[j];
                        Vec<D, real> dx;
                        for (int d = 0; d < D; ++d)
                            dx.c[d] = box.template separation<real>(d, xi.c[d], other.x[d]);
                        const real most = radius + other.radius + reach, r2 = squaredNorm(dx);
                        if (!(r2 < most*most) || j == i || apart(i, j)) continue;
                        const real close = radius + other.radius + nearReach;
                        f(j, r2 < close*close);
                    }
                });
        }
    }

private:

    //- Members of one rigid body, bonded pairs, and ghosts: what they do to each other is others'
    //  business
    HD bool apart(int i, int j) const
    {
        if (!Backend::gpu && calm && calm[i] == ghostMark && calm[j] == ghostMark) return true;
        if (clump && clump[i] >= 0 && clump[i] == clump[j]) return true;
        return bonds.first && bonds.keepsApart(id[i], id[j]);
    }
};

//- How many entries particles have (CPU)
template<class Backend, int D, class P>
struct CountContacts
{
    static constexpr const char* name = "countContacts";
    ContactSearch<Backend, D, P> search;
    const int* active;
    int* count;

    HD void operator()(int i) const
    {
        int k = 0;
        if (i < *active) search.forEachCandidate(i, [&](int, bool) { ++k; });
        count[i] = k;
    }
};

//- Entries a block of 32 particles takes: the longest list, 32 times
struct BlockEntries
{
    static constexpr const char* name = "blockEntries";
    const int* count;
    int* base;
    int width;

    HD void operator()(int block) const
    {
        int longest = 0;
        for (int l = 0; l < width; ++l)
        {
            const int k = count[block*width + l];
            longest = k > longest ? k : longest;
        }
        base[block] = longest*width;
    }
};

//- Half lists (CPU)
template<class Backend, int D, class P>
struct WriteContacts
{
    static constexpr const char* name = "writeContacts";
    ContactSearch<Backend, D, P> search;
    const int* active;
    ContactListView<Backend, typename P::real> list;
    int words;                  // of a history; those that do not touch are zero

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        int k = 0;
        search.forEachCandidate(i, [&](int j, bool)
        {
            const std::size_t e = list.index(i, k++);
            list.entry[e] = std::uint32_t(j);
            list.owner[e] = i;
            for (int c = 0; c < words; ++c) list.history[e*words + c] = 0;
            if (list.rest) list.rest[e] = 0;
        });
    }
};

struct InvertOrder
{
    static constexpr const char* name = "invertOrder";
    const std::uint32_t* order;
    int* inverse;
    HD void operator()(int i) const { inverse[order[i]] = i; }
};

//- What contacts remember, from the half lists of before the sort to those of after it (CPU).
//  Numbers of the history from `turns` on change their sign where the other end becomes the owner
template<class Backend, int H, int turns, class R>
struct HandOver
{
    static constexpr const char* name = "handOver";
    using List = ContactListView<Backend, R>;

    List from, to;
    const std::uint32_t* order;
    const int* inverse;
    const int* active;

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        const int before = int(order[i]);
        for (int k = 0; k < from.count[before]; ++k)
        {
            const std::size_t e = from.index(before, k);
            if (!(from.entry[e] & List::touching)) continue;
            const int j = inverse[List::other(from.entry[e])];
            if (j >= *active) continue;
            const bool turn = j < i;
            const int owner = turn ? j : i, partner = turn ? i : j;
            for (int l = 0; l < to.count[owner]; ++l)
            {
                const std::size_t n = to.index(owner, l);
                if (List::other(to.entry[n]) != partner) continue;
                to.entry[n] |= List::touching;
                for (int c = 0; c < H; ++c)
                {
                    const R h = from.template remembered<H>(e, c);
                    to.template remembered<H>(n, c) = turn && c >= turns ? -h : h;
                }
                break;
            }
        }
    }
};

//- What touched in the last step, of particles in their new order: counted, then kept while the
//  lists are written over
template<class Backend, class R, bool Write>
struct KeepContacts
{
    static constexpr const char* name = Write ? "keepContacts" : "countTouching";
    using List = ContactListView<Backend, R>;

    List list;
    int histories;
    const std::uint32_t* order;
    const int* inverse;
    const int* active;
    int* first;                 // counts, then their sums
    int* partner;               // where the other is now
    R* history;                 // words of a contact one after the other

    HD void operator()(int i) const
    {
        const int old = int(order[i]);
        int at = Write ? first[i] : 0;
        const int words = List::historyWords(histories), count = i < *active ? list.count[old] : 0;
        for (int k = 0; k < count; ++k)
        {
            const std::size_t e = list.index(old, k);
            const std::uint32_t entry = list.entry[e];
            if (!(entry & List::touching)) continue;
            const int j = inverse[List::other(entry)];
            if (j >= *active) continue;
            if constexpr (Write)
            {
                partner[at] = j;
                list.unload(histories, e, history + std::size_t(at)*words);
            }
            ++at;
        }
        if constexpr (!Write) first[i] = at;
    }
};

//- Full lists with what contacts remembered
template<class Backend, int D, class P>
struct WriteFullLists
{
    static constexpr const char* name = "writeContacts";
    using R = typename P::real;
    using List = ContactListView<Backend, R>;

    ContactSearch<Backend, D, P> search;
    const int* active;
    List list;
    int histories;
    const int* nearCount;
    const int* keptFirst;       // null: nothing is remembered
    const int* keptPartner;
    const R* keptHistory;

    HD void operator()(int i) const
    {
        if (i >= *active) return;
        int near = 0, far = nearCount[i];
        const int begin = keptFirst ? keptFirst[i] : 0, end = keptFirst ? keptFirst[i + 1] : 0;
        search.forEachCandidate(i, [&](int j, bool isNear)
        {
            const std::size_t e = list.index(i, isNear ? near++ : far++);
            std::uint32_t entry = std::uint32_t(j);
            int kept = -1;
            for (int c = begin; c < end; ++c) if (keptPartner[c] == j) kept = c;
            if (kept >= 0)
            {
                entry |= List::touching;
                list.load(
                    histories, e, keptHistory + std::size_t(kept)*List::historyWords(histories));
            }
            list.entry[e] = entry;
            if (list.rest) list.rest[e] = 0;
        });
    }
};

} // namespace riprap
