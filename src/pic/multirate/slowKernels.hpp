/*  Multirate: which tiles are slow, and what is done with their particles; see slowTiles.hpp.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/grid/particles.hpp"
#include "pic/grid/tiles.hpp"
#include "pic/transfer/sample.hpp"

namespace riprap
{

//- States: particles are stepped with the grid; wait; are brought up to the grid in this step
static constexpr unsigned char currentTile = 0, slowTile = 1, dueTile = 2;

//- 1 for each tile in which water goes faster than a limit, particles fly, or solids move
template<int D, class R>
struct FindFastTiles
{
    static constexpr const char* name = "findFastTiles";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* start;                   // of the cells' particles
    const unsigned char* nearWater;     // cells (wetCells.hpp)
    const R* u[D];
    const R* wallVelocity[D];           // nullptr: walls rest
    const R* aperture[D];
    const R* baseAperture[D];           // without bodies; nullptr: there are none
    const unsigned char* always;        // tiles that count as fast; nullptr: none
    R limit;                            // [m/s]
    unsigned char* fast;

    HD void operator()(int t) const
    {
        bool found = always && always[t];
        const bool solids = wallVelocity[0] || baseAperture[0];
        if (!found && (solids || particlesOf(grid, tiles, t, start) > 0))
            eachRowOf(grid, tiles, t, [&](typename UniformGrid<D>::Index c, int end)
            { for (; c.c[0] < end && !found; ++c.c[0]) found = isFast(c); });
        fast[t] = found;
    }

private:

    HD bool isFast(const typename UniformGrid<D>::Index& c) const
    {
        const int cell = grid.cell(c);
        if (!nearWater[cell] && start[cell + 1] > start[cell]) return true;
        bool found = false;
        for (int d = 0; d < D; ++d)
            for (int side = 0; side < 2; ++side)
            {
                const int face = grid.faceOf(d, c, side);
                found = found || (nearWater[cell] && !(absolute(u[d][face]) <= limit))
                    || (wallVelocity[d] && wallVelocity[d][face] != R(0))
                    || (baseAperture[d] && aperture[d][face] != baseAperture[d][face]);
            }
        return found;
    }
};

//- After an interval: tiles that have particles and nothing fast about them are slow
template<int D>
struct ChooseSlowTiles
{
    static constexpr const char* name = "chooseSlowTiles";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* start;
    const unsigned char* nearFast;
    unsigned char* state;
    int* flag;                          // of slow ones; tiles + 1

    HD void operator()(int t) const
    {
        flag[t] = 0;
        if (t == tiles.count()) return;
        const bool slow = !nearFast[t] && particlesOf(grid, tiles, t, start) > 0;
        state[t] = slow ? slowTile : currentTile;
        flag[t] = slow;
    }
};

//- The same of states that are known
struct FlagSlowTiles
{
    static constexpr const char* name = "flagSlowTiles";
    int tiles;
    const unsigned char* state;
    int* flag;

    HD void operator()(int t) const { flag[t] = t < tiles && state[t] == slowTile; }
};

//- Slow tiles that something fast has come near to, or all, are due
struct WakeTiles
{
    static constexpr const char* name = "wakeTiles";
    int tiles;
    const unsigned char* nearFast;
    bool all;
    unsigned char* state;
    int* flag;                          // of those; tiles + 1

    HD void operator()(int t) const
    {
        flag[t] = 0;
        if (t == tiles || state[t] != slowTile || !(all || nearFast[t])) return;
        state[t] = dueTile;
        flag[t] = 1;
    }
};

struct EndDueTiles
{
    static constexpr const char* name = "endDueTiles";
    unsigned char* state;
    HD void operator()(int t) const { if (state[t] == dueTile) state[t] = currentTile; }
};

//- Tiles whose particles are summed in this step: those that are stepped with the grid, then slow
//  ones whose particles are not those that were summed
template<int D>
struct FlagSummedTiles
{
    static constexpr const char* name = "flagSummedTiles";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* start;
    const int* occupied;                // place of tiles that have particles; -1: none
    const unsigned char* state;
    bool all;                           // none of the slow ones have been summed
    int* count;                         // particles of slow ones
    int* flag;                          // 2 tiles + 1

    HD void operator()(int t) const
    {
        const int n = tiles.count();
        if (t == n) { flag[2*n] = 0; return; }
        flag[t] = state[t] == currentTile && occupied[t] >= 0;
        flag[n + t] = 0;
        if (state[t] != slowTile) return;
        const int now = particlesOf(grid, tiles, t, start);
        flag[n + t] = all || now != count[t];
        count[t] = now;
    }
};

struct ListSummedTiles
{
    static constexpr const char* name = "listSummedTiles";
    int tiles;
    const int* before;                  // flags, summed up
    const unsigned char* state;
    const int* slot;                    // of slow tiles' sums
    int* place;                         // as GatherTiles has it
    int *current, *summed, *summedSlot;
    int* counts;

    HD void operator()(int t) const
    {
        const bool listed = before[t + 1] > before[t];
        place[t] = listed ? before[t] : (state[t] == slowTile ? -2 - slot[t] : -1);
        if (listed) current[before[t]] = t;
        if (before[tiles + t + 1] > before[tiles + t])
        {
            const int k = before[tiles + t] - before[tiles];
            summed[k] = t;
            summedSlot[k] = slot[t];
        }
        if (t > 0) return;
        counts[0] = before[tiles];
        counts[1] = before[2*tiles] - before[tiles];
    }
};

//- What a face's velocity has changed by, and its mean, since the interval began
template<class R>
struct AddToInterval
{
    static constexpr const char* name = "addToInterval";
    const R* du;
    const R* u;
    R* change;
    R* mean;
    R part;                             // of the step in the time since then

    HD void operator()(int i) const
    {
        change[i] += du[i];
        mean[i] += part*(u[i] - mean[i]);
    }
};

//- Particles that have come to a slow tile from another wait there with the others: what they will
//  be given, they give now
template<int Order, int D, class R>
struct EnterSlowTiles
{
    static constexpr const char* name = "enterSlowTiles";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    PicParticles<D, R> particles;       // in the order of the cells that they come from
    const unsigned char* state;
    const R* change[D];

    HD void operator()(int cell, const typename UniformGrid<D>::Index& c) const
    {
        if (state[tiles.of(c)] == slowTile) return;
        for (int p = particles.start[cell]; p < particles.start[cell + 1]; ++p)
        {
            const Vec<D, double> x = particles.position(p);
            const int to = int(cellKey<D, R>(grid, 1/grid.h, x));
            if (to >= grid.cells() || state[tiles.of(grid.cellIndex(to))] != slowTile) continue;
            for (int d = 0; d < D; ++d)
                particles.v[d][p] -= sampleFace<Order>(grid, change[d], d, x);
        }
    }
};

//- Velocities that particles of slow tiles have still to take, summed up
template<int Order, int D, class R>
struct SumPending
{
    static constexpr const char* name = "sumPending";
    PicParticles<D, R> particles;
    UniformGrid<D> grid;
    TileChoice<D> slow;
    const R* change[D];

    HD void add(int i, double* sums) const
    {
        const Vec<D, double> x = particles.position(i);
        if (!slow.has(InCell<D, R>(grid, x).index())) return;
        for (int d = 0; d < D; ++d) sums[d] += sampleFace<Order>(grid, change[d], d, x);
    }
};

//- Particles of slow tiles
template<int D>
struct CountSlow
{
    static constexpr const char* name = "countSlow";
    UniformGrid<D> grid;
    CellTiles<D> tiles;
    const int* start;
    const unsigned char* state;

    HD void add(int t, double* sums) const
    {
        if (state[t] == slowTile) sums[0] += particlesOf(grid, tiles, t, start);
    }
};

} // namespace riprap
