/*  The sweeps of a level of the V-cycle in one launch, in 2D: a block of threads takes a tile with
    the cells around it into shared memory, sweeps there, and writes the tile.

    What it reads of cells around the tile it computes anew: each of the four half sweeps makes one
    more ring of them worthless, so four rings are read. (Down the first reads no neighbour, and one
    ring is left: enough for the residuals of the tile, which the block sums for the coarse level.)
    The same numbers come out as of a launch for each half sweep. Blocks must not read what others
    write: sweeps down write to a second vector, sweeps up go from there back to the first.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "core/backend/blocks.hpp"
#include "pic/pressure/transfer.hpp"

namespace riprap
{

//- Sweeps of either colour that a tile's rings stand
static constexpr int tileSweeps = 2;

struct TilePatch
{
    static constexpr int rings = 2*tileSweeps;
    static constexpr int sideX = 1 << tileLog<2>(0), sideY = 1 << tileLog<2>(1);
    static constexpr int width = sideX + 2*rings, height = sideY + 2*rings;

    float x[height][width], b[height][width], inverse[height][width], lower[2][height][width];
};

//- Up: with the correction from the coarse level, black cells first; down: from x = 0, and
//  residuals to the coarse level
template<bool Up>
struct RelaxTile
{
    static constexpr const char* name = Up ? "pressureRelaxUp" : "pressureRelaxDown";
    static constexpr int threads = 256;
    using Shared = TilePatch;
    LevelData<2> level;
    TiledCells<2> cells;
    float* to;
    const float* from;              // up: what sweeps down have left,
    LevelData<2> coarse;            // and the next level

    HD void operator()(const Team& team, TilePatch& t, int block) const
    {
        constexpr int all = TilePatch::width*TilePatch::height, half = all/2;
        if (block >= *cells.count) return;
        const TileOrigin<2> origin = cells.list[block];
        team.each(all, [&](int i) { load(t, origin, i % TilePatch::width, i/TilePatch::width); });
        for (int k = 0; k < 2*tileSweeps; ++k)
            team.each(half, [&](int i) { sweep(t, i, (k + (Up ? 1 : 0)) & 1, k == 0); });
        team.each(TilePatch::sideX*TilePatch::sideY, [&](int i)
        {
            const int x = i % TilePatch::sideX, y = i/TilePatch::sideX;
            const int own = origin.c + x + y*level.shape.stride[1];
            const int px = x + TilePatch::rings, py = y + TilePatch::rings;
            if (t.inverse[py][px] > 0 && origin.x[0] + x < level.shape.n[0]
                && origin.x[1] + y < level.shape.n[1])
                to[own] = t.x[py][px];
        });
        if (!Up)
            team.each(TilePatch::sideX*TilePatch::sideY/4,
                [&](int i) {
                    restrictResidual(
                        t, origin, i % (TilePatch::sideX/2), i/(TilePatch::sideX/2));
                });
    }

private:

    //- Of the coarse cell x, y of the tile, as RestrictResidual: of its red cells, since black ones
    //  have none
    HD void restrictResidual(const TilePatch& t, const TileOrigin<2>& origin, int x, int y) const
    {
        const int at[2] = {(origin.x[0] >> 1) + x, (origin.x[1] >> 1) + y};
        if (at[0] >= coarse.shape.n[0] || at[1] >= coarse.shape.n[1]) return;
        float sum = 0;
        for (int o = 0; o < 2; ++o)
        {
            const int cx = 2*x + o, cy = 2*y + o, px = cx + TilePatch::rings,
                      py = cy + TilePatch::rings;
            if (!(t.inverse[py][px] > 0) || origin.x[0] + cx >= level.shape.n[0]
                || origin.x[1] + cy >= level.shape.n[1])
                continue;
            const float own = t.x[py][px];
            float flux = 0;
            flux += t.lower[0][py][px]*(own - t.x[py][px - 1])
                + t.lower[0][py][px + 1]*(own - t.x[py][px + 1]);
            flux += t.lower[1][py][px]*(own - t.x[py - 1][px])
                + t.lower[1][py + 1][px]*(own - t.x[py + 1][px]);
            sum += t.b[py][px] - flux - level.s[origin.c + cx + cy*level.shape.stride[1]]*own;
        }
        coarse.b[at[0] + at[1]*coarse.shape.stride[1]] = sum;
    }

    //- Around a ring, or nothing
    HD void load(TilePatch& t, const TileOrigin<2>& origin, int px, int py) const
    {
        const int p[2] = {px, py};
        int at[2];
        bool in = true;
        for (int d = 0; d < 2; ++d)
        {
            const int n = level.shape.n[d];
            at[d] = origin.x[d] + p[d] - TilePatch::rings;
            if (level.shape.first[d] > 0)
                at[d] = at[d] < 0 ? (at[d] + TilePatch::rings*n) % n : at[d] % n;
            in = in && at[d] >= 0 && at[d] < n;
        }
        const int c = at[0] + at[1]*level.shape.stride[1];
        t.inverse[py][px] = in ? level.inverse[c] : 0;
        t.b[py][px] = in ? level.b[c] : 0;
        for (int d = 0; d < 2; ++d) t.lower[d][py][px] = in ? level.a[d][c] : 0;
        t.x[py][px] = Up && in
            ? from[c] + coarse.x[(at[0] >> 1) + (at[1] >> 1)*coarse.shape.stride[1]]
            : 0;
    }

    //- Cell i of a colour; the outermost ring has no neighbours
    HD void sweep(TilePatch& t, int i, int colour, bool first) const
    {
        const int y = i/(TilePatch::width/2), x = 2*(i % (TilePatch::width/2)) + ((y + colour) & 1);
        const float inverse = t.inverse[y][x];
        if (!(inverse > 0)) return;
        if (first && !Up) { t.x[y][x] = t.b[y][x]*inverse; return; }
        if (x == 0 || y == 0 || x == TilePatch::width - 1 || y == TilePatch::height - 1) return;
        const float along = t.lower[0][y][x]*t.x[y][x - 1],
                    beyond = t.lower[0][y][x + 1]*t.x[y][x + 1];
        const float below = t.lower[1][y][x]*t.x[y - 1][x],
                    above = t.lower[1][y + 1][x]*t.x[y + 1][x];
        // in the order of ProlongSweep and of Sweep
        t.x[y][x] = (first ? t.b[y][x] + along + beyond + below + above
                           : t.b[y][x] + ((along + beyond) + (below + above)))
            *inverse;
    }
};

} // namespace riprap
