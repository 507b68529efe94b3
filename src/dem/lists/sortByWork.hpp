/*  The order of particles on the GPU. Cells put together what is near each other. Then, among so
    many of these, those with as many contacts: 32 particles take their steps at one pace, and all
    wait for the one with the longest list.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/lists/listBuild.hpp"

namespace riprap
{

//- The k-th particle in the order of cells: how many entries it will have, how many of them are
//  near, and what that costs
template<class Backend, int D, class P>
struct CountNeighbours
{
    static constexpr const char* name = "countContacts";

    ContactSearch<Backend, D, P> search;        // of particles where they are before the sort
    const int* active;
    const int* walls;           // its entries of walls; null: there are none
    int* count;
    int* nearCount;
    int* cost;

    HD void operator()(int k) const
    {
        int all = 0, near = 0;
        if (k < *active)
            search.forEachCandidate(search.place[k],
                [&](int, bool isNear)
                {
                    ++all;
                    near += isNear;
                });
        count[k] = all;
        nearCount[k] = near;
        // a near pair costs about as much as four that are not. Those at walls stay together,
        // whatever else they have
        cost[k] = all + 3*near + (walls && walls[k] ? 1 << 20 : 0);
    }
};

//- Where the k-th particle goes; order, its inverse and counts as they are then
struct SortByWork
{
    static constexpr const char* name = "sortByWork";
    static constexpr int window = 256;

    int n;
    const int* active;
    const int* cellOrder;       // index before the sort of the k-th
    const int* found;           // entries of the k-th
    const int* foundNear;
    const int* foundWalls;      // and those of walls; null: there are none
    const int* foundElements;
    const int* cost;
    bool stay;                  // all keep their places
    int* place;                 // of the k-th
    int* inverse;
    std::uint32_t* order;
    int* count;
    int* nearCount;
    int* wallEntries;
    int* wallElements;

    HD void operator()(int k) const
    {
        const int before = cellOrder[k], i = stay ? before : newIndex(k);
        inverse[before] = i;
        order[i] = std::uint32_t(before);
        count[i] = found[k];
        nearCount[i] = foundNear[k];
        if (foundWalls)
        {
            wallEntries[i] = foundWalls[k];
            wallElements[i] = foundElements[k];
        }
        place[k] = i;
    }

private:

    HD int newIndex(int k) const
    {
        const int begin = k - k % window, end = begin + window < *active ? begin + window : *active;
        if (k >= end) return k;
        const int own = cost[k];
        int i = begin;
        for (int j = begin; j < end; ++j)
        {
            const int c = cost[j];
            i += c < own || (c == own && j < k);
        }
        return i;
    }
};

} // namespace riprap
