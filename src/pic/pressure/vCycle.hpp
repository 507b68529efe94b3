/*  V-cycle: `sweeps` two-colour sweeps before and after the correction from the next coarser level.

    Before: red, black, red, black ...; after: black, red, ...: the mirror image, so that the cycle is a symmetric operator, as
    conjugate gradients need it. The coarsest level gets bottomSweeps of either order. Small levels are done by one block of the
    GPU, in one launch: their cost is latency alone.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <vector>
#include "core/oneBlock.hpp"
#include "pic/pressure/relaxTile.hpp"

namespace riprap
{

static constexpr int maxTailLevels = 14;
static constexpr int bottomSweeps = 2;
static constexpr int tailCells = 3000;
static_assert(2*tailCells <= DenseCells<2>::most, "padded levels of the tail must be small enough for its quotients");

//- Each pass over n items: a launch of its own
template<class Backend>
struct Launches
{
    Context<Backend>& context;
    template<class F> void each(int n, const F& f) const { forEach(context, n, f); }
    template<class F> void eachRow(int n, const F& f) const { forEachRow(context, n, f); }
};

EITHER_SIDE template<int D, class Cells, class Executor>
HD void relaxDown(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    run.each(cells.halves(), FirstSweep<D, Cells>{level, cells});
    for (int k = 1; k < 2*sweeps; ++k) run.each(cells.halves(), Sweep<D, Cells>{level, cells, k & 1});
}

//- The sweeps after the first black one
EITHER_SIDE template<int D, class Cells, class Executor>
HD void relaxUp(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    for (int k = 1; k < 2*sweeps; ++k) run.each(cells.halves(), Sweep<D, Cells>{level, cells, (k + 1) & 1});
}

//- The same row by row, for the CPU
template<int D, class Cells, class Executor>
void relaxDownRows(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    run.eachRow(cells.rows(), FirstSweeps<D, Cells>{level, cells});
    for (int k = 2; k < 2*sweeps; ++k) run.eachRow(cells.rows(), RowSweep<D, Cells>{level, cells, k & 1});
}

template<int D, class Cells, class Executor>
void relaxUpRows(const Executor& run, const LevelData<D>& level, const Cells& cells, int sweeps)
{
    for (int k = 1; k < 2*sweeps; ++k) run.eachRow(cells.rows(), RowSweep<D, Cells>{level, cells, (k + 1) & 1});
}

//- The small levels, finest first
template<int D>
struct TailCycle
{
    static constexpr const char* name = "pressureTail";
    LevelData<D> level[maxTailLevels];
    int levels = 0, sweeps = 2;

    HD void operator()(const Team& team) const
    {
        using Dense = DenseCells<D>;
        for (int l = 0; l + 1 < levels; ++l)
        {
            relaxDown(team, level[l], dense(l), sweeps);
            team.each(level[l + 1].shape.cells, RestrictResidual<D, Dense>{level[l], level[l + 1], dense(l + 1)});
        }
        const int bottom = levels - 1;
        relaxDown(team, level[bottom], dense(bottom), bottomSweeps);
        team.each(dense(bottom).halves(), Sweep<D, Dense>{level[bottom], dense(bottom), 1});
        relaxUp(team, level[bottom], dense(bottom), bottomSweeps);
        for (int l = levels - 2; l >= 0; --l)
        {
            team.each(dense(l).halves(), ProlongSweep<D, Dense>{level[l], level[l + 1], dense(l)});
            relaxUp(team, level[l], dense(l), sweeps);
        }
    }

    HD DenseCells<D> dense(int l) const { return DenseCells<D>(level[l].shape); }
};

//- x of the finest level from its b. second: another x of each tiled level; with it the sweeps of a level take one launch, as far as there is one for them (2D)
template<int D, class Backend>
void vCycle
(
    Context<Backend>& context, const std::vector<LevelData<D>>& level, const std::vector<TiledCells<D>>& cells, const TailCycle<D>& tail, int sweeps,
    const std::vector<float*>& second = std::vector<float*>()
)
{
    using Tiled = TiledCells<D>;
    const Launches<Backend> launch{context};
    const int tiled = int(cells.size());        // levels that are not in the tail
    const bool together = D == 2 && !second.empty() && sweeps == tileSweeps;
    for (int l = 0; l < tiled; ++l)
    {
        const bool last = l + 1 == tiled;
        if constexpr (!Backend::gpu)
            if (!together && !level[l].shape.ringRows())
            {
                relaxDownRows(launch, level[l], cells[l], sweeps);
                if (!last) launch.eachRow(cells[l + 1].rows(), RestrictRow<D, Tiled>{level[l], level[l + 1], cells[l + 1]});
                else launch.eachRow(tail.dense(0).rows(), RestrictRow<D, DenseCells<D>>{level[l], level[l + 1], tail.dense(0)});
                continue;
            }
        LevelData<D> swept = level[l];
        if (!together) relaxDown(launch, level[l], cells[l], sweeps);
        else if constexpr (D == 2)
        {
            swept.x = second[l];
            forEachBlock(context, cells[l].capacity, RelaxTile<false>{level[l], cells[l], second[l], nullptr, {}});
        }
        if (!last) launch.each(cells[l + 1].all(), RestrictResidual<D, Tiled>{swept, level[l + 1], cells[l + 1]});
        else launch.each(level[l + 1].shape.cells, RestrictResidual<D, DenseCells<D>>{swept, level[l + 1], tail.dense(0)});
    }
    oneBlock(context, tail);
    for (int l = tiled - 1; l >= 0; --l)
    {
        if constexpr (!Backend::gpu)
            if (!together && !level[l].shape.ringRows())
            {
                launch.eachRow(cells[l].rows(), ProlongRow<D, Tiled>{level[l], level[l + 1], cells[l]});
                relaxUpRows(launch, level[l], cells[l], sweeps);
                continue;
            }
        if (!together)
        {
            launch.each(cells[l].halves(), ProlongSweep<D, Tiled>{level[l], level[l + 1], cells[l]});
            relaxUp(launch, level[l], cells[l], sweeps);
        }
        else if constexpr (D == 2) forEachBlock(context, cells[l].capacity, RelaxTile<true>{level[l], cells[l], level[l].x, second[l], level[l + 1]});
    }
}

} // namespace riprap
